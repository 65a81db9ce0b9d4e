// SPDX-License-Identifier: MIT
#include "light/light_pyramid.hpp"

#include "light/images.hpp"
#include "polarization/stokes.hpp"

using namespace nicol;

namespace {

LaneLight look_up(const Environment& light, const std::vector<glm::dvec3>& directions, float solid_angle) {
    LaneLight out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out.towards, i, glm::vec3(directions[i]));
    Lanes solid_angles;
    solid_angles.value.fill(solid_angle);
    LightPyramid(light).look_up(solid_angles, out);
    return out;
}

glm::dvec3 lane(const LaneVectors& v, std::size_t i) {
    return glm::normalize(glm::dvec3(v.x[i], v.y[i], v.z[i]));
}

// Returns the light of a lane in theta_phi_frame().
Stokes found(const LaneLight& light, std::size_t channel, std::size_t i) {
    Stokes s(0.0);
    for (std::size_t p = 0; p < light.components; ++p)
        s[static_cast<int>(p)] = static_cast<double>(light.irradiance[channel][p][i]);
    const glm::dvec3 along = -lane(light.towards, i);
    return rotated(s, angle_between(frame_with_x(along, lane(light.x, i)), theta_phi_frame(along)));
}

// Returns the mean light within a solid angle around a direction, in theta_phi_frame() of that direction.
Stokes mean_around(const Environment& light, int channel, const glm::dvec3& towards, double solid_angle) {
    constexpr int rings = 12, around = 24;
    const Frame axes = theta_phi_frame(-towards);
    Stokes sum(0.0);
    for (int r = 0; r < rings; ++r)
        for (int a = 0; a < around; ++a) {
            const double z = 1 - solid_angle / (2 * pi) * (r + 0.5) / rings;
            const glm::dvec3 along = axes * direction(std::acos(z), 2 * pi * (a + 0.5) / around);
            // The frame at `along` is parallel to the frame at the centre.
            const Frame parallel = frame_with_x(along, axes[0]);
            sum += rotated(light.radiance(channel, -along), angle_between(theta_phi_frame(along), parallel)) /
                   static_cast<double>(rings * around);
        }
    return sum;
}

}  // namespace

TEST_CASE("small solid angles see the environment's own light") {
    std::vector<glm::dvec3> directions = random_directions(16, 5);
    directions[0] = direction(0.06, 1);
    directions[0] = {directions[0].x, directions[0].z, directions[0].y};  // near the zenith
    directions[1] = -directions[0];
    directions[2] = {0, 0, -1};
    for (const bool polarized : {false, true}) {
        for (const int channels : {1, 5}) {
            CAPTURES(polarized, channels);
            const auto light = image_environment(random_image(128, 65, channels, 3, polarized));
            const LaneLight out = look_up(*light, directions, 1e-6F);
            CHECK(out.components == (polarized ? 4 : 1));
            for (int c = 0; c < channels; ++c)
                for (std::size_t i = 0; i < kLanes; ++i)
                    CHECK(glm::distance(found(out, static_cast<std::size_t>(c), i),
                                        light->radiance(c, lane(out.towards, i))) < 2e-4);
        }
    }
}

TEST_CASE("larger solid angles see the mean") {
    const std::vector<glm::dvec3> directions = random_directions(16, 6);
    const auto light = psh_environment(random_field(6, 1, 4));
    for (const float solid_angle : {0.01F, 0.05F, 0.2F}) {
        CAPTURE(solid_angle);
        const LaneLight out = look_up(*light, directions, solid_angle);
        for (std::size_t i = 0; i < kLanes; ++i)
            CHECK(glm::distance(found(out, 0, i), mean_around(*light, 0, directions[i],
                                                              static_cast<double>(solid_angle))) < 0.02);
    }
    // Noise vanishes in the mean, so that a sharp look-up fails.
    const auto noise = image_environment(random_image(512, 257, 1, 8));
    const LaneLight out = look_up(*noise, directions, 0.2F);
    for (std::size_t i = 0; i < kLanes; ++i) CHECK(std::abs(found(out, 0, i)[0] - 1) < 0.1);
}
