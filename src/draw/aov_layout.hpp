// SPDX-License-Identifier: MIT
// Layout of AOVs in the attachments that they are drawn into.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

#include "image/aovs.hpp"

namespace nicol {

/// AOVs packed one after another into as few RGBA32F attachments as hold them. Each member is the index of
/// the AOV's first float in a pixel, -1 if the AOV is absent. Float i is component i % 4 of attachment i / 4.
/// Ids take two floats, the lower and the upper 16 bits.
struct AovLayout {
    int normals = -1;
    int depth = -1;
    int positions = -1;
    int instances = -1;
    int alpha = -1;
    int floats = 0;

    explicit AovLayout(std::uint32_t mask) {
        const auto place = [&](int& at, std::uint32_t bit, int count) {
            if ((mask & bit) == 0) return;
            at = floats;
            floats += count;
        };
        place(normals, aov_normals, 3);
        place(depth, aov_depth, 1);
        place(positions, aov_positions, 3);
        place(alpha, aov_alpha, 1);
        place(instances, aov_instances, 2);
    }
    /// Returns the index of an AOV's first float, -1 if the AOV is absent.
    [[nodiscard]] int first(AovBit aov) const noexcept {
        switch (aov) {
            case aov_normals:
                return normals;
            case aov_depth:
                return depth;
            case aov_positions:
                return positions;
            case aov_alpha:
                return alpha;
            case aov_instances:
                return instances;
            default:
                return -1;
        }
    }
    [[nodiscard]] int attachments() const noexcept { return (floats + 3) / 4; }
    /// Returns the value of an attachment's pixels without surfaces.
    [[nodiscard]] glm::vec4 background(int attachment) const;
};

}  // namespace nicol
