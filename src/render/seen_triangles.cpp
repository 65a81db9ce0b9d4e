// SPDX-License-Identifier: MIT
#include "render/seen_triangles.hpp"

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace nicol {
namespace {

// Number of triangles in a sample, if there are as many.
constexpr std::size_t kSampledTriangles = 2048;

// A polygon in clip space. A triangle that five planes cut has at most eight corners.
struct ClippedTriangle {
    std::array<glm::dvec4, 8> corners;
    std::size_t size = 0;
    [[nodiscard]] std::span<const glm::dvec4> used() const { return std::span(corners).first(size); }
};

// Returns the part of a polygon in which distance(corner), a linear function, is not negative.
template <class Distance>
ClippedTriangle clipped(const ClippedTriangle& polygon, const Distance& distance) {
    if (std::ranges::all_of(polygon.used(), [&](const glm::dvec4& p) { return distance(p) >= 0; }))
        return polygon;
    ClippedTriangle out;
    const auto add = [&out](const glm::dvec4& p) {
        if (out.size < out.corners.size()) out.corners[out.size++] = p;
    };
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const glm::dvec4& here = polygon.corners[k];
        const glm::dvec4& next = polygon.corners[(k + 1) % polygon.size];
        const double inside = distance(here), then = distance(next);
        if (inside >= 0) add(here);
        if ((inside >= 0) != (then >= 0)) add(here + inside / (inside - then) * (next - here));
    }
    return out;
}

double twice_area(const WorldGeometry& geometry, const glm::uvec3& t) {
    const glm::dvec3 a(geometry.positions[t.x]);
    return glm::length(
        glm::cross(glm::dvec3(geometry.positions[t.y]) - a, glm::dvec3(geometry.positions[t.z]) - a));
}

}  // namespace

double shown_share(const Projection& projection, const std::array<glm::vec3, 3>& corners, double grazing) {
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
    const double length = glm::length(normal);
    double least = projection.near_clip;
    if (projection.view.orthographic) {
        const double facing = glm::dot(normal, projection.view.towards(a));
        if (!(facing > 0) || facing > grazing * length) return 0;
    } else {
        const double height = glm::dot(normal, projection.view.eye - a);  // times the length
        if (!(height > 0)) return 0;
        if (grazing < 1) least = std::max(least, height / (grazing * length));
    }
    const auto to_clip = [&](const glm::vec3& p) { return projection.world_to_clip * glm::dvec4(p, 1); };
    ClippedTriangle polygon{.corners = {to_clip(corners[0]), to_clip(corners[1]), to_clip(corners[2])},
                            .size = 3};
    const bool parallel = projection.view.orthographic;
    polygon = clipped(polygon, [=](const glm::dvec4& p) { return p.w - (parallel ? p.z : least); });
    for (const glm::length_t axis : {0, 1})
        for (const double sign : {-1.0, 1.0})
            polygon = clipped(polygon, [=](const glm::dvec4& p) { return p.w - sign * p[axis]; });
    double area = 0;
    for (std::size_t k = 2; k < polygon.size; ++k) {
        const auto at = [&](std::size_t i) { return glm::dvec2(polygon.corners[i]) / polygon.corners[i].w; };
        const glm::dvec2 u = at(k - 1) - at(0), v = at(k) - at(0);
        area += std::abs(u.x * v.y - u.y * v.x) / 2;
    }
    return area / 4;  // the image has an area of 4 in clip space
}

void SeenTriangles::update(const WorldGeometry& geometry, Version version) {
    sampling_.run(version, [&] {
        sample_.clear();
        const std::size_t triangles = geometry.triangles.size();
        if (triangles <= kSampledTriangles) {
            sample_.reserve(triangles);
            for (std::uint32_t i = 0; i < triangles; ++i) sample_.push_back({.triangle = i, .weight = 1});
            return;
        }
        double all = 0;
        for (const glm::uvec3& t : geometry.triangles) all += twice_area(geometry, t);
        sample_.reserve(kSampledTriangles);
        // The triangles in which the sum of expected numbers passes the middle of each unit.
        double passed = 0, reached = 0.5;
        for (std::uint32_t i = 0; i < triangles; ++i) {
            const double part = (all > 0 ? twice_area(geometry, geometry.triangles[i]) / all : 0) +
                                1 / static_cast<double>(triangles);
            const double expected = 0.5 * kSampledTriangles * part;
            passed += expected;
            if (passed < reached) continue;
            const double count = std::floor(passed - reached) + 1;
            reached += count;
            sample_.push_back({.triangle = i, .weight = count / expected});
        }
    });
}

}  // namespace nicol
