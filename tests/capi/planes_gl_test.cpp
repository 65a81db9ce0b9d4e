// SPDX-License-Identifier: MIT
// Depth, normals, positions and instances of surfaces against what geometry says.
#include "capi.hpp"
#include "planes.hpp"

using namespace capi_test;

namespace {

using Vec = std::array<double, 3>;

double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Of a camera at (0, 0, distance) that looks at the origin with 45 degrees across; not normalized: z is -1.
Vec ray_through(std::size_t x, std::size_t y, std::uint32_t width, std::uint32_t height) {
    const double half = std::tan(std::acos(-1.0) / 8);
    const auto w = static_cast<double>(width), h = static_cast<double>(height);
    return {half * (2 * (static_cast<double>(x) + 0.5) / w - 1),
            half * h / w * (1 - 2 * (static_cast<double>(y) + 0.5) / h), -1};
}

// The depth at which the ray from (0, 0, distance) first meets the unit sphere about a centre. None near the
// outline, where a mesh differs from its sphere: `sure` says whether it is neither there nor beside it.
std::optional<double> sphere_depth(const Vec& ray, double distance, const Vec& centre, double radius,
                                   bool& sure) {
    const Vec from = {-centre[0], -centre[1], distance - centre[2]};
    const double a = dot(ray, ray), b = dot(ray, from), c = dot(from, from) - radius * radius;
    const double root = b * b - a * c;
    sure = std::abs(root) > 0.05 * radius * radius;
    if (root <= 0) return std::nullopt;
    return (-b - std::sqrt(root)) / a;
}

struct Assets {
    Owned<nicol_environment> light;
    Owned<nicol_mesh> sphere, rectangle;
    Owned<nicol_material> plain, both;

    explicit Assets(nicol_context context)
        : light(constant_light(context, {1})),
          sphere(capi_test::sphere(context)),
          rectangle(capi_test::rectangle(context)),
          plain(diffuse(context, {0.5F})) {
        OK(nicol_material_create_twosided(context, plain, &both));
    }
};

constexpr std::uint32_t width = 48, height = 32;
constexpr float infinity = std::numeric_limits<float>::infinity();

void check_sphere(const Surfaces& seen, double distance, const Vec& centre, double radius, std::uint32_t id) {
    std::size_t hits = 0;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            const Vec ray = ray_through(x, y, width, height);
            bool sure = false;
            const std::optional<double> depth = sphere_depth(ray, distance, centre, radius, sure);
            if (!sure) continue;
            if (!depth) {
                CHECK(seen.depth[i] == infinity);
                CHECK(seen.instance[i] == NICOL_NO_INSTANCE);
                for (std::size_t k = 0; k < 3; ++k) {
                    CHECK(seen.normal[3 * i + k] == 0);
                    CHECK(seen.position[3 * i + k] == 0);
                }
                continue;
            }
            ++hits;
            CHECK(seen.instance[i] == id);
            CHECK(seen.depth[i] == doctest::Approx(*depth).epsilon(0.002));
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = (k == 2 ? distance : 0) + *depth * ray[k];
                CHECK(std::abs(seen.position[3 * i + k] - at) < 0.01);
                CHECK(std::abs(seen.normal[3 * i + k] - (at - centre[k]) / radius) < 0.02);
            }
        }
    }
    CHECK(hits > 60);
}

}  // namespace

TEST_CASE("a sphere has the planes of a sphere, before and after it moves, by every method") {
    on_every_backend([](nicol_context context) {
        const Assets assets(context);
        const Owned scene(empty_scene(context));
        OK(nicol_scene_set_environment(scene, assets.light, nullptr, 0));
        const std::uint32_t id = add(scene, assets.sphere, assets.plain, placed(0, 0, 0));
        const Owned framebuffer(framebuffer_of(context, width, height, 1));
        const nicol_camera camera = front_camera(5);
        for (const nicol_render_options& options : every_method()) {
            CAPTURE(options.method);
            OK(nicol_scene_set_transform(scene, id, placed(0, 0, 0).rows));
            OK(nicol_render(scene, &camera, &options, framebuffer));
            check_sphere(Surfaces(framebuffer), 5, {0, 0, 0}, 1, id);
            // Rotated and moved: normals and positions stay the world's.
            const Matrix moved = {{0, 0, 0.8, 0.5, 0.8, 0, 0, -0.25, 0, 0.8, 0, 0.75, 0, 0, 0, 1}};
            OK(nicol_scene_set_transform(scene, id, moved.rows));
            OK(nicol_render(scene, &camera, &options, framebuffer));
            check_sphere(Surfaces(framebuffer), 5, {0.5, -0.25, 0.75}, 0.8, id);
        }
    });
}

TEST_CASE("a plane seen at an angle, from its front, its back and as two sides") {
    on_every_backend([](nicol_context context) {
        const Assets assets(context);
        // Through the origin, its normal in x and z.
        const double c = std::cos(0.4), s = std::sin(0.4);
        for (const bool behind : {false, true}) {
            for (const bool two_sided : {false, true}) {
                CAPTURE(behind);
                CAPTURE(two_sided);
                const double side = behind ? -1 : 1;
                const Matrix to_world = {
                    {9 * side * c, 0, side * s, 0, 0, 9, 0, 0, -9 * side * s, 0, side * c, 0, 0, 0, 0, 1}};
                const Owned scene(empty_scene(context));
                add(scene, assets.rectangle, two_sided ? assets.both : assets.plain, to_world);
                const Owned framebuffer(framebuffer_of(context, width, height, 1));
                const nicol_camera camera = front_camera(4);
                for (const nicol_render_options& options : every_method()) {
                    CAPTURE(options.method);
                    OK(nicol_render(scene, &camera, &options, framebuffer));
                    const Surfaces seen(framebuffer);
                    const double sign = two_sided ? 1 : side;
                    for (std::size_t i = 0; i < seen.depth.size(); ++i) {
                        const Vec ray = ray_through(i % width, i / width, width, height);
                        const double depth = 4 * c / (c - s * ray[0]);
                        CHECK(seen.depth[i] == doctest::Approx(depth).epsilon(1e-5));
                        CHECK(seen.instance[i] == 0);
                        CHECK(seen.normal[3 * i] == doctest::Approx(sign * s).epsilon(1e-5));
                        CHECK(std::abs(seen.normal[3 * i + 1]) < 1e-6F);
                        CHECK(seen.normal[3 * i + 2] == doctest::Approx(sign * c).epsilon(1e-5));
                        CHECK(seen.position[3 * i] == doctest::Approx(depth * ray[0]).epsilon(1e-4));
                        CHECK(seen.position[3 * i + 1] == doctest::Approx(depth * ray[1]).epsilon(1e-4));
                        CHECK(std::abs(seen.position[3 * i + 2] - (4 - depth)) < 1e-4);
                    }
                }
            }
        }
    });
}

TEST_CASE("orthographic depth is along the camera's axis, in units of the scene") {
    on_every_backend([](nicol_context context) {
        const Assets assets(context);
        const Owned scene(empty_scene(context));
        add(scene, assets.rectangle, assets.plain, placed(0, 0, 1));
        const Owned framebuffer(framebuffer_of(context, 8, 8, 1));
        nicol_camera camera = front_camera(3.5);
        camera.projection = NICOL_PROJECTION_ORTHOGRAPHIC;
        for (const std::size_t i : {0U, 1U, 4U, 5U, 8U, 9U}) camera.to_world[i] *= 2;  // twice the rectangle
        for (const nicol_render_options& options : every_method()) {
            OK(nicol_render(scene, &camera, &options, framebuffer));
            const std::vector<float> depth = read_surface<float>(framebuffer, NICOL_PLANE_DEPTH, 1);
            for (std::size_t y = 0; y < 8; ++y) {
                for (std::size_t x = 0; x < 8; ++x) {
                    const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
                    if (inside) CHECK(depth[8 * y + x] == doctest::Approx(2.5).epsilon(1e-6));
                    if (!inside) CHECK(depth[8 * y + x] == infinity);
                }
            }
        }
    });
}

TEST_CASE("three instances have their ids, the nearest of them in front") {
    on_every_backend([](nicol_context context) {
        const Assets assets(context);
        const Owned scene(empty_scene(context));
        const std::uint32_t far = add(scene, assets.rectangle, assets.plain, placed(0, 0, -1, 9));
        const std::uint32_t left = add(scene, assets.sphere, assets.both, placed(-0.8, 0, 0, 0.5));
        const std::uint32_t right = add(scene, assets.sphere, assets.plain, placed(0.8, 0, 0, 0.5));
        const Owned framebuffer(framebuffer_of(context, width, height, 1));
        const nicol_camera camera = front_camera(4);
        for (const nicol_render_options& options : every_method()) {
            CAPTURE(options.method);
            OK(nicol_scene_set_transform(scene, right, placed(0.8, 0, 0, 0.5).rows));
            OK(nicol_render(scene, &camera, &options, framebuffer));
            const auto at = [&](std::size_t x, std::size_t y) {
                return read_surface<std::uint32_t>(framebuffer, NICOL_PLANE_INSTANCE, 1)[y * width + x];
            };
            CHECK(at(24, 16) == far);
            CHECK(at(12, 16) == left);
            CHECK(at(35, 16) == right);
            // Where the left one was, behind it.
            OK(nicol_scene_set_transform(scene, right, placed(-0.8, 0, -0.5, 0.4).rows));
            OK(nicol_render(scene, &camera, &options, framebuffer));
            CHECK(at(35, 16) == far);
            CHECK(at(12, 16) == left);
            OK(nicol_scene_set_transform(scene, right, placed(-0.8, 0, 0.7, 0.4).rows));
            OK(nicol_render(scene, &camera, &options, framebuffer));
            CHECK(at(12, 16) == right);
        }
        // The others keep their ids.
        OK(nicol_scene_remove_instance(scene, far));
        for (const nicol_render_options& options : every_method()) {
            CAPTURE(options.method);
            OK(nicol_render(scene, &camera, &options, framebuffer));
            const std::vector<std::uint32_t> ids =
                read_surface<std::uint32_t>(framebuffer, NICOL_PLANE_INSTANCE, 1);
            CHECK(ids[16 * width + 12] == right);
            CHECK(ids[16 * width + 24] == NICOL_NO_INSTANCE);
        }
    });
}

TEST_CASE("planes follow the mask of the last render, and nothing else is made") {
    on_every_stage([](const Stage& stage) {
        const struct {
            std::uint32_t bit;
            nicol_plane plane;
        } planes[] = {{NICOL_AOV_DEPTH, NICOL_PLANE_DEPTH},
                      {NICOL_AOV_NORMALS, NICOL_PLANE_NORMAL},
                      {NICOL_AOV_POSITIONS, NICOL_PLANE_POSITION},
                      {NICOL_AOV_INSTANCES, NICOL_PLANE_INSTANCE}};
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        nicol_statistics bare = NICOL_STATISTICS_INIT;
        OK(stage.try_render(options));
        OK(nicol_framebuffer_get_statistics(stage.framebuffer, &bare));
        const std::vector<float> image = read_all(stage.framebuffer);
        std::vector<std::uint32_t> pixels(24 * 16 * 3);
        const auto readable = [&](nicol_plane plane) {
            nicol_plane_buffer to = NICOL_PLANE_BUFFER_INIT;
            to.plane = plane;
            to.pixels = pixels.data();
            to.byte_size = pixels.size() * 4;
            const nicol_result result = nicol_framebuffer_read_plane(stage.framebuffer, &to);
            if (result != NICOL_OK) CHECK(result == NICOL_ERROR_INVALID_ARGUMENT);
            return result == NICOL_OK;
        };
        for (std::uint32_t mask = NICOL_AOV_ALL; mask > 0; --mask) {
            CAPTURE(mask);
            options.aovs = mask;
            OK(stage.try_render(options));
            for (const auto& [bit, plane] : planes) CHECK(readable(plane) == ((mask & bit) != 0));
            CHECK(read_all(stage.framebuffer) == image);
            // The same again: nothing runs, the planes stay.
            nicol_statistics again = NICOL_STATISTICS_INIT;
            OK(stage.try_render(options));
            OK(nicol_framebuffer_get_statistics(stage.framebuffer, &again));
            CHECK(again.draw_ms == 0);
            CHECK(again.texture_bytes > bare.texture_bytes);
            for (const auto& [bit, plane] : planes) CHECK(readable(plane) == ((mask & bit) != 0));
        }
        options.aovs = 0;
        OK(stage.try_render(options));
        for (const auto& [bit, plane] : planes) CHECK_FALSE(readable(plane));
        nicol_statistics after = NICOL_STATISTICS_INIT;
        OK(nicol_render(stage.scene, &stage.camera, nullptr, stage.framebuffer));
        OK(nicol_framebuffer_get_statistics(stage.framebuffer, &after));
        CHECK(after.texture_bytes == bare.texture_bytes);
    });
}

TEST_CASE("a render that is stopped leaves the planes of the one before") {
    on_every_stage([](const Stage& stage) {
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.aovs = NICOL_AOV_DEPTH;
        OK(stage.try_render(options));
        const std::vector<float> depth = read_surface<float>(stage.framebuffer, NICOL_PLANE_DEPTH, 1);
        options.aovs = NICOL_AOV_NORMALS;
        options.progress = [](void*, const char*, double) -> std::int32_t { return 0; };
        const nicol_camera other = front_camera(6);
        FAILS(nicol_render(stage.scene, &other, &options, stage.framebuffer), NICOL_ERROR_CANCELLED, "stop");
        CHECK(read_surface<float>(stage.framebuffer, NICOL_PLANE_DEPTH, 1) == depth);
    });
}

TEST_CASE("the luminance of a scene of three channels has planes too") {
    on_every_stage([](const Stage& stage) {
        const Owned grey(framebuffer_of(stage.context, 24, 16, 1));
        for (const nicol_render_options& options : every_method()) {
            OK(stage.try_render(options));
            OK(nicol_render(stage.scene, &stage.camera, &options, grey));
            const Surfaces colours(stage.framebuffer), seen(grey);
            CHECK(seen.depth == colours.depth);
            CHECK(seen.normal == colours.normal);
            CHECK(seen.position == colours.position);
            CHECK(seen.instance == colours.instance);
        }
    });
}
