// SPDX-License-Identifier: MIT
#include "shading/realizable_range.hpp"

#include <algorithm>
#include <cmath>

namespace nicol {

std::size_t make_physical(std::span<glm::vec4> stokes, float noise) {
    std::size_t moved = 0;
    for (glm::vec4& s : stokes) {
        const float polarized2 = s.y * s.y + s.z * s.z + s.w * s.w;
        const bool inside = s.x >= 0 && polarized2 <= s.x * s.x;
        float factor = 1;
        if (!inside) {
            ++moved;
            s.x = std::max(s.x, 0.0F);
            factor = polarized2 > 0 ? std::min(s.x / std::sqrt(polarized2), 1.0F) : 0.0F;
        }
        if (noise > 0) factor /= 1 + noise / s.x * (noise / s.x);
        if (factor < 1) {
            s.y *= factor;
            s.z *= factor;
            s.w *= factor;
        }
    }
    return moved;
}

}  // namespace nicol
