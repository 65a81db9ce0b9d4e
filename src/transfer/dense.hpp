// SPDX-License-Identifier: MIT
// The transfer matrices of the paper: one a vertex, from the world's light to outgoing coefficients.
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

/// What the matrices of one material share: which coefficients go in, which come out, and the material's own
/// matrix. Rows and columns that are zero for every vertex are not stored.
class DenseMaterial {
public:
    /// One matrix a channel in the surface's frame (project_material()), all of the same orders; `kind`: of
    /// the light. Throws Error(invalid_argument) for none or for orders above
    /// CoefficientMatrix::kMaxDenseOrder.
    DenseMaterial(std::span<const IsotropicMatrix> channels, LightKind kind);

    [[nodiscard]] int order() const noexcept { return outgoing_.order(); }
    [[nodiscard]] int channels() const noexcept { return static_cast<int>(entries_.size()); }
    /// The coefficients that come out, in each vertex's own frame.
    [[nodiscard]] const LightLayout& outgoing() const noexcept { return outgoing_; }
    /// Positions 4 * psh_index(l, m) + p of the light's coefficients that go in.
    [[nodiscard]] const std::vector<std::size_t>& columns() const noexcept { return columns_; }

private:
    friend class DenseBuilder;
    struct Entry {
        std::size_t row;     // number of the outgoing layout
        std::size_t column;  // 4 * psh_index(l, m) + p in the surface's frame
        float value;
    };

    LightLayout outgoing_;
    std::vector<std::size_t> columns_;
    std::vector<std::vector<Entry>> entries_;  // by channel
};

/// The matrices of a run of vertices of one material, [vertex][channel][column][row].
class DenseTransfer {
public:
    DenseTransfer(std::shared_ptr<const DenseMaterial> material, std::size_t vertices);

    [[nodiscard]] const DenseMaterial& material() const noexcept { return *material_; }
    [[nodiscard]] std::size_t vertices() const noexcept { return vertices_; }
    [[nodiscard]] std::size_t row_stride() const noexcept { return row_stride_; }
    [[nodiscard]] std::span<float> at(std::size_t vertex) {
        return {data_.get() + vertex * vertex_stride_, vertex_stride_};
    }
    /// Of vertices first <= v < last.
    [[nodiscard]] std::span<const float> between(std::size_t first, std::size_t last) const {
        return {data_.get() + first * vertex_stride_, (last - first) * vertex_stride_};
    }
    /// Floats a vertex.
    [[nodiscard]] std::size_t vertex_stride() const noexcept { return vertex_stride_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return vertices_ * vertex_stride_ * sizeof(float); }

    /// relight: the outgoing coefficients of vertices first <= v < last, written to out's vertices
    /// out_first + v. `light` is in the world's axes; a light or material of one channel serves all channels
    /// of out. Runs on the calling thread; calls for different vertices may run side by side.
    void apply(const PshVector& light, std::size_t first, std::size_t last, std::size_t out_first,
               VertexLight& out) const;

private:
    std::shared_ptr<const DenseMaterial> material_;
    std::size_t vertices_;
    std::size_t row_stride_;
    std::size_t vertex_stride_;
    std::unique_ptr<float[]> data_;
};

/// Makes the matrices: reflected = material x shadow (Eq. 54, by triple products) x rotation into the
/// vertex's frame. Holds work space: one object a thread.
class DenseBuilder {
public:
    /// `shadows` may be shared; its orders are those of the material, its scalar order that of the
    /// visibility.
    DenseBuilder(std::shared_ptr<const DenseMaterial> material, std::shared_ptr<const ShadowMatrix> shadows);

    /// visibility: coefficients over real harmonics in the vertex's frame, of the directions the light
    /// travels in; empty where nothing is in the way.
    void build(const glm::vec3& normal, std::span<const double> visibility, std::span<float> out);

private:
    std::shared_ptr<const DenseMaterial> material_;
    std::shared_ptr<const ShadowMatrix> shadows_;
    CoefficientMatrix identity_;
    CoefficientMatrix rotated_;
    std::vector<float> rows_;      // of rotated_, the columns that go in
    std::vector<float> products_;  // [row][column]
};

}  // namespace nicol
