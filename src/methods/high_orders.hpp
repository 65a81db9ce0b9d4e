// SPDX-License-Identifier: MIT
// The orders of light above order_low: the light filtered, materials fitted, visibility expanded.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "material/response_cache.hpp"
#include "methods/transfer_method.hpp"
#include "specular/high_order.hpp"
#include "specular/high_order_light.hpp"
#include "specular/high_order_visibility.hpp"
#include "stage/options.hpp"
#include "surfaces/vertex_stage.hpp"

namespace nicol {

/// Distant light to a high order, in its own axes: filtering commutes with rotation, so that a rotation costs
/// nothing.
struct DistantLight {
    const PshVector& coefficients;  ///< of order `high`, scaled
    Version version;                ///< of the coefficients
    int low;
    int high;  ///< above low
    bool polarized;
};

class HighOrderTransfer {
public:
    /// Where to keep what takes long to fit; an empty folder: nowhere.
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// project: filters the light and fits the materials, as far as changes make it necessary.
    void project(const TransferInput& input, const DistantLight& light, HighOrders form, RenderRun& run);
    /// The visibility that bake() would compute for all vertices; none where it has what it needs of them.
    [[nodiscard]] std::optional<VisibilityRequest> request(const TransferInput& input, int low);
    /// bake: coefficients of visibility, those of a request that has been filled.
    void bake(const TransferInput& input, int low, std::optional<VisibilityRequest> request, RenderRun& run);
    /// Adds what it keeps to the statistics.
    void count(Statistics& statistics) const;

    /// A material without variation with the maps and factors for its high orders.
    struct Part {
        HighOrderFactors factors;
        std::optional<LobeMap> convolved;  ///< of the published form
        bool filtered = false;             ///< the maps are there
        HighOrderMaps maps;
    };
    using Parts = std::map<MaterialPtr, Part>;
    [[nodiscard]] const Versioned<Parts>& parts() const noexcept { return parts_; }
    /// Of twice the order that high orders begin above; empty where nothing casts shadows.
    [[nodiscard]] const Versioned<VisibilityBlocks>& visibility() const noexcept { return visibility_; }
    /// Of a material's lobe about the mirror direction, radians, where it varies of the middle one of its
    /// layers; visible fractions are computed for this lobe.
    [[nodiscard]] double lobe_width(const MaterialPtr& material) const;

private:
    void fit(const TransferInput& input, const DistantLight& light, HighOrders form, RenderRun& run);
    void filter(const DistantLight& light, HighOrders form);
    [[nodiscard]] VisibilityBlocks expanded(const TransferInput& input, int order, RenderRun& run) const;

    std::filesystem::path folder_;
    CacheNotice notice_;
    // Form, low and high order, channels, whether the light is polarized.
    Stage<HighOrders, int, int, int, bool> sizing_;
    Stage<Version, HighOrders, int, int, int, bool> fitting_;
    Versioned<Parts> parts_;
    Version fitted_ = 0;  // of the parts without what is filtered for them
    std::map<MaterialPtr, std::vector<ConvolutionKernel>> kernels_;
    Stage<Version> lighting_;
    Stage<Version, Version> filtering_;
    std::optional<HighOrderLight> light_;

    VertexStage<int> expanding_{{}};  // order
    Versioned<VisibilityBlocks> visibility_;
};

}  // namespace nicol
