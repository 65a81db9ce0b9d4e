// SPDX-License-Identifier: MIT
#include "material/frames.hpp"

#include "directions.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

double difference(const SurfaceRotations<double>& a, const SurfaceRotations<double>& b) {
    return std::max({std::abs(a.in_cos2 - b.in_cos2), std::abs(a.in_sin2 - b.in_sin2),
                     std::abs(a.out_cos2 - b.out_cos2), std::abs(a.out_sin2 - b.out_sin2)});
}

/// By the angles between frames with x along s.
SurfaceRotations<double> by_angles(const glm::dvec3& s, const glm::dvec3& light, const glm::dvec3& viewer) {
    const double in = angle_between(frame_with_x(-light, s), theta_phi_frame(-light));
    const double out = angle_between(frame_with_x(viewer, s), theta_phi_frame(viewer));
    return {std::cos(2 * in), std::sin(2 * in), std::cos(2 * out), std::sin(2 * out)};
}

}  // namespace

TEST_CASE("rotations from s-frames are those by the angles between frames") {
    std::mt19937 random(6);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 light = random_direction_within(random, 1.57);
        const glm::dvec3 viewer = random_direction_within(random, 1.57);
        CHECK(difference(rotations_from_s_frames(light, viewer),
                         by_angles(glm::cross(light, viewer), light, viewer)) <= 1e-12);
        // Close to each other: the exact difference keeps the digits of s.
        const glm::dvec3 step = glm::cross(light, random_direction(random));
        const glm::dvec3 next = glm::normalize(light + 1e-6 * step);
        CHECK(difference(rotations_from_s_frames(light, next),
                         by_angles(glm::cross(light, next - light), light, next)) <= 1e-9);
    }
}

TEST_CASE("rotations next to the normal follow the azimuths, however near") {
    for (const double zenith : {1e-3, 1e-10, 1e-16, 1e-60}) {
        CAPTURE(zenith);
        const glm::dvec3 up(0, 0, 1);
        for (int i = 0; i < 20; ++i) {
            // Seen along the normal, phi-hat of the other direction is s.
            const double azimuth = 0.3 * i;
            const double cosine = std::cos(2 * azimuth);
            const double sine = std::sin(2 * azimuth);
            const glm::dvec3 tilted = direction(zenith, azimuth);
            CHECK(difference(rotations_from_s_frames(tilted, up), {-1, 0, -cosine, sine}) <= 1e-12);
            CHECK(difference(rotations_from_s_frames(up, tilted), {-cosine, -sine, -1, 0}) <= 1e-12);
        }
    }
}

TEST_CASE("x is phi-hat where the directions are equal") {
    for (const glm::dvec3& d : {glm::dvec3(0, 0, 1), direction(1e-9, 2), direction(1, 2)})
        CHECK(difference(rotations_from_s_frames(d, d), {-1, 0, -1, 0}) == 0);
}
