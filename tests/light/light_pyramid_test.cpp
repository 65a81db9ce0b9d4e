// SPDX-License-Identifier: MIT
#include "light/light_pyramid.hpp"

#include "light/images.hpp"
#include "polarization/stokes.hpp"

using namespace nicol;

namespace {

LaneLight look_up(const Environment& light, const std::vector<glm::dvec3>& directions, float variance) {
    LaneLight out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out.towards, i, glm::vec3(directions[i]));
    Lanes variances;
    variances.value.fill(variance);
    LightPyramid(light).look_up(variances, out);
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
    if (light.components == 1) return s;
    const glm::dvec3 along = -lane(light.towards, i);
    return rotated(s, angle_between(frame_with_x(along, lane(light.x, i)), theta_phi_frame(along)));
}

// Returns the mean light in a normally distributed blob around a direction, in theta_phi_frame() of that
// direction.
Stokes mean_around(const Environment& light, int channel, const glm::dvec3& towards, double variance) {
    constexpr int rings = 24, around = 24;
    const Frame axes = theta_phi_frame(-towards);
    Stokes sum(0.0);
    for (int r = 0; r < rings; ++r)
        for (int a = 0; a < around; ++a) {
            const double angle = std::sqrt(-2 * variance * std::log((r + 0.5) / rings));
            const glm::dvec3 along = axes * direction(angle, 2 * pi * (a + 0.5) / around);
            // The frame at `along` is parallel to the frame at the centre.
            const glm::dvec3 centre = -towards;
            const glm::dvec3 x =
                axes[0] - glm::dot(axes[0], along) / (1 + glm::dot(centre, along)) * (centre + along);
            sum += rotated(light.radiance(channel, -along),
                           angle_between(theta_phi_frame(along), frame_with_x(along, x))) /
                   static_cast<double>(rings * around);
        }
    return sum;
}

}  // namespace

TEST_CASE("small blobs see the environment's own light") {
    std::vector<glm::dvec3> directions = random_directions(16, 5);
    directions[0] = direction(0.06, 1);
    directions[0] = {directions[0].x, directions[0].z, directions[0].y};  // near the zenith
    directions[1] = -directions[0];
    directions[2] = {0, 0, -1};
    for (const bool polarized : {false, true}) {
        for (const int channels : {1, 5}) {
            CAPTURES(polarized, channels);
            const auto light = image_environment(random_image(128, 65, channels, 3, polarized));
            const LaneLight out = look_up(*light, directions, 1e-9F);
            CHECK(out.components == (polarized ? 4 : 1));
            for (int c = 0; c < channels; ++c)
                for (std::size_t i = 0; i < kLanes; ++i)
                    CHECK(glm::distance(found(out, static_cast<std::size_t>(c), i),
                                        light->radiance(c, lane(out.towards, i))) < 2e-4);
        }
    }
}

TEST_CASE("blobs keep the light and its place, and have the wanted variance") {
    constexpr double width = 0.04 * 0.04 / 2;                        // variance of the light along each axis
    constexpr double own = width + 4 * pi * pi / (512 * 512 * 6.0);  // interpolated
    for (const glm::dvec3& to :
         {glm::dvec3(0.3, 0.8, 0.5), {0, 1, 0}, {1, 1, 1}, {0.1, 0.2, -1}, {1, 0, 1}}) {
        const glm::dvec3 middle = glm::normalize(to);
        EquirectImage image(512, 257, 1);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const glm::dvec3 d = towards((x + 0.5) / image.width, y / (image.height - 1.0));
                image.at(0, y, x)[0] = static_cast<float>(std::exp((glm::dot(d, middle) - 1) / width));
            }
        }
        const LightPyramid pyramid(*image_environment(image));
        for (const float variance : {0.0F, 1e-4F, 1e-3F, 4e-3F, 0.01F, 0.02F, 0.05F}) {
            CAPTURES(to.x, to.y, to.z, variance);
            constexpr int rows = 256, columns = 512;
            Lanes variances;
            variances.value.fill(variance);
            double total = 0, squares = 0;
            glm::dvec3 sum(0.0);
            for (int y = 0; y < rows; ++y) {
                for (int x = 0; x < columns; x += static_cast<int>(kLanes)) {
                    std::array<glm::dvec3, kLanes> directions;
                    LaneLight out;
                    for (std::size_t i = 0; i < kLanes; ++i) {
                        directions[i] =
                            towards((x + static_cast<double>(i) + 0.5) / columns, (y + 0.5) / rows);
                        put(out.towards, i, glm::vec3(directions[i]));
                    }
                    pyramid.look_up(variances, out);
                    const double weight = std::sin(pi * (y + 0.5) / rows) * pi / rows * 2 * pi / columns;
                    for (std::size_t i = 0; i < kLanes; ++i) {
                        const double light = weight * static_cast<double>(out.irradiance[0][0][i]);
                        const double angle = std::acos(std::min(1.0, glm::dot(directions[i], middle)));
                        total += light;
                        sum += light * directions[i];
                        squares += light * angle * angle;
                    }
                }
            }
            const double found = squares / total / 2 - own, w = static_cast<double>(variance);
            CHECK(total == doctest::Approx(2 * pi * width).epsilon(0.07));  // at the pole; 0.02 elsewhere
            CHECK(glm::distance(glm::normalize(sum), middle) < 0.03 * std::sqrt(w) + 1e-4);
            CHECK(std::abs(found - w) < 0.12 * w + 0.02 * own);
        }
    }
}

TEST_CASE("larger blobs see the mean") {
    std::vector<glm::dvec3> directions = random_directions(16, 6);
    directions[0] = {0, 1, 0};
    directions[1] = glm::normalize(glm::dvec3(0.01, -1, 0.02));
    const auto light = psh_environment(random_field(6, 1, 4));
    for (const float variance : {0.002F, 0.01F, 0.04F}) {
        CAPTURE(variance);
        const LaneLight out = look_up(*light, directions, variance);
        for (std::size_t i = 0; i < kLanes; ++i)
            CHECK(glm::distance(found(out, 0, i),
                                mean_around(*light, 0, directions[i], static_cast<double>(variance))) < 0.02);
    }
}

TEST_CASE("radiance alone is that of all components") {
    std::vector<glm::dvec3> directions = random_directions(16, 7);
    directions[0] = {0, -1, 0};
    for (const int channels : {1, 3, 5}) {
        const auto light = image_environment(random_image(128, 65, channels, 4, true));
        const LightPyramid alone(*light, 64, LightPyramid::Kept::radiance), all(*light, 64);
        CHECK(!alone.polarized());
        for (const float variance : {1e-9F, 0.002F, 0.01F, 0.1F}) {
            CAPTURES(channels, variance);
            LaneLight found, of_all;
            for (std::size_t i = 0; i < kLanes; ++i) put(found.towards, i, glm::vec3(directions[i]));
            of_all.towards = found.towards;
            Lanes variances;
            variances.value.fill(variance);
            alone.look_up(variances, found);
            all.look_up(variances, of_all);
            REQUIRE(found.components == 1);
            // Images of wide blobs of radiance alone have fewer texels.
            const double tolerance = variance < 0.02F ? 1e-5 : 0.01;
            for (std::size_t c = 0; c < found.irradiance.size(); ++c)
                for (std::size_t i = 0; i < kLanes; ++i)
                    CHECK(found.irradiance[c][0][i] ==
                          doctest::Approx(of_all.irradiance[c][0][i]).epsilon(tolerance));
        }
    }
}

TEST_CASE("the light of a blob leans to where it comes from") {
    for (const int channels : {1, 5}) {
        EquirectImage image(128, 65, channels);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const glm::dvec3 d = towards((x + 0.5) / image.width, y / (image.height - 1.0));
                    const double beside = glm::dot(d, glm::normalize(glm::dvec3(0.3, 0.8, 0.5 + c))) - 1;
                    image.at(c, y, x)[0] = static_cast<float>(0.1 + std::exp(beside / 0.1));
                }
        const auto light = image_environment(image);
        const LightPyramid pyramid(*light);
        const std::vector<glm::dvec3> directions = random_directions(16, 6);
        for (const float variance : {2e-3F, 5e-3F, 0.02F}) {
            LaneLight out;
            LaneVectors leans;
            for (std::size_t i = 0; i < kLanes; ++i) put(out.towards, i, glm::vec3(directions[i]));
            Lanes variances;
            variances.value.fill(variance);
            pyramid.look_up(variances, out, leans);
            const LaneLight alone = look_up(*light, directions, variance);
            double wrong = 0, all = 0;
            for (std::size_t i = 0; i < kLanes; ++i) {
                CHECK(out.irradiance[0][0][i] == alone.irradiance[0][0][i]);
                const glm::dvec3 middle = directions[i], lean(leans.x[i], leans.y[i], leans.z[i]);
                CHECK(std::abs(glm::dot(lean, middle)) < 1e-3 * glm::length(lean) + 1e-7);
                CHECK(glm::length(lean) <= 1.001 * std::sqrt(double{variance}));
                // The mean of directions across the middle, by the light of the first four channels.
                const Frame axes = frame_with_x(middle, {0.3, 0.8, 0.1});
                constexpr int rings = 32, around = 32;
                glm::dvec3 sum(0.0);
                double total = 0;
                for (int r = 0; r < rings; ++r)
                    for (int a = 0; a < around; ++a) {
                        const double angle = std::sqrt(-2 * double{variance} * std::log((r + 0.5) / rings));
                        const glm::dvec3 there = axes * direction(angle, 2 * pi * (a + 0.5) / around);
                        double s0 = 0;
                        for (int c = 0; c < std::min(channels, 4); ++c) s0 += light->radiance(c, there)[0];
                        total += s0;
                        sum += s0 * (there - glm::dot(there, middle) * middle);
                    }
                wrong += glm::dot(lean - sum / total, lean - sum / total);
                all += glm::dot(sum / total, sum / total);
            }
            CAPTURES(channels, variance, std::sqrt(wrong / all));
            CHECK(wrong < 0.15 * 0.15 * all);
        }
    }
}
