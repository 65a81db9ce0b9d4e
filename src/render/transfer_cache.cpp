// SPDX-License-Identifier: MIT
#include "render/transfer_cache.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/matrix.hpp>
#include <utility>

#include "nicol/rotation.hpp"

namespace nicol {
namespace {

// Vertices between two looks at the progress callback, and between two tasks.
constexpr std::size_t chunk = 16384;
constexpr std::size_t grain = 256;

LightKind kind_of(const EnvironmentPtr& environment) {
    if (!environment || !environment->polarized()) return LightKind::unpolarized;
    return environment->circular() ? LightKind::full : LightKind::linear;
}

// The first channel alone where all are equal.
PshVector without_repeats(PshVector light) {
    for (int c = 1; c < light.channels(); ++c) {
        if (!std::ranges::equal(light.channel(c), light.channel(0))) return light;
    }
    PshVector single(light.order(), 1);
    std::ranges::copy(light.channel(0), single.channel(0).begin());
    return single;
}

}  // namespace

TransferCache::TransferCache(int threads) : arena_(threads > 0 ? threads : tbb::task_arena::automatic) {}

void TransferCache::update(const Scene& scene, const Projection& projection, int order, Progress& progress,
                           Statistics& statistics) {
    if (geometry_revision_ != scene.geometry_revision()) {
        geometry_ = world_geometry(scene);
        geometry_revision_ = scene.geometry_revision();
    }
    project_light(scene, order, statistics);
    project_materials(scene, progress, statistics);
    if (lit_geometry_ != geometry_revision_ || lit_light_ != scene.light_revision()) {
        relight(scene, progress, statistics);
        lit_geometry_ = geometry_revision_;
        lit_light_ = scene.light_revision();
    }
    shade(projection, progress, statistics);
    count(statistics);
}

void TransferCache::project_light(const Scene& scene, int order, Statistics& statistics) {
    const LightKind kind = kind_of(scene.environment());
    const bool same_layout = layout_ && layout_->order() == order && layout_->kind() == kind;
    if (same_layout && environment_ == scene.environment()) return;
    const Stopwatch watch;
    lit_light_ = 0;
    environment_ = scene.environment();
    light_ = environment_ ? without_repeats(environment_->project(order)) : PshVector(order, 1);
    if (!same_layout) {
        tables_.clear();
        layout_ = std::make_unique<LightLayout>(order, kind);
        shade_ = std::make_unique<Shade>(*layout_);
    }
    statistics.project_ms += watch.milliseconds();
}

void TransferCache::project_materials(const Scene& scene, Progress& progress, Statistics& statistics) {
    const Stopwatch watch;
    if (table_channels_ != scene.channels()) tables_.clear();
    table_channels_ = scene.channels();
    std::map<MaterialPtr, ResponseTable> tables;
    for (const VertexRange& range : geometry_.ranges) {
        if (tables.contains(range.material)) continue;
        if (auto known = tables_.extract(range.material)) {
            tables.insert(std::move(known));
            continue;
        }
        progress.report("project",
                        static_cast<double>(tables.size()) / static_cast<double>(geometry_.ranges.size()));
        arena_.execute([&] {
            tables.emplace(range.material, ResponseTable(*range.material, *layout_, table_channels_));
        });
    }
    tables_ = std::move(tables);
    statistics.project_ms += watch.milliseconds();
}

void TransferCache::relight(const Scene& scene, Progress& progress, Statistics& statistics) {
    const Stopwatch watch;
    PshVector light = rotated(light_, scene.light_rotation());
    for (double& coefficient : light.data()) coefficient *= scene.light_scale();
    const std::size_t vertices = geometry_.positions.size();
    const Relight turn(*layout_, light);
    vertex_light_ = VertexLight(*layout_, light.channels(), vertices);
    for (std::size_t first = 0; first < vertices; first += chunk) {
        progress.report("relight", static_cast<double>(first) / static_cast<double>(vertices));
        const tbb::blocked_range<std::size_t> all(first, std::min(first + chunk, vertices), grain);
        arena_.execute([&] {
            tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
                turn.run(std::span(geometry_.normals).subspan(range.begin(), range.size()), range.begin(),
                         vertex_light_);
            });
        });
    }
    statistics.relight_ms += watch.milliseconds();
}

void TransferCache::shade(const Projection& projection, Progress& progress, Statistics& statistics) {
    const Stopwatch watch;
    const std::size_t vertices = geometry_.positions.size();
    statistics.vertices_skipped = find_visible(geometry_, projection, visible_);
    stokes_.resize(static_cast<std::size_t>(table_channels_));
    for (auto& channel : stokes_) channel.resize(vertices);
    const std::vector<std::span<glm::vec4>> out(stokes_.begin(), stokes_.end());
    for (const VertexRange& run : geometry_.ranges) {
        const ResponseTable& table = tables_.at(run.material);
        for (std::size_t first = run.first; first < run.last; first += chunk) {
            progress.report("shade", static_cast<double>(first) / static_cast<double>(vertices));
            const tbb::blocked_range<std::size_t> all(first, std::min(first + chunk, run.last), grain);
            arena_.execute([&] {
                tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
                    shade_->run(table, vertex_light_, projection.view, geometry_.positions, geometry_.normals,
                                visible_, range.begin(), range.end(), out);
                });
            });
        }
    }
    statistics.shade_ms += watch.milliseconds();
}

void TransferCache::count(Statistics& statistics) const {
    statistics.order = layout_->order();
    statistics.vertices = geometry_.positions.size();
    statistics.triangles = geometry_.triangles.size();
    statistics.light_columns_skipped = static_cast<std::uint64_t>(4 - static_cast<int>(layout_->kind())) *
                                       static_cast<std::uint64_t>(light_.channels());
    statistics.channels_shared = static_cast<std::uint64_t>(table_channels_ - light_.channels());
    for (const auto& [material, table] : tables_) {
        statistics.response_bytes += table.bytes();
        for (std::size_t p = 0; p < 4; ++p) {
            // s1 and s2 are made together or not at all.
            const bool made = p == 1 || p == 2 ? table.makes(1) || table.makes(2) : p == 0 || table.makes(p);
            if (!made) statistics.response_rows_skipped += static_cast<std::uint64_t>(table_channels_);
        }
    }
    statistics.transfer_bytes = vertex_light_.bytes() + geometry_.bytes() + visible_.size() +
                                stokes_.size() * geometry_.positions.size() * sizeof(glm::vec4);
}

}  // namespace nicol
