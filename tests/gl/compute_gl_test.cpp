// SPDX-License-Identifier: MIT
// Compute programs over shader storage.
#include <array>
#include <vector>

#include "error.hpp"
#include "gl/buffer.hpp"
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/test_shaders.hpp"

using namespace nicol;
using namespace nicol::gl;

TEST_CASE("a compute program reads one storage buffer and writes another") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            constexpr std::size_t count = 1000;
            std::vector<float> source(count), result(count);
            for (std::size_t i = 0; i < count; ++i) source[i] = 0.25f * static_cast<float>(i) - 50.0f;
            const Buffer input(context, BufferUse::storage, std::as_bytes(std::span(source)));
            const Buffer output(context, BufferUse::storage, count * sizeof(float), BufferUpdate::fixed);
            const Define factor{"FACTOR", "2.0"};
            const Program program = Program::compute(context, test_shader("double.comp"), {&factor, 1});
            CHECK(program.is_compute());
            input.bind_storage(0);
            output.bind_storage(1);
            dispatch(program, (count + 63) / 64);
            output.read(0, std::as_writable_bytes(std::span(result)));
            for (std::size_t i = 0; i < count; ++i) REQUIRE(result[i] == 2.0f * source[i]);
        });
    });
}

TEST_CASE("a part of a buffer can be bound") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const std::size_t step =
                std::max<std::size_t>(context->limits().storage_alignment, sizeof(float));
            const std::size_t first = step / sizeof(float), count = first + 10;
            std::vector<float> source(count), result(10);
            for (std::size_t i = 0; i < count; ++i) source[i] = static_cast<float>(i);
            const Buffer input(context, BufferUse::storage, std::as_bytes(std::span(source)));
            const Buffer output(context, BufferUse::storage, 10 * sizeof(float), BufferUpdate::fixed);
            const Define factor{"FACTOR", "1.0"};
            const Program program = Program::compute(context, test_shader("double.comp"), {&factor, 1});
            input.bind_storage(0, step, 10 * sizeof(float));
            output.bind_storage(1);
            dispatch(program, 1);
            output.read(0, std::as_writable_bytes(std::span(result)));
            CHECK(result ==
                  std::vector<float>(source.begin() + static_cast<std::ptrdiff_t>(first), source.end()));
        });
    });
}

TEST_CASE("bindings and dispatches outside the limits are refused") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const Limits& limits = context->limits();
            const Buffer buffer(context, BufferUse::storage, 4096, BufferUpdate::fixed);
            CHECK_THROWS_AS(buffer.bind_storage(static_cast<unsigned>(limits.storage_bindings)), Error);
            CHECK_THROWS_AS(buffer.bind_storage(0, 0, 4097), Error);
            CHECK_THROWS_AS(buffer.bind_storage(0, 4096, 0), Error);
            if (limits.storage_alignment > 1) CHECK_THROWS_AS(buffer.bind_storage(0, 1, 4), Error);
            if (limits.storage_bytes <= (std::size_t{1} << 28)) {
                const Buffer large(context, BufferUse::storage, limits.storage_bytes + 4096,
                                   BufferUpdate::fixed);
                CHECK_THROWS_AS(large.bind_storage(0), Error);
                CHECK_NOTHROW(large.bind_storage(0, 4096, limits.storage_bytes));
            }
            const Define factor{"FACTOR", "1.0"};
            const Program program = Program::compute(context, test_shader("double.comp"), {&factor, 1});
            CHECK_THROWS_AS(dispatch(program, 0), Error);
            CHECK_THROWS_AS(dispatch(program, 1, 1, limits.groups[2] + 1), Error);
            RenderTarget target(context, {4, 4, 1, false});
            CHECK_THROWS_AS(draw_fullscreen(target, program), Error);
        });
    });
}
