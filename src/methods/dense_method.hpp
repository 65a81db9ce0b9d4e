// SPDX-License-Identifier: MIT
// The dense method: the paper's transfer matrices, one per vertex.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "material/response_table.hpp"
#include "methods/transfer_method.hpp"
#include "surfaces/vertex_stage.hpp"
#include "transfer/dense.hpp"

namespace nicol {

class DenseMethod final : public TransferMethod {
public:
    /// Transfer matrices and response of the vertices of one range.
    struct Run {
        std::size_t first;
        DenseTransfer matrices;
        std::shared_ptr<const ResponseTable> response;
    };

    void project(const TransferInput& input, RenderRun& run) override;
    void bake(const TransferInput& input, VisibilityRequest* request, RenderRun& run) override;
    void relight(const TransferInput& input, RenderExecutor& executor, RenderRun& run) override;
    void shade(const ShadeInput& input, RenderExecutor& executor, RenderRun& run) const override;
    void shade_pixels(const PixelInput& input, RenderExecutor& executor, RenderRun& run) const override;
    void count(const TransferInput& input, Statistics& statistics) const override;

    /// Returns one run per range of the geometry.
    [[nodiscard]] const Versioned<std::vector<Run>>& runs() const noexcept { return runs_; }

private:
    struct Projected {
        std::vector<IsotropicMatrix> channels;
        LightKind kind = LightKind::unpolarized;  // kind of the light that the other members are for
        std::shared_ptr<const DenseMaterial> material;
        std::shared_ptr<const ResponseTable> response;
    };
    using Materials = std::map<MaterialPtr, Projected>;

    [[nodiscard]] Materials projected(const TransferInput& input, RenderRun& run);
    void build(const TransferInput& input, const VertexRange& range, bool all, DenseTransfer& out,
               RenderRun& run) const;

    Stage<int> sizing_;  // order
    Stage<Version, int, LightKind> projecting_;
    Materials materials_;
    // Inputs: order, kind of the light.
    VertexStage<int, LightKind> baking_{{.on_materials = true}};
    Versioned<std::vector<Run>> runs_;
    // Inputs: executor, light, whether pixels are shaded.
    VertexStage<Version, Version, bool> relighting_{{.on_materials = true}};
};

}  // namespace nicol
