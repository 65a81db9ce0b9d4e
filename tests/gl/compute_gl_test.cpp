// SPDX-License-Identifier: MIT
// Tests of compute programs over shader storage.
#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "gl/buffer.hpp"
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/test_shaders.hpp"
#include "gl/texture_array.hpp"

using namespace nicol;
using namespace nicol::gl;

GL_THREAD_TEST_CASE("a compute program reads one buffer, or a part of it, and writes another") {
    constexpr std::size_t read = 1000;
    const Define factor{"FACTOR", "2.0"};
    const Program program = Program::compute(context, test_shader("double.comp"), {&factor, 1});
    CHECK(program.is_compute());
    const std::size_t aligned = std::max<std::size_t>(context->limits().storage_alignment, sizeof(float));
    for (const std::size_t first : {std::size_t{0}, aligned / sizeof(float)}) {
        std::vector<float> source(first + read), result(read);
        for (std::size_t i = 0; i < source.size(); ++i) source[i] = 0.25f * static_cast<float>(i) - 50;
        const Buffer input(context, BufferUse::storage, std::as_bytes(std::span(source)));
        const Buffer output(context, BufferUse::storage, read * sizeof(float), BufferUpdate::fixed);
        if (first == 0)
            input.bind_storage(0);
        else
            input.bind_storage(0, aligned, read * sizeof(float));
        output.bind_storage(1);
        dispatch(program, (read + 63) / 64);
        output.read(0, std::as_writable_bytes(std::span(result)));
        for (std::size_t i = 0; i < read; ++i) REQUIRE(result[i] == 2 * source[first + i]);
    }
}

GL_THREAD_TEST_CASE("a binding is that of the last call") {
    constexpr std::size_t count = 64;
    const Define factor{"FACTOR", "2.0"};
    const Program program = Program::compute(context, test_shader("double.comp"), {&factor, 1});
    const Buffer output(context, BufferUse::storage, count * sizeof(float), BufferUpdate::fixed);
    output.bind_storage(1);
    std::vector<float> result(count);
    const auto check = [&](const Buffer& input, float expected) {
        input.bind_storage(0);
        dispatch(program, 1);
        output.read(0, std::as_writable_bytes(std::span(result)));
        CHECK(std::ranges::count(result, expected) == count);
    };
    const auto filled = [&](float value) {
        const std::vector<float> source(count, value);
        return Buffer(context, BufferUse::storage, std::as_bytes(std::span(source)));
    };
    const Buffer kept = filled(1);
    for (int i = 2; i < 6; ++i) {
        // Each round deletes a bound buffer; some drivers give its name to the next one.
        const Buffer input = filled(static_cast<float>(i));
        check(input, 2 * static_cast<float>(i));
        check(input, 2 * static_cast<float>(i));
        check(kept, 2);
        check(input, 2 * static_cast<float>(i));
    }
}

GL_THREAD_TEST_CASE("one dispatch writes the layers of an array, which are copied one by one") {
    constexpr int width = 6, height = 5, layers = 3;
    TextureArray array(context, width, height, layers);
    const Program program = Program::compute(context, test_shader("layers.comp"));
    Texture2D copy(context, {width, height});
    std::vector<float> texels(copy.numbers());
    for (const bool cleared : {false, true}) {
        array.bind_image();
        dispatch(program, 1, 1, layers);
        if (cleared) array.clear();
        for (int layer = 0; layer < layers; ++layer) {
            array.copy_layer(layer, copy);
            copy.read(texels);
            for (int i = 0; i < width * height; ++i) {
                const glm::vec4 written(i % width, i / width, layer, 1);
                const glm::vec4 found = glm::make_vec4(&texels[4 * static_cast<std::size_t>(i)]);
                REQUIRE(found == (cleared ? glm::vec4(0) : written));
            }
        }
    }
    Texture2D other(context, {height, width});
    Texture2D grey(context, {.width = width, .height = height, .format = Format::r32f});
    for (Texture2D* const refused : {&other, &grey}) CHECK_THROWS_AS(array.copy_layer(0, *refused), Error);
    for (const int layer : {-1, layers}) CHECK_THROWS_AS(array.copy_layer(layer, copy), Error);
    const int limit = context->limits().texture_size;
    for (const auto& size : {std::array{0, 1, 1}, {1, 0, 1}, {1, 1, 0}, {limit + 1, 1, 1}})
        CHECK_THROWS_AS(TextureArray(context, size[0], size[1], size[2]), Error);
}

GL_THREAD_TEST_CASE("bindings and dispatches outside the limits are refused") {
    const Limits& limits = context->limits();
    const Buffer buffer(context, BufferUse::storage, 4096, BufferUpdate::fixed);
    CHECK_THROWS_AS(buffer.bind_storage(static_cast<unsigned>(limits.storage_bindings)), Error);
    CHECK_THROWS_AS(buffer.bind_storage(0, 0, 4097), Error);
    CHECK_THROWS_AS(buffer.bind_storage(0, 4096, 0), Error);
    if (limits.storage_alignment > 1) CHECK_THROWS_AS(buffer.bind_storage(0, 1, 4), Error);
    if (limits.storage_bytes <= (std::size_t{1} << 28)) {
        const Buffer large(context, BufferUse::storage, limits.storage_bytes + 4096, BufferUpdate::fixed);
        CHECK_THROWS_AS(large.bind_storage(0), Error);
        CHECK_NOTHROW(large.bind_storage(0, 4096, limits.storage_bytes));
    }
    const Define factor{"FACTOR", "1.0"};
    const Program program = Program::compute(context, test_shader("double.comp"), {&factor, 1});
    CHECK_THROWS_AS(dispatch(program, 0), Error);
    CHECK_THROWS_AS(dispatch(program, 1, 1, limits.groups[2] + 1), Error);
    RenderTarget target(context, {4, 4, 1, false});
    CHECK_THROWS_AS(draw_fullscreen(target, program), Error);
}
