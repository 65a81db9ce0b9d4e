// SPDX-License-Identifier: MIT
// Light that surfaces reflect to each other, as incident light of vertices.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "material/response_cache.hpp"
#include "methods/linked_light.hpp"
#include "methods/transfer_input.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

/// Highest order of bounced light at vertices.
inline constexpr int kBounceOrder = 3;

/// Bounced light: the sum over bounces of a Neumann series along links, see SurfaceLink.
class Bounces {
public:
    /// Sets the cache folder of response tables, see load_or_build().
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Projects the materials to response tables of the bounced light's order.
    void project(const TransferInput& input, RenderRun& run);
    /// Finds the links.
    void bake(const TransferInput& input, RenderRun& run);
    /// Computes the bounced light. shadows: the vertices' visibility.
    void relight(const TransferInput& input, const VisibilityProduct& shadows, RenderRun& run);
    /// Drops everything.
    void clear();

    /// Returns a version that changes whenever the bounced light changes.
    [[nodiscard]] Version version() const noexcept { return light_.version(); }
    /// Returns the bounced light in the vertices' frames; empty: there is none.
    [[nodiscard]] const VertexLight& light() const noexcept { return *light_; }
    /// Returns, for each number of light(), its index in a light of the layout of relight().
    [[nodiscard]] std::span<const std::size_t> places() const noexcept { return places_; }
    /// Adds the bounced light to blocks first <= b < last of light in the vertices' frames.
    void add_to(VertexLight& light, std::size_t first, std::size_t last) const;

    void count(Statistics& statistics) const;

private:
    using Tables = std::map<MaterialPtr, ResponseTable>;

    void find_direct(const TransferInput& input, const VisibilityProduct& shadows, RenderRun& run);
    void light_links(const TransferInput& input, RenderRun& run);
    /// Sets a block of rows_ to all light of its vertices.
    void sum_rows(const FrameRotation& rotation, std::span<const glm::vec3> normals, std::size_t block);
    void iterate(const TransferInput& input, RenderRun& run);

    std::filesystem::path folder_;
    CacheNotice notice_;
    std::optional<LightLayout> layout_;
    std::vector<std::size_t> places_;
    Stage<int, int, LightKind> sizing_;  // channels, order, kind
    Stage<Version, int, int, LightKind> projecting_;
    Versioned<Tables> tables_;
    Stage<SurfaceVersions> linking_;
    Stage<SurfaceVersions, Version> weighting_;  // surfaces, materials
    Versioned<LinkedSurfaces> links_;
    Stage<Version, Version> lighting_;  // links, local lights
    Versioned<LinkStokes> lit_;         // reflection of local lights; empty: there are none
    // Inputs: links, tables, light, reflection of local lights, bounces.
    Stage<Version, Version, Version, Version, int> relighting_;
    VertexLight direct_;  // in the vertices' frames
    VertexLight rows_;    // all light, as rows in the geometry's axes
    LinkStokes stokes_;
    Versioned<VertexLight> light_;
    int rounds_ = 0;
    double share_ = 0;  // share of bounced light
    double left_ = 0;   // estimated share of the light of bounces that were left out
};

}  // namespace nicol
