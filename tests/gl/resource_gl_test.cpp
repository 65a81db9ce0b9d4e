// SPDX-License-Identifier: MIT
// Tests of buffers, textures, vertex arrays and targets: content, limits and memory accounting.
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/test_shaders.hpp"

using namespace nicol;
using namespace nicol::gl;

namespace {

constexpr auto none = std::numeric_limits<std::size_t>::max();
constexpr int lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();

std::vector<float> counting(std::size_t count) {
    std::vector<float> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<float>(i);
    return numbers;
}

}  // namespace

GL_THREAD_TEST_CASE("a dynamic buffer takes updates of parts, a fixed one none") {
    std::array<std::byte, 7> bytes;
    bytes.fill(std::byte{9});
    // Fills the memory first, so that zeros cannot come from fresh memory.
    for (int i = 0; i < 20; ++i) Buffer(context, BufferUse::storage, bytes);
    Buffer buffer(context, BufferUse::storage, 7, BufferUpdate::dynamic);
    buffer.read(0, bytes);
    CHECK(bytes == std::array<std::byte, 7>{});  // new buffers without data are zero
    const std::array<std::byte, 2> part{std::byte{1}, std::byte{2}};
    buffer.update(5, part);
    buffer.read(0, bytes);
    CHECK(bytes[4] == std::byte{0});
    CHECK(bytes[5] == std::byte{1});
    CHECK(bytes[6] == std::byte{2});
    CHECK_INVALID(buffer.update(6, part));
    CHECK_INVALID(buffer.update(none, part));
    CHECK_INVALID(buffer.read(1, bytes));
    Buffer fixed(context, BufferUse::storage, bytes);
    CHECK_INVALID(fixed.update(0, part));
}

GL_THREAD_TEST_CASE("buffers of impossible sizes are refused and cost nothing") {
    CHECK_INVALID(Buffer(context, BufferUse::storage, 0, BufferUpdate::dynamic));
    for (const std::size_t bytes : {std::size_t{1} << 50, none})
        check_error(ErrorCode::out_of_memory,
                    CALL(Buffer(context, BufferUse::storage, bytes, BufferUpdate::dynamic)));
    CHECK_INVALID(Buffer(context, BufferUse::vertex, std::span<const std::byte>{}));
    CHECK(total_bytes(context->memory()) == 0);
}

GL_THREAD_TEST_CASE("a texture gives back what it was given") {
    std::vector<float> texels = counting(4 * 6 * 5), back(texels.size());
    Texture2D texture(context, {6, 5}, texels);
    texture.read(back);
    CHECK(back == texels);
    const std::vector<float> patch(4 * 2 * 3, -1.0f);
    texture.update(4, 2, 2, 3, patch);
    for (std::size_t y = 2; y < 5; ++y)
        for (std::size_t x = 4; x < 6; ++x)
            for (std::size_t i = 0; i < 4; ++i) texels[4 * (6 * y + x) + i] = -1.0f;
    texture.read(back);
    CHECK(back == texels);
    for (const auto& box : {std::array{5, 2, 2, 3},
                            {-1, 0, 2, 3},
                            {0, 0, 2, 2},
                            {highest, 0, 2, 3},
                            {0, 0, highest, 3},
                            {0, 0, lowest, 3}})
        CHECK_INVALID(texture.update(box[0], box[1], box[2], box[3], patch));
    CHECK_INVALID(texture.read(std::span(back).first(8)));

    for (int i = 0; i < 20; ++i) Texture2D(context, {6, 5}, texels);
    const Texture2D empty(context, {6, 5});
    empty.read(back);
    CHECK(back == std::vector<float>(back.size(), 0.0f));
}

GL_TEST_CASE("textures outside the limits are refused") {
    context->run([&] {
        const int limit = context->limits().texture_size;
        for (const auto& size :
             {std::array{limit + 1, 1}, {1, limit + 1}, {highest, highest}, {0, 1}, {1, -1}})
            CHECK_INVALID(Texture2D(context, {size[0], size[1]}));
        CHECK_INVALID(Texture2D(context, {2, 2}, std::vector<float>(15)));
        // llvmpipe supports a few GiB only, while hardware may hold the texture.
        if (context->info().software && limit >= 16384)
            check_error(ErrorCode::out_of_memory, CALL(Texture2D(context, {limit, limit})));
        const Texture2D texture(context, {1, 1});
        CHECK_INVALID(texture.bind(static_cast<unsigned>(context->limits().texture_units)));
    });
    CHECK(total_bytes(context->memory()) == 0);
}

GL_THREAD_TEST_CASE("filters and wraps do what they are named") {
    const std::array<float, 8> texels{0, 0, 0, 0, 1, 1, 1, 1};  // two texels side by side
    // The image has 8 pixels over coordinates 0 .. 2, so its second half lies beyond the edge.
    const Define scale{"SCALE", "vec2(2.0, 1.0)"};
    const Program program = Program::graphics(context, embedded_shader("fullscreen.vert"),
                                              test_shader("gather.frag"), {&scale, 1});
    const auto row = [&](Filter filter, Wrap wrap) {
        const Texture2D texture(context, {2, 1, filter, wrap, Wrap::clamp}, texels);
        RenderTarget target(context, {8, 1, 1, false});
        texture.bind(3);
        draw_fullscreen(target, program);
        std::array<float, 32> pixels{};
        target.read(0, pixels);
        std::array<float, 8> first{};
        for (std::size_t i = 0; i < 8; ++i) first[i] = pixels[4 * i];
        return first;
    };
    using Row = std::array<float, 8>;
    // Each row deletes the texture of the unit; some drivers give its name to the next one.
    CHECK(row(Filter::nearest, Wrap::clamp) == Row{0, 0, 1, 1, 1, 1, 1, 1});
    CHECK(row(Filter::nearest, Wrap::repeat) == Row{0, 0, 1, 1, 0, 0, 1, 1});
    CHECK(row(Filter::nearest, Wrap::mirror) == Row{0, 0, 1, 1, 1, 1, 0, 0});
    const Row linear = row(Filter::linear, Wrap::clamp);
    const Row expected{0, 0.25f, 0.75f, 1, 1, 1, 1, 1};
    for (std::size_t i = 0; i < 8; ++i) CHECK(linear[i] == doctest::Approx(expected[i]).epsilon(0.01));
    const Row repeated = row(Filter::linear, Wrap::repeat);
    CHECK(repeated[0] == doctest::Approx(0.25f).epsilon(0.01));
}

GL_TEST_CASE("render targets outside the limits are refused") {
    context->run([&] {
        const Limits& limits = context->limits();
        const int side = limits.target_size;
        for (const auto& size :
             {std::array{side + 1, 1, 1}, {1, 0, 1}, {1, 1, 0}, {1, 1, limits.colour_attachments + 1}})
            CHECK_INVALID(RenderTarget(context, {size[0], size[1], size[2], true}));
        if (context->info().software && side >= 16384)
            check_error(ErrorCode::out_of_memory, CALL(RenderTarget(context, {side, side, 1, true})));
        CHECK(total_bytes(context->memory()) == 0);

        RenderTarget target(context, {3, 2, limits.colour_attachments, false});
        std::vector<float> pixels(3 * 2 * 4);
        for (int i = 0; i < target.colours(); ++i) target.clear_colour(i, glm::vec4(static_cast<float>(i)));
        for (int i = 0; i < target.colours(); ++i) {
            target.read(i, pixels);
            CHECK(pixels == std::vector<float>(pixels.size(), static_cast<float>(i)));
        }
        // Written pixels can be read back from their attachment, and other attachments stay unchanged.
        std::vector<float> written(pixels.size());
        for (std::size_t i = 0; i < written.size(); ++i) written[i] = 0.5F * static_cast<float>(i) - 3;
        target.write(1, written);
        target.read(1, pixels);
        CHECK(pixels == written);
        target.read(0, pixels);
        CHECK(pixels == std::vector<float>(pixels.size(), 0.0F));
        CHECK_INVALID(target.write(target.colours(), written));
        written.pop_back();
        CHECK_INVALID(target.write(0, written));

        CHECK_INVALID(target.clear_colour(target.colours(), {}));
        CHECK_INVALID(target.read(-1, pixels));
        CHECK_INVALID(target.clear_depth());
        RenderTarget deep(context, {3, 2, 1, true});
        CHECK_INVALID(deep.clear_depth(std::numeric_limits<float>::quiet_NaN()));
    });
    CHECK_INVALID(RenderTarget(nullptr, {1, 1, 1, false}));
}

GL_TEST_CASE("vertex arrays refuse attributes and indices that reach outside their buffers") {
    const auto other = make_context(context->info().backend);
    const auto foreign = other->run(
        [&] { return std::make_shared<Buffer>(other, BufferUse::vertex, 1024, BufferUpdate::fixed); });
    context->run([&] {
        const auto buffer = std::make_shared<Buffer>(context, BufferUse::vertex, 3 * 12, BufferUpdate::fixed);
        const auto indices = [&](std::vector<std::uint32_t> list) {
            return std::make_shared<IndexBuffer>(context, list);
        };
        const auto good = indices({0, 1, 2});
        CHECK(good->largest() == 2);
        CHECK_NOTHROW(VertexArray(context, std::array<Attribute, 1>{{{0, 3, buffer, 0, 0}}}, good));
        CHECK_NOTHROW(VertexArray(context, std::array<Attribute, 1>{{{0, 2, buffer, 4, 12}}}, good));
        const auto refused = [&](const Attribute& attribute, const std::shared_ptr<IndexBuffer>& list) {
            CHECK_INVALID(VertexArray(context, {&attribute, 1}, list));
        };
        refused({0, 3, buffer, 0, 0}, indices({0, 1, 3}));
        refused({0, 3, buffer, 0, 12}, nullptr);
        for (const Attribute& attribute : std::vector<Attribute>{{0, 3, buffer, 4, 12},
                                                                 {0, 3, buffer, 1u << 30, 12},
                                                                 {0, 3, buffer, 2, 12},
                                                                 {0, 3, buffer, 0, 13},
                                                                 {0, 3, buffer, 0, std::size_t{1} << 40},
                                                                 {0, 0, buffer, 0, 12},
                                                                 {0, 5, buffer, 0, 12},
                                                                 {4711, 3, buffer, 0, 12},
                                                                 {0, 3, nullptr, 0, 12},
                                                                 {0, 3, foreign, 0, 12}})
            refused(attribute, good);
        const std::array<Attribute, 2> twice{{{0, 3, buffer, 0, 0}, {0, 3, buffer, 0, 0}}};
        CHECK_INVALID(VertexArray(context, twice, good));
        CHECK_INVALID(indices({}));
        CHECK_INVALID(indices({0, 1}));
    });
}

GL_TEST_CASE("memory of every kind is counted") {
    context->run([&] {
        const Buffer vertex(context, BufferUse::vertex, 100, BufferUpdate::fixed);
        const IndexBuffer index(context, std::array<std::uint32_t, 3>{0, 0, 0});
        const Buffer storage(context, BufferUse::storage, 1000, BufferUpdate::fixed);
        const Texture2D texture(context, {8, 4});
        const RenderTarget target(context, {16, 10, 2, true});
        const MemoryUse use = context->memory();
        CHECK(use.of(MemoryKind::vertex) == 100);
        CHECK(use.of(MemoryKind::index) == 12);
        CHECK(use.of(MemoryKind::storage) == 1000);
        CHECK(use.of(MemoryKind::texture) == 8 * 4 * 16);
        CHECK(use.of(MemoryKind::render_target) == 16 * 10 * (2 * 16 + 4));
        CHECK(total_bytes(use) == 100 + 12 + 1000 + 8 * 4 * 16 + 16 * 10 * 36);
    });
    CHECK(total_bytes(context->memory()) == 0);
}
