// SPDX-License-Identifier: MIT
// Tests of lights without a size: closed forms, shadows and polarization.
#include "directions.hpp"
#include "function_texture.hpp"
#include "material/conductor.hpp"
#include "material/plastic.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;
using Kind = LocalLight::Kind;

namespace {

const glm::dvec3 aside = glm::normalize(glm::dvec3(0.4, -0.3, 1));

/// Returns the matrix of a light at `place` that emits along `direction`, with its +y as near as possible to
/// `up`.
glm::dmat4 shining(const glm::dvec3& direction, const glm::dvec3& place = glm::dvec3(0.0),
                   const glm::dvec3& up = {0.1, 1, 0.2}) {
    const glm::dvec3 z = glm::normalize(direction);
    const glm::dvec3 x = glm::normalize(glm::cross(up, z));
    glm::dmat4 to_world(glm::dmat3(x, glm::cross(z, x), z));
    to_world[3] = glm::dvec4(place, 1);
    return to_world;
}

/// Returns one sample at the origin, which has no noise because the lights have no size. `material` lies in
/// the plane z = 0 and faces +z.
std::vector<Stokes> lit(const std::vector<LocalLight>& lights, const MaterialPtr& material = diffuse({0.6}),
                        const glm::dvec3& towards_viewer = aside, int samples = 1) {
    Scene scene;
    scene.add(square(material));
    for (const LocalLight& light : lights) scene.add_light(light);
    return point(scene, camera_on({0, 0, 0}, towards_viewer), samples);
}

void check_close(const Stokes& ours, const Stokes& wanted, double tolerance) {
    for (int p = 0; p < 4; ++p) {
        CAPTURES(p, ours[p], wanted[p]);
        CHECK(std::abs(ours[p] - wanted[p]) <= tolerance * std::max(1e-3, wanted[0]));
    }
}

}  // namespace

TEST_CASE("a directional light makes a diffuse plane E rho / pi cos bright, in each channel") {
    for (const double zenith : {0.0, 0.5, 1.2, 1.5, 1.6, 3.0}) {
        const LocalLight light{
            .kind = Kind::directional, .value = {3, 2, 1}, .to_world = shining(-direction(zenith, 0.7))};
        const std::vector<Stokes> ours = lit({light}, diffuse({0.2, 0.4, 0.6}));
        REQUIRE(ours.size() == 3);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto i = static_cast<double>(c);
            const double wanted = (3 - i) * (0.2 + 0.2 * i) / pi * std::max(0.0, std::cos(zenith));
            CHECK(ours[c][0] == doctest::Approx(wanted).epsilon(1e-7));
            CHECK(glm::length(glm::dvec3(ours[c][1], ours[c][2], ours[c][3])) == 0);
        }
    }
}

TEST_CASE("a smooth surface reflects lights with a size alone") {
    const auto mirrored = [](double angular_radius, const MaterialPtr& material) {
        const LocalLight light{.kind = Kind::directional,
                               .value = {1},
                               .to_world = shining({aside.x, aside.y, -aside.z}),
                               .angular_radius = angular_radius};
        return lit({light}, material, aside, 64)[0][0];
    };
    const MaterialPtr mirror = conductor({{0, -1}});
    CHECK(mirrored(0, mirror) == 0);
    CHECK(mirrored(0.05, mirror) > 10);
    const double base = mirrored(0, plastic({.specular_reflectance = {0}}));
    CHECK(mirrored(0, plastic({})) == doctest::Approx(base));
    CHECK(mirrored(0.05, plastic({})) > 2 * base);
}

TEST_CASE("a point light falls off with the square of the distance and the cosine") {
    for_all({0.5, 3.0, 40.0}, {0.0, 0.8, 1.4}, [](double distance, double zenith) {
        const LocalLight light{.value = {2}, .to_world = shining({1, 2, 3}, distance * direction(zenith, 2))};
        const double wanted = 0.6 / pi * 2 * std::cos(zenith) / (distance * distance);
        CHECK(lit({light})[0][0] == doctest::Approx(wanted).epsilon(3e-5));
    });
}

TEST_CASE("a spot emits light as a point light within its beam, less beyond, not behind its cutoff") {
    const glm::dvec3 place(0, 0, 2);
    const double without = lit({{.value = {2}, .to_world = shining({0, 0, -1}, place)}})[0][0];
    for (const auto& [angle, wanted] :
         {std::pair{0.0, 1.0}, {0.25, 1.0}, {0.35, 0.75}, {0.45, 0.25}, {0.55, 0.0}, {3.0, 0.0}}) {
        const LocalLight light{.kind = Kind::spot,
                               .value = {2},
                               .to_world = shining({std::sin(angle), 0, -std::cos(angle)}, place),
                               .cutoff_angle = 0.5,
                               .beam_width = 0.3};
        CHECK(lit({light})[0][0] == doctest::Approx(wanted * without).epsilon(1e-4));
    }
}

TEST_CASE("the irradiance of a projector on its plane z = 1 is its value, over the whole rectangle") {
    const TexturePtr image =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.y, 1, 1); });
    for (const glm::dvec2& at :
         {glm::dvec2(0, 0), {0.3, -0.2}, {-0.5, 0.4}, {0.57, 0.2}, {0.59, 0.2}, {0.2, -0.4}}) {
        // The receiver is at the origin. `at` lies in the plane z = 1 of the projector's axes, whose x is the
        // world's -x.
        const LocalLight light{.kind = Kind::projector,
                               .value = {3, 2, 1},
                               .to_world = shining({0, 0, -1}, {at.x, -at.y, 1}, {0, 1, 0}),
                               .texture = image,
                               .fov = 2 * std::atan(0.58),
                               .aspect = 1.2};
        const glm::dvec2 half(0.58, 0.58 / 1.2);
        const bool inside = std::abs(at.x) < half.x && std::abs(at.y) < half.y;
        const glm::dvec2 uv = 0.5 - 0.5 * at / half;
        const std::vector<Stokes> ours = lit({light});
        const double wanted[] = {3 * uv.x, 2 * uv.y, 1};
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(ours[c][0] == doctest::Approx(inside ? 0.6 / pi * wanted[c] : 0).epsilon(1e-4));
        // At three times the distance the light is a ninth.
        LocalLight far = light;
        far.to_world[3] = glm::dvec4(3 * at.x, -3 * at.y, 3, 1);
        CHECK(lit({far})[0][0] == doctest::Approx(ours[0][0] / 9).epsilon(1e-4));
    }
}

TEST_CASE("the texture of a spot colours its light") {
    const TexturePtr image =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.y, 1, 1); });
    const LocalLight light{.kind = Kind::spot,
                           .to_world = shining({0, 0, -1}, {0.3, -0.1, 1}, {0, 1, 0}),
                           .cutoff_angle = pi / 4,
                           .beam_width = pi / 4,
                           .texture = image};
    const std::vector<Stokes> ours = lit({light});
    // The receiver is at (0.3, 0.1, 1) in the spot's axes.
    CHECK(ours[0][0] / ours[2][0] == doctest::Approx(0.65).epsilon(1e-4));
    CHECK(ours[1][0] / ours[2][0] == doctest::Approx(0.55).epsilon(1e-4));
}

TEST_CASE("lights add to each other and to the environment") {
    const LocalLight sun{.kind = Kind::directional, .value = {1.5}, .to_world = shining({1, 0, -1})};
    const LocalLight lamp{.value = {2}, .to_world = shining({1, 0, 0}, {0.5, 1, 2})};
    const MaterialPtr material = pplastic({.alpha = 0.3});
    const Stokes both = lit({sun, lamp}, material)[0];
    check_close(both, lit({sun}, material)[0] + lit({lamp}, material)[0], 1e-6);

    Scene scene;
    scene.add(square(material));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    const Camera camera = camera_on({0, 0, 0}, aside);
    const Stokes alone = point(scene, camera, 64)[0];
    scene.add_light(sun);
    scene.add_light(lamp);
    for (const Strategy strategy : {Strategy::both, Strategy::light, Strategy::surface})
        check_close(point(scene, camera, 1 << 12, strategy)[0], alone + both, 0.02);
    // The environment's samples do not change.
    check_close(point(scene, camera, 64)[0], alone + both, 1e-6);
}

TEST_CASE("something between a point light and the surface hides it; something beyond does not") {
    const LocalLight light{.value = {2}, .to_world = shining({1, 0, 0}, {0, 0, 2})};
    const double open = lit({light})[0][0];
    for (const auto& [height, hides] :
         {std::pair{0.5, true}, {1.99, true}, {2.01, false}, {3.0, false}, {1e3, false}, {-1.0, false}}) {
        Scene scene;
        scene.add(square(diffuse({0.6})));
        scene.add(square(diffuse({0.6}), Frame(1.0), {0, 0, height}, 0.3));
        scene.add_light(light);
        const Camera camera = camera_on({0, 0, 0}, {1, 0, 0.3});
        CAPTURE(height);
        CHECK(point(scene, camera, 4)[0][0] == doctest::Approx(hides ? 0 : open).epsilon(1e-4));
        for (const bool shadows : {true, false}) {
            ReferenceStatistics statistics;
            const StokesImage image = render_reference(scene, project(camera, 1, 1), 1, 1,
                                                       {.samples = 8, .shadows = shadows}, statistics);
            CHECK(statistics.shadow_rays == (shadows ? 8 : 0));
            if (!shadows) CHECK(image.data[0] == doctest::Approx(open).epsilon(1e-4));
        }
    }
}

TEST_CASE("a polarized light is reflected by the material's own matrix") {
    std::mt19937 random(21);
    std::normal_distribution<double> normal;
    const MaterialPtr materials[] = {pplastic({.diffuse_reflectance = {0.3}, .alpha = 0.4}),
                                     rough_conductor({.eta = {{0.2, -3.1}}, .alpha = 0.3})};
    for (int i = 0; i < 8; ++i) {
        const MaterialPtr& material = materials[i % 2];
        const Frame surface = frame_with_x(random_direction(random), {1, 2, 3});
        const glm::dvec3 to_light = glm::normalize(glm::dvec3(normal(random), normal(random), 1));
        const glm::dvec3 to_viewer = glm::normalize(glm::dvec3(normal(random), normal(random), 1));
        const glm::dmat4 to_world = shining(-(surface * to_light), {}, random_direction(random));
        const PolarizationState state{
            .dolp = 0.8, .aolp = 0.3 * i, .docp = 0.5, .axis = random_direction(random)};
        Scene scene;
        scene.add(square(material, surface));
        scene.add_light({.kind = Kind::directional, .value = {2}, .to_world = to_world, .state = state});
        const Camera camera = camera_on({0, 0, 0}, surface * to_viewer);

        // The state as unit vectors of the field in space: (s1, s2) has twice the field's angle from x.
        const glm::dvec3 z = glm::dvec3(to_world[2]);
        const glm::dvec3 axis = glm::dmat3(to_world) * state.axis;
        const glm::dvec3 zero = glm::normalize(axis - glm::dot(axis, z) * z);
        const glm::dvec3 strongest = std::cos(state.aolp) * zero + std::sin(state.aolp) * glm::cross(z, zero);
        const Frame in = surface * theta_phi_frame(-to_light);
        const double angle = std::atan2(glm::dot(strongest, in[1]), glm::dot(strongest, in[0]));
        const Stokes incident(1, 0.8 * std::cos(2 * angle), 0.8 * std::sin(2 * angle), 0.5);
        const Stokes reflected = 2 * to_light.z * (evaluate(*material, 0, to_light, to_viewer) * incident);
        const Viewpoint view = project(camera, 1, 1).view;
        const Stokes wanted = rotated(
            reflected, angle_between(surface * theta_phi_frame(to_viewer), view.frame(surface * to_viewer)));
        CAPTURE(i);
        check_close(point(scene, camera, 1)[0], wanted, 2e-6);
    }
}

TEST_CASE("light polarized in the plane of incidence is not reflected at Brewster's angle") {
    const double brewster = std::atan(1.5);
    const MaterialPtr glass =
        pplastic({.diffuse_reflectance = {0}, .int_ior = 1.5, .ext_ior = 1, .alpha = 0.05});
    const glm::dvec3 to_light = direction(brewster, 0);
    const auto brightness = [&](const PolarizationState& state) {
        const LocalLight light{
            .kind = Kind::directional, .to_world = shining(-to_light, {}, {0, 1, 0}), .state = state};
        return lit({light}, glass, direction(brewster, pi))[0];
    };
    const Stokes unpolarized = brightness({});
    // +y of the light is the world's +y, perpendicular to the plane of incidence. +x lies in this plane.
    CHECK(brightness({.dolp = 1, .axis = {1, 0, 0}})[0] < 1e-3 * unpolarized[0]);
    CHECK(brightness({.dolp = 1, .axis = {0, 1, 0}})[0] == doctest::Approx(2 * unpolarized[0]).epsilon(1e-3));
    CHECK(brightness({.dolp = 1, .aolp = pi / 2, .axis = {1, 0, 0}})[0] ==
          doctest::Approx(2 * unpolarized[0]).epsilon(1e-3));
    CHECK(brightness({.docp = 1})[0] == doctest::Approx(unpolarized[0]).epsilon(1e-6));
}
