// SPDX-License-Identifier: MIT
// The dense method: the article's transfer matrices, one a vertex.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "nicol/render.hpp"
#include "render/transfer_input.hpp"
#include "transfer/dense.hpp"
#include "transfer/outgoing_shade.hpp"

namespace nicol {

class DenseMethod {
public:
    // The vertices of one instance.
    struct Run {
        std::size_t first;
        DenseTransfer matrices;
        std::shared_ptr<const OutgoingShade> shade;
        OutgoingLight light;
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
    void bake(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);

    std::map<std::pair<MaterialPtr, int>, std::vector<IsotropicMatrix>> matrices_;  // by material and order
    std::vector<Run> runs_;
    std::uint64_t runs_revision_ = 0;
    RelightKey baked_for_;  // light not counted
    RelightKey lit_for_;
};

}  // namespace nicol
