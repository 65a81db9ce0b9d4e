// SPDX-License-Identifier: MIT
// Gradients of the light that vertices keep as rows, summed over the points that interpolate it.
#pragma once

#include <tbb/spin_mutex.h>

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "simd/lanes.hpp"

namespace nicol {

/// Sums of gradients, [vertex][number]: the transpose of the interpolation between vertices.
class VertexGradient {
public:
    VertexGradient(std::size_t vertices, std::size_t row_size)
        : row_size_(row_size), blocks_((vertices + kLanes - 1) / kLanes) {}

    /// Adds weights[k] * row to the sum of vertex corners[k]. Threads may call it side by side.
    void add(const glm::uvec3& corners, const glm::vec3& weights, const float* row);

    [[nodiscard]] std::size_t row_size() const noexcept { return row_size_; }
    /// Returns the sum of a vertex; null: no point has added to a vertex of its block of sixteen.
    [[nodiscard]] const float* row(std::size_t vertex) const {
        const float* const block = blocks_[vertex / kLanes].get();
        return block == nullptr ? nullptr : block + vertex % kLanes * row_size_;
    }

private:
    static constexpr std::size_t kLocks = 1024;

    std::size_t row_size_;
    std::vector<std::unique_ptr<float[]>> blocks_;  // rows of sixteen vertices
    std::array<tbb::spin_mutex, kLocks> locks_;     // of the blocks with equal remainders
};

}  // namespace nicol
