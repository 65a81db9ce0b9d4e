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

/// What VisibilityHarmonics makes of every vertex, sixteen consecutive vertices side by side, 16 bits a
/// number: each is off by at most 5.5e-5, what nothing hides is exact, and numbers beyond sqrt(4 pi) count as
/// that. Sixteen vertices that see all above their horizon are not kept, nor are coefficients of odd l + m of
/// mirrored visibility, which are zero.
class VisibilityBlocks {
public:
    /// Numbers stand for themselves over this.
    static constexpr float kOne = 32767 / 3.5449077F;

    VisibilityBlocks() = default;
    /// All zero but for what nothing hides.
    VisibilityBlocks(const Visibility& visibility, const VisibilityHarmonics& harmonics);

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] HorizonExtension extension() const noexcept { return extension_; }
    [[nodiscard]] bool empty() const noexcept { return place_.empty(); }
    [[nodiscard]] std::size_t vertices() const noexcept { return vertices_; }

    /// Of vertices 16 block to 16 block + 15, by psh_index; nothing where they see all above their horizon.
    /// Calls for different blocks may run side by side.
    void set(std::size_t block, const Lanes* coefficients);
    /// The same from another of this order and extension that has the block.
    void take_over(std::size_t block, const VisibilityBlocks& before);
    /// For each m from 0 on, each l from m on in steps(): those of m in each lane, then those of -m unless m
    /// = 0. Null where the vertices see all above their horizon.
    [[nodiscard]] const std::int16_t* block(std::size_t block) const {
        return place_[block] == open ? nullptr : numbers_[place_[block] * kept_.size()].value.data();
    }
    [[nodiscard]] int steps() const noexcept { return extension_ == HorizonExtension::mirrored ? 2 : 1; }

    /// psh_count(order()) coefficients of one vertex.
    void expand(std::size_t vertex, std::span<float> out) const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return numbers_.size() * sizeof(FixedLanes) + place_.size() * sizeof(std::uint32_t);
    }

private:
    static constexpr std::uint32_t open = ~std::uint32_t{0};
    // As vector instructions load them.
    struct alignas(32) FixedLanes {
        std::array<std::int16_t, kLanes> value;
    };

    int order_ = 0;
    HorizonExtension extension_ = HorizonExtension::mirrored;
    std::size_t vertices_ = 0;
    std::vector<std::size_t> kept_;     // psh_index of the numbers of a block
    std::vector<std::uint32_t> place_;  // of each block, or `open`
    std::vector<float> everything_;     // what nothing hides, by psh_index
    std::vector<FixedLanes> numbers_;   // [place][kept]
};

/// What VisibilityHarmonics makes of sixteen vertices, at most `count` of them and then the last again, by
/// psh_index.
void project_block(const VisibilityHarmonics& harmonics, const Visibility& visibility,
                   std::span<const glm::vec3> normals, std::size_t first, std::size_t count, Lanes* out);

}  // namespace nicol
