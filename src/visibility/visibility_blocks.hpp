// SPDX-License-Identifier: MIT
// Compact coefficients of the visibility at all vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simd/lanes.hpp"
#include "visibility/block_memory.hpp"
#include "visibility/visibility.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// Coefficients of VisibilityHarmonics at every vertex, in 16 bits each, sixteen consecutive vertices side by
/// side. Each number is off by at most 5.5e-5; numbers beyond sqrt(4 pi) are clamped. Blocks of sixteen
/// unoccluded vertices are not stored. Coefficients of odd l + m are zero and not stored either.
class VisibilityBlocks {
public:
    /// Scale of the stored numbers, which are multiples of 1 / kOne.
    static constexpr float kOne = 32767 / VisibilityHarmonics::kUnoccluded;

    VisibilityBlocks() = default;
    /// Makes coefficients that are all zero, except for unoccluded blocks. needed: 1 for each vertex whose
    /// block is used, else 0; empty: all are used. Occluded blocks without a needed vertex are left out.
    VisibilityBlocks(const Visibility& visibility, int order, std::span<const std::uint8_t> needed = {});
    /// Makes coefficients from those of an earlier state, of the same order or empty. former: for each
    /// vertex, the index in the earlier state of a vertex with equal coefficients, or kNoVertex. Sets
    /// missing[v] to 1 for each vertex of an occluded block whose coefficients are not known, else to 0. A
    /// block without a needed vertex is kept if all of its vertices have a former one, and left out
    /// otherwise.
    VisibilityBlocks(VisibilityBlocks&& before, std::span<const std::uint32_t> former,
                     const Visibility& visibility, int order, std::vector<std::uint8_t>& missing,
                     std::span<const std::uint8_t> needed = {});

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] bool empty() const noexcept { return numbers_.blocks() == 0; }
    [[nodiscard]] std::size_t vertices() const noexcept { return vertices_; }

    /// Sets computed[v] to 0 for each vertex of a block that was left out, else to 1.
    void find_computed(std::span<std::uint8_t> computed) const;

    /// Sets the coefficients, by psh_index, of up to sixteen vertices, one in each lane; has no effect on
    /// vertices of unoccluded blocks or of blocks that were left out. Calls for different vertices may run
    /// side by side.
    void set(std::span<const std::uint32_t> vertices, const Lanes* coefficients);
    /// Returns the numbers of a block: for each m from 0 on and each l = m, m + 2, ..., the number of m in
    /// each lane, then the number of -m unless m = 0. Returns null if the vertices are unoccluded
    /// or the block was left out.
    [[nodiscard]] const std::int16_t* block(std::size_t block) const {
        const FixedLanes* const numbers = numbers_.at(block);
        return numbers == nullptr ? nullptr : numbers->value.data();
    }

    /// Computes the psh_count(order()) coefficients of one vertex.
    void expand(std::size_t vertex, std::span<float> out) const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return numbers_.count() * kept_.size() * sizeof(FixedLanes);
    }

private:
    // Sixteen numbers, aligned for vector instructions.
    struct alignas(32) FixedLanes {
        std::array<std::int16_t, kLanes> value;
    };

    int order_ = 0;
    std::size_t vertices_ = 0;
    std::vector<std::size_t> kept_;       // psh_index of each number of a block
    std::vector<std::uint8_t> left_out_;  // 1 for each block that was left out, else 0
    BlockMemory<FixedLanes> numbers_;     // of a block: [kept]; none if it is unoccluded
};

}  // namespace nicol
