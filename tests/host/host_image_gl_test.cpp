// SPDX-License-Identifier: MIT
// Tests of images that stay on the device: the framebuffer's own textures, and drawing into textures of the
// application.
#include "host/egl_host.hpp"

using namespace host_test;

namespace {

constexpr int width = 24, height = 16;

GLuint texture_of(const GladGLContext& gl, GLenum format, int w = width, int h = height) {
    GLuint texture = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, format, w, h);
    return texture;
}

std::vector<float> texels(const GladGLContext& gl, GLuint texture) {
    std::vector<float> values(std::size_t{4} * width * height);
    gl.GetTextureImage(texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(values.size() * sizeof(float)),
                       values.data());
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    return values;
}

std::vector<float> rotated(const std::vector<float>& rows) {
    std::vector<float> values;
    for (int y = height - 1; y >= 0; --y)
        values.insert(values.end(), rows.begin() + 4 * width * y, rows.begin() + 4 * width * (y + 1));
    return values;
}

nicol_texture_target into(GLuint texture) {
    nicol_texture_target target = NICOL_TEXTURE_TARGET_INIT;
    target.texture = texture;
    return target;
}

double srgb(double v) {
    v = std::clamp(v, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Returns an RGBA image with alpha 1, its colours from the three channels' Stokes vectors by `seen`.
template <class F>
std::vector<float> image(const std::vector<float>& stokes, F seen) {
    std::vector<float> values(std::size_t{4} * width * height, 1);
    const std::size_t plane = values.size();
    for (std::size_t pixel = 0; pixel < plane; pixel += 4)
        for (std::size_t c = 0; c < 3; ++c) values[pixel + c] = float(seen(&stokes[c * plane + pixel]));
    return values;
}

struct Show {
    Application application;
    Owned<nicol_context> context{make_host_context()};
    Stage stage{context};
    std::vector<float> stokes = stage.image();
};

}  // namespace

HOST_TEST_CASE("a framebuffer's textures are the Stokes vectors of its channels") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    for (std::uint32_t c = 0; c < 3; ++c) {
        nicol_gl_texture texture = NICOL_GL_TEXTURE_INIT;
        OK(nicol_framebuffer_get_texture(show.stage.framebuffer, c, &texture));
        CHECK((texture.target == GL_TEXTURE_2D && texture.internal_format == GL_RGBA32F));
        CHECK((texture.width == width && texture.height == height));
        REQUIRE(gl.IsTexture(texture.name) == GL_TRUE);
        GLint format = 0;
        gl.GetTextureLevelParameteriv(texture.name, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
        CHECK(format == GL_RGBA32F);
        CHECK(texels(gl, texture.name) == read_plane(show.stage.framebuffer, NICOL_PLANE_STOKES, c));
        const GLuint name = texture.name;
        nicol_render_options options = plain_options();
        options.disabled_optimisations = NICOL_OPTIMISATION_UNCHANGED;
        OK(show.stage.try_render(options));
        OK(nicol_framebuffer_get_texture(show.stage.framebuffer, c, &texture));
        CHECK(texture.name == name);
    }
}

HOST_TEST_CASE("Stokes vectors are copied into the application's texture") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const GLuint exact = texture_of(gl, GL_RGBA32F), half = texture_of(gl, GL_RGBA16F);
    nicol_texture_target target = into(exact);
    OK(nicol_framebuffer_draw_stokes(show.stage.framebuffer, 1, &target));
    const std::vector<float> plane = read_plane(show.stage.framebuffer, NICOL_PLANE_STOKES, 1);
    CHECK(texels(gl, exact) == plane);
    target.bottom_up = 1;
    OK(nicol_framebuffer_draw_stokes(show.stage.framebuffer, 1, &target));
    CHECK(texels(gl, exact) == rotated(plane));
    target = into(half);
    OK(nicol_framebuffer_draw_stokes(show.stage.framebuffer, 1, &target));
    CHECK(largest_difference(texels(gl, half), plane) < 1e-3 * *std::ranges::max_element(plane));
    CHECK(texels(gl, half) != plane);
}

HOST_TEST_CASE("a polarizer passes what Malus' law says") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const GLuint exact = texture_of(gl, GL_RGBA32F), coded = texture_of(gl, GL_RGBA8),
                 coded_srgb = texture_of(gl, GL_SRGB8_ALPHA8);
    nicol_observation seen = NICOL_OBSERVATION_INIT;
    seen.kind = NICOL_OBSERVATION_POLARIZER;
    seen.exposure = 1.5F;
    for (const float degrees : {0.0F, 30.0F, 90.0F, -45.0F, 210.0F}) {
        CAPTURE(degrees);
        seen.polarizer_angle = degrees;
        const double twice = 2 * double(degrees) * pi / 180;
        const auto passed = [&](const float* s) {
            return std::exp2(1.5) * 0.5 *
                   (double(s[0]) + std::cos(twice) * double(s[1]) + std::sin(twice) * double(s[2]));
        };
        nicol_texture_target target = into(exact);
        OK(nicol_framebuffer_draw_observation(show.stage.framebuffer, &seen, &target));
        CHECK(largest_difference(texels(gl, exact), image(show.stokes, passed)) < 1e-5);
        target.encoding = NICOL_ENCODING_SRGB;
        for (const GLuint texture : {exact, coded, coded_srgb}) {
            target.texture = texture;
            OK(nicol_framebuffer_draw_observation(show.stage.framebuffer, &seen, &target));
            std::vector<float> expected = image(show.stokes, [&](const float* s) { return srgb(passed(s)); });
            if (texture == exact) {
                CHECK(largest_difference(texels(gl, texture), expected) < 1e-4);
                continue;
            }
            for (float& value : expected) value *= 255;
            std::vector<std::uint8_t> codes(expected.size());
            gl.GetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(codes.size()),
                               codes.data());
            CHECK(largest_difference(codes, expected) < 0.56);  // the encoding's powers have few bits
        }
    }
}

HOST_TEST_CASE("the other images are those of the planes") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const nicol_texture_target target = into(texture_of(gl, GL_RGBA32F));
    const auto drawn = [&](nicol_observation_kind kind, float scale) {
        nicol_observation seen = NICOL_OBSERVATION_INIT;
        seen.kind = kind;
        seen.scale = scale;
        OK(nicol_framebuffer_draw_observation(show.stage.framebuffer, &seen, &target));
        return texels(gl, target.texture);
    };
    CHECK(largest_difference(drawn(NICOL_OBSERVATION_S0, 0),
                             image(show.stokes, [](const float* s) { return s[0]; })) == 0);
    const std::size_t plane = std::size_t{4} * width * height;
    std::vector<float> degree = drawn(NICOL_OBSERVATION_DOLP, 0), angle = drawn(NICOL_OBSERVATION_AOLP, 0),
                       positive = drawn(NICOL_OBSERVATION_S1, 0.25F);
    for (std::size_t i = 0; i < plane; i += 4) {
        double s[3] = {};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) s[k] += double(show.stokes[c * plane + i + k]) / 3;
        const double dolp = s[0] > 0 ? std::min(1.0, std::hypot(s[1], s[2]) / s[0]) : 0;
        REQUIRE(double(degree[i]) == doctest::Approx(dolp).epsilon(1e-4));
        REQUIRE(double(positive[i + 1] - positive[i]) == doctest::Approx(4 * s[1]).epsilon(1e-4));
        REQUIRE(std::min(positive[i], positive[i + 1]) == 0);
        // The colour is red at 0 degrees and cyan at 90 degrees, and its brightest component is the DoLP.
        REQUIRE(double(std::max({angle[i], angle[i + 1], angle[i + 2]})) ==
                doctest::Approx(dolp).epsilon(1e-4));
        if (dolp > 0.1 && std::abs(s[2]) < 0.1 * std::abs(s[1]))
            REQUIRE((angle[i] > angle[i + 2]) == (s[1] > 0));
    }
}

HOST_TEST_CASE("targets that cannot be drawn into are refused by name") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const nicol_framebuffer framebuffer = show.stage.framebuffer;
    const nicol_observation seen = NICOL_OBSERVATION_INIT;
    const auto refused = [&](GLuint texture, const char* text) {
        const nicol_texture_target target = into(texture);
        REFUSES(nicol_framebuffer_draw_observation(framebuffer, &seen, &target), text);
        REFUSES(nicol_framebuffer_draw_stokes(framebuffer, 0, &target), text);
        CHECK(gl.GetError() == GL_NO_ERROR);
    };
    refused(0, "does not exist");
    refused(12345, "does not exist");
    GLuint named = 0, cube = 0, unsized = 0;
    gl.GenTextures(1, &named);
    refused(named, "does not exist");
    gl.CreateTextures(GL_TEXTURE_CUBE_MAP, 1, &cube);
    gl.TextureStorage2D(cube, 1, GL_RGBA8, 16, 16);
    refused(cube, "GL_TEXTURE_2D");
    gl.CreateTextures(GL_TEXTURE_2D, 1, &unsized);
    refused(unsized, "no pixels");
    refused(texture_of(gl, GL_R32F), "internal format");
    refused(texture_of(gl, GL_RGBA8, width, height + 1), "24 x 17");
    nicol_gl_texture own = NICOL_GL_TEXTURE_INIT;
    OK(nicol_framebuffer_get_texture(framebuffer, 2, &own));
    refused(own.name, "own");
    CHECK(read_all(framebuffer) == show.stokes);

    nicol_texture_target target = into(texture_of(gl, GL_RGBA8));
    const auto draw = nicol_framebuffer_draw_observation;
    check_refused({
        {"channel", [&] { return nicol_framebuffer_draw_stokes(framebuffer, 3, &target); }},
        {"channel", [&] { return nicol_framebuffer_get_texture(framebuffer, 3, &own); }},
        {"texture", [&] { return nicol_framebuffer_get_texture(framebuffer, 0, nullptr); }},
        {"observation", [&] { return draw(framebuffer, nullptr, &target); }},
        {"target", [&] { return draw(framebuffer, &seen, nullptr); }},
    });
    using T = nicol_texture_target;
    check_wrong(target, [&](const T& wrong) { return draw(framebuffer, &seen, &wrong); },
                {{"bottom_up", [](T& t) { t.bottom_up = 2; }}, {"encoding", [](T& t) { t.encoding = 2; }}});
    using O = nicol_observation;
    check_wrong(
        seen, [&](const O& wrong) { return draw(framebuffer, &wrong, &target); },
        {{"kind", [](O& o) { o.kind = 99; }},
         {"polarizer_angle", [](O& o) { o.kind = NICOL_OBSERVATION_POLARIZER, o.polarizer_angle = NAN; }},
         {"exposure", [](O& o) { o.kind = NICOL_OBSERVATION_POLARIZER, o.exposure = INFINITY; }},
         {"scale", [](O& o) { o.kind = NICOL_OBSERVATION_S2, o.scale = -1; }}});
    Application::leave();
    FAILS(nicol_framebuffer_draw_observation(framebuffer, &seen, &target), NICOL_ERROR_NOT_CURRENT,
          "not current");
    show.application.enter();
}

HOST_TEST_CASE("many channels are seen as their mean, but not as colours") {
    const Application application;
    const Owned context(make_host_context());
    const Owned framebuffer(framebuffer_of(context, width, height, 16));
    const nicol_texture_target target = into(texture_of(application.gl, GL_RGBA16F));
    nicol_observation seen = NICOL_OBSERVATION_INIT;
    REFUSES(nicol_framebuffer_draw_observation(framebuffer, &seen, &target), "16 channels");
    seen.kind = NICOL_OBSERVATION_DOLP;
    OK(nicol_framebuffer_draw_observation(framebuffer, &seen, &target));
    const std::vector<float> black = texels(application.gl, target.texture);
    for (std::size_t i = 0; i < black.size(); ++i) REQUIRE(black[i] == (i % 4 == 3 ? 1 : 0));
}

STAGE_TEST_CASE("a context of our own shares no textures") {
    nicol_gl_texture texture = NICOL_GL_TEXTURE_INIT;
    const nicol_texture_target target = into(1);
    const nicol_observation seen = NICOL_OBSERVATION_INIT;
    const nicol_framebuffer framebuffer = stage.framebuffer;
    const auto code = NICOL_ERROR_UNSUPPORTED;
    FAILS(nicol_framebuffer_get_texture(framebuffer, 0, &texture), code, "own");
    FAILS(nicol_framebuffer_draw_stokes(framebuffer, 0, &target), code, "own");
    FAILS(nicol_framebuffer_draw_observation(framebuffer, &seen, &target), code, "own");
    CHECK(texture.name == 0);
}
