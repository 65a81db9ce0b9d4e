// SPDX-License-Identifier: MIT
// Visibility of single vertices as harmonics.
#pragma once

#include <vector>

#include "harmonics/psh.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol::test {

/// Returns the coefficients of one vertex, [psh_index(l, m)].
inline std::vector<float> projected(const VisibilityHarmonics& harmonics, const Visibility& visibility,
                                    std::span<const glm::vec3> normals, std::uint32_t vertex) {
    std::vector<Lanes> lanes(psh_count(harmonics.order()));
    harmonics.project(visibility, normals, {&vertex, 1}, lanes);
    std::vector<float> out;
    for (const Lanes& lane : lanes) out.push_back(lane[0]);
    return out;
}

}  // namespace nicol::test
