// SPDX-License-Identifier: MIT
#include "methods/factored_method.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace nicol {
namespace {

// Sets 0 for each vertex in a block of sixteen that has a vertex which is seen and one which is not current,
// else 1. Light is kept by blocks, and a block is only as current as all of its vertices are.
void find_fresh(std::span<const std::uint8_t> seen, std::span<const std::uint8_t> current,
                std::vector<std::uint8_t>& out) {
    out.assign(seen.size(), 1);
    for (std::size_t first = 0; first < out.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, out.size() - first);
        const auto any = [&](std::span<const std::uint8_t> flags, std::uint8_t flag) {
            return std::ranges::find(flags.subspan(first, count), flag) !=
                   flags.begin() + static_cast<std::ptrdiff_t>(first + count);
        };
        if (any(seen, 1) && any(current, 0)) std::ranges::fill(std::span(out).subspan(first, count), 0);
    }
}

}  // namespace

void FactoredMethod::set_cache(std::filesystem::path folder, CacheNotice notice) {
    bounces_.set_cache(folder, notice);
    not_smooth_.set_cache(folder, notice);
    not_followed_.set_cache(folder, notice);
    tables_.set_cache(std::move(folder), std::move(notice));
}

void FactoredMethod::project(const TransferInput& input, RenderRun& run) {
    run.statistics.materials_projected +=
        tables_.project(input, {.without = input.sampled}, input.layout, run);
    if (input.bounces == 0) return;
    bounces_.project(input, run);
    if (!input.bounces_apart) return;
    for (const bool followed : {false, true})
        (followed ? not_followed_ : not_smooth_)
            .project(input, apart_terms(input.sampled, followed), bounces_.layout(), run);
}

ResponseTables::Choice FactoredMethod::apart_terms(SampledTerms sampled, bool followed) {
    using Terms = ResponseTables::Choice::Terms;
    return {.without = sampled, .terms = followed ? Terms::not_followed : Terms::not_smooth};
}

void FactoredMethod::bake(const TransferInput& input, VisibilityRequest* request, RenderRun& run) {
    if (input.bounces > 0)
        bounces_.bake(input, run);
    else
        bounces_.clear();
    if (!baking_.update(input, input.layout.order(), input.layout.kind())) return;
    if (input.visibility == nullptr) {
        shadows_.change().reset();
        baking_.complete();
        return;
    }
    // Numbers of other vertices are computed when an image shows them.
    const std::size_t vertices = input.geometry.normals.size();
    const std::span<const std::uint8_t> needed = input.seen ? input.seen() : std::span<const std::uint8_t>();
    if (*shadows_ && baked_ == vertices && input.seen && baking_.suffices(needed)) return;
    const Stopwatch watch;
    std::optional<VisibilityProduct> former = std::exchange(shadows_.change(), std::nullopt);
    if (!former) baking_.discard();
    run.workers.run([&] {
        std::optional<VisibilityProduct>& shadows = shadows_.change();
        const bool fits = request != nullptr && request->blocks.order() == 2 * input.layout.order();
        const KeptCoefficients keep =
            fits ? KeptCoefficients{&request->blocks, request->missing} : KeptCoefficients{};
        if (former && baking_.any_current()) {
            shadows.emplace(std::move(*former), baking_.former(), *input.visibility, *input.directions,
                            input.geometry.normals, keep, needed);
            return;
        }
        former.reset();
        shadows.emplace(*input.visibility, *input.directions, input.geometry.normals, input.layout, keep,
                        needed);
    });
    baked_ = vertices;
    fresh_.resize(vertices);
    (*shadows_)->find_computed(fresh_);
    if (std::ranges::find(fresh_, 0) == fresh_.end())
        baking_.complete();
    else
        baking_.complete(fresh_);
    run.statistics.bake_ms += watch.milliseconds();
}

void FactoredMethod::relight(const TransferInput& input, RenderExecutor& executor, RenderRun& run) {
    if (input.at_pixels && !*shadows_) return;  // all points have the same light
    const Stopwatch watch;
    if (input.bounces > 0) bounces_.relight(input, run);
    KeptLight& kept = input.at_pixels ? of_pixels_ : of_vertices_;
    KeptLight& other = input.at_pixels ? of_vertices_ : of_pixels_;
    // A camera may need vertices in one picture and pixels in the next, and back. Relighting takes longer
    // than either, so both lights are kept while they are of use.
    if (run.saves_memory || other.light != input.light_version || !executor.keeps_both_lights()) {
        other.relighting.reset();
        executor.forget_light(!input.at_pixels);
    }
    kept.light = input.light_version;
    auto& relighting = kept.relighting;
    // Bounced light that stays apart is no part of the vertices' light.
    const Version bounced = input.bounces_apart ? Version{0} : bounces_.version();
    if (!relighting.update(input, executor.version(), input.light_version, input.layout.kind(), bounced))
        return;
    if (relighting.has_renumbered()) {
        if (executor.renumber(relighting.former(), input.at_pixels, run))
            relighting.renumbered();
        else
            relighting.discard();
    }
    double seeing_ms = 0;  // counts as drawing
    if (!input.seen) {
        run.statistics.vertices_relit += executor.relight(*this, input, relighting.current(), run);
        relighting.complete();
    } else {
        // Other vertices are relit when an image shows them.
        const Stopwatch seeing;
        const std::span<const std::uint8_t> seen = input.seen();
        seeing_ms = seeing.milliseconds();
        find_fresh(seen, relighting.current(), fresh_);
        const bool lit = relighting.any_current() && kept.vertices == fresh_.size();
        if (!lit || std::ranges::find(fresh_, 0) != fresh_.end()) {
            run.statistics.vertices_relit += executor.relight(*this, input, fresh_, run);
            relit_.resize(fresh_.size());
            std::ranges::transform(fresh_, relit_.begin(), [](std::uint8_t one) { return one == 0 ? 1 : 0; });
            relighting.complete(relit_);
        }
    }
    kept.vertices = input.geometry.positions.size();
    run.statistics.relight_ms += watch.milliseconds() - seeing_ms;
}

void FactoredMethod::shade(const ShadeInput& input, RenderExecutor& executor, RenderRun& run) const {
    executor.shade(*this, input, run);
}

void FactoredMethod::shade_pixels(const PixelInput& input, RenderExecutor& executor, RenderRun& run) const {
    executor.shade_pixels(*this, input, run);
}

void FactoredMethod::count(const TransferInput& input, Statistics& statistics) const {
    for (const auto& [material, table] : *tables()) {
        statistics.response_bytes += table.bytes();
        for (std::size_t p = 0; p < 4; ++p) {
            // s1 and s2 are made together or not at all.
            const bool made = p == 1 || p == 2 ? table.makes(1) || table.makes(2) : p == 0 || table.makes(p);
            if (!made) statistics.response_rows_skipped += static_cast<std::uint64_t>(input.channels);
        }
    }
    if (input.bounces > 0) bounces_.count(statistics);
    for (const bool followed : {false, true})
        for (const auto& [material, table] : apart(followed)) statistics.response_bytes += table.bytes();
    if (*shadows_) statistics.transfer_bytes += (*shadows_)->bytes();
}

}  // namespace nicol
