// SPDX-License-Identifier: MIT
#include "devices/adjoint/vertex_gradient.hpp"

namespace nicol {

void VertexGradient::add(const glm::uvec3& corners, const glm::vec3& weights, const float* row) {
    for (glm::length_t k = 0; k < 3; ++k) {
        const float weight = weights[k];
        if (weight == 0) continue;
        float* const sum = rows_.data() + corners[k] * row_size_;
        const tbb::spin_mutex::scoped_lock lock(locks_[corners[k] % kLocks]);
        for (std::size_t j = 0; j < row_size_; ++j) sum[j] += weight * row[j];
    }
}

}  // namespace nicol
