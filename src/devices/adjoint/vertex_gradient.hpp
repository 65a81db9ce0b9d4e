// SPDX-License-Identifier: MIT
// Gradients of the light that vertices keep as rows, summed over the points that interpolate it.
#pragma once

#include <tbb/spin_mutex.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nicol {

/// Sums of gradients, [vertex][number]: the transpose of the interpolation between vertices.
class VertexGradient {
public:
    VertexGradient(std::size_t vertices, std::size_t row_size)
        : row_size_(row_size), rows_(vertices * row_size) {}

    /// Adds weights[k] * row to the sum of vertex corners[k]. Threads may call it side by side.
    void add(const glm::uvec3& corners, const glm::vec3& weights, const float* row);

    [[nodiscard]] std::size_t row_size() const noexcept { return row_size_; }
    [[nodiscard]] const float* row(std::size_t vertex) const { return rows_.data() + vertex * row_size_; }

private:
    static constexpr std::size_t kLocks = 1024;

    std::size_t row_size_;
    std::vector<float> rows_;
    std::array<tbb::spin_mutex, kLocks> locks_;  // of the vertices with equal remainders
};

}  // namespace nicol
