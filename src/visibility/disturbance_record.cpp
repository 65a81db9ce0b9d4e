// SPDX-License-Identifier: MIT
#include "visibility/disturbance_record.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

// Largest number of balls, unless one change has half as many.
constexpr std::size_t kMostBalls = 24;

Ball joined(const Ball& a, const Ball& b) {
    const float distance = glm::distance(a.centre, b.centre);
    return {.centre = 0.5F * (a.centre + b.centre),
            .radius = 1.0001F * (0.5F * distance + std::max(a.radius, b.radius))};
}

void append(std::span<const Ball> some, std::vector<Ball>& balls) {
    const std::size_t most = std::max(kMostBalls, 2 * some.size());
    balls.insert(balls.end(), some.begin(), some.end());
    if (balls.size() <= most) return;
    for (std::size_t i = 0; 2 * i < balls.size(); ++i)
        balls[i] = joined(balls[2 * i], balls[std::min(2 * i + 1, balls.size() - 1)]);
    balls.resize((balls.size() + 1) / 2);
}

}  // namespace

void DisturbanceRecord::add(std::span<const Ball> added, std::span<const Ball> removed) {
    append(added, added_);
    append(removed, removed_);
    ++changes_;
}

}  // namespace nicol
