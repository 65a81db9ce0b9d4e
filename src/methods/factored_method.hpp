// SPDX-License-Identifier: MIT
// The factored method: light in the vertices' frames, dotted with the rows of response tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "methods/bounces.hpp"
#include "methods/response_tables.hpp"
#include "methods/transfer_method.hpp"
#include "surfaces/vertex_stage.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

class FactoredMethod final : public TransferMethod {
public:
    /// Sets the cache folder of response tables, see load_or_build().
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    void project(const TransferInput& input, RenderRun& run) override;
    void bake(const TransferInput& input, VisibilityRequest* request, RenderRun& run) override;
    void relight(const TransferInput& input, RenderExecutor& executor, RenderRun& run) override;
    void shade(const ShadeInput& input, RenderExecutor& executor, RenderRun& run) const override;
    void shade_pixels(const PixelInput& input, RenderExecutor& executor, RenderRun& run) const override;
    void count(const TransferInput& input, Statistics& statistics) const override;

    /// Response tables of plain_materials().
    using Tables = ResponseTables::Map;
    [[nodiscard]] const Versioned<Tables>& tables() const noexcept { return tables_.tables(); }
    /// Returns the terms of a material that reflect the bounced light which stays apart. followed: whether
    /// rays follow the material's lobes.
    [[nodiscard]] static ResponseTables::Choice apart_terms(SampledTerms sampled, bool followed);
    /// Returns the response tables of these terms, in the layout of bounced light.
    [[nodiscard]] const Tables& apart(bool followed) const noexcept {
        return followed ? *not_followed_.tables() : *not_smooth_.tables();
    }
    /// Returns the visibility product; none if nothing casts shadows.
    [[nodiscard]] const Versioned<std::optional<VisibilityProduct>>& shadows() const noexcept {
        return shadows_;
    }

    /// Returns the bounced light.
    [[nodiscard]] const Bounces& bounces() const noexcept { return bounces_; }

private:
    ResponseTables tables_, not_smooth_, not_followed_;
    // Inputs: order, kind of the light.
    VertexStage<int, LightKind> baking_{{.renumbers = true, .turns = true}};
    Versioned<std::optional<VisibilityProduct>> shadows_;
    std::size_t baked_ = 0;  // number of vertices of shadows_
    Bounces bounces_;
    // Light that the executor keeps, for vertices or for pixels.
    struct KeptLight {
        // Inputs: executor, light, its components, bounced light.
        VertexStage<Version, Version, LightKind, Version> relighting{{.renumbers = true}};
        std::size_t vertices = 0;
        Version light = 0;
    };
    KeptLight of_vertices_, of_pixels_;
    std::vector<std::uint8_t> fresh_, relit_;  // work space of relight(), by vertex
};

}  // namespace nicol
