// SPDX-License-Identifier: MIT
// Meisters' two ears theorem: a simple polygon has a corner whose triangle lies inside of it and contains no
// other corner. It is cut off, and what is left is a simple polygon again.
#include "geometry/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>

namespace nicol::geometry {
namespace {

// Clipping takes time with the square of the corners.
constexpr std::size_t kMost = 1024;

// Twice the area of a triangle, above 0 where it turns left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Clipper {
public:
    Clipper(std::span<const glm::dvec3> corners, const glm::dvec3& normal, std::vector<glm::uvec3>& out)
        : out_(out) {
        // Onto the plane that shows most of it.
        const glm::dvec3 size = glm::abs(normal);
        const glm::length_t drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
        const bool mirrored = normal[drop] < 0;
        for (const glm::dvec3& p : corners) {
            const glm::dvec2 q(p[(drop + 1) % 3], p[(drop + 2) % 3]);
            points_.push_back(mirrored ? glm::dvec2(q.y, q.x) : q);
        }
        left_.resize(corners.size());
        std::iota(left_.begin(), left_.end(), 0U);
    }

    void run() {
        std::size_t at = 0;
        std::size_t failed = 0;
        while (left_.size() > 3) {
            at %= left_.size();
            if (!is_ear(at)) {
                ++at;
                if (++failed < left_.size()) continue;
                // None is left where the polygon crosses itself: the largest corner is as good as any.
                at = largest();
            }
            failed = 0;
            cut(at);
            // The next but one: triangles become less thin than around one corner.
            ++at;
        }
        out_.emplace_back(left_[0], left_[1], left_[2]);
    }

private:
    [[nodiscard]] glm::uvec3 around(std::size_t at) const {
        const std::size_t n = left_.size();
        return {left_[(at + n - 1) % n], left_[at], left_[(at + 1) % n]};
    }
    [[nodiscard]] double area(std::size_t at) const {
        const glm::uvec3 t = around(at);
        return turn(points_[t.x], points_[t.y], points_[t.z]);
    }
    [[nodiscard]] bool is_ear(std::size_t at) const {
        if (!(area(at) > 0)) return false;
        const glm::uvec3 t = around(at);
        const glm::dvec2& a = points_[t.x];
        const glm::dvec2& b = points_[t.y];
        const glm::dvec2& c = points_[t.z];
        return std::ranges::none_of(left_, [&](std::uint32_t i) {
            const glm::dvec2& p = points_[i];
            // Where a bridge leads to a hole, corners lie in the same place.
            if (p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }
    [[nodiscard]] std::size_t largest() const {
        std::size_t best = 0;
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (area(i) > most) {
                most = area(i);
                best = i;
            }
        }
        return best;
    }
    void cut(std::size_t at) {
        out_.push_back(around(at));
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
    }

    std::vector<glm::uvec3>& out_;
    std::vector<glm::dvec2> points_;
    std::vector<std::uint32_t> left_;
};

// Whether a fan about the first corner covers it without flat or flipped triangles.
bool fan_covers(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
    const double least = 1e-12 * glm::dot(normal, normal);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 triangle = glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
        if (!(glm::dot(triangle, normal) > least)) return false;
    }
    return true;
}

// The normal of a polygon, planar or not, its length twice the area (Newell).
glm::dvec3 area_normal(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

}  // namespace

void clip_ears(std::span<const glm::dvec3> corners, std::vector<glm::uvec3>& out) {
    const glm::dvec3 normal = corners.size() == 3 ? glm::dvec3(0) : area_normal(corners);
    if (corners.size() == 3 || corners.size() > kMost || fan_covers(corners, normal)) {
        for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) out.emplace_back(0, i, i + 1);
        return;
    }
    Clipper(corners, normal, out).run();
}

}  // namespace nicol::geometry
