// SPDX-License-Identifier: MIT
#include "render/hidden_vertices.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>

#include "scene/pixel_ray.hpp"

namespace nicol {
namespace {

using Range = tbb::blocked_range<std::size_t>;

constexpr std::size_t kGrain = 4096;
constexpr std::ptrdiff_t kReach = 2;  // pixels around a vertex
// Part of its distance that a vertex must be behind what rays meet, to count as hidden.
constexpr float kBehind = 1e-3F;

// Sets flags that other threads may set as well.
void set(std::vector<std::uint8_t>& flags, const glm::uvec3& corners) {
    for (glm::length_t k = 0; k < 3; ++k)
        std::atomic_ref(flags[corners[k]]).store(1, std::memory_order_relaxed);
}

// Distances along the view direction of the surfaces at the centres of an image's pixels.
class Depths {
public:
    // Sets shown[v] to 1 for each vertex of a triangle at a pixel's centre.
    Depths(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
           std::vector<std::uint8_t>& shown)
        : projection_(projection),
          width_(static_cast<std::ptrdiff_t>(std::lround(2 / projection.pixel.x))),
          height_(static_cast<std::ptrdiff_t>(std::lround(2 / projection.pixel.y))),
          farthest_(static_cast<std::size_t>(width_ * height_), std::numeric_limits<float>::infinity()) {
        tbb::parallel_for(std::ptrdiff_t{0}, height_, [&](std::ptrdiff_t y) {
            for (std::ptrdiff_t x = 0; x < width_; ++x) {
                const Ray ray = pixel_ray(projection, static_cast<int>(width_), static_cast<int>(height_),
                                          static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
                const std::optional<RayHit> hit = rays.intersect(ray);
                if (!hit) continue;
                const glm::uvec3& corners = geometry.triangles[hit->triangle];
                set(shown, corners);
                // Other rays may pass where an alpha mask has stopped this one.
                if (opacity_of(*geometry.ranges[range_of(geometry, corners.x)].material) != nullptr) continue;
                at(x, y) =
                    static_cast<float>(hit->distance * glm::dot(ray.direction, projection.view.forward));
            }
        });
        spread(1, width_, height_);
        spread(width_, height_, width_);
    }

    // Returns whether a point is behind all that rays meet around it.
    [[nodiscard]] bool hide(const glm::vec3& point) const {
        const glm::dvec4 clip = projection_.world_to_clip * glm::dvec4(point, 1);
        if (!(clip.w > 0)) return false;
        const double x = (clip.x / clip.w + 1) / 2 * static_cast<double>(width_);
        const double y = (1 - clip.y / clip.w) / 2 * static_cast<double>(height_);
        if (!(x >= 0 && y >= 0 && x < static_cast<double>(width_) && y < static_cast<double>(height_)))
            return false;
        const double depth = glm::dot(glm::dvec3(point) - projection_.view.eye, projection_.view.forward);
        const auto index = static_cast<std::ptrdiff_t>(y) * width_ + static_cast<std::ptrdiff_t>(x);
        return static_cast<float>(depth) * (1 - kBehind) > farthest_[static_cast<std::size_t>(index)];
    }

private:
    [[nodiscard]] float& at(std::ptrdiff_t x, std::ptrdiff_t y) {
        return farthest_[static_cast<std::size_t>(y * width_ + x)];
    }

    // Replaces each distance by the largest one in reach along lines of `length` pixels that are `step`
    // apart.
    void spread(std::ptrdiff_t step, std::ptrdiff_t length, std::ptrdiff_t lines) {
        const std::ptrdiff_t between = step == 1 ? width_ : 1;
        tbb::parallel_for(std::ptrdiff_t{0}, lines, [&](std::ptrdiff_t line) {
            std::vector<float> values(static_cast<std::size_t>(length));
            float* const first = farthest_.data() + line * between;
            for (std::ptrdiff_t i = 0; i < length; ++i) values[static_cast<std::size_t>(i)] = first[i * step];
            for (std::ptrdiff_t i = 0; i < length; ++i) {
                const auto from = values.begin() + std::max(i - kReach, std::ptrdiff_t{0});
                const auto to = values.begin() + std::min(i + kReach + 1, length);
                first[i * step] = *std::max_element(from, to);
            }
        });
    }

    const Projection& projection_;
    std::ptrdiff_t width_, height_;
    std::vector<float> farthest_;  // row by row; infinite without a surface
};

}  // namespace

void remove_hidden(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
                   std::vector<std::uint8_t>& visible) {
    std::vector<std::uint8_t> shown(visible.size());
    const Depths depths(geometry, rays, projection, shown);
    std::vector<std::uint8_t> hidden(visible.size());
    tbb::parallel_for(Range(0, visible.size(), kGrain), [&](const Range& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v)
            hidden[v] = visible[v] != 0 && depths.hide(geometry.positions[v]) ? 1 : 0;
    });
    tbb::parallel_for(Range(0, geometry.triangles.size(), kGrain), [&](const Range& range) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
            const glm::uvec3& corners = geometry.triangles[t];
            if ((visible[corners.x] & visible[corners.y] & visible[corners.z]) == 0) continue;
            if ((hidden[corners.x] & hidden[corners.y] & hidden[corners.z]) == 0) set(shown, corners);
        }
    });
    for (std::size_t v = 0; v < visible.size(); ++v) visible[v] &= shown[v];
}

}  // namespace nicol
