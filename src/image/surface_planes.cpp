// SPDX-License-Identifier: MIT
// Sizes and contents of planes of surfaces.
#include "nicol/surface_planes.hpp"

#include <limits>
#include <string>

#include "nicol/error.hpp"

namespace nicol {

SurfacePlanes::SurfacePlanes(int width_, int height_, std::uint32_t planes) : width(width_), height(height_) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if ((planes & plane_depth) != 0) depth.assign(pixels, std::numeric_limits<float>::infinity());
    if ((planes & plane_normals) != 0) normals.resize(3 * pixels);
    if ((planes & plane_positions) != 0) positions.resize(3 * pixels);
    if ((planes & plane_instances) != 0) instances.assign(pixels, kNoInstance);
}

std::uint32_t SurfacePlanes::planes() const noexcept {
    const auto bit = [](const auto& plane, std::uint32_t value) { return plane.empty() ? 0U : value; };
    return bit(depth, plane_depth) | bit(normals, plane_normals) | bit(positions, plane_positions) |
           bit(instances, plane_instances);
}

void SurfacePlanes::check(const char* what) const {
    const std::size_t pixels =
        width < 0 || height < 0 ? 0 : static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto fits = [&](const auto& plane, std::size_t numbers) {
        return plane.empty() || plane.size() == numbers * pixels;
    };
    if (fits(depth, 1) && fits(normals, 3) && fits(positions, 3) && fits(instances, 1)) return;
    throw Error(ErrorCode::invalid_argument, std::string(what) + ": a plane does not have " +
                                                 std::to_string(width) + " x " + std::to_string(height) +
                                                 " pixels");
}

}  // namespace nicol
