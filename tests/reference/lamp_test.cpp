// SPDX-License-Identifier: MIT
// Tests of area lights and suns of finite size: closed forms, strategies against each other, and their
// images.
#include "directions.hpp"
#include "function_texture.hpp"
#include "material/conductor.hpp"
#include "material/mixture.hpp"
#include "polarization/fresnel.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;
using Kind = LocalLight::Kind;

namespace {

const glm::dvec3 aside = glm::normalize(glm::dvec3(1, 0.2, 0.3));
constexpr Strategy strategies[] = {Strategy::both, Strategy::light, Strategy::surface};
const Frame facing_down(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));

EmissionPtr emission(const Emission& emission) {
    return std::make_shared<const Emission>(emission);
}

Instance lamp(const EmissionPtr& light, const Frame& frame, const glm::dvec3& center, double half) {
    Instance out = square(diffuse({0}), frame, center, half);
    out.emission = light;
    return out;
}

/// Returns a diffuse floor of this albedo in the plane z = 0.
Scene floor(double albedo = 0.6) {
    Scene scene;
    scene.add(square(diffuse({albedo}), Frame(1.0), {0, 0, 0}, 100));
    return scene;
}

double at_origin(const Scene& scene, Strategy strategy = Strategy::both, int samples = 1 << 14) {
    return point(scene, camera_on({0, 0, 0}, aside), samples, strategy)[0][0];
}

/// Returns the irradiance at the origin on a plane facing +z, from a polygon above it of radiance 1, by
/// Lambert's formula.
double polygon_irradiance(const std::vector<glm::dvec3>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i]);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b)).z;
    }
    return std::abs(sum) / 2;
}

}  // namespace

TEST_CASE("a disc of the sky lights a plane by its irradiance times the cosine, however large") {
    for_all({0.0046, 0.2, 0.6}, {0.0, 0.5, 0.9}, [](double radius, double zenith) {
        Scene scene = floor();
        // The irradiance on a facing plane is pi L sin^2, and on a tilted plane that value times the cosine.
        scene.add_light({.kind = Kind::directional,
                         .value = {3},
                         .to_world = glm::dmat4(theta_phi_frame(-direction(zenith, 1))),
                         .angular_radius = radius});
        CAPTURES(radius, zenith);
        for (const Strategy strategy : {Strategy::both, Strategy::light})
            CHECK(at_origin(scene, strategy) ==
                  doctest::Approx(3 * 0.6 / pi * std::cos(zenith)).epsilon(1e-3));
        if (radius > 0.1)
            CHECK(at_origin(scene, Strategy::surface, 1 << 16) ==
                  doctest::Approx(3 * 0.6 / pi * std::cos(zenith)).epsilon(0.02));
    });
}

TEST_CASE("a disc as large as the sky is a sky of even light") {
    Scene scene = floor();
    scene.add_light({.kind = Kind::directional,
                     .value = {pi},
                     .to_world = glm::dmat4(theta_phi_frame({0, 0, -1})),
                     .angular_radius = pi / 2});
    for (const Strategy strategy : strategies)
        CHECK(at_origin(scene, strategy) == doctest::Approx(0.6).epsilon(1e-3));
}

TEST_CASE("a square lamp lights the floor as Lambert's polygon") {
    for (const double aslant : {0.0, 0.7}) {
        const Frame frame =
            facing_down * glm::dmat3(glm::rotate(glm::dmat4(1.0), aslant, glm::dvec3(1, 0.3, 0)));
        const glm::dvec3 center(0.7, -0.2, 1.5);
        Scene scene = floor();
        scene.add(lamp(emission({.radiance = {2}}), frame, center, 0.8));
        std::vector<glm::dvec3> corners;
        for (const glm::dvec2& c : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            corners.push_back(center + 0.8 * (c.x * frame[0] + c.y * frame[1]));
        const double wanted = 2 * 0.6 / pi * polygon_irradiance(corners);
        for (const Strategy strategy : strategies)
            CHECK(at_origin(scene, strategy) == doctest::Approx(wanted).epsilon(5e-3));
    }
}

TEST_CASE("an emissive sphere lights the floor by the square of its apparent radius") {
    const glm::dvec3 center(1, 0.5, 2);
    Scene scene = floor();
    glm::dmat4 to_world(glm::dmat3(0.4));
    to_world[3] = glm::dvec4(center, 1);
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()),
               .material = diffuse({0.5}),
               .to_world = to_world,
               .emission = emission({.radiance = {5}})});
    const double distance = glm::length(center);
    const double wanted = 0.6 * 5 * 0.4 * 0.4 / (distance * distance) * center.z / distance;
    for (const Strategy strategy : strategies)
        CHECK(at_origin(scene, strategy) == doctest::Approx(wanted).epsilon(0.01));
}

TEST_CASE("lamps add, and so they do where there are too many to sample each") {
    std::vector<Instance> lamps;
    for (int i = 0; i < 20; ++i) {
        // Most lamps are dark and rarely chosen, and one is black.
        const double radiance = i == 7 ? 10 : i == 3 ? 0 : 0.1 * i;
        lamps.push_back(lamp(emission({.radiance = {radiance}}), facing_down,
                             {0.5 * (i % 5) - 1, 0.5 * (i / 5) - 0.7, 1 + 0.05 * i}, 0.15));
    }
    double sum = 0;
    Scene all = floor();
    for (const Instance& one : lamps) {
        Scene scene = floor();
        for (const Instance& other : lamps) {
            // The other lamps occlude this one when they are dark, too.
            Instance dark = other;
            if (&other != &one) dark.emission = nullptr;
            scene.add(dark);
        }
        sum += at_origin(scene, Strategy::light, 1 << 12);
        all.add(one);
    }
    for (const Strategy strategy : {Strategy::both, Strategy::light})
        CHECK(at_origin(all, strategy, 1 << 16) == doctest::Approx(sum).epsilon(0.01));
}

TEST_CASE("sampling lamps, the surface or both gives the same light on every material") {
    Scene scene;
    scene.add(square(pplastic({.diffuse_reflectance = {0.3}, .alpha = 0.3}), Frame(1.0), {0, 0, 0}, 5));
    scene.add(lamp(emission({.radiance = {2}, .state = {.dolp = 0.7, .aolp = 0.4, .docp = 0.3}}), facing_down,
                   {-0.8, 0, 1.2}, 0.5));
    scene.add_light({.kind = Kind::directional,
                     .value = {1},
                     .to_world = glm::dmat4(theta_phi_frame(-direction(0.7, 2.5))),
                     .angular_radius = 0.3,
                     .state = {.dolp = 0.9, .axis = {0.3, 1, 0}}});
    scene.set_environment(constant_environment({0.2}), glm::dmat3(1.0), 1);
    const Camera camera = camera_on({0, 0, 0}, {0.9, 0.1, 0.8});
    const Stokes both = point(scene, camera, 1 << 16, Strategy::both, 1)[0];
    CHECK(glm::length(glm::dvec2(both[1], both[2])) > 0.05 * both[0]);
    CHECK(std::abs(both[3]) > 1e-3 * both[0]);
    for (const Strategy strategy : {Strategy::light, Strategy::surface}) {
        const Stokes other = point(scene, camera, 1 << 17, strategy, 2)[0];
        for (int p = 0; p < 4; ++p) CHECK(std::abs(other[p] - both[p]) < 5e-3 * both[0]);
    }
}

TEST_CASE("smooth metal mirrors a lamp as Fresnel says") {
    const std::complex<double> index(0.4, -2.4);
    Scene scene;
    scene.add(square(conductor({index}), Frame(1.0), {0, 0, 0}, 5));
    scene.add(lamp(emission({.radiance = {2}}), facing_down, {-1, 0, 1}, 0.3));
    for (const Strategy strategy : strategies)
        for (const double tangent : {0.5, 0.75, 0.95, 1.25, 1.4}) {
            const glm::dvec3 viewer = glm::normalize(glm::dvec3(tangent, 0, 1));
            const bool lit = std::abs(tangent - 1) < 0.3;
            const Stokes found = point(scene, camera_on({0, 0, 0}, viewer), 64, strategy)[0];
            const Stokes expected = fresnel_reflection(viewer.z, index) * Stokes(lit ? 2 : 0, 0, 0, 0);
            CAPTURES(tangent, static_cast<int>(strategy), found[0], expected[0]);
            CHECK(found[0] == doctest::Approx(expected[0]).epsilon(1e-4));
            CHECK(std::hypot(found[1], found[2]) == doctest::Approx(std::abs(expected[1])).epsilon(1e-3));
        }
}

TEST_CASE("a surface emits light from its front, or from both sides") {
    for_all({false, true}, {false, true}, [](bool two_sided, bool away) {
        Scene scene = floor();
        scene.add(lamp(emission({.two_sided = two_sided}), away ? Frame(1.0) : facing_down, {0, 0, 1}, 0.5));
        const bool lights = two_sided || !away;
        for (const Strategy strategy : strategies) CHECK((at_origin(scene, strategy, 64) > 0.05) == lights);
        const Camera below = camera_on({0, 0, 1}, {1, 0.1, -0.3});
        CHECK(point(scene, below, 16)[0][0] == (lights ? 1 : 0));
    });
}

TEST_CASE("what stands before a lamp hides it, unless there are no shadows") {
    Scene scene = floor();
    const double open = [&] {
        Scene lit = floor();
        lit.add(lamp(emission({}), facing_down, {0, 0, 2}, 0.5));
        return at_origin(lit);
    }();
    scene.add(lamp(emission({}), facing_down, {0, 0, 2}, 0.5));
    scene.add(square(diffuse({0.5}), Frame(1.0), {0, 0, 1}, 0.6));
    scene.add_light({.kind = Kind::directional,
                     .value = {1},
                     .to_world = glm::dmat4(theta_phi_frame({0, 0, -1})),
                     .angular_radius = 0.1});
    const double of_disc = 0.6 / pi;
    const Camera camera = camera_on({0, 0, 0}, aside);
    for (const Strategy strategy : strategies) {
        CHECK(at_origin(scene, strategy) == 0);
        ReferenceStatistics statistics;
        const StokesImage image = render_reference(
            scene, project(camera, 1, 1), 1, 1, {.samples = 1 << 16, .shadows = false}, statistics, strategy);
        CHECK(image.data[0] == doctest::Approx(open + of_disc).epsilon(0.02));
        CHECK(statistics.shadow_rays == 0);
    }
}

TEST_CASE("the camera sees a surface emit light, with its polarization, added to what it reflects") {
    const PolarizationState state{.dolp = 0.6, .aolp = 0.5, .docp = -0.4, .axis = {0.3, 1, 0}};
    // The instance is stretched and rotated. The polarization axis is a direction of the mesh.
    glm::dmat4 to_world = glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(1, 2, 0.5)) *
                          glm::scale(glm::dmat4(1.0), glm::dvec3(2, 0.5, 1));
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(make_rectangle(1)),
               .material = diffuse({0.5}),
               .to_world = to_world,
               .emission = emission({.radiance = {1, 2, 3}, .state = state})});
    const glm::dvec3 towards = glm::normalize(glm::dvec3(to_world[2]) + glm::dvec3(0.4, 0.1, 0.2));
    const Camera camera = camera_on({0, 0, 0}, towards);
    const Viewpoint view = project(camera, 1, 1).view;
    const Frame received = view.frame(towards);
    // AoLP is the angle in the image from its right towards its top.
    const glm::dvec3 axis = glm::dmat3(to_world) * state.axis;
    const double axis_angle = std::atan2(glm::dot(axis, received[1]), glm::dot(axis, received[0]));
    const double aolp = axis_angle + state.aolp;
    const std::vector<Stokes> ours = point(scene, camera, 4);
    REQUIRE(ours.size() == 3);
    for (std::size_t c = 0; c < 3; ++c) {
        const double s0 = static_cast<double>(c) + 1;
        CHECK(ours[c][0] == doctest::Approx(s0));
        CHECK(ours[c][1] == doctest::Approx(s0 * 0.6 * std::cos(2 * aolp)).epsilon(1e-5));
        CHECK(ours[c][2] == doctest::Approx(s0 * 0.6 * std::sin(2 * aolp)).epsilon(1e-5));
        CHECK(ours[c][3] == doctest::Approx(-0.4 * s0));
    }
    scene.add_light(
        {.kind = Kind::directional,
         .value = {pi},
         .to_world = glm::dmat4(glm::dmat3(theta_phi_frame(-glm::normalize(glm::dvec3(to_world[2])))))});
    CHECK(point(scene, camera, 4)[0][0] == doctest::Approx(1.5).epsilon(1e-5));
}

TEST_CASE("a lamp behind a polarizing sheet is seen as Mitsuba 3 does") {
    // Each row is a `polarizer` of this angle in degrees at z = 0, seen from this position with the camera's
    // up at (0.2, 1, 0.1). The values are s1 / s0 and s2 / s0 of Mitsuba 3.9.
    const struct {
        glm::dvec3 eye;
        double theta, s1, s2;
    } cases[] = {
        {{0, 0, 4}, 0, 0.923, 0.385},       {{0, 0, 4}, 30, 0.795, -0.607},
        {{0, 0, 4}, 75, -0.607, -0.795},    {{2, 1, 3}, 0, 0.971, 0.24},
        {{2, 1, 3}, 30, 0.725, -0.688},     {{-1.5, 2.5, 2}, 75, 0.314, -0.949},
        {{3, 0.2, 0.5}, 30, 0.946, -0.325}, {{2, 1, -3}, 0, 0.898, -0.44},
        {{2, 1, -3}, 75, -0.753, 0.659},    {{-1.5, 2.5, -2}, 30, 0.785, 0.62},
    };
    for (const auto& c : cases) {
        const double theta = c.theta * pi / 180;
        Scene scene;
        scene.add(lamp(
            emission({.two_sided = true,
                      .state = {.dolp = 1, .aolp = pi / 2, .axis = {std::sin(theta), std::cos(theta), 0}}}),
            Frame(1.0), {0, 0, 0}, 1));
        const Stokes seen = point(scene, camera_on({0, 0, 0}, c.eye, {0.2, 1, 0.1}), 1)[0];
        CAPTURES(c.eye.x, c.eye.z, c.theta);
        CHECK(std::abs(seen[1] / seen[0] - c.s1) < 1e-3);
        CHECK(std::abs(seen[2] / seen[0] - c.s2) < 1e-3);
    }
}

TEST_CASE("a texture of emission lies on its surface, as the camera sees it and as it lights") {
    const TexturePtr image =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.y, 1, 1); });
    Scene scene = floor();
    scene.add(lamp(emission({.radiance = {1, 2, 1}, .texture = image}), facing_down, {0, 0, 2}, 0.5));
    // u grows with x, and v against y.
    const std::vector<Stokes> seen = point(scene, camera_on({0.25, 0.125, 2}, {0.1, 0.1, -1}), 4);
    CHECK(seen[0][0] == doctest::Approx(0.75).epsilon(1e-4));
    CHECK(seen[1][0] == doctest::Approx(2 * 0.375).epsilon(1e-4));
    // Above the middle, symmetry makes the means of u and v 1/2.
    for (const Strategy strategy : strategies) {
        const std::vector<Stokes> lit = point(scene, camera_on({0, 0, 0}, aside), 1 << 14, strategy);
        CHECK(lit[0][0] / lit[2][0] == doctest::Approx(0.5).epsilon(0.01));
        CHECK(lit[1][0] / lit[2][0] == doctest::Approx(1).epsilon(0.01));
    }
}

TEST_CASE("where a lamp is cut out it emits no light, and hides nothing") {
    const TexturePtr left =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x < 0.5F ? 1 : 0); }, 1);
    const glm::dvec3 center(0.1, 0.2, 1.5);
    Scene scene = floor();
    Instance half = lamp(emission({.radiance = {2}}), facing_down, center, 0.8);
    half.material = masked(half.material, left);
    scene.add(half);
    const std::vector<glm::dvec3> corners = {center + glm::dvec3(-0.8, -0.8, 0),
                                             center + glm::dvec3(0, -0.8, 0), center + glm::dvec3(0, 0.8, 0),
                                             center + glm::dvec3(-0.8, 0.8, 0)};
    for (const Strategy strategy : strategies)
        CHECK(at_origin(scene, strategy) ==
              doctest::Approx(2 * 0.6 / pi * polygon_irradiance(corners)).epsilon(5e-3));
}

TEST_CASE("lamps and their shadows are counted as rays") {
    Scene scene = floor();
    for (int i = 0; i < 3; ++i) scene.add(lamp(emission({}), facing_down, {2 * i - 2, 0, 1}, 0.3));
    ReferenceStatistics statistics;
    (void)render_reference(scene, project(camera_on({0, 0, 0}, aside), 1, 1), 1, 1, {.samples = 64},
                           statistics);
    // Each sample casts one ray to each lamp and one into the surface's lobe.
    CHECK(statistics.shadow_rays == 4 * 64);
}
