// SPDX-License-Identifier: MIT
#include "visibility/disturbed_rays.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "visibility/ray_boxes.hpp"
#include "visibility/ray_cones.hpp"

namespace nicol {
namespace {

// Margin of radii against rounding, relative to the distance.
constexpr float kSlack = 1e-4F;
// Nodes of a tree are not divided if the sine of the angle of their radius is smaller.
constexpr float kSmall = 0.1F;
// Sines of the angles of the masks' balls.
constexpr std::array kMaskSines{0.03F, kSmall};
// Number of balls from which on masks are worth their computation.
constexpr std::size_t kManyBalls = 32;
// Cells of the masks along an edge of the octahedral map; even, so that no cell crosses an axis.
constexpr std::size_t kCells = 64;

Ball ball_around(const Ball& a, const Ball& b) {
    const glm::vec3 between = b.centre - a.centre;
    const float distance = glm::length(between);
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    const float radius = 0.5F * (distance + a.radius + b.radius);
    return {.centre = a.centre + (radius - a.radius) / distance * between, .radius = (1 + kSlack) * radius};
}

// Returns the unit direction at a point of the octahedral map, which covers -1 .. 1 along both axes.
glm::vec3 from_octahedral(float x, float y) {
    glm::vec3 v(x, y, 1 - std::abs(x) - std::abs(y));
    if (v.z < 0) {
        v.x = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
        v.y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
    }
    return glm::normalize(v);
}

// Returns the index of the cell of the octahedral map that contains a direction of any length.
std::size_t cell_of(const glm::vec3& direction) {
    const float scale = 1 / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    glm::vec2 at(direction.x * scale, direction.y * scale);
    if (direction.z < 0)
        at = {(1 - std::abs(at.y)) * (at.x < 0 ? -1.0F : 1.0F),
              (1 - std::abs(at.x)) * (at.y < 0 ? -1.0F : 1.0F)};
    const auto cell = [](float x) {
        return std::min(static_cast<std::size_t>((x + 1) * (kCells / 2.0F)), kCells - 1);
    };
    return cell(at.y) * kCells + cell(at.x);
}

}  // namespace

// Node of a tree of balls: a given ball, or a ball around the two nodes at `children` and the next place. The
// first node is the root.
struct DisturbedRays::Node {
    Ball ball;
    std::uint32_t children = 0;  // 0: the ball is a given one
    std::uint32_t number = 0;    // of a given ball
};

namespace {

template <class Node>
std::vector<Node> tree_of(std::span<const Ball> balls) {
    std::vector<Node> tree;
    if (balls.empty()) return tree;
    std::vector<Node> sorted;
    sorted.reserve(balls.size());
    for (const Ball& ball : balls)
        sorted.push_back({.ball = ball, .number = static_cast<std::uint32_t>(sorted.size())});
    const auto build = [&](const auto& self, std::size_t place, std::size_t first, std::size_t last) -> void {
        if (last - first == 1) {
            tree[place] = sorted[first];
            return;
        }
        glm::vec3 least = sorted[first].ball.centre;
        glm::vec3 most = least;
        for (std::size_t i = first; i < last; ++i) {
            least = glm::min(least, sorted[i].ball.centre);
            most = glm::max(most, sorted[i].ball.centre);
        }
        const glm::vec3 size = most - least;
        const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = (first + last) / 2;
        const auto at = [&](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(last), [axis](const Node& a, const Node& b) {
            return a.ball.centre[axis] < b.ball.centre[axis];
        });
        const std::size_t children = tree.size();
        tree.resize(children + 2);
        self(self, children, first, middle);
        self(self, children + 1, middle, last);
        tree[place] = {.ball = ball_around(tree[children].ball, tree[children + 1].ball),
                       .children = static_cast<std::uint32_t>(children)};
    };
    tree.resize(1);
    build(build, 0, 0, sorted.size());
    return tree;
}

}  // namespace

class DisturbedRays::Finder {
public:
    Finder(const DirectionSet& directions, bool many) : directions_(directions), cones_(directions) {
        if (many) make_masks();
    }

    // Adds the rays that may meet balls of a tree. boxes: by number of a ball, or empty.
    void mark(const std::vector<Node>& tree, std::span<const Box> boxes, const glm::vec3& origin,
              const glm::vec3& normal, std::vector<std::uint16_t>& bits) const {
        if (tree.empty()) return;
        std::array<std::uint32_t, 64> stack{};  // a balanced tree of 2^32 balls is no deeper
        std::size_t left = 1;
        while (left > 0) {
            const Node& node = tree[stack[--left]];
            const glm::vec3 to = node.ball.centre - origin;
            const float distance = glm::length(to);
            const float radius = node.ball.radius + kSlack * (distance + node.ball.radius);
            if (glm::dot(normal, to) < -radius) continue;  // the whole ball is below the horizon
            if (node.children != 0 && !(radius < kSmall * distance)) {
                stack[left++] = node.children;
                stack[left++] = node.children + 1;
                continue;
            }
            if (!(radius < distance)) {
                if (boxes.empty()) return bits.assign(bits.size(), 0xFFFF);
                add_rays_to_box(directions_, origin, boxes[node.number], bits);
                continue;
            }
            const float sine = radius / distance;
            if (!masks_.empty() && sine <= kSmall)
                add_mask(to, sine, bits);
            else
                cones_.add(to / distance, sine, bits);
        }
    }

    [[nodiscard]] std::size_t bundles() const noexcept { return cones_.bundles(); }

private:
    // Computes, for each cell of the octahedral map and each of kMaskSines, the rays that a ball of this
    // angle in a direction inside the cell may meet. A cell consists of spherical triangles between its
    // corners, so a corner is farthest from its centre.
    void make_masks() {
        const std::size_t bundles = cones_.bundles();
        masks_.resize(kCells * kCells * kMaskSines.size() * bundles);
        tbb::parallel_for(std::size_t{0}, kCells * kCells, [&](std::size_t cell) {
            const auto at = [cell](float x, float y) {
                const std::size_t column = cell % kCells, row = cell / kCells;
                return from_octahedral((static_cast<float>(column) + x) * (2.0F / kCells) - 1,
                                       (static_cast<float>(row) + y) * (2.0F / kCells) - 1);
            };
            const glm::vec3 centre = at(0.5F, 0.5F);
            float least = 1;
            for (const float x : {0.0F, 1.0F})
                for (const float y : {0.0F, 1.0F}) least = std::min(least, glm::dot(centre, at(x, y)));
            const float cell_angle = std::acos(std::min(least, 1.0F)) + kSlack;
            for (std::size_t s = 0; s < kMaskSines.size(); ++s) {
                const float angle = cell_angle + std::asin(kMaskSines[s]);
                cones_.add(centre, std::sin(angle),
                           std::span(masks_).subspan((cell * kMaskSines.size() + s) * bundles, bundles));
            }
        });
    }

    void add_mask(const glm::vec3& to, float sine, std::span<std::uint16_t> bits) const {
        const std::size_t s = sine <= kMaskSines[0] ? 0 : 1;
        const std::uint16_t* mask = &masks_[(cell_of(to) * kMaskSines.size() + s) * bits.size()];
        for (std::size_t b = 0; b < bits.size(); ++b) bits[b] = static_cast<std::uint16_t>(bits[b] | mask[b]);
    }

    const DirectionSet& directions_;
    RayCones cones_;
    std::vector<std::uint16_t> masks_;  // [cell][sine][bundle]; empty: there are few balls
};

DisturbedRays::DisturbedRays(const DirectionSet& directions, const Disturbances& disturbances)
    : finder_(std::make_unique<const Finder>(
          directions, disturbances.added.size() + disturbances.removed.size() >= kManyBalls)),
      added_(tree_of<Node>(disturbances.added)),
      removed_(tree_of<Node>(disturbances.removed)),
      added_boxes_(disturbances.added_boxes.begin(), disturbances.added_boxes.end()),
      removed_boxes_(disturbances.removed_boxes.begin(), disturbances.removed_boxes.end()) {}

DisturbedRays::~DisturbedRays() = default;

bool DisturbedRays::find(const glm::vec3& origin, const glm::vec3& normal, DisturbedBundles& bundles) const {
    const auto mark = [&](const std::vector<Node>& tree, const std::vector<Box>& boxes,
                          std::vector<std::uint16_t>& bits) {
        bits.assign(finder_->bundles(), 0);
        finder_->mark(tree, boxes, origin, normal, bits);
        return std::ranges::any_of(bits, [](std::uint16_t some) { return some != 0; });
    };
    const bool closes = mark(added_, added_boxes_, bundles.may_close);
    const bool opens = mark(removed_, removed_boxes_, bundles.may_open);
    return closes || opens;
}

}  // namespace nicol
