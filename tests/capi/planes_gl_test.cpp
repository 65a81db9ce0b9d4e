// SPDX-License-Identifier: MIT
// Tests of depth, normals, positions and instances of surfaces against analytic geometry.
#include "planes.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t width = 48, height = 32;
constexpr float infinity = std::numeric_limits<float>::infinity();

// Returns the ray through pixel i of a camera that looks along -z with a 45-degree field of view. Its z is
// -1, so it is not normalized.
glm::dvec3 ray_through(std::size_t i) {
    const double half = std::tan(pi / 8);
    return {half * (2 * (static_cast<double>(i % width) + 0.5) / width - 1),
            half * height / width * (1 - 2 * (static_cast<double>(i / width) + 0.5) / height), -1};
}

glm::dvec3 vector_at(const std::vector<float>& plane, std::size_t i) {
    return {plane[3 * i], plane[3 * i + 1], plane[3 * i + 2]};
}

struct Ball {
    glm::dvec3 centre;
    double radius;
    std::uint32_t id;
};

// Checks balls seen from (0, 0, 5) in front of the plane z = -1 of instance `far`, or of nothing. Pixels at
// outlines are skipped, because there a mesh differs from its sphere.
void check_balls(nicol_framebuffer framebuffer, const std::vector<Ball>& balls, std::uint32_t far) {
    const Surfaces seen(framebuffer);
    const glm::dvec3 eye(0, 0, 5);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
        const glm::dvec3 ray = ray_through(i), found = vector_at(seen.position, i);
        bool sure = true;
        std::uint32_t id = far;
        double depth = far == NICOL_NO_INSTANCE ? HUGE_VAL : 6;
        glm::dvec3 normal(0, 0, 1);
        for (const Ball& ball : balls) {
            const glm::dvec3 from = eye - ball.centre;
            const double square = ball.radius * ball.radius, a = glm::dot(ray, ray), b = glm::dot(ray, from),
                         root = b * b - a * (glm::dot(from, from) - square);
            sure = sure && std::abs(root) > 0.05 * square;
            if (root <= 0 || (-b - std::sqrt(root)) / a >= depth) continue;
            id = ball.id;
            depth = (-b - std::sqrt(root)) / a;
            normal = (eye + depth * ray - ball.centre) / ball.radius;
        }
        if (!sure) continue;
        CHECK(seen.instance[i] == id);
        if (id == NICOL_NO_INSTANCE) {
            CHECK((seen.depth[i] == infinity && found == glm::dvec3(0)));
            CHECK(vector_at(seen.normal, i) == glm::dvec3(0));
            continue;
        }
        hits += id != far ? 1 : 0;
        CHECK(seen.depth[i] == doctest::Approx(depth).epsilon(0.002));
        CHECK(glm::distance(found, eye + depth * ray) < 0.01);
        CHECK(glm::distance(vector_at(seen.normal, i), normal) < 0.02);
    }
    CHECK(hits > 60);
}

struct Assets {
    Owned<nicol_mesh> sphere, rectangle;
    Owned<nicol_material> plain, both;
    Owned<nicol_scene> scene;

    explicit Assets(nicol_context context)
        : sphere(capi_test::sphere(context)),
          rectangle(capi_test::rectangle(context)),
          plain(diffuse(context, {0.5F})),
          both(make(nicol_material_create_twosided, context, plain)),
          scene(empty_scene(context)) {}
};

}  // namespace

CONTEXT_TEST_CASE("spheres have the planes and ids of spheres, wherever they move, by every method") {
    const Assets assets(context);
    const std::uint32_t far = add(assets.scene, assets.rectangle, assets.plain, placed(0, 0, -1, 9));
    const std::uint32_t left = add(assets.scene, assets.sphere, assets.both, placed(-0.8, 0, 0, 0.5));
    const std::uint32_t right = add(assets.scene, assets.sphere, assets.plain);
    const Owned framebuffer(framebuffer_of(context, width, height, 1));
    const nicol_camera camera = front_camera(5);
    // The right ball is also rotated. Normals and positions stay in world space.
    const auto check_at = [&](const glm::dvec3& c, double r, std::uint32_t behind) {
        OK(nicol_scene_set_transform(assets.scene, right,
                                     Matrix{0, 0, r, c.x, r, 0, 0, c.y, 0, r, 0, c.z, 0, 0, 0, 1}.rows));
        for (const nicol_render_options& options : every_method()) {
            CAPTURE(options.method);
            OK(nicol_render(assets.scene, &camera, &options, framebuffer));
            check_balls(framebuffer, {{{-0.8, 0, 0}, 0.5, left}, {c, r, right}}, behind);
        }
    };
    check_at({0.8, 0, 0}, 0.5, far);
    check_at({-0.8, 0, -0.5}, 0.4, far);  // behind the left ball
    check_at({-0.8, 0, 0.7}, 0.4, far);
    OK(nicol_scene_remove_instance(assets.scene, far));  // the other instances keep their ids
    check_at({0.5, -0.25, 0.75}, 0.8, NICOL_NO_INSTANCE);
}

CONTEXT_TEST_CASE("a plane seen at an angle, from its front, its back and as two sides") {
    const Assets assets(context);
    const Owned framebuffer(framebuffer_of(context, width, height, 1));
    const nicol_camera camera = front_camera(4);
    // The plane passes through the origin, and its normal lies in the x-z plane.
    const double c = std::cos(0.4), s = std::sin(0.4);
    for_all({1.0, -1.0}, {false, true}, [&](double side, bool two_sided) {
        CAPTURES(side, two_sided);
        const Owned scene(empty_scene(context));
        add(scene, assets.rectangle, two_sided ? assets.both : assets.plain,
            {{9 * side * c, 0, side * s, 0, 0, 9, 0, 0, -9 * side * s, 0, side * c, 0, 0, 0, 0, 1}});
        const double sign = two_sided ? 1 : side;
        for (const nicol_render_options& options : every_method()) {
            CAPTURE(options.method);
            OK(nicol_render(scene, &camera, &options, framebuffer));
            const Surfaces seen(framebuffer);
            for (std::size_t i = 0; i < seen.depth.size(); ++i) {
                const glm::dvec3 ray = ray_through(i), position = vector_at(seen.position, i);
                const double depth = 4 * c / (c - s * ray.x);
                CHECK(seen.depth[i] == doctest::Approx(depth).epsilon(1e-5));
                CHECK(seen.instance[i] == 0);
                CHECK(seen.normal[3 * i] == doctest::Approx(sign * s).epsilon(1e-5));
                CHECK(std::abs(seen.normal[3 * i + 1]) < 1e-6F);
                CHECK(seen.normal[3 * i + 2] == doctest::Approx(sign * c).epsilon(1e-5));
                CHECK(position.x == doctest::Approx(depth * ray.x).epsilon(1e-4));
                CHECK(position.y == doctest::Approx(depth * ray.y).epsilon(1e-4));
                CHECK(std::abs(position.z - (4 - depth)) < 1e-4);
            }
        }
    });
}

CONTEXT_TEST_CASE("orthographic depth is along the camera's axis, in units of the scene") {
    const Assets assets(context);
    add(assets.scene, assets.rectangle, assets.plain, placed(0, 0, 1));
    const Owned framebuffer(framebuffer_of(context, 8, 8, 1));
    nicol_camera camera = front_camera(3.5);
    camera.projection = NICOL_PROJECTION_ORTHOGRAPHIC;
    for (const std::size_t i : {0U, 1U, 4U, 5U, 8U, 9U}) camera.to_world[i] *= 2;  // double size
    for (const nicol_render_options& options : every_method()) {
        OK(nicol_render(assets.scene, &camera, &options, framebuffer));
        const std::vector<float> depth = read_surface<float>(framebuffer, NICOL_PLANE_DEPTH, 1);
        for (std::size_t i = 0; i < 64; ++i) {
            const bool inside = i % 8 >= 2 && i % 8 < 6 && i / 8 >= 2 && i / 8 < 6;
            if (inside) CHECK(depth[i] == doctest::Approx(2.5).epsilon(1e-6));
            if (!inside) CHECK(depth[i] == infinity);
        }
    }
}

STAGE_TEST_CASE("planes follow the mask of the last render, and nothing else is made") {
    const struct {
        std::uint32_t bit;
        nicol_plane plane;
    } planes[] = {{NICOL_AOV_DEPTH, NICOL_PLANE_DEPTH},
                  {NICOL_AOV_NORMAL, NICOL_PLANE_NORMAL},
                  {NICOL_AOV_POSITION, NICOL_PLANE_POSITION},
                  {NICOL_AOV_INSTANCE, NICOL_PLANE_INSTANCE},
                  {NICOL_AOV_ALPHA, NICOL_PLANE_ALPHA}};
    nicol_render_options options = plain_options();
    const std::vector<float> image = stage.image();
    const nicol_statistics bare = statistics_of(stage.framebuffer);
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
        if ((mask & NICOL_AOV_VARIANCE) != 0) continue;
        CAPTURE(mask);
        options.aovs = mask;
        OK(stage.try_render(options));
        for (const auto& [bit, plane] : planes) CHECK(readable(plane) == ((mask & bit) != 0));
        CHECK(read_all(stage.framebuffer) == image);
        // Repeating the render runs nothing and keeps the planes.
        OK(stage.try_render(options));
        const nicol_statistics again = statistics_of(stage.framebuffer);
        CHECK(again.draw_ms == 0);
        CHECK(again.texture_bytes > bare.texture_bytes);
        for (const auto& [bit, plane] : planes) CHECK(readable(plane) == ((mask & bit) != 0));
    }
    stage.render();
    for (const auto& [bit, plane] : planes) CHECK_FALSE(readable(plane));
    CHECK(statistics_of(stage.framebuffer).texture_bytes == bare.texture_bytes);
}

STAGE_TEST_CASE(
    "the variance is there after a render that asked for it, also of the luminance, and of no other") {
    const Owned grey(framebuffer_of(stage.context, 24, 16, 1));
    nicol_render_options options = with_variance();
    std::vector<float> pixels(24 * 16 * 4);
    const auto read = [&](nicol_framebuffer from) {
        return nicol_framebuffer_read(from, NICOL_PLANE_VARIANCE, 0, pixels.data(), 0, 4 * pixels.size());
    };
    for (const nicol_framebuffer framebuffer :
         {nicol_framebuffer(stage.framebuffer), nicol_framebuffer(grey)}) {
        options.aovs = NICOL_AOV_VARIANCE;
        OK(nicol_render(stage.scene, &stage.camera, &options, framebuffer));
        OK(read(framebuffer));
        CHECK(*std::ranges::min_element(pixels) >= 0);
        CHECK(*std::ranges::max_element(pixels) > 0);
        // Repeating the render runs nothing and keeps the plane.
        OK(nicol_render(stage.scene, &stage.camera, &options, framebuffer));
        CHECK(statistics_of(framebuffer).camera_rays == 0);
        OK(read(framebuffer));
        options.aovs = NICOL_AOV_DEPTH;
        OK(nicol_render(stage.scene, &stage.camera, &options, framebuffer));
        REFUSES(read(framebuffer), "NICOL_PLANE_VARIANCE is not there");
    }
}

STAGE_TEST_CASE("a render that is stopped leaves the planes of the one before") {
    nicol_render_options options = plain_options();
    options.aovs = NICOL_AOV_DEPTH;
    OK(stage.try_render(options));
    const std::vector<float> depth = read_surface<float>(stage.framebuffer, NICOL_PLANE_DEPTH, 1);
    options.aovs = NICOL_AOV_NORMAL;
    options.progress = [](void*, const char*, double) -> std::int32_t { return 0; };
    const nicol_camera other = front_camera(6);
    FAILS(nicol_render(stage.scene, &other, &options, stage.framebuffer), NICOL_ERROR_CANCELLED, "stop");
    CHECK(read_surface<float>(stage.framebuffer, NICOL_PLANE_DEPTH, 1) == depth);
}

STAGE_TEST_CASE(
    "a framebuffer of one channel shows the luminance of three, and planes too, by every method") {
    const Owned grey(framebuffer_of(stage.context, 24, 16, 1));
    for (const nicol_render_options& options : every_method()) {
        OK(stage.try_render(options));
        OK(nicol_render(stage.scene, &stage.camera, &options, grey));
        const Surfaces colours(stage.framebuffer), seen(grey);
        CHECK(seen.depth == colours.depth);
        CHECK(seen.normal == colours.normal);
        CHECK(seen.position == colours.position);
        CHECK(seen.instance == colours.instance);
        check_luminance(read_all(grey), read_all(stage.framebuffer), 1e-5);
        CHECK(statistics_of(grey).camera_rays == statistics_of(stage.framebuffer).camera_rays);
        CHECK(statistics_of(grey).order == statistics_of(stage.framebuffer).order);
    }
}
