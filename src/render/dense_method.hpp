// SPDX-License-Identifier: MIT
// The dense method: the paper's transfer matrices, one a vertex.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "render/render.hpp"
#include "render/transfer_input.hpp"
#include "shading/shade.hpp"
#include "transfer/dense.hpp"

namespace nicol {

class DenseMethod {
public:
    // The vertices of one instance.
    struct Run {
        std::size_t first;
        DenseTransfer matrices;
        std::shared_ptr<const ResponseTable> response;  // of_outgoing_light()
        VertexLight light;
        /// 1 for vertices whose matrices are new since their light was made; empty: all are.
        std::vector<std::uint8_t> fresh;
    };

    /// project and bake of the matrices, as far as changes make it necessary. Adds to `statistics`.
    void prepare(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);
    /// relight, likewise. Only after prepare() with the same input.
    void relight(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);
    /// shade: the vertices with visible[v] != 0. Only after relight() with the same input.
    void shade(const TransferInput& input, const Viewpoint& view, std::span<const std::uint8_t> visible,
               Workers& workers, Progress& progress, VertexStokes& out) const;
    void count(const TransferInput& input, Statistics& statistics) const;

    [[nodiscard]] const std::vector<Run>& runs() const noexcept { return runs_; }
    /// Counts the changes of their matrices.
    [[nodiscard]] std::uint64_t runs_revision() const noexcept { return runs_revision_; }

private:
    struct Projected {
        std::vector<IsotropicMatrix> channels;
        std::shared_ptr<const DenseMaterial> material;
        std::shared_ptr<const ResponseTable> response;
    };

    void project(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);
    // `stale`: vertices whose matrices are wrong though their material is the same.
    void bake(const TransferInput& input, const std::function<bool(std::size_t)>& stale, Workers& workers,
              Progress& progress, Statistics& statistics);

    std::map<MaterialPtr, Projected> materials_;
    int order_ = -1;  // that the materials are of
    LightKind kind_ = LightKind::unpolarized;
    std::vector<Run> runs_;
    std::uint64_t runs_revision_ = 0;
    RelightKey baked_for_;               // light not counted
    std::uint64_t baked_materials_ = 0;  // revision of the materials
    std::uint64_t lit_for_ = 0;          // revision of the light
};

}  // namespace nicol
