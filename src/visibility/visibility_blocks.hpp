// SPDX-License-Identifier: MIT
// Visibility's coefficients at all vertices, kept small.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "simd/lanes.hpp"
#include "visibility/visibility.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// The coefficients of VisibilityHarmonics at every vertex, sixteen consecutive vertices side by side, 16
/// bits a number: each is off by at most 5.5e-5, and numbers beyond sqrt(4 pi) are cut there. Blocks of
/// sixteen unoccluded vertices are not stored, nor are coefficients of odd l + m, which are zero.
class VisibilityBlocks {
public:
    /// Stored numbers are multiples of 1 / kOne.
    static constexpr float kOne = 32767 / VisibilityHarmonics::kUnoccluded;

    VisibilityBlocks() = default;
    /// All zero, except for unoccluded blocks.
    VisibilityBlocks(const Visibility& visibility, int order);

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] bool empty() const noexcept { return place_.empty(); }
    [[nodiscard]] std::size_t vertices() const noexcept { return vertices_; }

    /// Of vertices 16 block to 16 block + 15, by psh_index; ignored where they are unoccluded.
    /// Calls for different blocks may run side by side.
    void set(std::size_t block, const Lanes* coefficients);
    /// The same from another of this order that has the block.
    void take_over(std::size_t block, const VisibilityBlocks& before);
    /// For each m from 0 on, each l = m, m + 2, ...: that of m in each lane, then that of -m unless m = 0.
    /// Null where the vertices are unoccluded.
    [[nodiscard]] const std::int16_t* block(std::size_t block) const {
        return place_[block] == kUnoccluded ? nullptr : numbers_[place_[block] * kept_.size()].value.data();
    }

    /// psh_count(order()) coefficients of one vertex.
    void expand(std::size_t vertex, std::span<float> out) const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return numbers_.size() * sizeof(FixedLanes) + place_.size() * sizeof(std::uint32_t);
    }

private:
    static constexpr std::uint32_t kUnoccluded = ~std::uint32_t{0};
    // As vector instructions load them.
    struct alignas(32) FixedLanes {
        std::array<std::int16_t, kLanes> value;
    };

    int order_ = 0;
    std::size_t vertices_ = 0;
    std::vector<std::size_t> kept_;     // psh_index of the numbers of a block
    std::vector<std::uint32_t> place_;  // of each block, or kUnoccluded
    std::vector<FixedLanes> numbers_;   // [place][kept]
};

/// VisibilityHarmonics::project() of vertices first to first + count - 1, at most sixteen, by psh_index; the
/// other lanes repeat the last.
void project_block(const VisibilityHarmonics& harmonics, const Visibility& visibility,
                   std::span<const glm::vec3> normals, std::size_t first, std::size_t count, Lanes* out);

}  // namespace nicol
