// SPDX-License-Identifier: MIT
#include "render/cpu/pixel_batch.hpp"

#include <algorithm>

#include "render/hit_image.hpp"

namespace nicol {

void PixelBatch::take(const PixelInput& input, std::span<const PixelPoint> points) {
    const std::uint64_t group = points.front().group();
    std::size_t count = 0;
    while (count < points.size() && count < kMost && points[count].group() == group) ++count;
    points_ = points.first(count);
    weights_ = {};
    find_surfaces(input);
    const VertexRange& range = input.geometry.ranges[points_.front().range];
    if (range.material->variation() != nullptr) find_textures(input, range);
}

void PixelBatch::find_surfaces(const PixelInput& input) {
    const WorldGeometry& geometry = input.geometry;
    const auto width = static_cast<std::size_t>(input.hits.width());
    for (std::size_t begin = 0; begin < points_.size(); begin += kLanes) {
        const std::size_t count = std::min(kLanes, points_.size() - begin);
        std::array<Corners, kLanes> triangles;
        std::array<glm::vec2, kLanes> at;
        for (std::size_t i = 0; i < count; ++i) {
            const PixelPoint& point = points_[begin + i];
            triangles[i] = geometry.triangles[point.triangle];
            const std::size_t column = point.pixel % width;
            const std::size_t row = point.pixel / width;
            at[i] =
                glm::vec2(on_image_plane(input.projection, input.hits.width(), input.hits.height(),
                                         static_cast<double>(column) + 0.5 + static_cast<double>(point.at.x),
                                         static_cast<double>(row) + 0.5 + static_cast<double>(point.at.y)));
        }
        find_surface(input.view, geometry.positions, geometry.normals, std::span(triangles).first(count),
                     std::span(at).first(count), surfaces_[begin / kLanes]);
    }
}

void PixelBatch::find_textures(const PixelInput& input, const VertexRange& range) {
    triangles_.clear();
    for (const PixelPoint& point : points_) triangles_.push_back(point.triangle);
    textures_.find(*range.material->variation(), is_back(input.geometry, range),
                   {.geometry = input.geometry,
                    .projection = input.projection,
                    .width = input.hits.width(),
                    .height = input.hits.height()},
                   triangles_, std::span(surfaces_).first(surfaces().size()));
    weights_ = textures_.weights();
}

void PixelBatch::gather(std::span<const std::span<glm::vec4>> stokes, std::size_t components,
                        std::size_t first, std::span<const std::span<glm::vec4>> out) const {
    glm::vec4 wanted(0);
    for (std::size_t p = 0; p < components; ++p) wanted[static_cast<glm::length_t>(p)] = 1;
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < points_.size(); ++i)
            out[c][points_[i].pixel - first] += points_[i].weight * wanted * stokes[c][i];
}

}  // namespace nicol
