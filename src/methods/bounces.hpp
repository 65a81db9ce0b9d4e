// SPDX-License-Identifier: MIT
// Light that surfaces reflect to each other, as incident light of vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "methods/bounce_columns.hpp"
#include "methods/linked_surfaces.hpp"
#include "methods/response_tables.hpp"
#include "methods/transfer_input.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"

namespace nicol {

/// Bounced light. It is linear in the distant light, so the bake finds, for each receiver, the bounced light
/// of each coefficient of the distant light's low orders. A relight multiplies and adds.
class Bounces {
public:
    /// Sets the cache folder of response tables, see load_or_build().
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Projects the materials to response tables of the bounced light's order.
    void project(const TransferInput& input, RenderRun& run);
    /// Finds receivers, links and the bounced light of each coefficient.
    void bake(const TransferInput& input, RenderRun& run);
    /// Computes the bounced light.
    void relight(const TransferInput& input, RenderRun& run);
    /// Drops everything.
    void clear();

    /// Returns a version that changes whenever the bounced light changes.
    [[nodiscard]] Version version() const noexcept { return light_.version(); }
    /// Returns the bounced light in the geometry's axes if pixels are shaded, otherwise in the vertices'
    /// frames; empty: there is none, or it stays apart.
    [[nodiscard]] const VertexLight& light() const noexcept { return *light_; }
    /// Returns the bounced light and, as the last channel, the coverage of directions by surfaces, as
    /// BouncedLight takes them: in the geometry's axes, as rows of layout(). Empty unless bounced light stays
    /// apart or pixels are shaded whose materials have sampled terms; the coverage is 0 without the latter.
    [[nodiscard]] const VertexLight& rows() const noexcept { return rows_; }
    [[nodiscard]] const LightLayout& layout() const noexcept { return *layout_; }
    /// Returns, for each number of light(), its index in a light of the layout of relight().
    [[nodiscard]] std::span<const std::size_t> places() const noexcept { return places_; }
    /// Adds the bounced light to blocks first <= b < last of light in the same axes.
    void add_to(VertexLight& light, std::size_t first, std::size_t last) const;

    /// Returns the gradient by the coefficients of the distant light, in the geometry's axes, from that by
    /// the vertices' light: the transpose of the light that add_to() adds. row(v): gradient of vertex v, or
    /// null for 0, [channel][number of light], in the geometry's axes. light: layout of the vertices' light.
    [[nodiscard]] PshVector gradient(const std::function<const float*(std::size_t)>& row,
                                     const LightLayout& light, int channels) const;

    void count(Statistics& statistics) const;
    /// Returns an upper bound of the bytes that one vertex adds. light: components of the distant light,
    /// none: it is dark. bounced: components of the bounced light.
    [[nodiscard]] static std::uint64_t bytes_of_vertex(std::optional<LightKind> light, LightKind bounced,
                                                       int channels);

private:
    void light_links(const TransferInput& input, RenderRun& run);
    /// Sets at_receivers_ and the shares of bounced light.
    void combine(const TransferInput& input, RenderRun& run);
    /// Interpolates at_receivers_ at the vertices.
    void interpolate(const TransferInput& input, RenderRun& run);

    ResponseTables tables_;
    std::optional<LightLayout> layout_;
    std::vector<std::size_t> places_;
    Stage<SurfaceVersions> linking_;
    Stage<SurfaceVersions, Version> weighting_;  // surfaces, materials
    Versioned<LinkedSurfaces> links_;
    // Inputs: links, tables, components of the distant light, channels, bounces, negligible light.
    Stage<Version, Version, std::optional<LightKind>, int, int, double> solving_;
    Versioned<BounceColumns> columns_;
    Stage<Version, Version> lighting_;  // links and tables with the columns, local lights
    Versioned<LitSeries> lit_;          // bounced light of local lights
    std::vector<float> local_;          // local_light_at_receivers(); empty: there is none
    bool makes_rows_ = false;           // whether rows() is made
    bool covers_ = false;               // whether its last channel is more than 0
    // Inputs: columns, distant light, lit_, whether pixels are shaded, makes_rows_, whether bounced light
    // stays apart.
    Stage<Version, Version, Version, bool, bool, bool> relighting_;
    Stage<Version, int, LightKind> covering_;  // links, layout
    std::vector<float> coverage_;              // [receiver][number], see coverage_at_receivers()
    std::vector<float> at_receivers_;  // [receiver][channel and coverage][number], in the world's axes
    VertexLight rows_;                 // see rows()
    Versioned<VertexLight> light_;
    double share_ = 0;  // share of bounced light
    double left_ = 0;   // estimated share of the light of bounces that were left out
};

}  // namespace nicol
