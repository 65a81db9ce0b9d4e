// SPDX-License-Identifier: MIT
// The relight step, second half: product of the light and the visibility at each vertex.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "transfer/vertex_light.hpp"
#include "visibility/block_memory.hpp"
#include "visibility/shadow_grid.hpp"
#include "visibility/shadow_matrices.hpp"
#include "visibility/visibility_blocks.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// Coefficients of visibility that VisibilityProduct computes on the way and keeps in addition.
struct KeptCoefficients {
    /// Blocks for equally many vertices and twice the light's order; null: none.
    VisibilityBlocks* blocks = nullptr;
    std::span<std::uint8_t> missing;  ///< set to 0 for each vertex that is set; may be empty
};

/// The product V f (Eq. 54) of visibility and Stokes vector field at every vertex, in the vertices' frames.
/// It is truncated at the order of f and exact for the coefficients of V (VisibilityHarmonics) up to twice
/// that order, which EvenIrradiance scales. Numbers have 16 bits; each is off by at most 3.1e-5. If the
/// directions do not resolve twice the order, the bound is 6.2e-5 times the power of two that the largest
/// number so far has required: numbers that are stored when the unit grows are rounded again. Blocks of
/// sixteen consecutive unoccluded vertices cost nothing. Immutable once made.
class VisibilityProduct {
public:
    /// Highest order for which a vertex has a symmetric matrix, O(order^4); above it, a vertex has samples on
    /// a grid, O(order^3). Matrices are two to four times as fast, but take four times the memory of the grid
    /// at order 6 and eleven times at 12.
    static constexpr int kHighestMatrixOrder = 9;

    /// Makes the product for light of this layout. `normals`: one for each vertex of `visibility`. needed: 1
    /// for each vertex whose block run() is called for, else 0; empty: all are needed. Blocks without a
    /// needed vertex may be left out. Runs on the calling thread's TBB arena. Throws Error(invalid_argument)
    /// for sizes that do not fit or an order beyond half of VisibilityHarmonics::kHighestOrder.
    VisibilityProduct(const Visibility& visibility, const DirectionSet& directions,
                      std::span<const glm::vec3> normals, const LightLayout& layout,
                      const KeptCoefficients& keep = {}, std::span<const std::uint8_t> needed = {});
    /// Makes the product from that of an earlier state with equal directions and layout. Numbers are taken
    /// over from `former`: for each vertex, the index in the earlier state of a vertex with equal visibility
    /// and normal, or kNoVertex. A block without a needed vertex is kept if all of its vertices have a former
    /// one, and left out otherwise.
    VisibilityProduct(VisibilityProduct&& before, std::span<const std::uint32_t> former,
                      const Visibility& visibility, const DirectionSet& directions,
                      std::span<const glm::vec3> normals, const KeptCoefficients& keep = {},
                      std::span<const std::uint8_t> needed = {});

    /// Returns the number of blocks of sixteen consecutive vertices, as in VertexLight, with an occluded
    /// vertex.
    [[nodiscard]] std::size_t blocks() const noexcept { return occluded_.size(); }

    /// Sets computed[v] to 0 for each vertex of a block that was left out, else to 1.
    void find_computed(std::span<std::uint8_t> computed) const;

    /// Computes light = V light for the vertices of VertexLight's blocks `first` <= b < `last`; unoccluded
    /// blocks are left unchanged. The blocks must not have been left out. Calls for different blocks may run
    /// side by side. skipped: number of blocks that are missing in front of `light`.
    void run(VertexLight& light, std::size_t first, std::size_t last, std::size_t skipped = 0) const;

    /// Views of the object for implementations on other processors, which need a product without blocks that
    /// were left out.
    [[nodiscard]] std::span<const std::uint32_t> vertices() const noexcept {
        return vertices_;
    }  ///< vertices of all blocks
    /// Returns the unit of the numbers: a number is stored as a multiple of unit() / kFixedOne.
    [[nodiscard]] float unit() const noexcept { return unit_; }
    [[nodiscard]] std::size_t numbers_of_vertex() const noexcept { return size_; }
    /// Returns the numbers of block 0 <= i < blocks(): up to kHighestMatrixOrder [pair of matrix
    /// elements][lane][element of the pair], above it [sample of the grid][lane].
    [[nodiscard]] std::span<const std::int16_t> numbers(std::size_t i) const {
        return {numbers_.at(occluded_[i])->value.data(), size_ * kLanes};
    }
    /// Returns the matrices or null. Exactly one of matrices() and grid() is null.
    [[nodiscard]] const ShadowMatrices* matrices() const noexcept {
        return matrices_ ? &*matrices_ : nullptr;
    }
    [[nodiscard]] const ShadowGrid* grid() const noexcept { return grid_ ? &*grid_ : nullptr; }
    [[nodiscard]] const LightLayout& layout() const noexcept { return layout_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    // Two numbers of sixteen vertices: side by side in each lane for matrices, one after the other for the
    // grid.
    struct alignas(64) NumberPair {
        std::array<std::int16_t, 2 * kLanes> value;
    };
    // Input of the computation of the numbers.
    struct Input {
        const Visibility& visibility;
        const VisibilityHarmonics& harmonics;
        std::span<const glm::vec3> normals;
        KeptCoefficients keep;
    };

    void find_occluded(const Visibility& visibility);
    // Makes the unit large enough for a number, and expresses the stored numbers in it.
    void grow_unit(float largest);
    // Computes the numbers of some vertices, on threads, and calls use(sixteen, numbers) for each sixteen of
    // them, in any order.
    template <class Use>
    void compute(std::span<const std::uint32_t> vertices, const Input& input, const Use& use) const;
    // Computes and stores the numbers of some vertices, whose blocks have memory. The unit grows if a number
    // requires it.
    void store(std::span<const std::uint32_t> vertices, const Input& input);
    // Stores numbers in the present unit, clamped, and returns the largest one if it may need another unit.
    float store_in_unit(std::span<const std::uint32_t> vertices, const Input& input);

    LightLayout layout_;
    std::optional<ShadowMatrices> matrices_;  // set up to kHighestMatrixOrder; otherwise grid_ is set
    std::optional<ShadowGrid> grid_;
    std::vector<std::uint32_t> occluded_;  // VertexLight's blocks with an occluded vertex, ascending
    std::vector<std::uint32_t> vertices_;  // vertices of these blocks
    std::size_t size_ = 0;                 // numbers per vertex, even
    float unit_ = 1;
    BlockMemory<NumberPair> numbers_;  // of a block of VertexLight: [pair]; none if it is unoccluded
};

}  // namespace nicol
