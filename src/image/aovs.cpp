// SPDX-License-Identifier: MIT
#include "image/aovs.hpp"

#include <limits>
#include <string>

#include "error.hpp"

namespace nicol {

Aovs::Aovs(int width_, int height_, std::uint32_t mask, int channels_)
    : width(width_), height(height_), channels(channels_) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if ((mask & aov_depth) != 0) depth.assign(pixels, std::numeric_limits<float>::infinity());
    if ((mask & aov_normals) != 0) normals.resize(3 * pixels);
    if ((mask & aov_positions) != 0) positions.resize(3 * pixels);
    if ((mask & aov_instances) != 0) instances.assign(pixels, kNoInstance);
    if ((mask & aov_alpha) != 0) alpha.resize(pixels);
    if ((mask & aov_variance) != 0) variance.resize(4 * static_cast<std::size_t>(channels) * pixels);
}

std::uint32_t Aovs::mask() const noexcept {
    const auto bit = [](const auto& plane, std::uint32_t value) { return plane.empty() ? 0U : value; };
    return bit(depth, aov_depth) | bit(normals, aov_normals) | bit(positions, aov_positions) |
           bit(instances, aov_instances) | bit(variance, aov_variance) | bit(alpha, aov_alpha);
}

bool Aovs::fit(int image_width, int image_height, int image_channels) const noexcept {
    if (mask() == 0) return true;
    return width == image_width && height == image_height && (variance.empty() || channels == image_channels);
}

void Aovs::check(const char* what) const {
    const std::size_t pixels =
        width < 0 || height < 0 ? 0 : static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto fits = [&](const auto& plane, std::size_t numbers) {
        return plane.empty() || plane.size() == numbers * pixels;
    };
    const std::size_t components = channels < 0 ? 0 : 4 * static_cast<std::size_t>(channels);
    if (fits(depth, 1) && fits(normals, 3) && fits(positions, 3) && fits(instances, 1) &&
        fits(variance, components) && fits(alpha, 1))
        return;
    throw Error(ErrorCode::invalid_argument, std::string(what) + ": a plane does not have " +
                                                 std::to_string(width) + " x " + std::to_string(height) +
                                                 " pixels");
}

}  // namespace nicol
