// SPDX-License-Identifier: MIT
#include "render/hidden_vertices.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>
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

// Distance in pixels from an edge within which a drawn image may show the triangle beyond it: corners are
// rounded by half of 1/256 of a pixel along both axes.
constexpr double kBesideEdge = 0x1p-9 * std::numbers::sqrt2;
// Offset of further rays along both axes, which lead over any edge within kBesideEdge.
constexpr double kBeyondEdge = 0x1p-8;

// Returns the size of an image in pixels.
glm::ivec2 size_of(const Projection& projection) {
    return {static_cast<int>(std::lround(2 / projection.pixel.x)),
            static_cast<int>(std::lround(2 / projection.pixel.y))};
}

// Returns where a point is in an image of some size, in pixels, right and down from the upper left corner;
// nothing for points beside the camera or behind it.
std::optional<glm::dvec2> place_of(const Projection& projection, const glm::ivec2& size,
                                   const glm::vec3& point) {
    const glm::dvec4 clip = projection.world_to_clip * glm::dvec4(point, 1);
    if (!(clip.w > 0)) return std::nullopt;
    return glm::dvec2((clip.x / clip.w + 1) / 2 * size.x, (1 - clip.y / clip.w) / 2 * size.y);
}

// Triangles at places of an image.
class Places {
public:
    Places(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
           std::vector<std::uint8_t>& shown)
        : geometry_(geometry),
          rays_(rays),
          projection_(projection),
          shown_(shown),
          size_(size_of(projection)) {}

    [[nodiscard]] const glm::ivec2& size() const noexcept { return size_; }

    // Shows the triangle at a place, and those beyond its edges if these are close.
    void show(const glm::dvec2& place) const {
        const std::optional<std::uint32_t> triangle = show_at(place);
        if (!triangle || !is_beside_edge(*triangle, place)) return;
        for (const double x : {-kBeyondEdge, kBeyondEdge})
            for (const double y : {-kBeyondEdge, kBeyondEdge}) show_at(place + glm::dvec2(x, y));
    }

private:
    // Shows the triangle at a place, and returns it if there is one.
    std::optional<std::uint32_t> show_at(const glm::dvec2& place) const {
        const std::optional<RayHit> hit =
            rays_.intersect(pixel_ray(projection_, size_.x, size_.y, place.x, place.y));
        if (!hit) return std::nullopt;
        set(shown_, geometry_.triangles[hit->triangle]);
        return hit->triangle;
    }

    [[nodiscard]] bool is_beside_edge(std::uint32_t triangle, const glm::dvec2& place) const {
        const glm::uvec3& corners = geometry_.triangles[triangle];
        std::array<glm::dvec2, 3> from;
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::optional<glm::dvec2> corner =
                place_of(projection_, size_, geometry_.positions[corners[k]]);
            if (!corner) return true;
            from[static_cast<std::size_t>(k)] = *corner - place;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 &a = from[k], &b = from[(k + 1) % 3];
            const double area = a.x * b.y - a.y * b.x;  // of the parallelogram of edge and place
            if (area * area <= kBesideEdge * kBesideEdge * glm::dot(b - a, b - a)) return true;
        }
        return false;
    }

    const WorldGeometry& geometry_;
    const RayScene& rays_;
    const Projection& projection_;
    std::vector<std::uint8_t>& shown_;
    glm::ivec2 size_;
};

// Distances along the view direction of the surfaces at the centres of an image's pixels.
class Depths {
public:
    // Sets shown[v] to 1 for each vertex of a triangle at a pixel's centre.
    Depths(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
           std::vector<std::uint8_t>& shown)
        : projection_(projection),
          size_(size_of(projection)),
          farthest_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y),
                    std::numeric_limits<float>::infinity()) {
        tbb::parallel_for(0, size_.y, [&](int y) {
            for (int x = 0; x < size_.x; ++x) {
                const Ray ray = pixel_ray(projection, size_.x, size_.y, x + 0.5, y + 0.5);
                const std::optional<RayHit> hit = rays.intersect(ray);
                if (!hit) continue;
                const glm::uvec3& corners = geometry.triangles[hit->triangle];
                set(shown, corners);
                // Other rays may pass where an alpha mask has stopped this one.
                if (opacity_of(*geometry.ranges[range_of(geometry, corners.x)].material) != nullptr) continue;
                farthest_[index(x, y)] =
                    static_cast<float>(hit->distance * glm::dot(ray.direction, projection.view.forward));
            }
        });
        spread(1, size_.x, size_.y);
        spread(size_.x, size_.y, size_.x);
    }

    // Returns whether a point is behind all that rays meet around it.
    [[nodiscard]] bool hide(const glm::vec3& point) const {
        const std::optional<glm::dvec2> place = place_of(projection_, size_, point);
        if (!place || !(place->x >= 0 && place->y >= 0 && place->x < size_.x && place->y < size_.y))
            return false;
        const double depth = glm::dot(glm::dvec3(point) - projection_.view.eye, projection_.view.forward);
        const std::size_t pixel = index(static_cast<int>(place->x), static_cast<int>(place->y));
        return static_cast<float>(depth) * (1 - kBehind) > farthest_[pixel];
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
    }

    // Replaces each distance by the largest one in reach along lines of `length` pixels that are `step`
    // apart.
    void spread(std::ptrdiff_t step, std::ptrdiff_t length, std::ptrdiff_t lines) {
        const std::ptrdiff_t between = step == 1 ? size_.x : 1;
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
    glm::ivec2 size_;
    std::vector<float> farthest_;  // row by row; infinite without a surface
};

// Shows the triangles of which a corner is not behind all that rays meet around it, among those that
// `passes(t)` admits.
template <class Passes>
void show_unhidden(const WorldGeometry& geometry, const Depths& depths, std::span<const std::uint8_t> visible,
                   std::vector<std::uint8_t>& shown, const Passes& passes) {
    std::vector<std::uint8_t> hidden(visible.size());
    tbb::parallel_for(Range(0, visible.size(), kGrain), [&](const Range& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v)
            hidden[v] = visible[v] != 0 && depths.hide(geometry.positions[v]) ? 1 : 0;
    });
    tbb::parallel_for(Range(0, geometry.triangles.size(), kGrain), [&](const Range& range) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
            const glm::uvec3& corners = geometry.triangles[t];
            if (!passes(t) || (visible[corners.x] & visible[corners.y] & visible[corners.z]) == 0) continue;
            if ((hidden[corners.x] & hidden[corners.y] & hidden[corners.z]) == 0) set(shown, corners);
        }
    });
}

}  // namespace

void remove_hidden(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
                   std::vector<std::uint8_t>& visible) {
    std::vector<std::uint8_t> shown(visible.size());
    const Depths depths(geometry, rays, projection, shown);
    show_unhidden(geometry, depths, visible, shown, [](std::size_t) { return true; });
    for (std::size_t v = 0; v < visible.size(); ++v) visible[v] &= shown[v];
}

void remove_unsampled(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
                      std::span<const glm::dvec2> samples, std::vector<std::uint8_t>& visible) {
    std::vector<std::uint8_t> shown(visible.size());
    const Places places(geometry, rays, projection, shown);
    tbb::parallel_for(0, places.size().y, [&](int y) {
        for (int x = 0; x < places.size().x; ++x)
            for (const glm::dvec2& sample : samples) places.show(glm::dvec2(x, y) + 0.5 + sample);
    });
    if (!geometry.blocking.empty()) {
        const Depths depths(geometry, rays, projection, shown);
        show_unhidden(geometry, depths, visible, shown, [&](std::size_t t) {
            return geometry.blocking[t].x == geometry.blocking[t].y;  // rays pass it
        });
    }
    for (std::size_t v = 0; v < visible.size(); ++v) visible[v] &= shown[v];
}

}  // namespace nicol
