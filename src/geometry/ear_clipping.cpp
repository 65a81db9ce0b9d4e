// SPDX-License-Identifier: MIT
// Triangulation by Meisters' two ears theorem: a simple polygon has a corner whose triangle lies inside of it
// and contains no other corner. Cutting off that corner leaves a simple polygon.
#include "geometry/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace nicol::geometry {
namespace {

// Largest number of corners that are clipped; the time grows with the square of the corners.
constexpr std::size_t kMost = 1024;

// Returns twice the signed area of a triangle, positive for a left turn.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Clips one polygon in a time of at most the square of its corners. Cutting an ear changes only whether its
/// two neighbours are ears, and only reflex corners can lie in the triangle of another corner.
class Clipper {
public:
    Clipper(std::span<const glm::dvec3> corners, const glm::dvec3& normal, const LoadBudget& budget,
            std::vector<glm::uvec3>& out)
        : budget_(budget), out_(out) {
        // The polygon is projected onto the coordinate plane where its area is largest.
        const glm::dvec3 size = glm::abs(normal);
        const glm::length_t drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
        const bool mirrored = normal[drop] < 0;
        const auto count = static_cast<std::uint32_t>(corners.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const glm::dvec3& p = corners[i];
            const glm::dvec2 q(p[(drop + 1) % 3], p[(drop + 2) % 3]);
            points_.push_back(mirrored ? glm::dvec2(q.y, q.x) : q);
            before_.push_back((i + count - 1) % count);
            after_.push_back((i + 1) % count);
        }
        reflex_at_.assign(corners.size(), kNotReflex);
        waits_.assign(corners.size(), false);
        for (std::uint32_t i = 0; i < count; ++i) note_angle(i);
        left_ = count;
    }

    void run() {
        // Every other corner comes first: triangles become less thin than around one corner.
        for (const std::uint32_t first : {0U, 1U})
            for (std::uint32_t i = first; i < points_.size(); i += 2) wait(i);
        // Rounding hides ears; a few more passes find them.
        int passes = 4;
        while (left_ > 3) {
            if (waiting_.empty() && passes-- > 0) {
                for_each_left([&](std::uint32_t i) { wait(i); });
            } else if (waiting_.empty()) {
                // No ear is left if the polygon crosses itself; the largest corner is as good as any.
                cut(largest());
            } else {
                const std::uint32_t i = waiting_.front();
                waiting_.pop_front();
                if (!waits_[i]) continue;
                waits_[i] = false;
                if (is_ear(i)) cut(i);
            }
        }
        out_.push_back(around(last_));
    }

private:
    static constexpr std::size_t kNotReflex = ~std::size_t{0};

    [[nodiscard]] glm::uvec3 around(std::uint32_t i) const { return {before_[i], i, after_[i]}; }
    [[nodiscard]] double area(std::uint32_t i) const {
        return turn(points_[before_[i]], points_[i], points_[after_[i]]);
    }

    [[nodiscard]] bool is_ear(std::uint32_t i) const {
        budget_.step(reflex_.size() + 1);
        if (!(area(i) > 0)) return false;
        const glm::dvec2 a = points_[before_[i]];
        const glm::dvec2 b = points_[i];
        const glm::dvec2 c = points_[after_[i]];
        return std::ranges::none_of(reflex_, [&](std::uint32_t other) {
            const glm::dvec2& p = points_[other];
            // Corners coincide where a bridge leads to a hole.
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 && p != a && p != b &&
                   p != c;
        });
    }

    void wait(std::uint32_t i) {
        if (waits_[i]) return;
        waits_[i] = true;
        waiting_.push_back(i);
    }

    void cut(std::uint32_t i) {
        out_.push_back(around(i));
        const std::uint32_t before = before_[i];
        const std::uint32_t after = after_[i];
        after_[before] = after;
        before_[after] = before;
        waits_[i] = false;
        set_reflex(i, false);
        --left_;
        last_ = after;
        for (const std::uint32_t neighbour : {before, after}) {
            note_angle(neighbour);
            wait(neighbour);
        }
    }

    void note_angle(std::uint32_t i) { set_reflex(i, !(area(i) > 0)); }

    void set_reflex(std::uint32_t i, bool reflex) {
        if (reflex == (reflex_at_[i] != kNotReflex)) return;
        if (reflex) {
            reflex_at_[i] = reflex_.size();
            reflex_.push_back(i);
        } else {
            reflex_[reflex_at_[i]] = reflex_.back();
            reflex_at_[reflex_.back()] = reflex_at_[i];
            reflex_.pop_back();
            reflex_at_[i] = kNotReflex;
        }
    }

    template <class Visit>
    void for_each_left(const Visit& visit) const {
        std::uint32_t i = last_;
        do {
            visit(i);
            i = after_[i];
        } while (i != last_);
    }

    [[nodiscard]] std::uint32_t largest() const {
        budget_.step(left_);
        std::uint32_t best = last_;
        for_each_left([&](std::uint32_t i) {
            if (area(i) > area(best)) best = i;
        });
        return best;
    }

    const LoadBudget& budget_;
    std::vector<glm::uvec3>& out_;
    std::vector<glm::dvec2> points_;
    std::vector<std::uint32_t> before_, after_;  // the neighbours of a corner among those that are left
    std::vector<std::uint32_t> reflex_;          // corners that turn right or go straight on
    std::vector<std::size_t> reflex_at_;         // by corner, its place in reflex_
    std::deque<std::uint32_t> waiting_;          // corners that may be ears
    std::vector<bool> waits_;                    // by corner
    std::uint32_t left_ = 0;
    std::uint32_t last_ = 0;  // any one of the corners that are left
};

// Returns whether a fan about the first corner covers the polygon without flat or flipped triangles.
bool fan_covers(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
    const double least = 1e-12 * glm::dot(normal, normal);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 triangle = glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
        if (!(glm::dot(triangle, normal) > least)) return false;
    }
    return true;
}

// Returns the normal of a polygon, planar or not; its length is twice the area (Newell).
glm::dvec3 area_normal(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

}  // namespace

void clip_ears(std::span<const glm::dvec3> corners, const LoadBudget& budget, std::vector<glm::uvec3>& out) {
    const glm::dvec3 normal = corners.size() == 3 ? glm::dvec3(0) : area_normal(corners);
    if (corners.size() == 3 || corners.size() > kMost || fan_covers(corners, normal)) {
        for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) out.emplace_back(0, i, i + 1);
        return;
    }
    Clipper(corners, normal, budget, out).run();
}

}  // namespace nicol::geometry
