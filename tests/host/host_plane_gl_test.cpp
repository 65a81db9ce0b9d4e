// SPDX-License-Identifier: MIT
// Tests of planes that stay on the device, and of images that share a depth buffer with the application.
#include "capi/planes.hpp"
#include "host/egl_host.hpp"

using namespace host_test;

namespace {

constexpr int width = 24, height = 16;
constexpr std::size_t pixel_count = std::size_t{width} * height;

GLuint texture_of(const GladGLContext& gl, GLenum format, int w = width) {
    GLuint texture = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, format, w, height);
    return texture;
}

template <class Number>
std::vector<Number> texels(const GladGLContext& gl, GLuint texture, GLenum components, GLenum type) {
    std::vector<Number> values(pixel_count * (components == GL_RGBA ? 4 : 1));
    gl.GetTextureImage(texture, 0, components, type, static_cast<GLsizei>(values.size() * sizeof(Number)),
                       values.data());
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    return values;
}

nicol_texture_target into(GLuint texture) {
    nicol_texture_target target = NICOL_TEXTURE_TARGET_INIT;
    target.texture = texture;
    return target;
}

/// Returns packed numbers as texels: components that are missing are 0, and alpha 1.
std::vector<float> as_texels(const std::vector<float>& numbers, std::size_t components) {
    std::vector<float> values(4 * pixel_count, 0);
    for (std::size_t p = 0; p < pixel_count; ++p) {
        values[4 * p + 3] = 1;
        std::copy_n(&numbers[components * p], components, &values[4 * p]);
    }
    return values;
}

struct PlaneCase {
    nicol_plane plane;
    std::size_t components;
    std::uint32_t aov;
};
constexpr PlaneCase kPlanes[] = {{NICOL_PLANE_S0, 1, 0},
                                 {NICOL_PLANE_S2, 1, 0},
                                 {NICOL_PLANE_STOKES, 4, 0},
                                 {NICOL_PLANE_DOLP, 1, 0},
                                 {NICOL_PLANE_AOLP, 1, 0},
                                 {NICOL_PLANE_DEPTH, 1, NICOL_AOV_DEPTH},
                                 {NICOL_PLANE_NORMAL, 3, NICOL_AOV_NORMAL},
                                 {NICOL_PLANE_POSITION, 3, NICOL_AOV_POSITION},
                                 {NICOL_PLANE_ALPHA, 1, NICOL_AOV_ALPHA}};

struct Show {
    Application application;
    Owned<nicol_context> context{make_host_context()};
    Stage stage{context};

    void render(nicol_method method, std::uint32_t aovs) const {
        nicol_render_options options = plain_options();
        options.method = method;
        options.samples = 2;
        options.aovs = aovs;
        OK(stage.try_render(options));
    }
};

/// A host's projection, and its depth of a distance.
struct DepthCase {
    nicol_depth_mapping mapping;
    float near, far;
    double (*depth)(double z);
    bool reversed;
};
constexpr DepthCase kDepths[] = {
    {NICOL_DEPTH_MAPPING_PERSPECTIVE, 0.5F, 8,
     [](double z) { return (1 / 0.5 - 1 / z) / (1 / 0.5 - 1 / 8.0); }, false},
    {NICOL_DEPTH_MAPPING_PERSPECTIVE, 0.5F, 0, [](double z) { return 1 - 0.5 / z; }, false},
    {NICOL_DEPTH_MAPPING_PERSPECTIVE_REVERSED, 0.5F, 8,
     [](double z) { return (1 / z - 1 / 8.0) / (1 / 0.5 - 1 / 8.0); }, true},
    {NICOL_DEPTH_MAPPING_PERSPECTIVE_REVERSED, 0.5F, 0, [](double z) { return 0.5 / z; }, true},
    {NICOL_DEPTH_MAPPING_ORTHOGRAPHIC, -1, 8, [](double z) { return (z + 1) / 9; }, false},
    {NICOL_DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED, -1, 8, [](double z) { return (8 - z) / 9; }, true}};

}  // namespace

HOST_TEST_CASE("planes in the application's textures have the numbers that are read") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const nicol_framebuffer framebuffer = show.stage.framebuffer;
    nicol_texture_target target = into(texture_of(gl, GL_RGBA32F));
    // Each pair of AOVs is packed in other attachments, and the reference method makes them without drawing.
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE})
        for (const std::uint32_t aovs :
             {NICOL_AOV_ALL, NICOL_AOV_NORMAL | NICOL_AOV_POSITION, NICOL_AOV_POSITION | NICOL_AOV_ALPHA}) {
            show.render(method, aovs);
            for (const PlaneCase& p : kPlanes) {
                if ((p.aov & aovs) != p.aov) continue;
                CAPTURES(method, aovs, p.plane);
                OK(nicol_framebuffer_draw_plane(framebuffer, p.plane, 0, &target));
                const auto drawn = texels<float>(gl, target.texture, GL_RGBA, GL_FLOAT);
                const std::vector<float> wanted =
                    as_texels(read_surface<float>(framebuffer, p.plane, p.components), p.components);
                const bool computed = p.plane == NICOL_PLANE_DOLP || p.plane == NICOL_PLANE_AOLP;
                if (computed)
                    CHECK(largest_difference(drawn, wanted) < 1e-5);
                else
                    CHECK(drawn == wanted);
            }
            if ((aovs & NICOL_AOV_INSTANCE) == 0) continue;
            const nicol_texture_target ids = into(texture_of(gl, GL_R32UI));
            OK(nicol_framebuffer_draw_plane(framebuffer, NICOL_PLANE_INSTANCE, 0, &ids));
            CHECK(texels<std::uint32_t>(gl, ids.texture, GL_RED_INTEGER, GL_UNSIGNED_INT) ==
                  read_surface<std::uint32_t>(framebuffer, NICOL_PLANE_INSTANCE, 1));
        }
    const nicol_texture_target single = into(texture_of(gl, GL_R32F));
    OK(nicol_framebuffer_draw_plane(framebuffer, NICOL_PLANE_S1, 2, &single));
    CHECK(texels<float>(gl, single.texture, GL_RED, GL_FLOAT) == read_plane(framebuffer, NICOL_PLANE_S1, 2));
}

HOST_TEST_CASE("an image and the application's surfaces hide each other by depth") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const nicol_framebuffer framebuffer = show.stage.framebuffer;
    show.render(NICOL_METHOD_FACTORED, NICOL_AOV_DEPTH);
    const std::vector<float> distances = read_plane(framebuffer, NICOL_PLANE_DEPTH);
    const std::vector<float> s0 = read_plane(framebuffer, NICOL_PLANE_S0);
    // The application's surface is a plane before a part of the body, which is 2.2 to 3.8 away.
    constexpr double wall = 2.9;
    for (const DepthCase& c : kDepths)
        for (const GLenum format : {GLenum{GL_DEPTH_COMPONENT32F}, GLenum{GL_DEPTH24_STENCIL8}})
            for (const bool bottom_up : {false, true}) {
                CAPTURES(c.mapping, c.far, format, bottom_up);
                nicol_texture_target target = into(texture_of(gl, GL_RGBA32F));
                target.bottom_up = bottom_up ? 1 : 0;
                target.depth_texture = texture_of(gl, format);
                target.depth_mapping = c.mapping;
                target.depth_near = c.near;
                target.depth_far = c.far;
                // The left half has the wall, the right half nothing.
                const auto nothing = c.reversed ? 0.0F : 1.0F;
                GLuint host = 0;
                gl.CreateFramebuffers(1, &host);
                gl.NamedFramebufferTexture(host, GL_DEPTH_ATTACHMENT, target.depth_texture, 0);
                gl.ClearNamedFramebufferfv(host, GL_DEPTH, 0, &nothing);
                const auto wall_depth = static_cast<float>(c.depth(wall));
                gl.BindFramebuffer(GL_FRAMEBUFFER, host);
                gl.Enable(GL_SCISSOR_TEST);
                gl.Scissor(0, 0, width / 2, height);
                gl.ClearBufferfv(GL_DEPTH, 0, &wall_depth);
                gl.Disable(GL_SCISSOR_TEST);
                OK(nicol_framebuffer_draw_plane(framebuffer, NICOL_PLANE_S0, 0, &target));

                const auto drawn = texels<float>(gl, target.texture, GL_RGBA, GL_FLOAT);
                const auto depth = texels<float>(gl, target.depth_texture, GL_DEPTH_COMPONENT, GL_FLOAT);
                int hidden = 0, shown = 0;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        const auto at = static_cast<std::size_t>(y * width + x);
                        const auto from =
                            static_cast<std::size_t>((bottom_up ? height - 1 - y : y) * width + x);
                        const double distance = double(distances[from]);
                        const bool behind = x < width / 2 && distance > wall;
                        hidden += behind && std::isfinite(distance) ? 1 : 0;
                        shown += !behind && std::isfinite(distance) && x < width / 2 ? 1 : 0;
                        REQUIRE(drawn[4 * at] == (behind ? 0 : s0[from]));
                        REQUIRE(drawn[4 * at + 3] == (behind ? 0 : 1));
                        const double wanted = behind                    ? double(wall_depth)
                                              : std::isfinite(distance) ? c.depth(distance)
                                                                        : double(nothing);
                        REQUIRE(double(depth[at]) == doctest::Approx(wanted).epsilon(1e-6));
                    }
                CHECK(hidden > 5);
                CHECK(shown > 5);
                gl.DeleteFramebuffers(1, &host);
            }
    // Observations take part alike.
    nicol_texture_target target = into(texture_of(gl, GL_RGBA32F));
    target.depth_texture = texture_of(gl, GL_DEPTH_COMPONENT32F);
    target.depth_near = 1;
    const nicol_observation seen = NICOL_OBSERVATION_INIT;
    const GLfloat nearest = 0;
    gl.ClearTexImage(target.depth_texture, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &nearest);
    OK(nicol_framebuffer_draw_observation(framebuffer, &seen, &target));
    CHECK(texels<float>(gl, target.texture, GL_RGBA, GL_FLOAT) == std::vector<float>(4 * pixel_count, 0));
}

HOST_TEST_CASE("a framebuffer's images may be textures of the application") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    // Five channels take two groups of attachments.
    std::vector<std::uint32_t> textures;
    for (int c = 0; c < 5; ++c) textures.push_back(texture_of(gl, GL_RGBA32F));
    for (const std::uint32_t channels : {3U, 1U}) {
        CAPTURE(channels);
        Owned<nicol_framebuffer> lent(
            make(nicol_framebuffer_create_textures, show.context, textures.data(), channels));
        const Owned own(framebuffer_of(show.context, width, height, channels));
        for (const auto shown : {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE}) {
            nicol_render_options options = plain_options();
            options.method = shown;
            options.samples = 2;
            OK(nicol_render(show.stage.scene, &show.stage.camera, &options, lent));
            OK(nicol_render(show.stage.scene, &show.stage.camera, &options, own));
            for (std::uint32_t c = 0; c < channels; ++c) {
                const auto image = texels<float>(gl, textures[c], GL_RGBA, GL_FLOAT);
                CHECK(image == read_plane(own, NICOL_PLANE_STOKES, c));
                CHECK(image == read_plane(lent, NICOL_PLANE_STOKES, c));
            }
        }
        nicol_gl_texture texture = NICOL_GL_TEXTURE_INIT;
        OK(nicol_framebuffer_get_texture(lent, channels - 1, &texture));
        CHECK(texture.name == textures[channels - 1]);
        FAILS(nicol_framebuffer_resize(lent, 8, 8), NICOL_ERROR_UNSUPPORTED, "of the host");
    }
    for (const std::uint32_t texture : textures) CHECK(gl.IsTexture(texture) == GL_TRUE);
    const Owned<nicol_framebuffer> many(
        make(nicol_framebuffer_create_textures, show.context, textures.data(), std::uint32_t{5}));
    CHECK(read_all(many).size() == 5 * 4 * pixel_count);

    nicol_framebuffer none = nullptr;
    const auto create = [&](std::vector<std::uint32_t> names) {
        const auto channels = static_cast<std::uint32_t>(names.size());
        return nicol_framebuffer_create_textures(show.context, names.data(), channels, &none);
    };
    GLuint loose = 0;
    gl.GenTextures(1, &loose);
    gl.BindTexture(GL_TEXTURE_2D, loose);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    check_refused({
        {"channels is 0",
         [&] { return nicol_framebuffer_create_textures(show.context, textures.data(), 0, &none); }},
        {"channels is 17", [&] { return create(std::vector<std::uint32_t>(17, textures[0])); }},
        {"two channels",
         [&] {
             return create({textures[0], textures[0]});
         }},
        {"another size",
         [&] {
             return create({textures[0], texture_of(gl, GL_RGBA32F, 25)});
         }},
        {"must be GL_RGBA32F", [&] { return create({texture_of(gl, GL_RGBA16F)}); }},
        {"glTexStorage2D", [&] { return create({loose}); }},
        {"does not exist",
         [&] {
             return create({textures[0], 12345});
         }},
        {"textures is NULL",
         [&] { return nicol_framebuffer_create_textures(show.context, nullptr, 1, &none); }},
    });
    CHECK(none == nullptr);
    CHECK(gl.GetError() == GL_NO_ERROR);
}

HOST_TEST_CASE("planes and depths that cannot be drawn are refused by name") {
    const Show show;
    const GladGLContext& gl = show.application.gl;
    const nicol_framebuffer framebuffer = show.stage.framebuffer;
    show.render(NICOL_METHOD_FACTORED, 0);
    const nicol_texture_target colours = into(texture_of(gl, GL_RGBA32F));
    const auto draw = [&](nicol_plane plane, std::uint32_t channel, const nicol_texture_target& target) {
        return nicol_framebuffer_draw_plane(framebuffer, plane, channel, &target);
    };
    nicol_texture_target deep = colours;
    deep.depth_texture = texture_of(gl, GL_DEPTH_COMPONENT24);
    deep.depth_near = 0.1F;
    REFUSES(draw(NICOL_PLANE_S0, 0, deep), "NICOL_PLANE_DEPTH");
    show.render(NICOL_METHOD_REFERENCE, NICOL_AOV_ALL | NICOL_AOV_VARIANCE);
    OK(draw(NICOL_PLANE_S0, 0, deep));
    check_refused({
        {"plane is 14", [&] { return draw(14, 0, colours); }},
        {"nicol_framebuffer_draw_observation", [&] { return draw(NICOL_PLANE_POLARIZER, 0, colours); }},
        {"channel is 3", [&] { return draw(NICOL_PLANE_AOLP, 3, colours); }},
        {"channel must be 0", [&] { return draw(NICOL_PLANE_DEPTH, 1, colours); }},
        {"not on the device", [&] { return draw(NICOL_PLANE_VARIANCE, 0, colours); }},
        {"GL_R32UI", [&] { return draw(NICOL_PLANE_INSTANCE, 0, colours); }},
        {"GL_RGBA16F or GL_RGBA32F",
         [&] { return draw(NICOL_PLANE_NORMAL, 0, into(texture_of(gl, GL_R32F))); }},
        {"GL_R16F or GL_R32F", [&] { return draw(NICOL_PLANE_S0, 0, into(texture_of(gl, GL_R32UI))); }},
    });
    using T = nicol_texture_target;
    check_wrong(deep, [&](const T& wrong) { return draw(NICOL_PLANE_S0, 0, wrong); },
                {{"GL_DEPTH32F_STENCIL8", [&](T& t) { t.depth_texture = colours.texture; }},
                 {"does not exist", [](T& t) { t.depth_texture = 12345; }},
                 {"another size", [&](T& t) { t.depth_texture = texture_of(gl, GL_DEPTH_COMPONENT24, 25); }},
                 {"depth_mapping", [](T& t) { t.depth_mapping = 4; }},
                 {"depth_near is 0", [](T& t) { t.depth_near = 0; }},
                 {"depth_near is nan", [](T& t) { t.depth_near = NAN; }},
                 {"depth_far 0.05", [](T& t) { t.depth_far = 0.05F; }},
                 {"depth_far 0.00", [](T& t) { t.depth_mapping = NICOL_DEPTH_MAPPING_ORTHOGRAPHIC; }},
                 {"depth_far inf", [](T& t) { t.depth_far = INFINITY; }}});
    CHECK(gl.GetError() == GL_NO_ERROR);
    const Owned many(framebuffer_of(show.context, width, height, 16));
    nicol_observation degree = NICOL_OBSERVATION_INIT;
    degree.kind = NICOL_OBSERVATION_DOLP;
    REFUSES(nicol_framebuffer_draw_observation(many, &degree, &deep), "at most 15 channels");
}
