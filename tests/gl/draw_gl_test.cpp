// SPDX-License-Identifier: MIT
// Tests of drawing triangles into float targets and reading them back exactly.
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/test_shaders.hpp"

using namespace nicol;
using namespace nicol::gl;

namespace {

struct Vertex {
    float position[3];
    float colour[4];
};

constexpr float depth_of_vertex = 0.25f;
constexpr std::array<float, 4> stokes{1.5f, -0.25f, 3e-30f, 65504.5f};  // signed, tiny, beyond half precision

Vertex vertex(float x, float y, float z = depth_of_vertex, std::array<float, 4> c = stokes) {
    return {{x, y, z}, {c[0], c[1], c[2], c[3]}};
}

VertexArray interleaved(const std::shared_ptr<Context>& context, std::span<const Vertex> vertices,
                        std::span<const std::uint32_t> indices) {
    const auto buffer = std::make_shared<Buffer>(context, BufferUse::vertex, std::as_bytes(vertices));
    const std::array<Attribute, 2> attributes{
        {{0, 3, buffer, 0, sizeof(Vertex)}, {1, 4, buffer, offsetof(Vertex, colour), sizeof(Vertex)}}};
    return {context, attributes, std::make_shared<IndexBuffer>(context, indices)};
}

Program coloured(const std::shared_ptr<Context>& context) {
    return Program::graphics(context, test_shader("coloured.vert"), test_shader("colours.frag"));
}

std::vector<float> pixels_of(const RenderTarget& target, int attachment) {
    std::vector<float> pixels(target.colour(attachment).numbers());
    target.read(attachment, pixels);
    return pixels;
}

std::array<float, 4> pixel(const std::vector<float>& pixels, int width, int x, int y) {
    const auto at = static_cast<std::size_t>(4 * (y * width + x));
    return {pixels[at], pixels[at + 1], pixels[at + 2], pixels[at + 3]};
}

constexpr std::uint32_t one_triangle[] = {0, 1, 2};
// A triangle over the upper left half of the image, counter-clockwise with y up.
const std::array<Vertex, 3> upper_left{vertex(-1, 1), vertex(-1, -1), vertex(1, 1)};

/// Draws the triangle and returns both attachments of the image.
std::array<std::vector<float>, 2> upper_left_image(const std::shared_ptr<Context>& context, int width,
                                                   int height) {
    return context->run([&] {
        RenderTarget target(context, {width, height, 2, true});
        target.clear({-1.0f, -2.0f, -3.0f, -4.0f});
        draw(target, coloured(context), interleaved(context, upper_left, one_triangle));
        return std::array{pixels_of(target, 0), pixels_of(target, 1)};
    });
}

}  // namespace

GL_TEST_CASE("a triangle arrives exactly, the top row first") {
    constexpr int width = 7, height = 5;
    const auto [colours, places] = upper_left_image(context, width, height);
    int covered = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float side =
                (static_cast<float>(x) + 0.5f) / width + (static_cast<float>(y) + 0.5f) / height;
            if (std::abs(side - 1.0f) < 1e-5f) continue;  // either result is valid on the edge
            CAPTURES(x, y);
            if (side > 1.0f) {
                CHECK(pixel(colours, width, x, y) == std::array{-1.0f, -2.0f, -3.0f, -4.0f});
                continue;
            }
            ++covered;
            CHECK(pixel(colours, width, x, y) == stokes);
            const auto place = pixel(places, width, x, y);
            CHECK(place[0] == static_cast<float>(x) + 0.5f);
            CHECK(place[1] == static_cast<float>(y) + 0.5f);  // gl_FragCoord.y counts from the top
            CHECK(place[2] == doctest::Approx(depth_of_vertex));
            CHECK(place[3] == 1.0f);  // counter-clockwise in clip space is front-facing
        }
    CHECK(covered > 10);
}

TEST_CASE("both backends draw the same image") {
    std::array<std::vector<float>, 2> first;
    on_every_backend([&](const std::shared_ptr<Context>& context) {
        const auto image = upper_left_image(context, 64, 33);
        if (first[0].empty()) {
            first = image;
        } else if (context->info().software) {
            CHECK(image == first);
        }
    });
}

GL_THREAD_TEST_CASE("the nearer triangle wins in either order, unless the test is off") {
    const Program program = coloured(context);
    const std::array<float, 4> red{1, 0, 0, 1}, green{0, 1, 0, 1};
    // Returns a red and a green triangle over all pixels at depths a and b.
    const auto triangles = [&](float a, float b) {
        return std::array{vertex(-3, -3, a, red),   vertex(3, -3, a, red),   vertex(0, 3, a, red),
                          vertex(-3, -3, b, green), vertex(3, -3, b, green), vertex(0, 3, b, green)};
    };
    const std::array<Vertex, 6> two = triangles(0.75f, 0.25f);
    const std::uint32_t near_first[] = {0, 1, 2, 3, 4, 5}, far_first[] = {3, 4, 5, 0, 1, 2};
    const auto middle = [&](std::span<const std::uint32_t> order, const DrawState& state) {
        RenderTarget target(context, {3, 3, 1, true});
        draw(target, program, interleaved(context, two, order), state);
        return pixel(pixels_of(target, 0), 3, 1, 1);
    };
    CHECK(middle(near_first, {}) == red);
    CHECK(middle(far_first, {}) == red);
    CHECK(middle(near_first, {DepthTest::off, true, Cull::none}) == green);
    CHECK(middle(near_first, {DepthTest::nearer, false, Cull::none}) == green);

    // At equal depth `nearer` keeps the first triangle, and `nearer_or_equal` takes the second.
    RenderTarget target(context, {3, 3, 1, true});
    const VertexArray vertices = interleaved(context, triangles(0.5f, 0.5f), near_first);
    draw(target, program, vertices);
    CHECK(pixel(pixels_of(target, 0), 3, 1, 1) == red);
    draw(target, program, vertices, {DepthTest::nearer_or_equal, true, Cull::none});
    CHECK(pixel(pixels_of(target, 0), 3, 1, 1) == green);
    // Clearing resets the depth, even after a draw that did not write depth.
    draw(target, program, vertices, {DepthTest::nearer, false, Cull::none});
    target.clear();
    draw(target, program, vertices, 0, 3);
    CHECK(pixel(pixels_of(target, 0), 3, 1, 1) == red);
    target.clear_depth(0.9f);
    draw(target, program, vertices, 3, 3);
    CHECK(pixel(pixels_of(target, 0), 3, 1, 1) == red);
}

GL_THREAD_TEST_CASE("clearing clears all components, whatever was drawn before") {
    RenderTarget target(context, {4, 4, 2});
    const Program program = coloured(context);
    const VertexArray vertices = interleaved(context, upper_left, one_triangle);
    target.clear(glm::vec4(7.0f));
    draw(target, program, vertices, {.components = 1});
    target.clear(glm::vec4(3.0f));
    for (int attachment = 0; attachment < 2; ++attachment)
        for (const float value : pixels_of(target, attachment)) REQUIRE(value == 3.0f);
}

GL_THREAD_TEST_CASE("culling drops the faces it names") {
    const Program program = coloured(context);
    const std::uint32_t counter_clockwise[] = {0, 1, 2}, clockwise[] = {0, 2, 1};
    const auto drawn = [&](std::span<const std::uint32_t> order, Cull cull) {
        RenderTarget target(context, {4, 4, 1, false});
        draw(target, program, interleaved(context, upper_left, order), {DepthTest::off, false, cull});
        return pixel(pixels_of(target, 0), 4, 0, 0) == stokes;
    };
    CHECK(drawn(counter_clockwise, Cull::none));
    CHECK(drawn(clockwise, Cull::none));
    CHECK(drawn(counter_clockwise, Cull::back));
    CHECK(!drawn(clockwise, Cull::back));
    CHECK(!drawn(counter_clockwise, Cull::front));
    CHECK(drawn(clockwise, Cull::front));
}

GL_TEST_CASE("separate attributes draw what interleaved ones do") {
    const auto expected = upper_left_image(context, 8, 8)[0];
    context->run([&] {
        std::vector<float> positions{99.0f}, colours;  // one unused float in front tests the offset
        for (const Vertex& v : upper_left) {
            positions.insert(positions.end(), v.position, v.position + 3);
            colours.insert(colours.end(), v.colour, v.colour + 4);
        }
        const auto buffer = [&](const std::vector<float>& data) {
            return std::make_shared<Buffer>(context, BufferUse::vertex, std::as_bytes(std::span(data)));
        };
        const std::array<Attribute, 2> attributes{
            {{0, 3, buffer(positions), sizeof(float), 0}, {1, 4, buffer(colours), 0, 0}}};
        const VertexArray vertices(context, attributes, std::make_shared<IndexBuffer>(context, one_triangle));
        RenderTarget target(context, {8, 8, 2, false});
        target.clear({-1.0f, -2.0f, -3.0f, -4.0f});
        draw(target, coloured(context), vertices, {DepthTest::off, false, Cull::none});
        CHECK(pixels_of(target, 0) == expected);
    });
}

GL_THREAD_TEST_CASE("the full-screen triangle samples a texture upright") {
    constexpr int width = 5, height = 3;
    std::vector<float> texels(4 * width * height);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = 0.5f * static_cast<float>(i) - 7.0f;
    const Texture2D texture(context, {width, height}, texels);
    const Define scale{"SCALE", "1.0"};
    const Program program = Program::graphics(context, embedded_shader("fullscreen.vert"),
                                              test_shader("gather.frag"), {&scale, 1});
    RenderTarget target(context, {width, height, 1, false});
    texture.bind(3);
    draw_fullscreen(target, program);
    CHECK(pixels_of(target, 0) == texels);

    // The full-screen triangle lies at the far plane, behind everything drawn before it.
    RenderTarget behind(context, {width, height, 1, true});
    draw_fullscreen(behind, program, {DepthTest::nearer_or_equal, false, Cull::none});
    CHECK(pixels_of(behind, 0) == texels);
    behind.clear();
    behind.clear_depth(0.001f);
    draw_fullscreen(behind, program, {DepthTest::nearer_or_equal, false, Cull::none});
    CHECK(pixels_of(behind, 0) == std::vector<float>(texels.size(), 0.0f));
}

GL_TEST_CASE("draws refuse what does not fit together") {
    const auto other = make_context(context->info().backend);
    auto foreign = other->run([&] { return std::make_unique<Program>(coloured(other)); });
    context->run([&] {
        RenderTarget target(context, {4, 4, 1, true});
        const Program program = coloured(context);
        const VertexArray vertices = interleaved(context, upper_left, one_triangle);
        CHECK_THROWS_AS(draw(target, *foreign, vertices), Error);
        CHECK_THROWS_AS(draw(target, program, vertices, 0, 4), Error);
        CHECK_THROWS_AS(draw(target, program, vertices, 1, 2), Error);
        CHECK_THROWS_AS(draw(target, program, vertices, 3, 3), Error);
        CHECK_THROWS_AS(draw(target, program, vertices, 3, std::numeric_limits<std::size_t>::max() - 2),
                        Error);
        CHECK_THROWS_AS(dispatch(program, 1), Error);
        CHECK_NOTHROW(draw(target, program, vertices, 3, 0));
    });
}
