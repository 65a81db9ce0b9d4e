// SPDX-License-Identifier: MIT
#include "methods/high_orders.hpp"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <utility>

#include "specular/convolution_kernel.hpp"
#include "specular/high_order_cache.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {

void HighOrderTransfer::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

void HighOrderTransfer::project(const TransferInput& input, const DistantLight& light, HighOrders form,
                                RenderRun& run) {
    const Stopwatch watch;
    bool ran = fitting_.run(
        input.materials, input.sampled, form, light.low, light.high, input.channels, light.polarized, [&] {
            sizing_.run(input.sampled, form, light.low, light.high, input.channels, light.polarized, [&] {
                parts_.change().clear();
                light_.reset();
                kernels_.clear();
            });
            fit(input, light, form, run);
            fitted_ = new_version();
        });
    ran |= filtering_.run(fitted_, light.version, [&] {
        lighting_.run(light.version, [&] {
            light_.reset();
            for (auto& [material, part] : parts_.change()) part.filtered = false;
        });
        run.workers.run([&] { filter(light, form); });
    });
    if (ran) run.statistics.project_ms += watch.milliseconds();
}

void HighOrderTransfer::fit(const TransferInput& input, const DistantLight& light, HighOrders form,
                            RenderRun& run) {
    Parts& known = parts_.change();
    Parts parts;
    std::map<MaterialPtr, std::vector<ConvolutionKernel>> kernels;
    const std::vector<MaterialPtr> materials = plain_materials(input.geometry.ranges);
    for (const MaterialPtr& material : materials) {
        if (auto kept = kernels_.extract(material)) kernels.insert(std::move(kept));
        if (auto kept = known.extract(material)) {
            parts.insert(std::move(kept));
            continue;
        }
        run.progress.report("project",
                            static_cast<double>(parts.size()) / static_cast<double>(materials.size()));
        ++run.statistics.materials_projected;
        const MaterialPtr projected = in_harmonics(material, input.sampled);
        run.workers.run([&] {
            Part part{.factors = HighOrderFactors::mirror(), .convolved = {}, .maps = {}};
            if (form == HighOrders::convolution) {
                const int channels = material->channels() == 1 ? 1 : input.channels;
                kernels[material] = mirrored_kernels(*projected, light.high, channels);
            } else {
                part.factors =
                    load_or_fit(*projected, light.low, light.high, input.channels, folder_, notice_);
            }
            parts.emplace(material, std::move(part));
        });
    }
    known = std::move(parts);
    kernels_ = std::move(kernels);
}

void HighOrderTransfer::filter(const DistantLight& light, HighOrders form) {
    for (auto& [material, part] : parts_.change()) {
        if (part.filtered) continue;
        if (form == HighOrders::convolution) {
            part.convolved = convolved_map(light.coefficients, kernels_.at(material), light.low, light.high);
            part.maps = {.central = &*part.convolved};
        } else {
            if (!light_) light_.emplace(light.coefficients, light.low, light.high, light.polarized);
            part.maps = light_->maps(part.factors);
        }
        part.filtered = true;
    }
}

std::optional<VisibilityRequest> HighOrderTransfer::request(const TransferInput& input, int low) {
    const int order = 2 * low;
    if (input.visibility == nullptr || !expanding_.update(input, order) || expanding_.any_current()) {
        return std::nullopt;
    }
    return VisibilityRequest{.blocks = VisibilityBlocks(*input.visibility, order)};
}

void HighOrderTransfer::bake(const TransferInput& input, int low, std::optional<VisibilityRequest> request,
                             RenderRun& run) {
    const int order = 2 * low;
    if (!expanding_.update(input, order)) return;
    const Stopwatch watch;
    if (!expanding_.any_current()) visibility_.change() = {};
    if (request && request->filled) {
        visibility_.change() = std::move(request->blocks);
    } else if (input.visibility != nullptr) {
        request.reset();
        visibility_.change() = expanded(input, order, run);
    }
    expanding_.complete();
    run.statistics.bake_ms += watch.milliseconds();
}

VisibilityBlocks HighOrderTransfer::expanded(const TransferInput& input, int order, RenderRun& run) const {
    const std::size_t vertices = input.geometry.positions.size();
    std::optional<VisibilityHarmonics> harmonics;
    run.workers.run([&] { harmonics.emplace(*input.directions, order); });
    const std::span former = expanding_.former();
    // Former vertices of a block; none if one of them is not known.
    const auto known = [&](std::size_t first) -> std::optional<std::array<std::uint32_t, kLanes>> {
        std::array<std::uint32_t, kLanes> out{};
        for (std::size_t i = 0; i < kLanes; ++i) {
            out[i] = former[std::min(first + i, vertices - 1)];
            if (out[i] == kNoVertex || visibility_->block(out[i] / kLanes) == nullptr) return std::nullopt;
        }
        return out;
    };
    VisibilityBlocks next(*input.visibility, order);
    run.workers.for_vertices(
        0, vertices, vertices, "bake", run.progress, [&](std::size_t begin, std::size_t end) {
            const std::size_t of_block = psh_count(order);
            std::vector<Lanes> coefficients(VisibilityHarmonics::kBatch / kLanes * of_block);
            std::vector<std::uint32_t> unknown;
            const auto project = [&] {
                harmonics->project(*input.visibility, input.geometry.normals, unknown, coefficients);
                for (std::size_t k = 0; k < unknown.size(); k += kLanes)
                    next.set(unknown[k] / kLanes, &coefficients[k / kLanes * of_block]);
                unknown.clear();
            };
            for (std::size_t first = begin; first < end; first += kLanes) {
                const std::size_t block = first / kLanes;
                if (next.block(block) == nullptr) continue;
                const std::size_t size = std::min(kLanes, end - first);
                if (const auto before = known(first)) {
                    next.take_over(block, *visibility_, *before);
                    continue;
                }
                for (std::size_t v = first; v < first + size; ++v)
                    unknown.push_back(static_cast<std::uint32_t>(v));
                if (unknown.size() == VisibilityHarmonics::kBatch) project();
            }
            project();
        });
    return next;
}

double HighOrderTransfer::lobe_width(const MaterialPtr& material) const {
    std::vector<int> lobes;
    for (const MaterialPtr& plain : plain_materials(material))
        lobes.push_back(parts_->at(plain).factors.central_lobe());
    const auto middle = lobes.begin() + static_cast<std::ptrdiff_t>(lobes.size() / 2);
    std::ranges::nth_element(lobes, middle);
    return kLobeWidths[static_cast<std::size_t>(*middle)];
}

void HighOrderTransfer::count(Statistics& statistics) const {
    if (light_) statistics.response_bytes += light_->bytes();
    for (const auto& [material, part] : *parts_) {
        statistics.response_bytes += part.factors.data().size_bytes();
        if (part.convolved) statistics.response_bytes += part.convolved->bytes();
    }
    statistics.transfer_bytes += visibility_->bytes();
}

}  // namespace nicol
