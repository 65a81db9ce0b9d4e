// SPDX-License-Identifier: MIT
#include "light/image_light.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "light/environment_checks.hpp"
#include "light/equirect.hpp"
#include "light/equirect_projection.hpp"

namespace nicol {

Stokes look_up(const EquirectView& view, int channel, const glm::dvec3& towards_light) {
    const glm::dvec2 uv = equirect_coordinates(towards_light);
    const double column = uv.x * view.width - 0.5;
    const double row = uv.y * (view.height - 1);
    const int left = static_cast<int>(std::floor(column));
    const int top = std::min(static_cast<int>(row), view.height - 2);
    const double a = column - left;
    const double b = row - top;
    const int x0 = left < 0 ? view.width - 1 : left;
    const int x1 = left + 1 < view.width ? left + 1 : 0;
    const float* corner = view.values + static_cast<std::size_t>(channel) * view.channel_stride +
                          static_cast<std::size_t>(top) * view.row_stride;
    const auto pixel = [&](const float* from, int x) {
        const float* v = from + static_cast<std::size_t>(x) * view.pixel_stride;
        return view.components == 1 ? Stokes(v[0], 0, 0, 0) : Stokes(v[0], v[1], v[2], v[3]);
    };
    const auto between = [&](const float* from) { return (1 - a) * pixel(from, x0) + a * pixel(from, x1); };
    const Stokes s = (1 - b) * between(corner) + b * between(corner + view.row_stride);
    if (view.components == 1) return s;
    return rotated(s, angle_between(equirect_frame(uv.x, uv.y), theta_phi_frame(-towards_light)));
}

ImageLight::ImageLight(EquirectImage image) : image_(std::move(image)) {
    for (std::size_t i = 0; i < image_.data.size(); i += 4) {
        circular_ = circular_ || image_.data[i + 3] != 0;
        polarized_ = polarized_ || circular_ || image_.data[i + 1] != 0 || image_.data[i + 2] != 0;
    }
}

Stokes ImageLight::radiance(int channel, const glm::dvec3& towards_light) const {
    check_look_up(*this, channel, towards_light);
    return look_up(pixels(), channel, towards_light);
}

PshVector ImageLight::project(int order) const {
    return project_equirect(pixels(), order);
}

EquirectView ImageLight::pixels() const noexcept {
    EquirectView view = view_of(image_);
    if (!polarized_) view.components = 1;
    return view;
}

}  // namespace nicol
