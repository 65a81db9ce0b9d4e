// SPDX-License-Identifier: MIT
#include "render/dense_method.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "nicol/material_projection.hpp"

namespace nicol {

void DenseMethod::prepare(const TransferInput& input, Workers& workers, Progress& progress,
                          Statistics& statistics) {
    const RelightKey key = RelightKey(input).without_light();
    if (baked_for_ == key) return;
    baked_for_ = lit_for_ = {};
    ++runs_revision_;
    bake(input, workers, progress, statistics);
    baked_for_ = key;
}

void DenseMethod::bake(const TransferInput& input, Workers& workers, Progress& progress,
                       Statistics& statistics) {
    const Stopwatch projecting;
    const int order = input.layout.order();
    std::map<std::pair<MaterialPtr, int>, std::vector<IsotropicMatrix>> matrices;
    std::map<MaterialPtr, std::shared_ptr<const DenseMaterial>> materials;
    std::map<MaterialPtr, std::shared_ptr<const OutgoingShade>> shades;
    for (const VertexRange& range : input.geometry.ranges) {
        if (materials.contains(range.material)) continue;
        progress.report("project", static_cast<double>(materials.size()) /
                                       static_cast<double>(input.geometry.ranges.size()));
        const std::pair key(range.material, order);
        if (auto known = matrices_.extract(key)) {
            matrices.insert(std::move(known));
        } else {
            std::vector<IsotropicMatrix>& channels = matrices[key];
            for (int c = 0; c < range.material->channels(); ++c) {
                workers.run([&] { channels.push_back(project_material(*range.material, c, order)); });
            }
        }
        const auto material = std::make_shared<const DenseMaterial>(matrices.at(key), input.layout.kind());
        materials.emplace(range.material, material);
        shades.emplace(range.material, std::make_shared<const OutgoingShade>(material->outgoing()));
    }
    matrices_ = std::move(matrices);
    statistics.project_ms += projecting.milliseconds();

    const Stopwatch baking;
    const auto shadows = std::make_shared<const ShadowMatrix>(2 * order, order, order);
    std::optional<VisibilityHarmonics> harmonics;
    if (input.visibility != nullptr) harmonics.emplace(*input.directions, 2 * order, input.horizon);
    runs_.clear();
    for (const VertexRange& range : input.geometry.ranges) {
        const auto& material = materials.at(range.material);
        const std::size_t count = range.last - range.first;
        Run& run = runs_.emplace_back(Run{.first = range.first,
                                          .matrices = DenseTransfer(material, count),
                                          .shade = shades.at(range.material),
                                          .light = {}});
        workers.for_vertices(
            range.first, range.last, input.geometry.positions.size(), "bake", progress,
            [&](std::size_t begin, std::size_t end) {
                DenseBuilder builder(material, shadows);
                std::vector<float> seen(psh_count(2 * order));
                std::vector<double> visibility;
                for (std::size_t v = begin; v < end; ++v) {
                    if (harmonics) {
                        harmonics->project(*input.visibility, v, input.geometry.normals[v], seen);
                        visibility.assign(seen.begin(), seen.end());
                    }
                    builder.build(input.geometry.normals[v], visibility, run.matrices.at(v - range.first));
                }
            });
    }
    statistics.bake_ms += baking.milliseconds();
}

void DenseMethod::relight(const TransferInput& input, Workers& workers, Progress& progress,
                          Statistics& statistics) {
    const RelightKey key(input);
    if (lit_for_ == key) return;
    lit_for_ = {};
    const Stopwatch watch;
    for (Run& run : runs_) {
        const std::size_t count = run.matrices.vertices();
        const int channels = std::max(input.light.channels(), run.matrices.material().channels());
        run.light.resize(run.matrices.material().outgoing(), channels, count);
        workers.for_vertices(0, count, count, "relight", progress, [&](std::size_t begin, std::size_t end) {
            run.matrices.apply(input.light, begin, end, 0, run.light);
        });
    }
    lit_for_ = key;
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
        workers.for_vertices(0, count, count, "shade", progress, [&](std::size_t begin, std::size_t end) {
            run.shade->run(run.light, view, positions, normals, visible.subspan(run.first, count), begin, end,
                           channels);
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
