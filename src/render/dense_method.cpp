// SPDX-License-Identifier: MIT
#include "render/dense_method.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

#include "material/material_projection.hpp"

namespace nicol {

void DenseMethod::prepare(const TransferInput& input, Workers& workers, Progress& progress,
                          Statistics& statistics) {
    const RelightKey key = RelightKey(input).without_light();
    if (baked_for_ == key && baked_materials_ == input.material_revision) return;
    const auto before = RelightKey::before(input);
    const bool same = baked_for_ == key;
    const bool follows = before && baked_for_ == before->without_light();
    baked_for_ = {};
    ++runs_revision_;
    if (!same && !follows) runs_.clear();
    project(input, workers, progress, statistics);
    const auto stale = [&](std::size_t v) { return !same && input.unchanged->vertices[v] == 0; };
    bake(input, stale, workers, progress, statistics);
    baked_for_ = key;
    baked_materials_ = input.material_revision;
}

void DenseMethod::project(const TransferInput& input, Workers& workers, Progress& progress,
                          Statistics& statistics) {
    const Stopwatch watch;
    const int order = input.layout.order();
    if (order_ != order) materials_.clear();
    if (kind_ != input.layout.kind()) {
        for (auto& [material, projected] : materials_) projected.material.reset();
    }
    order_ = order;
    kind_ = input.layout.kind();
    std::map<MaterialPtr, Projected> materials;
    for (const VertexRange& range : input.geometry.ranges) {
        if (materials.contains(range.material)) continue;
        progress.report("project", static_cast<double>(materials.size()) /
                                       static_cast<double>(input.geometry.ranges.size()));
        if (auto known = materials_.extract(range.material)) {
            materials.insert(std::move(known));
        } else {
            Projected& projected = materials[range.material];
            for (int c = 0; c < range.material->channels(); ++c) {
                workers.run(
                    [&] { projected.channels.push_back(project_material(*range.material, c, order)); });
            }
            ++statistics.materials_projected;
        }
        Projected& projected = materials.at(range.material);
        if (projected.material) continue;
        projected.material = std::make_shared<const DenseMaterial>(projected.channels, kind_);
        projected.response = std::make_shared<const ResponseTable>(
            ResponseTable::of_outgoing_light(projected.material->outgoing()));
    }
    materials_ = std::move(materials);
    statistics.project_ms += watch.milliseconds();
}

void DenseMethod::bake(const TransferInput& input, const std::function<bool(std::size_t)>& stale,
                       Workers& workers, Progress& progress, Statistics& statistics) {
    const Stopwatch watch;
    const int order = input.layout.order();
    const auto shadows = std::make_shared<const ShadowMatrix>(2 * order, order, order);
    std::optional<VisibilityHarmonics> harmonics;
    if (input.visibility != nullptr) harmonics.emplace(*input.directions, 2 * order);
    std::vector<Run> former = std::move(runs_);
    runs_.clear();
    for (const VertexRange& range : input.geometry.ranges) {
        const auto& material = materials_.at(range.material).material;
        const std::size_t count = range.last - range.first;
        const auto same = [&](const Run& run) {
            return run.first == range.first && run.matrices.vertices() == count &&
                   &run.matrices.material() == material.get();
        };
        const auto known = std::ranges::find_if(former, same);
        const bool all = known == former.end();
        if (all) {
            runs_.push_back(Run{.first = range.first,
                                .matrices = DenseTransfer(material, count),
                                .response = materials_.at(range.material).response,
                                .light = {},
                                .fresh = {}});
        } else {
            runs_.push_back(std::move(*known));
            former.erase(known);
        }
        Run& run = runs_.back();
        for (std::size_t i = 0; i < run.fresh.size(); ++i) {
            if (stale(range.first + i)) run.fresh[i] = 1;
        }
        std::atomic<std::size_t> baked = 0;
        workers.for_vertices(
            range.first, range.last, input.geometry.positions.size(), "bake", progress,
            [&](std::size_t first, std::size_t last) {
                std::optional<DenseBuilder> builder;
                std::vector<float> seen(psh_count(2 * order));
                std::vector<double> visibility;
                for (std::size_t v = first; v < last; ++v) {
                    if (!all && !stale(v)) continue;
                    if (!builder) builder.emplace(material, shadows);
                    if (harmonics) {
                        harmonics->project(*input.visibility, v, input.geometry.normals[v], seen);
                        visibility.assign(seen.begin(), seen.end());
                    }
                    builder->build(input.geometry.normals[v], visibility, run.matrices.at(v - range.first));
                    ++baked;
                }
            });
        statistics.matrices_baked += baked;
    }
    statistics.bake_ms += watch.milliseconds();
}

void DenseMethod::relight(const TransferInput& input, Workers& workers, Progress& progress,
                          Statistics& statistics) {
    const bool same_light = lit_for_ == input.light_revision;
    const auto fresh = [](const Run& run) {
        return run.fresh.empty() || std::ranges::find(run.fresh, 1) != run.fresh.end();
    };
    if (same_light && std::ranges::none_of(runs_, fresh)) return;
    lit_for_ = 0;
    const Stopwatch watch;
    std::atomic<std::size_t> relit = 0;
    for (Run& run : runs_) {
        const std::size_t count = run.matrices.vertices();
        const int channels = std::max(input.light.channels(), run.matrices.material().channels());
        const bool all = !same_light || run.fresh.empty();
        run.light.resize(run.matrices.material().outgoing(), channels, count);
        workers.for_vertices(0, count, count, "relight", progress, [&](std::size_t first, std::size_t last) {
            const auto stale = [&](std::size_t v) { return all || run.fresh[v] != 0; };
            for_runs(first, last, stale, [&](std::size_t begin, std::size_t end) {
                run.matrices.apply(input.light, begin, end, 0, run.light);
                relit += end - begin;
            });
        });
        run.fresh.assign(count, 0);
    }
    lit_for_ = input.light_revision;
    statistics.vertices_relit += relit;
    statistics.relight_ms += watch.milliseconds();
}

void DenseMethod::shade(const TransferInput& input, const Viewpoint& view,
                        std::span<const std::uint8_t> visible, Workers& workers, Progress& progress,
                        VertexStokes& out) const {
    for (const Run& run : runs_) {
        const std::size_t count = run.matrices.vertices();
        const std::span positions = std::span(input.geometry.positions).subspan(run.first, count);
        const std::span normals = std::span(input.geometry.normals).subspan(run.first, count);
        std::vector<std::span<glm::vec4>> channels;
        for (auto& channel : out) channels.push_back(std::span(channel).subspan(run.first, count));
        const Shade shade(run.matrices.material().outgoing());
        workers.for_vertices(0, count, count, "shade", progress, [&](std::size_t begin, std::size_t end) {
            shade.run(*run.response, run.light, view, positions, normals, visible.subspan(run.first, count),
                      begin, end, channels);
        });
    }
}

void DenseMethod::count(const TransferInput& input, Statistics& statistics) const {
    for (const Run& run : runs_) {
        statistics.transfer_bytes += run.matrices.bytes() + run.light.bytes();
        const int rows = static_cast<int>(run.matrices.material().outgoing().kind());
        statistics.response_rows_skipped += static_cast<std::uint64_t>((4 - rows) * input.channels);
    }
}

}  // namespace nicol
