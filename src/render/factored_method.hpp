// SPDX-License-Identifier: MIT
// The factored method: light in the vertices' frames, dotted with the rows of response tables.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "material/response_cache.hpp"
#include "render/render.hpp"
#include "render/transfer_input.hpp"
#include "shading/shade.hpp"
#include "transfer/vertex_light.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

class FactoredMethod {
public:
    /// Keeps response tables in a folder, see load_or_build().
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// project and the shadows, as far as changes make it necessary. Adds to `statistics`.
    void prepare(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);
    /// relight, likewise. Only after prepare() with the same input.
    void relight(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);
    /// shade: the vertices with visible[v] != 0. Only after relight() with the same input.
    void shade(const TransferInput& input, const Viewpoint& view, std::span<const std::uint8_t> visible,
               Workers& workers, Progress& progress, VertexStokes& out) const;
    void count(const TransferInput& input, Statistics& statistics) const;

    [[nodiscard]] const std::map<MaterialPtr, ResponseTable>& tables() const noexcept { return tables_; }
    /// Counts the changes of tables().
    [[nodiscard]] std::uint64_t tables_revision() const noexcept { return tables_revision_; }
    /// None where nothing casts shadows.
    [[nodiscard]] const std::optional<VisibilityProduct>& shadows() const noexcept { return shadows_; }

private:
    void project(const TransferInput& input, Workers& workers, Progress& progress, Statistics& statistics);
    void prepare_shadows(const TransferInput& input, Workers& workers, Statistics& statistics);

    std::filesystem::path folder_;
    CacheNotice notice_;
    std::map<MaterialPtr, ResponseTable> tables_;
    std::uint64_t tables_revision_ = 0;
    int table_channels_ = 0;  // what the tables are for
    int tables_order_ = -1;
    LightKind tables_kind_ = LightKind::unpolarized;
    std::optional<VisibilityProduct> shadows_;
    RelightKey shadows_for_;  // light not counted
    VertexLight vertex_light_;
    RelightKey lit_for_;
};

}  // namespace nicol
