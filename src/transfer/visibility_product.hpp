// SPDX-License-Identifier: MIT
// relight, second half: the light at each vertex times what the vertex sees of it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/mirror_basis.hpp"
#include "transfer/vertex_light.hpp"
#include "visibility/shadow_grid.hpp"
#include "visibility/visibility_blocks.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// How finely a shadow is kept.
enum class ShadowStorage {
    /// 16 bits a number; each is off by at most 3.1e-5. Only visibility of more orders than its directions
    /// resolve has numbers beyond 2: all of its are then off by as much more as the largest is beyond 2.
    fixed16,
    float32,
};

/// The product V f (Eq. 54) of visibility and Stokes vector field at every vertex, in the vertices' frames,
/// cut at the order of f and exact for visibility of twice that: V is what VisibilityHarmonics makes. Sixteen
/// consecutive vertices that see all above their horizon cost nothing. Immutable once made.
class VisibilityProduct {
public:
    /// Which form the product takes; the same result.
    enum class Form {
        best,    ///< whichever is faster at these orders, as measured
        matrix,  ///< a symmetric matrix a vertex, of which mirrored visibility leaves a third; O(order^4)
        grid,    ///< samples on a small grid; O(order^3)
    };

    /// For light of this layout. Visibility's coefficients, which are made on the way, are put into `keep`,
    /// too, which is of the same visibility and extension and twice the layout's order. `normals`: one for
    /// each vertex of `visibility`. Runs on the calling thread's TBB arena. Throws Error(invalid_argument)
    /// for sizes that do not fit or an order beyond half of VisibilityHarmonics::kHighestOrder, or `keep` of
    /// another order; Error(unsupported) for the matrix with dark visibility.
    VisibilityProduct(const Visibility& visibility, const DirectionSet& directions,
                      std::span<const glm::vec3> normals, const LightLayout& layout,
                      HorizonExtension extension = HorizonExtension::mirrored, Form form = Form::best,
                      ShadowStorage storage = ShadowStorage::fixed16, VisibilityBlocks* keep = nullptr);
    /// The same from one of an earlier state, of the same directions, layout, extension, form and storage:
    /// what it has of sixteen vertices that are all `unchanged` is taken over. `unchanged` has a number for
    /// each vertex: 1 where it had the same visibility and normal under the same number.
    VisibilityProduct(VisibilityProduct&& before, std::span<const std::uint8_t> unchanged,
                      const Visibility& visibility, const DirectionSet& directions,
                      std::span<const glm::vec3> normals);
    ~VisibilityProduct();
    VisibilityProduct(VisibilityProduct&&) noexcept;
    VisibilityProduct& operator=(VisibilityProduct&&) noexcept;

    /// How many blocks of sixteen consecutive vertices, as VertexLight has them, shadows fall on.
    [[nodiscard]] std::size_t blocks() const noexcept;

    /// light = V light for the vertices of VertexLight's blocks `first` <= b < `last`; blocks on which no
    /// shadow falls are left alone. Calls for different blocks may run side by side.
    void run(VertexLight& light, std::size_t first, std::size_t last) const;

    [[nodiscard]] Form form() const noexcept;

    /// What other processors need to compute the same. Lives no longer than the object.
    struct Matrices {
        const MirrorBasis& basis;                 ///< the light is split before, joined after
        std::span<const std::uint32_t> vertices;  ///< of all blocks, ascending
        float unit;                               ///< times numbers over kFixedOne
        /// [block][number][lane]. The numbers are three square matrices, even to even, odd to
        /// odd and spin, each by tiles of kShadowTile rows, in them column after column.
        std::vector<std::int16_t> numbers;
        std::size_t numbers_of_vertex;
    };
    /// None where the product takes another form or stores 32 bits.
    [[nodiscard]] std::optional<Matrices> matrices() const;
    /// The same of the grid.
    struct Grid {
        const MirrorBasis& basis;
        std::span<const std::uint32_t> vertices;
        float unit;
        const ShadowGrid& grid;
        /// [block][sample][lane]. The samples are those of the even part of visibility, then
        /// of the odd part unless visibility is mirrored.
        std::span<const std::int16_t> samples;
        std::size_t samples_of_vertex;
    };
    [[nodiscard]] std::optional<Grid> grid() const;
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    struct Blocks;
    std::unique_ptr<Blocks> blocks_;
};

}  // namespace nicol
