// SPDX-License-Identifier: MIT
#include "shading/physical_range.hpp"

#include <algorithm>
#include <cmath>

namespace nicol {

std::size_t make_physical(std::span<glm::vec4> stokes) {
    std::size_t moved = 0;
    for (glm::vec4& s : stokes) {
        const float polarized2 = s.y * s.y + s.z * s.z + s.w * s.w;
        if (s.x >= 0 && polarized2 <= s.x * s.x) continue;
        ++moved;
        s.x = std::max(s.x, 0.0F);
        const float factor = polarized2 > 0 ? s.x / std::sqrt(polarized2) : 0.0F;
        if (factor < 1) {
            s.y *= factor;
            s.z *= factor;
            s.w *= factor;
        }
    }
    return moved;
}

}  // namespace nicol
