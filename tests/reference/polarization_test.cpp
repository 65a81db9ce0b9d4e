// SPDX-License-Identifier: MIT
// Tests of frames: light onto surfaces, from surfaces, and directly to the camera.
#include "directions.hpp"
#include "harmonics/rotation.hpp"
#include "material/brute_force.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const glm::dmat3 rotation = frame_with_x(glm::normalize(glm::dvec3(0.3, -0.5, 0.7)), {1, 0.2, 0.1});

/// Returns the linear part as a tensor in space, in which no choice of frame can hide an error.
glm::dmat3 tensor(const Stokes& s, const Frame& f) {
    return s[1] * (glm::outerProduct(f[0], f[0]) - glm::outerProduct(f[1], f[1])) +
           s[2] * (glm::outerProduct(f[0], f[1]) + glm::outerProduct(f[1], f[0]));
}

}  // namespace

TEST_CASE("light of every polarization reflected by pplastic is the brute-force integral") {
    const PshVector light = random_light(3, 2, 4, 11);
    const PshVector rotated_light = rotated(light, rotation);
    const MaterialPtr material =
        pplastic({.diffuse_reflectance = {0.6, 0.2}, .alpha = 0.3, .distribution = Distribution::ggx});
    std::mt19937 random(12);
    std::normal_distribution<double> normal;
    double most = 0;
    for (int i = 0; i < 4; ++i) {
        const Frame frame = frame_with_x(random_direction(random), {1, 2, 3});
        const glm::dvec3 own{normal(random), normal(random), 0.6 + 0.2 * i};
        const glm::dvec3 towards = glm::normalize(frame * own);
        Scene scene;
        scene.add(square(material, frame));
        scene.set_environment(std::make_shared<const PshLight>(light), rotation, 0.5);
        const Camera camera = camera_on({0, 0, 0}, towards);
        const Viewpoint view = project(camera, 1, 1).view;
        const std::vector<Stokes> ours = point(scene, camera, 1 << 13);
        for (int c = 0; c < 2; ++c) {
            const Stokes wanted = 0.5 * rotated(reflected(*material, c, rotated_light, frame, towards),
                                                angle_between(theta_phi_frame(towards), view.frame(towards)));
            CAPTURES(i, c);
            for (int p = 0; p < 4; ++p)
                CHECK(std::abs(ours[static_cast<std::size_t>(c)][p] - wanted[p]) < 3e-5);
            most = std::max(most, glm::length(wanted));
        }
    }
    // The light is nearly black in some directions, but never in four of them.
    CHECK(most > 5e-3);
}

TEST_CASE(
    "at Brewster's angle a floor reflects horizontally polarized light, whichever way the camera is held") {
    Scene scene;
    // The floor faces +y and is black inside.
    const Frame floor(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    scene.add(
        square(pplastic({.diffuse_reflectance = {0}, .int_ior = 1.5, .ext_ior = 1, .alpha = 0.01}), floor));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    const double brewster = std::atan(1.5);
    const glm::dvec3 towards(std::sin(brewster), std::cos(brewster), 0);
    const Stokes upright = point(scene, camera_on({0, 0, 0}, towards, {0, 1, 0}), 4096)[0];
    // The Fresnel reflectances are Rs = cos^2(2 theta_B) and Rp = 0.
    CHECK(upright[0] == doctest::Approx(std::pow(std::cos(2 * brewster), 2) / 2).epsilon(0.01));
    CHECK(upright[1] / upright[0] > 0.995);
    CHECK(std::abs(upright[2]) < 1e-3 * upright[0]);

    // The camera rolls to its right by 30 degrees. The horizon then rises to the right in the image,
    // counter-clockwise, and AoLP is 30 degrees.
    const double roll = pi / 6;
    const glm::dvec3 forward = -towards;
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const Stokes rolled =
        point(scene, camera_on({0, 0, 0}, towards, std::cos(roll) * up + std::sin(roll) * right), 4096)[0];
    CHECK(std::atan2(rolled[2], rolled[1]) / 2 == doctest::Approx(roll).epsilon(1e-3));
}

TEST_CASE("the background is the environment, in the frames of the camera") {
    const auto light = std::make_shared<const PshLight>(random_light(3, 3, 4, 13));
    Scene scene;
    scene.set_environment(light, rotation, 2);
    Camera camera;
    camera.to_world = look_at({1, 2, 3}, {0, 0.5, -1}, {0.1, 1, 0.3});
    camera.fov = 100;
    const Projection projection = project(camera, 5, 3);
    ReferenceStatistics statistics;
    const StokesImage image = render_reference(scene, projection, 5, 3, {.samples = 4096}, statistics);
    REQUIRE(image.channels == 3);
    CHECK(statistics.camera_rays == 5 * 3 * 4096);
    CHECK(statistics.shadow_rays == 0);
    // The mean over a pixel is computed by the clip matrix instead of the camera's axes.
    const glm::dmat4 clip_to_world = glm::inverse(projection.world_to_clip);
    constexpr int grid = 24;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            Stokes wanted(0.0);
            for (int i = 0; i < grid * grid; ++i) {
                const double px = (x + (i % grid + 0.5) / grid) / 5 * 2 - 1;
                const double py = 1 - (y + (i / grid + 0.5) / grid) / 3 * 2;
                const glm::dvec4 far = clip_to_world * glm::dvec4(px, py, 0, 1);
                const glm::dvec3 d = glm::normalize(glm::dvec3(far) / far.w - projection.view.eye);
                const glm::dvec3 own = glm::transpose(rotation) * d;
                const Stokes s = light->radiance(1, own);
                const glm::dmat3 t = tensor(s, rotation * theta_phi_frame(-own));
                const Frame f = projection.view.frame(-d);
                wanted += 2.0 / (grid * grid) *
                          Stokes(s[0], glm::dot(f[0], t * f[0]), glm::dot(f[0], t * f[1]), s[3]);
            }
            const Stokes ours = image.stokes(1, y, x);
            for (int p = 0; p < 4; ++p) CHECK(std::abs(ours[p] - wanted[p]) < 2e-3);
        }
    }
}
