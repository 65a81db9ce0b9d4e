// SPDX-License-Identifier: MIT
// Clear sky in closed form: sunlight scattered once by small particles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "error.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/transform.hpp"
#include "light/environment_checks.hpp"
#include "light/equirect.hpp"
#include "light/turbid_sky.hpp"

namespace nicol {
namespace {

class RayleighEnvironment final : public Environment {
public:
    RayleighEnvironment(const RayleighSky& sky, const glm::dvec3& sun)
        : sun_(sun), dop_max_(sky.dop_max), radiance_(sky.radiance) {
        const bool light = std::any_of(radiance_.begin(), radiance_.end(), [](double r) { return r > 0; });
        polarized_ = light && dop_max_ > 0;
    }

    int channels() const noexcept override { return static_cast<int>(radiance_.size()); }
    bool polarized() const noexcept override { return polarized_; }
    bool circular() const noexcept override { return false; }

    Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
        check_look_up(*this, channel, towards_light);
        return radiance_[static_cast<std::size_t>(channel)] * unit_sky(theta_phi_frame(-towards_light));
    }

    PshVector project(int order) const override {
        check_projection_order(order);
        // s0 is a polynomial of degree 2 and the spin part has order 2, so this small grid is exact.
        constexpr int sky_order = 2;
        constexpr int size = 2 * sky_order + 2;
        const LatitudeRows rows = fejer_rows(size);
        std::vector<double> samples(std::size_t{size} * size * 4);
        for (std::size_t j = 0; j < size; ++j) {
            for (std::size_t i = 0; i < size; ++i) {
                const double theta = rows.theta[j];
                const double phi = 2 * std::numbers::pi * static_cast<double>(i) / size;
                const glm::dvec3 along(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                       std::cos(theta));
                const Stokes s = unit_sky(theta_phi_frame(along));
                for (std::size_t p = 0; p < 4; ++p)
                    samples[(j * size + i) * 4 + p] = s[static_cast<glm::length_t>(p)];
            }
        }
        PshVector unit(sky_order, 1);
        PshTransform(sky_order, rows, size).analyze(samples, unit.channel(0));

        PshVector result(order, channels());
        const std::size_t count = 4 * psh_count(std::min(order, sky_order));
        for (int c = 0; c < channels(); ++c)
            for (std::size_t i = 0; i < count; ++i)
                result.channel(c)[i] = radiance_[static_cast<std::size_t>(c)] * unit.channel(0)[i];
        return result;
    }

    EquirectImage image() const override {
        constexpr int width = 512;
        constexpr int height = 257;
        EquirectImage image(width, height, channels());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const Stokes s = unit_sky(equirect_frame((x + 0.5) / width, y / (height - 1.0)));
                for (int c = 0; c < channels(); ++c)
                    for (std::size_t p = 0; p < 4; ++p)
                        image.at(c, y, x)[p] = static_cast<float>(radiance_[static_cast<std::size_t>(c)] *
                                                                  s[static_cast<glm::length_t>(p)]);
            }
        }
        return image;
    }

private:
    /// Returns the sky of radiance 1 in a frame whose z is the propagation direction. With e = sun x view,
    /// whose length is sin g, s0 DoLP = 3/4 dop_max |e|^2. The linear part is therefore a product of e with
    /// itself, without an angle or a division, and smooth at the sun.
    Stokes unit_sky(const Frame& frame) const {
        const glm::dvec3 view = -frame[2];
        const double cosine = glm::dot(sun_, view);
        const glm::dvec3 e = glm::cross(sun_, view);
        const double ex = glm::dot(e, frame[0]);
        const double ey = glm::dot(e, frame[1]);
        return 0.75 * Stokes(1 + cosine * cosine, dop_max_ * (ex * ex - ey * ey), dop_max_ * 2 * ex * ey, 0);
    }

    glm::dvec3 sun_;
    double dop_max_;
    std::vector<double> radiance_;
    bool polarized_ = false;
};

}  // namespace

glm::dvec3 unit_sun(const RayleighSky& sky) {
    // The direction is scaled first, so that the squared length neither overflows nor underflows.
    const glm::dvec3 a = glm::abs(sky.sun_direction);
    const double largest = std::max({a.x, a.y, a.z});
    const glm::dvec3 scaled = sky.sun_direction / largest;
    const double length = glm::length(scaled);
    if (!(largest > 0) || !std::isfinite(length))
        throw Error(ErrorCode::invalid_argument, "rayleigh_sky: sun_direction must be finite and not zero");
    if (!(sky.dop_max >= 0 && sky.dop_max <= 1))
        throw Error(ErrorCode::invalid_argument, "rayleigh_sky: dop_max must be 0 to 1");
    check_radiance("rayleigh_sky", sky.radiance);
    if (sky.turbidity == 0) return scaled / length;
    if (!(sky.turbidity >= 1.7 && sky.turbidity <= 10))
        throw Error(ErrorCode::invalid_argument, "rayleigh_sky: turbidity must be 0, or 1.7 to 10");
    if (sky.ground_albedo.size() != 1 && sky.ground_albedo.size() != sky.radiance.size())
        throw Error(ErrorCode::invalid_argument, "rayleigh_sky: ground_albedo has " +
                                                     std::to_string(sky.ground_albedo.size()) +
                                                     " values; it must have one, or one for each of the " +
                                                     std::to_string(sky.radiance.size()) + " channels");
    if (!std::ranges::all_of(sky.ground_albedo, [](double a) { return a >= 0 && a <= 1; }))
        throw Error(ErrorCode::invalid_argument, "rayleigh_sky: ground_albedo must be 0 to 1");
    if (scaled.y < 0)
        throw Error(ErrorCode::invalid_argument,
                    "rayleigh_sky: with turbidity, sun_direction must not point below the horizon (y < 0)");
    return scaled / length;
}

EnvironmentPtr rayleigh_sky(const RayleighSky& sky) {
    const glm::dvec3 sun = unit_sun(sky);
    if (sky.turbidity == 0) return std::make_shared<RayleighEnvironment>(sky, sun);
    return image_environment(turbid_sky_image(sky, sun));
}

}  // namespace nicol
