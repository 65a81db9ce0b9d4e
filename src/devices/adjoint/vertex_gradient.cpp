// SPDX-License-Identifier: MIT
#include "devices/adjoint/vertex_gradient.hpp"

namespace nicol {

void VertexGradient::add(const glm::uvec3& corners, const glm::vec3& weights, const float* row) {
    for (glm::length_t k = 0; k < 3; ++k) {
        const float weight = weights[k];
        if (weight == 0) continue;
        const std::size_t block = corners[k] / kLanes;
        const tbb::spin_mutex::scoped_lock lock(locks_[block % kLocks]);
        if (blocks_[block] == nullptr) blocks_[block] = std::make_unique<float[]>(kLanes * row_size_);
        float* const sum = blocks_[block].get() + corners[k] % kLanes * row_size_;
        for (std::size_t j = 0; j < row_size_; ++j) sum[j] += weight * row[j];
    }
}

}  // namespace nicol
