// SPDX-License-Identifier: MIT
// The light's orders above order_low: filtered light, fitted materials, expanded visibility.
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

/// Distant light up to a high order, in its own axes. Filtering commutes with rotation, so a rotation of the
/// light costs nothing.
struct DistantLight {
    const PshVector& coefficients;  ///< coefficients of order `high`
    Version version;                ///< version of the coefficients
    int low;
    int high;  ///< above low
    bool polarized;
};

class HighOrderTransfer {
public:
    /// Sets the cache folder of results that are slow to fit; an empty folder disables the cache.
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Filters the light and fits the materials (project). Repeats only what changes require.
    void project(const TransferInput& input, const DistantLight& light, HighOrders form, RenderRun& run);
    /// Returns a request for the visibility that bake() would compute; none if nothing casts shadows or all
    /// that the image shows is current. The caller must pass the request to bake().
    [[nodiscard]] std::optional<VisibilityRequest> request(const TransferInput& input, int low,
                                                           RenderRun& run);
    /// Computes the coefficients of visibility (bake) that the request still misses.
    void bake(const TransferInput& input, int low, std::optional<VisibilityRequest> request, RenderRun& run);
    /// Adds the memory of the kept results to the statistics.
    void count(Statistics& statistics) const;

    /// Maps and factors for the high orders of a plain material.
    struct Part {
        HighOrderFactors factors;
        std::optional<LobeMap> convolved;  ///< map of HighOrders::convolution
        bool filtered = false;             ///< whether `maps` is set
        HighOrderMaps maps;
    };
    using Parts = std::map<MaterialPtr, Part>;
    [[nodiscard]] const Versioned<Parts>& parts() const noexcept { return parts_; }
    /// Returns the visibility up to twice the order that high orders begin above; empty if nothing casts
    /// shadows.
    [[nodiscard]] const Versioned<VisibilityBlocks>& visibility() const noexcept { return visibility_; }
    /// Returns the width, in radians, of a material's lobe about the mirror direction; for a textured
    /// material, the median width of its layers. Visible fractions are computed for this lobe.
    [[nodiscard]] double lobe_width(const MaterialPtr& material) const;

private:
    void fit(const TransferInput& input, const DistantLight& light, HighOrders form, RenderRun& run);
    void filter(const DistantLight& light, HighOrders form);
    static void fill(VisibilityRequest& request, const TransferInput& input, RenderRun& run);

    std::filesystem::path folder_;
    CacheNotice notice_;
    // Inputs: sampled terms, form, low and high order, channels, whether the light is polarized. fitting_
    // also depends on the materials.
    Stage<SampledTerms, HighOrders, int, int, int, bool> sizing_;
    Stage<Version, SampledTerms, HighOrders, int, int, int, bool> fitting_;
    Versioned<Parts> parts_;
    Version fitted_ = 0;  // version of the parts without their filtered maps
    std::map<MaterialPtr, std::vector<ConvolutionKernel>> kernels_;
    Stage<Version> lighting_;
    Stage<Version, Version> filtering_;
    std::optional<HighOrderLight> light_;

    VertexStage<int> expanding_{{.renumbers = true, .turns = true}};  // order
    Versioned<VisibilityBlocks> visibility_;
};

}  // namespace nicol
