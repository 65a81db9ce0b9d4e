// SPDX-License-Identifier: MIT
// Dense transfer matrices of the paper: one per vertex, from the world's light to outgoing coefficients.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/product.hpp"
#include "harmonics/psh.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Part that the matrices of one material share: the incident and outgoing coefficients, and the material's
/// own matrix. Rows and columns that are zero for every vertex are not stored.
class DenseMaterial {
public:
    /// Takes one matrix per channel in the surface's frame (project_material()), all of equal orders; `kind`
    /// is that of the light. Throws Error(invalid_argument) if there is no matrix or an order exceeds
    /// CoefficientMatrix::kMaxDenseOrder.
    DenseMaterial(std::span<const IsotropicMatrix> channels, LightKind kind);

    [[nodiscard]] int order() const noexcept { return outgoing_.order(); }
    [[nodiscard]] int channels() const noexcept { return static_cast<int>(entries_.size()); }
    /// Returns the layout of the outgoing coefficients, in each vertex's own frame.
    [[nodiscard]] const LightLayout& outgoing() const noexcept { return outgoing_; }
    /// Returns the positions 4 * psh_index(l, m) + p of the light's coefficients that the matrices use.
    [[nodiscard]] const std::vector<std::size_t>& columns() const noexcept { return columns_; }

private:
    friend class DenseBuilder;
    struct Entry {
        std::size_t row;     // index in the outgoing layout
        std::size_t column;  // 4 * psh_index(l, m) + p in the surface's frame
        float value;
    };

    LightLayout outgoing_;
    std::vector<std::size_t> columns_;
    std::vector<std::vector<Entry>> entries_;  // by channel
};

/// Matrices of consecutive vertices of one material, [vertex][channel][column][row].
class DenseTransfer {
public:
    DenseTransfer(std::shared_ptr<const DenseMaterial> material, std::size_t vertices);

    [[nodiscard]] const DenseMaterial& material() const noexcept { return *material_; }
    [[nodiscard]] std::size_t vertices() const noexcept { return vertices_; }
    [[nodiscard]] std::size_t row_stride() const noexcept { return row_stride_; }
    [[nodiscard]] std::span<float> at(std::size_t vertex) {
        return {data_.get() + vertex * vertex_stride_, vertex_stride_};
    }
    /// Returns the matrices of vertices first <= v < last.
    [[nodiscard]] std::span<const float> between(std::size_t first, std::size_t last) const {
        return {data_.get() + first * vertex_stride_, (last - first) * vertex_stride_};
    }
    /// Returns the number of floats per vertex.
    [[nodiscard]] std::size_t vertex_stride() const noexcept { return vertex_stride_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return vertices_ * vertex_stride_ * sizeof(float); }

    /// Relights vertices first <= v < last: computes their outgoing coefficients and writes them to out's
    /// vertices out_first + v. `light` is in the world's axes; a light or material of one channel serves all
    /// channels of out. Runs on the calling thread; calls for different vertices may run side by side.
    void apply(const PshVector& light, std::size_t first, std::size_t last, std::size_t out_first,
               VertexLight& out) const;

private:
    std::shared_ptr<const DenseMaterial> material_;
    std::size_t vertices_;
    std::size_t row_stride_;
    std::size_t vertex_stride_;
    std::unique_ptr<float[]> data_;
};

/// Builder of the matrices: reflected = material x shadow (Eq. 54, by triple products) x rotation into the
/// vertex's frame. It holds work space, so each thread needs its own object.
class DenseBuilder {
public:
    /// Takes `shadows`, which may be shared. Its orders must equal the material's, its scalar order that of
    /// the visibility.
    DenseBuilder(std::shared_ptr<const DenseMaterial> material, std::shared_ptr<const ShadowMatrix> shadows);

    /// Computes the matrices of one vertex. visibility: coefficients over real harmonics of the propagation
    /// direction, in the vertex's frame; empty if the vertex is unoccluded.
    void build(const glm::vec3& normal, std::span<const double> visibility, std::span<float> out);

private:
    std::shared_ptr<const DenseMaterial> material_;
    std::shared_ptr<const ShadowMatrix> shadows_;
    CoefficientMatrix identity_;
    CoefficientMatrix rotated_;
    std::vector<float> rows_;      // columns of rotated_ that the matrices use
    std::vector<float> products_;  // [row][column]
};

}  // namespace nicol
