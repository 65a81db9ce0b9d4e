// SPDX-License-Identifier: MIT
#include "render/high_orders.hpp"

#include <algorithm>
#include <utility>

#include "specular/convolution_kernel.hpp"
#include "specular/high_order_cache.hpp"

namespace nicol {

void HighOrderTransfer::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

bool HighOrderTransfer::is_current(const TransferInput& input, int order) const {
    return visibility_order_ == order && visibility_revision_ == input.visibility_revision;
}

bool HighOrderTransfer::follows(const TransferInput& input, int order) const {
    return visibility_order_ == order && input.unchanged && !visibility_.empty() &&
           visibility_revision_ == input.unchanged->visibility &&
           visibility_geometry_ == input.unchanged->geometry;
}

AwaitedVisibility* HighOrderTransfer::await(const TransferInput& input, int low) {
    awaited_.reset();
    const int order = 2 * low;
    if (input.visibility == nullptr || is_current(input, order) || follows(input, order)) return nullptr;
    awaited_.emplace(AwaitedVisibility{.blocks = VisibilityBlocks(*input.visibility, order)});
    return &*awaited_;
}

void HighOrderTransfer::update(const TransferInput& input, const DistantLight& light, HighOrders form,
                               Workers& workers, Progress& progress, Statistics& statistics) {
    const Stopwatch projecting;
    const Key key{.form = form,
                  .low = light.low,
                  .high = light.high,
                  .channels = input.channels,
                  .polarized = light.polarized};
    const bool same_parts = key_ == key && fitted_ == input.material_revision;
    if (!same_parts) {
        fitted_ = 0;
        fit(input, key, workers, progress, statistics);
        fitted_ = input.material_revision;
    }
    if (!same_parts || filtered_ != light.revision) {
        if (filtered_ != light.revision) {
            light_.reset();
            for (auto& [material, part] : parts_) part.filtered = false;
        }
        filtered_ = 0;
        ++parts_revision_;
        filter(light, workers);
        filtered_ = light.revision;
    }
    statistics.project_ms += projecting.milliseconds();

    const int order = 2 * light.low;
    if (is_current(input, order)) return;
    const Stopwatch baking;
    const bool follows = this->follows(input, order);
    visibility_revision_ = 0;
    visibility_order_ = -1;
    ++visibility_count_;
    if (!follows) visibility_ = {};
    if (awaited_ && awaited_->filled) {
        visibility_ = std::move(awaited_->blocks);
    } else if (input.visibility != nullptr) {
        expand_visibility(input, order, follows, workers, progress);
    }
    awaited_.reset();
    visibility_order_ = order;
    visibility_revision_ = input.visibility_revision;
    visibility_geometry_ = input.geometry_revision;
    statistics.bake_ms += baking.milliseconds();
}

void HighOrderTransfer::fit(const TransferInput& input, const Key& key, Workers& workers, Progress& progress,
                            Statistics& statistics) {
    if (key_ != key) {
        parts_.clear();
        light_.reset();
        kernels_.clear();
        key_ = key;
    }
    std::map<MaterialPtr, Part> parts;
    std::map<MaterialPtr, std::vector<ConvolutionKernel>> kernels;
    for (const VertexRange& range : input.geometry.ranges) {
        const MaterialPtr& material = range.material;
        if (parts.contains(material)) continue;
        if (auto known = kernels_.extract(material)) kernels.insert(std::move(known));
        if (auto known = parts_.extract(material)) {
            parts.insert(std::move(known));
            continue;
        }
        progress.report(
            "project", static_cast<double>(parts.size()) / static_cast<double>(input.geometry.ranges.size()));
        ++statistics.materials_projected;
        workers.run([&] {
            if (key.form == HighOrders::convolution) {
                const int channels = material->channels() == 1 ? 1 : key.channels;
                kernels[material] = mirrored_kernels(*material, key.high, channels);
                parts.emplace(material, Part{.factors = HighOrderFactors::mirror(),
                                             .convolved = {},
                                             .filtered = false,
                                             .maps = {}});
            } else {
                parts.emplace(material, Part{.factors = load_or_fit(*material, key.low, key.high,
                                                                    key.channels, folder_, notice_),
                                             .convolved = {},
                                             .filtered = false,
                                             .maps = {}});
            }
        });
    }
    parts_ = std::move(parts);
    kernels_ = std::move(kernels);
}

void HighOrderTransfer::filter(const DistantLight& light, Workers& workers) {
    workers.run([&] {
        for (auto& [material, part] : parts_) {
            if (part.filtered) continue;
            if (key_.form == HighOrders::convolution) {
                part.convolved =
                    convolved_map(light.coefficients, kernels_.at(material), light.low, light.high);
                part.maps = {.centre = &*part.convolved};
            } else {
                if (!light_) light_.emplace(light.coefficients, light.low, light.high, light.polarized);
                part.maps = light_->maps(part.factors);
            }
            part.filtered = true;
        }
    });
}

void HighOrderTransfer::expand_visibility(const TransferInput& input, int order, bool follows,
                                          Workers& workers, Progress& progress) {
    const std::size_t vertices = input.geometry.positions.size();
    const VisibilityHarmonics harmonics(*input.directions, order);
    const VisibilityBlocks before = std::move(visibility_);
    visibility_ = VisibilityBlocks(*input.visibility, order);
    workers.for_vertices(0, vertices, vertices, "bake", progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Lanes> coefficients(psh_count(order));
        for (std::size_t first = begin; first < end; first += kLanes) {
            const std::size_t block = first / kLanes;
            if (visibility_.block(block) == nullptr) continue;
            const std::size_t size = std::min(kLanes, end - first);
            const bool known = follows &&
                               std::ranges::all_of(input.unchanged->vertices.subspan(first, size),
                                                   [](std::uint8_t one) { return one != 0; }) &&
                               before.block(block) != nullptr;
            if (known) {
                visibility_.take_over(block, before);
                continue;
            }
            project_block(harmonics, *input.visibility, input.geometry.normals, first, size,
                          coefficients.data());
            visibility_.set(block, coefficients.data());
        }
    });
}

void HighOrderTransfer::see(const TransferInput& input, const Viewpoint& view,
                            std::span<const std::uint8_t> visible, Workers& workers, Progress& progress) {
    const WorldGeometry& geometry = input.geometry;
    const std::size_t vertices = geometry.positions.size();
    fractions_.resize(visibility_.empty() ? 0 : vertices);
    if (visibility_.empty()) return;
    for (const VertexRange& range : geometry.ranges) {
        const HighOrderVisibility seen(visibility_.order(), lobe_width(range.material));
        workers.for_vertices(range.first, range.last, vertices, "shade", progress,
                             [&](std::size_t begin, std::size_t end) {
                                 seen.run(view, geometry.positions, geometry.normals, visible, visibility_,
                                          begin, end, fractions_);
                             });
    }
}

void HighOrderTransfer::shade(const TransferInput& input, const DistantLight& light, const Viewpoint& view,
                              std::span<const std::uint8_t> visible, Workers& workers, Progress& progress,
                              VertexStokes& out) {
    const WorldGeometry& geometry = input.geometry;
    const std::vector<std::span<glm::vec4>> channels(out.begin(), out.end());
    for (const VertexRange& range : geometry.ranges) {
        const Part& part = parts_.at(range.material);
        const HighOrder high(part.factors, part.maps, light.to_world);
        const HighOrderVisibility seen(visibility_.order(), lobe_width(range.material));
        const HighOrderShadows shadows{
            .fractions = {}, .visibility = visibility_.empty() ? nullptr : &seen, .seen = &visibility_};
        workers.for_vertices(range.first, range.last, geometry.positions.size(), "shade", progress,
                             [&](std::size_t begin, std::size_t end) {
                                 high.run(view, geometry.positions, geometry.normals, visible, shadows, begin,
                                          end, channels);
                             });
    }
}

void HighOrderTransfer::count(Statistics& statistics) const {
    if (light_) statistics.response_bytes += light_->bytes();
    for (const auto& [material, part] : parts_) {
        statistics.response_bytes += part.factors.data().size_bytes();
        if (part.convolved) statistics.response_bytes += part.convolved->bytes();
    }
    statistics.transfer_bytes += visibility_.bytes() + fractions_.size() * sizeof(glm::vec2);
}

}  // namespace nicol
