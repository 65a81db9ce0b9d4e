// SPDX-License-Identifier: MIT
#include "methods/dense_method.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "material/material_projection.hpp"
#include "visibility/even_irradiance.hpp"

namespace nicol {

void DenseMethod::project(const TransferInput& input, RenderRun& run) {
    const int order = input.layout.order();
    projecting_.run(input.materials, order, input.layout.kind(), [&] {
        const Stopwatch watch;
        sizing_.run(order, [&] { materials_.clear(); });
        materials_ = projected(input, run);
        run.statistics.project_ms += watch.milliseconds();
    });
}

DenseMethod::Materials DenseMethod::projected(const TransferInput& input, RenderRun& run) {
    Materials materials;
    for (const VertexRange& range : input.geometry.ranges) {
        if (materials.contains(range.material)) continue;
        run.progress.report("project", static_cast<double>(materials.size()) /
                                           static_cast<double>(input.geometry.ranges.size()));
        if (auto known = materials_.extract(range.material)) {
            materials.insert(std::move(known));
        } else {
            Projected& made = materials[range.material];
            for (int c = 0; c < range.material->channels(); ++c) {
                run.workers.run([&] {
                    made.channels.push_back(project_material(*range.material, c, input.layout.order()));
                });
            }
            ++run.statistics.materials_projected;
        }
        Projected& made = materials.at(range.material);
        if (made.material && made.kind == input.layout.kind()) continue;
        made.kind = input.layout.kind();
        made.material = std::make_shared<const DenseMaterial>(made.channels, made.kind);
        made.response = std::make_shared<const ResponseTable>(
            ResponseTable::of_outgoing_light(made.material->outgoing()));
    }
    return materials;
}

void DenseMethod::bake(const TransferInput& input, VisibilityRequest* /*request*/, RenderRun& run) {
    if (!baking_.update(input, input.layout.order(), input.layout.kind())) return;
    const Stopwatch watch;
    std::vector<Run> former = std::exchange(runs_.change(), {});
    if (!baking_.any_current()) former.clear();
    std::vector<Run> runs;
    for (const VertexRange& range : input.geometry.ranges) {
        const Projected& projected = materials_.at(range.material);
        const std::size_t count = range.last - range.first;
        const auto known = std::ranges::find_if(former, [&](const Run& one) {
            return one.first == range.first && one.matrices.vertices() == count &&
                   &one.matrices.material() == projected.material.get();
        });
        const bool all = known == former.end();
        if (all) {
            runs.push_back({.first = range.first,
                            .matrices = DenseTransfer(projected.material, count),
                            .response = projected.response});
        } else {
            runs.push_back(std::move(*known));
            former.erase(known);
        }
        build(input, range, all, runs.back().matrices, run);
    }
    runs_.change() = std::move(runs);
    baking_.complete();
    run.statistics.bake_ms += watch.milliseconds();
}

void DenseMethod::build(const TransferInput& input, const VertexRange& range, bool all, DenseTransfer& out,
                        RenderRun& run) const {
    const int order = input.layout.order();
    const auto& material = materials_.at(range.material).material;
    const auto shadows = std::make_shared<const ShadowMatrix>(2 * order, order, order);
    std::optional<VisibilityHarmonics> harmonics;
    std::optional<EvenIrradiance> even;
    if (input.visibility != nullptr) {
        run.workers.run([&] { harmonics.emplace(*input.directions, 2 * order); });
        even.emplace(*input.directions, order);
    }
    const std::span current = baking_.current();
    std::atomic<std::size_t> baked = 0;
    run.workers.for_vertices(
        range.first, range.last, input.geometry.positions.size(), "bake", run.progress,
        [&](std::size_t first, std::size_t last) {
            std::optional<DenseBuilder> builder;
            std::vector<std::uint32_t> vertices;
            for (std::size_t v = first; v < last; ++v)
                if (all || current[v] == 0) vertices.push_back(static_cast<std::uint32_t>(v));
            if (vertices.empty()) return;
            builder.emplace(material, shadows);
            const std::vector<glm::vec3>& normals = input.geometry.normals;
            const std::size_t size = psh_count(2 * order);
            constexpr std::size_t batch = VisibilityHarmonics::kBatch;
            std::vector<Lanes> seen(harmonics ? batch / kLanes * size : 0);
            std::vector<float> one(size);
            std::vector<double> visibility;
            for (std::size_t k = 0; k < vertices.size(); ++k) {
                const std::uint32_t v = vertices[k];
                if (harmonics) {
                    if (k % batch == 0)
                        harmonics->project(
                            *input.visibility, normals,
                            std::span(vertices).subspan(k, std::min(batch, vertices.size() - k)), seen);
                    const std::size_t block = k % batch / kLanes;
                    for (std::size_t i = 0; i < size; ++i) one[i] = seen[block * size + i][k % kLanes];
                    even->restore(*input.visibility, v, normals[v], one);
                    visibility.assign(one.begin(), one.end());
                }
                builder->build(normals[v], visibility, out.at(v - range.first));
                ++baked;
            }
        });
    run.statistics.matrices_baked += baked;
}

void DenseMethod::relight(const TransferInput& input, RenderExecutor& executor, RenderRun& run) {
    if (!relighting_.update(input, executor.version(), input.light_version, input.at_pixels)) return;
    const Stopwatch watch;
    run.statistics.vertices_relit += executor.relight(*this, input, relighting_.current(), run);
    relighting_.complete();
    run.statistics.relight_ms += watch.milliseconds();
}

void DenseMethod::shade(const ShadeInput& input, RenderExecutor& executor, RenderRun& run) const {
    executor.shade(*this, input, run);
}

void DenseMethod::shade_pixels(const PixelInput& input, RenderExecutor& executor, RenderRun& run) const {
    executor.shade_pixels(*this, input, run);
}

void DenseMethod::count(const TransferInput& input, Statistics& statistics) const {
    for (const Run& run : *runs_) {
        statistics.transfer_bytes += run.matrices.bytes();
        const int rows = static_cast<int>(run.matrices.material().outgoing().kind());
        statistics.response_rows_skipped += static_cast<std::uint64_t>((4 - rows) * input.channels);
    }
}

}  // namespace nicol
