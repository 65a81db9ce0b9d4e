// SPDX-License-Identifier: MIT
#include "methods/high_orders.hpp"

#include <algorithm>
#include <glm/vec2.hpp>
#include <optional>
#include <utility>

#include "material/shared_terms.hpp"
#include "methods/projected_materials.hpp"
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
    std::vector<MaterialPtr> fresh, projected;
    for (const MaterialPtr& material : materials) {
        if (auto kept = kernels_.extract(material)) kernels.insert(std::move(kept));
        if (auto kept = known.extract(material)) {
            parts.insert(std::move(kept));
            continue;
        }
        fresh.push_back(material);
        projected.push_back(in_harmonics(material, input.sampled));
    }
    KnownByTerms<KnownMoments> moments(projected);
    std::optional<SplitBasis> basis;
    if (form == HighOrders::split && !fresh.empty()) basis.emplace(light.low, light.high);
    std::vector<std::optional<HighOrderFactors>> factors(fresh.size());
    std::vector<std::vector<ConvolutionKernel>> of_fresh(fresh.size());
    project_each(projected, materials.size(), run, [&](std::size_t i) {
        if (form == HighOrders::convolution) {
            const int channels = fresh[i]->channels() == 1 ? 1 : input.channels;
            of_fresh[i] = mirrored_kernels(*projected[i], light.high, channels);
        } else {
            factors[i] = load_or_fit(*projected[i], *basis, input.channels, moments.of(*projected[i]),
                                     folder_, notice_);
        }
    });
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        Part part{.factors = HighOrderFactors::mirror(), .convolved = {}, .maps = {}};
        if (factors[i]) part.factors = *std::move(factors[i]);
        if (form == HighOrders::convolution) kernels.emplace(fresh[i], std::move(of_fresh[i]));
        parts.emplace(fresh[i], std::move(part));
    }
    run.statistics.materials_projected += fresh.size();
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

std::optional<VisibilityRequest> HighOrderTransfer::request(const TransferInput& input, int low,
                                                            RenderRun& run) {
    const int order = 2 * low;
    if (!expanding_.update(input, order) || input.visibility == nullptr) return std::nullopt;
    // Coefficients of other vertices are computed when an image shows them.
    const std::span<const std::uint8_t> needed = input.seen ? input.seen() : std::span<const std::uint8_t>();
    if (input.seen && visibility_->vertices() == needed.size() && expanding_.suffices(needed))
        return std::nullopt;
    VisibilityBlocks before = std::exchange(visibility_.change(), {});
    if (!expanding_.any_current()) before = {};
    VisibilityRequest out;
    run.workers.run([&] {
        out.blocks = VisibilityBlocks(std::move(before), expanding_.former(), *input.visibility, order,
                                      out.missing, needed);
    });
    // The coefficients are lost if the caller throws before bake().
    expanding_.discard();
    return out;
}

void HighOrderTransfer::bake(const TransferInput& input, int low, std::optional<VisibilityRequest> request,
                             RenderRun& run) {
    if (!expanding_.update(input, 2 * low)) return;
    if (input.visibility == nullptr) {
        visibility_.change() = {};
        expanding_.complete();
        return;
    }
    if (!request) return;  // all that is needed is current
    const Stopwatch watch;
    fill(*request, input, run);
    visibility_.change() = std::move(request->blocks);
    std::vector<std::uint8_t> computed(visibility_->vertices());
    visibility_->find_computed(computed);
    if (std::ranges::find(computed, 0) == computed.end())
        expanding_.complete();
    else
        expanding_.complete(computed);
    run.statistics.bake_ms += watch.milliseconds();
}

void HighOrderTransfer::fill(VisibilityRequest& request, const TransferInput& input, RenderRun& run) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t v = 0; v < request.missing.size(); ++v)
        if (request.missing[v] != 0) vertices.push_back(static_cast<std::uint32_t>(v));
    if (vertices.empty()) return;
    const int order = request.blocks.order();
    std::optional<VisibilityHarmonics> harmonics;
    run.workers.run([&] { harmonics.emplace(*input.directions, order); });
    constexpr std::size_t batch = VisibilityHarmonics::kBatch;
    const std::size_t size = psh_count(order);
    run.workers.for_vertices(
        0, vertices.size(), vertices.size(), "bake", run.progress, [&](std::size_t begin, std::size_t end) {
            std::vector<Lanes> coefficients(batch / kLanes * size);
            for (std::size_t first = begin; first < end; first += batch) {
                const auto some = std::span(vertices).subspan(first, std::min(batch, end - first));
                harmonics->project(*input.visibility, input.geometry.normals, some, coefficients);
                for (std::size_t k = 0; k < some.size(); k += kLanes)
                    request.blocks.set(some.subspan(k, std::min(kLanes, some.size() - k)),
                                       &coefficients[k / kLanes * size]);
            }
        });
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
