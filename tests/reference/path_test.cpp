// SPDX-License-Identifier: MIT
// Tests of paths that several surfaces reflect: closed forms, an independent quadrature, and invariances.
#include <climits>

#include "directions.hpp"
#include "image_difference.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;
using Kind = LocalLight::Kind;

namespace {

EmissionPtr emission(const Emission& emission) {
    return std::make_shared<const Emission>(emission);
}

Instance body(Mesh mesh, const MaterialPtr& material, const glm::dmat4& to_world = glm::dmat4(1.0)) {
    return {
        .mesh = std::make_shared<const Mesh>(std::move(mesh)), .material = material, .to_world = to_world};
}

std::vector<Stokes> pixel(const Scene& scene, const Camera& camera, int samples, int max_depth,
                          Strategy strategy = Strategy::both, std::uint64_t seed = 0) {
    const StokesImage image =
        render(scene, camera, 1, 1, {.samples = samples, .max_depth = max_depth, .seed = seed}, strategy);
    std::vector<Stokes> out;
    for (int c = 0; c < image.channels; ++c) out.push_back(image.stokes(c, 0, 0));
    return out;
}

/// Returns five walls of a cube of half side 2, which is open towards +z.
Scene open_box(const MaterialPtr& material) {
    Scene scene;
    const glm::dvec3 normals[] = {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    for (const glm::dvec3& normal : normals)
        scene.add(square(material, theta_phi_frame(normal), -2.0 * normal, 2));
    return scene;
}

/// Returns the linear part as a tensor in space, in which no choice of frame can hide an error.
glm::dmat3 tensor(const Stokes& s, const Frame& f) {
    return s[1] * (glm::outerProduct(f[0], f[0]) - glm::outerProduct(f[1], f[1])) +
           s[2] * (glm::outerProduct(f[0], f[1]) + glm::outerProduct(f[1], f[0]));
}

/// Light in space, without a frame.
struct Light {
    double s0 = 0, s3 = 0;
    glm::dmat3 linear{0.0};

    Light() = default;
    Light(const Stokes& s, const Frame& f) : s0(s[0]), s3(s[3]), linear(tensor(s, f)) {}
    [[nodiscard]] Stokes in(const Frame& f) const {
        return {s0, glm::dot(f[0], linear * f[0]), glm::dot(f[0], linear * f[1]), s3};
    }
};

/// Returns what a surface of this frame reflects of light from one direction of the world to another, cosine
/// included.
Light reflected(const Material& material, const Frame& surface, const Light& light,
                const glm::dvec3& towards_light, const glm::dvec3& towards_viewer) {
    const glm::dvec3 in = glm::transpose(surface) * towards_light;
    const glm::dvec3 out = glm::transpose(surface) * towards_viewer;
    const Stokes arriving = light.in(surface * theta_phi_frame(-in));
    return {in.z * (evaluate(material, 0, in, out) * arriving), surface * theta_phi_frame(out)};
}

/// Returns a corner of two walls and a floor that reflect glossily, with lights of every kind with a size.
Scene glossy_corner(const glm::dmat3& rotation = glm::dmat3(1.0)) {
    Scene scene;
    const auto add = [&](Instance instance) {
        instance.to_world = glm::dmat4(rotation) * instance.to_world;
        scene.add(instance);
    };
    const MaterialPtr material = pplastic({.diffuse_reflectance = {0.2}, .alpha = 0.3});
    for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
        add(square(material, theta_phi_frame(normal), glm::dvec3(2) - 3.0 * normal, 3));
    const Frame down(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
    Instance lamp = square(material, down, {1, 1, 3}, 0.5);
    lamp.emission = emission({.radiance = {4}, .state = {.dolp = 0.8, .aolp = 0.4, .docp = 0.3}});
    add(lamp);
    scene.add_light({.kind = Kind::directional,
                     .value = {1},
                     .to_world = glm::dmat4(rotation * theta_phi_frame(-direction(0.7, 0.6))),
                     .angular_radius = 0.3,
                     .state = {.dolp = 0.9, .axis = {0.3, 1, 0}}});
    scene.set_environment(rayleigh_sky({.sun_direction = {1, 1, 1}, .radiance = {0.5}}), rotation, 1);
    return scene;
}

}  // namespace

TEST_CASE("what absorbs nothing cannot be seen under even light") {
    Scene scene = open_box(twosided(diffuse({1})));
    scene.add(body(make_sphere(), diffuse({1})));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    const Camera camera = camera_on({1.8, 1.2, -2}, {-0.2, -0.1, 1});
    double before = 0;
    for (const int depth : {2, 3, 6}) {
        const double now = pixel(scene, camera, 1 << 12, depth)[0][0];
        CHECK(now > before);
        CHECK(now < 0.97);
        before = now;
    }
    // Most of this light takes more than the five reflections after which Russian roulette sets in.
    const Stokes all = pixel(scene, camera, 1 << 14, kUnlimitedDepth)[0];
    CHECK(all[0] == doctest::Approx(1).epsilon(0.01));
    for (int p = 1; p < 4; ++p) CHECK(all[p] == 0);
}

TEST_CASE("inside a closed room that emits light e, reflections of albedo a add up to e / (1 - a)") {
    const double albedos[] = {0.2, 0.5, 0.8};
    for (const bool round : {false, true}) {
        Scene scene;
        Instance room = body(round ? make_sphere() : make_cube(), twosided(diffuse({0.2, 0.5, 0.8})),
                             glm::scale(glm::dmat4(1.0), glm::dvec3(5)));
        room.emission = emission({.radiance = {1, 2, 3}, .two_sided = true});
        scene.add(room);
        const glm::dvec3 wall = round ? 5.0 * glm::normalize(glm::dvec3(0.1, 0.2, -1)) : glm::dvec3(1, 2, -5);
        const Camera camera = camera_on(wall, {0.2, -0.3, 1});
        for (const int depth : {1, 2, 3, 5, 8, kUnlimitedDepth}) {
            const std::vector<Stokes> ours = pixel(scene, camera, 1 << 13, depth);
            REQUIRE(ours.size() == 3);
            for (std::size_t c = 0; c < 3; ++c) {
                CAPTURES(round, depth, c);
                const double emitted = static_cast<double>(c + 1);
                const double wanted = emitted * (1 - std::pow(albedos[c], depth)) / (1 - albedos[c]);
                CHECK(ours[c][0] == doctest::Approx(wanted).epsilon(0.015));
                for (int p = 1; p < 4; ++p) CHECK(ours[c][p] == 0);
            }
        }
    }
}

TEST_CASE("polarized light that two patches reflect is the integral over the first") {
    const MaterialPtr first = pplastic({.diffuse_reflectance = {0.2}, .alpha = 0.3});
    const MaterialPtr second = pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.4});
    const Frame facing = frame_with_x(glm::normalize(glm::dvec3(-1, 0.1, -0.7)), {0.2, 1, 0.1});
    const Frame tilted = frame_with_x(glm::normalize(glm::dvec3(0.2, -0.1, 1)), {1, 0.3, 0.2});
    const glm::dvec3 center(1.5, 0.2, 1.1);
    constexpr double half = 0.4;
    // The light comes from below the second patch's horizon.
    const glm::dvec3 towards_light = glm::normalize(glm::dvec3(-1, 0.8, -0.2));
    const LocalLight light{.kind = Kind::directional,
                           .value = {2},
                           .to_world = glm::dmat4(theta_phi_frame(-towards_light)),
                           .state = {.dolp = 0.7, .aolp = 0.5, .docp = 0.6}};
    const glm::dvec3 towards_viewer = glm::normalize(glm::dvec3(-0.8, 0.4, 0.6));
    Scene scene;
    scene.add(square(second, tilted, {0, 0, 0}, 0.02));
    scene.add(square(first, facing, center, half));
    scene.add_light(light);
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    CHECK(pixel(scene, camera, 64, 2)[0] == Stokes(0.0));
    const Stokes ours = pixel(scene, camera, 1 << 17, 3)[0];

    const Frame of_light = theta_phi_frame(-towards_light);
    const Light arriving(
        2.0 * stokes_in(of_light, light.state, glm::dmat3(light.to_world) * light.state.axis), of_light);
    const Frame received = project(camera, 1, 1).view.frame(towards_viewer);
    Stokes wanted(0.0);
    constexpr int grid = 64;
    for (int i = 0; i < grid * grid; ++i) {
        const double x = half * ((i % grid + 0.5) / grid * 2 - 1);
        const double y = half * ((i / grid + 0.5) / grid * 2 - 1);
        const glm::dvec3 place = center + x * facing[0] + y * facing[1];
        const double distance = glm::length(place);
        const glm::dvec3 towards_place = place / distance;
        const Light between = reflected(*first, facing, arriving, towards_light, -towards_place);
        const double solid_angle =
            -glm::dot(facing[2], towards_place) / (distance * distance) * (4 * half * half / (grid * grid));
        wanted +=
            solid_angle * reflected(*second, tilted, between, towards_place, towards_viewer).in(received);
    }
    CHECK(glm::length(glm::dvec2(wanted[1], wanted[2])) > 0.2 * wanted[0]);
    CHECK(std::abs(wanted[3]) > 0.01 * wanted[0]);
    for (int p = 0; p < 4; ++p) {
        CAPTURES(p);
        CHECK(std::abs(ours[p] - wanted[p]) < 3e-3 * wanted[0]);
    }
}

TEST_CASE("light that surfaces emit, and that of the sky, counts once on a path, by every strategy") {
    const Scene scene = glossy_corner();
    const Camera camera = camera_on({0, 0.3, -1}, {0.9, 0.5, 0.5});
    const Stokes direct = pixel(scene, camera, 1 << 13, 2)[0];
    const Stokes both = pixel(scene, camera, 1 << 15, 5)[0];
    CHECK(both[0] > 1.1 * direct[0]);
    CHECK(glm::length(glm::dvec2(both[1], both[2])) > 0.02 * both[0]);
    for (const Strategy strategy : {Strategy::light, Strategy::surface}) {
        const Stokes other = pixel(scene, camera, 1 << 17, 5, strategy, 2)[0];
        for (int p = 0; p < 4; ++p) CHECK(std::abs(other[p] - both[p]) < 8e-3 * both[0]);
    }
}

TEST_CASE("a rotation of the scene with its camera leaves the image") {
    const glm::dmat3 rotation = frame_with_x(glm::normalize(glm::dvec3(0.3, -0.5, 0.7)), {1, 0.2, 0.1});
    Camera camera = camera_on({0, 0.3, -1}, {0.9, 0.5, 0.5});
    const Stokes upright = pixel(glossy_corner(), camera, 1 << 15, 6)[0];
    camera.to_world = glm::dmat4(rotation) * camera.to_world;
    const Stokes turned = pixel(glossy_corner(rotation), camera, 1 << 15, 6)[0];
    for (int p = 0; p < 4; ++p) CHECK(std::abs(turned[p] - upright[p]) < 5e-3 * upright[0]);
}

TEST_CASE("the camera alone sees light of depth 1") {
    Scene scene;
    Instance lamp = square(diffuse({0.5}));
    lamp.emission = emission({.radiance = {3}});
    scene.add(lamp);
    scene.set_environment(constant_environment({2}), glm::dmat3(1.0), 1);
    CHECK(pixel(scene, camera_on({0, 0, 0}, {0.2, 0.1, 1}), 16, 1)[0] == Stokes(3, 0, 0, 0));
    CHECK(pixel(scene, camera_on({5, 0, 0}, {0.2, 0.1, 1}), 16, 1)[0] == Stokes(2, 0, 0, 0));
    CHECK(pixel(scene, camera_on({0, 0, 0}, {0.2, 0.1, 1}), 1 << 12, 2)[0][0] ==
          doctest::Approx(4).epsilon(1e-3));
}

TEST_CASE("paths of a seed are the same with any number of threads") {
    const Scene scene = glossy_corner();
    Camera camera;
    camera.to_world = look_at({6, 5, 4}, {0, 0, 0}, {0, 0, 1});
    const auto images = [&](int threads, std::uint64_t seed) {
        return render(
            scene, camera, 21, 13,
            {.samples = 4, .max_depth = kUnlimitedDepth, .seed = seed, .workers = {.threads = threads}});
    };
    const StokesImage one = images(1, 5);
    CHECK(images(3, 5).data == one.data);
    CHECK(images(1, 6).data != one.data);
}

TEST_CASE("depths that are none, and reflections between surfaces that hide nothing, are refused") {
    const Scene scene = glossy_corner();
    const Camera camera;
    const auto refused = [&](const ReferenceOptions& options, const std::string& part) {
        check_error(ErrorCode::invalid_argument, CALL(render(scene, camera, 2, 2, options)), part);
    };
    refused({.samples = 1, .max_depth = 0}, "max_depth is 0; it must be 1 or more");
    refused({.samples = 1, .max_depth = 3, .shadows = false}, "max_depth to 2");
}
