// SPDX-License-Identifier: MIT
#include "render/factored_method.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace nicol {

void FactoredMethod::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

void FactoredMethod::prepare(const TransferInput& input, Workers& workers, Progress& progress,
                             Statistics& statistics) {
    project(input, workers, progress, statistics);
    prepare_shadows(input, workers, statistics);
}

void FactoredMethod::project(const TransferInput& input, Workers& workers, Progress& progress,
                             Statistics& statistics) {
    const Stopwatch watch;
    if (table_channels_ != input.channels || tables_order_ != input.layout.order() ||
        tables_kind_ != input.layout.kind()) {
        tables_.clear();
        ++tables_revision_;
    }
    table_channels_ = input.channels;
    tables_order_ = input.layout.order();
    tables_kind_ = input.layout.kind();
    std::map<MaterialPtr, ResponseTable> tables;
    for (const VertexRange& range : input.geometry.ranges) {
        if (tables.contains(range.material)) continue;
        if (auto known = tables_.extract(range.material)) {
            tables.insert(std::move(known));
            continue;
        }
        progress.report("project", static_cast<double>(tables.size()) /
                                       static_cast<double>(input.geometry.ranges.size()));
        ++tables_revision_;
        ++statistics.materials_projected;
        workers.run([&] {
            tables.emplace(range.material,
                           load_or_build(*range.material, input.layout, input.channels, folder_, notice_));
        });
    }
    if (!tables_.empty()) ++tables_revision_;
    tables_ = std::move(tables);
    statistics.project_ms += watch.milliseconds();
}

void FactoredMethod::prepare_shadows(const TransferInput& input, Workers& workers, Statistics& statistics) {
    const RelightKey key = RelightKey(input).without_light();
    if (shadows_for_ == key) return;
    const auto before = RelightKey::before(input);
    const bool follows = shadows_ && before && shadows_for_ == before->without_light();
    shadows_for_ = {};
    std::optional<VisibilityProduct> former = std::move(shadows_);
    shadows_.reset();
    if (input.visibility != nullptr) {
        const Stopwatch watch;
        workers.run([&] {
            const std::span normals(input.geometry.normals);
            if (follows) {
                shadows_.emplace(std::move(*former), input.unchanged->vertices, *input.visibility,
                                 *input.directions, normals);
            } else {
                former.reset();
                AwaitedVisibility* const awaited = input.awaited;
                const bool fits = awaited != nullptr && awaited->blocks.order() == 2 * input.layout.order();
                shadows_.emplace(*input.visibility, *input.directions, normals, input.layout,
                                 fits ? &awaited->blocks : nullptr);
                if (fits) awaited->filled = true;
            }
        });
        statistics.bake_ms += watch.milliseconds();
    }
    shadows_for_ = key;
}

void FactoredMethod::relight(const TransferInput& input, Workers& workers, Progress& progress,
                             Statistics& statistics) {
    const RelightKey key(input);
    if (lit_for_ == key) return;
    const std::size_t vertices = input.geometry.positions.size();
    const std::size_t blocks = vertex_light_.blocks();
    vertex_light_.resize(input.layout, input.light.channels(), vertices);
    const auto before = RelightKey::before(input);
    const bool follows = before && vertex_light_.blocks() == blocks && lit_for_ == *before;
    lit_for_ = {};
    const Stopwatch watch;
    const std::span normals(input.geometry.normals);
    const Relight turn(input.layout, input.light);
    const auto stale = [&](std::size_t block) {
        if (!follows) return true;
        const auto same = input.unchanged->vertices.subspan(block * kLanes);
        return std::ranges::any_of(same.first(std::min(kLanes, same.size())),
                                   [](std::uint8_t one) { return one == 0; });
    };
    std::atomic<std::size_t> relit = 0;
    workers.for_blocks(vertex_light_.blocks(), "relight", progress, [&](std::size_t first, std::size_t last) {
        for_runs(first, last, stale, [&](std::size_t begin, std::size_t end) {
            turn.run(normals, begin, end, vertex_light_);
            if (shadows_) shadows_->run(vertex_light_, begin, end);
            relit += std::min(end * kLanes, vertices) - begin * kLanes;
        });
    });
    lit_for_ = key;
    statistics.vertices_relit += relit;
    statistics.relight_ms += watch.milliseconds();
}

void FactoredMethod::shade(const TransferInput& input, const Viewpoint& view,
                           std::span<const std::uint8_t> visible, Workers& workers, Progress& progress,
                           VertexStokes& out) const {
    const WorldGeometry& geometry = input.geometry;
    const Shade shade(input.layout, input.least_components, input.most_components);
    const std::vector<std::span<glm::vec4>> channels(out.begin(), out.end());
    for (const VertexRange& run : geometry.ranges) {
        const ResponseTable& table = tables_.at(run.material);
        workers.for_vertices(run.first, run.last, geometry.positions.size(), "shade", progress,
                             [&](std::size_t begin, std::size_t end) {
                                 shade.run(table, vertex_light_, view, geometry.positions, geometry.normals,
                                           visible, begin, end, channels);
                             });
    }
}

void FactoredMethod::count(const TransferInput& input, Statistics& statistics) const {
    for (const auto& [material, table] : tables_) {
        statistics.response_bytes += table.bytes();
        for (std::size_t p = 0; p < 4; ++p) {
            // s1 and s2 are made together or not at all.
            const bool made = p == 1 || p == 2 ? table.makes(1) || table.makes(2) : p == 0 || table.makes(p);
            if (!made) statistics.response_rows_skipped += static_cast<std::uint64_t>(input.channels);
        }
    }
    statistics.transfer_bytes += vertex_light_.bytes() + (shadows_ ? shadows_->bytes() : 0);
}

}  // namespace nicol
