// SPDX-License-Identifier: MIT
// relight, second half: the light at each vertex times what the vertex sees of it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

#include "nicol/light_layout.hpp"
#include "transfer/mirror_basis.hpp"
#include "transfer/vertex_light.hpp"
#include "transfer/visibility_harmonics.hpp"

namespace nicol {

/// How finely a shadow is kept.
enum class ShadowStorage {
    fixed16,  ///< 16 bits a number; each is off by at most 3.1e-5
    float32,
};

/// The product V f (Eq. 54) of visibility and Stokes vector field at every vertex, in the vertices' frames,
/// exact for visibility of order in + out: V is what VisibilityHarmonics makes. Vertices that see all above
/// their horizon cost nothing. Immutable once made.
class ShadowProduct {
public:
    /// Which form the product takes; the same result.
    enum class Form {
        best,    ///< whichever is faster at these orders, as measured
        matrix,  ///< a matrix a vertex, of which mirrored visibility leaves a third; O(order^4)
        grid,    ///< samples on a small grid; O(order^3)
    };

    /// Light of layout `in` becomes light of layout `out`, which has the same kind and at least the same
    /// order. `normals`: one for each vertex of `visibility`. Runs on the calling thread's TBB arena. Throws
    /// Error(invalid_argument) for layouts that do not fit or orders whose sum is beyond
    /// VisibilityHarmonics::kHighestOrder; Error(unsupported) for the matrix with dark visibility.
    ShadowProduct(const Visibility& visibility, const DirectionSet& directions,
                  std::span<const glm::vec3> normals, const LightLayout& in, const LightLayout& out,
                  HorizonExtension extension = HorizonExtension::mirrored, Form form = Form::best,
                  ShadowStorage storage = ShadowStorage::fixed16);
    ~ShadowProduct();
    ShadowProduct(ShadowProduct&&) noexcept;
    ShadowProduct& operator=(ShadowProduct&&) noexcept;

    /// Vertices that do not see all are taken sixteen at a time: how many such blocks there are.
    [[nodiscard]] std::size_t blocks() const noexcept;
    /// The vertices of a block, ascending; sixteen, but for the last.
    [[nodiscard]] std::span<const std::uint32_t> vertices(std::size_t block) const;

    /// out = V in for the vertices of blocks `first` <= b < `last`; others are left alone: where `out` is
    /// another object, see copy(). `in` and `out` may be the same object where the layouts are equal. Calls
    /// for different blocks may run side by side.
    void run(const VertexLight& in, VertexLight& out, std::size_t first, std::size_t last) const;

    /// out = in for the vertices `first` <= v < `last`, with zeros above the order of `in`: the product of
    /// vertices that see all.
    void copy(const VertexLight& in, VertexLight& out, std::size_t first, std::size_t last) const;

    [[nodiscard]] Form form() const noexcept;

    /// What other processors need to compute the same. Lives as long as the object.
    struct Matrices {
        const MirrorBasis& basis;  ///< the light is split before, joined after
        std::span<const std::uint32_t> vertices;
        std::span<const std::int16_t> numbers;  ///< [block][number][lane], over kFixedOne: see ShadowMatrices
        std::size_t numbers_of_vertex;
    };
    /// None where the product takes another form, stores 32 bits, or has layouts that differ.
    [[nodiscard]] std::optional<Matrices> matrices() const;
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    struct Blocks;
    std::unique_ptr<Blocks> blocks_;
};

}  // namespace nicol
