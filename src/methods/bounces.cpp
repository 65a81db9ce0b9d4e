// SPDX-License-Identifier: MIT
#include "methods/bounces.hpp"

#include <tbb/combinable.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "surfaces/local_lights.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {
namespace {

// Share of the light that may be left out where the number of bounces is not limited.
constexpr double kNegligible = 2e-3;

TriangleSides sides_of(const WorldGeometry& geometry) {
    TriangleSides out;
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const bool back = batch.two_sided && is_back(geometry, geometry.ranges[batch.range]);
        std::vector<std::uint32_t>& to = back ? out.backs : out.fronts;
        for (std::size_t t = batch.first; t < batch.last; ++t) to.push_back(static_cast<std::uint32_t>(t));
    }
    return out;
}

// Largest ratio of a bounce to the one before. A material that absorbs nothing has 1.
constexpr double kLargestRatio = 0.99;

// Sums over vertices and channels of the squares of s0's mean over the sphere of directions.
struct Powers {
    double all = 0;
    double bounced = 0;
    double change = 0;  // change of the bounced light
};
Powers powers_of(const VertexLight& direct, const VertexLight& before, const VertexLight& after) {
    Powers out;
    for (std::size_t b = 0; b < after.blocks(); ++b)
        for (int c = 0; c < after.channels(); ++c)
            for (std::size_t i = 0; i < kLanes; ++i) {
                const double bounced = double{after.block(b, c).front()[i]};
                const double all = double{direct.block(b, c).front()[i]} + bounced;
                const double change = bounced - double{before.block(b, c).front()[i]};
                out.all += all * all;
                out.bounced += bounced * bounced;
                out.change += change * change;
            }
    return out;
}

}  // namespace

void Bounces::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

void Bounces::clear() {
    if (light_->blocks() == 0 && links_->links().empty()) return;
    light_.change() = VertexLight();
    links_.change() = LinkedSurfaces();
    linking_.reset();
    weighting_.reset();
    relighting_.reset();
    direct_ = rows_ = VertexLight();
    stokes_ = {};
    lighting_.reset();
    if (!lit_->empty()) lit_.change().clear();
    rounds_ = 0;
    share_ = left_ = 0;
}

void Bounces::project(const TransferInput& input, RenderRun& run) {
    const int order = std::min(kBounceOrder, input.layout.order());
    const LightKind kind = input.layout.kind();
    projecting_.run(input.materials, input.channels, order, kind, [&] {
        const Stopwatch watch;
        Tables& known = tables_.change();
        sizing_.run(input.channels, order, kind, [&] {
            known.clear();
            layout_.emplace(order, kind);
        });
        Tables tables;
        for (const MaterialPtr& material : plain_materials(input.geometry.ranges)) {
            if (auto kept = known.extract(material)) {
                tables.insert(std::move(kept));
                continue;
            }
            run.progress.report("project", 0);
            run.workers.run([&] {
                tables.emplace(material, load_or_build(*in_harmonics(material, SampledTerms::none), *layout_,
                                                       input.channels, folder_, notice_));
            });
        }
        known = std::move(tables);
        run.statistics.project_ms += watch.milliseconds();
    });
    places_ = places_in(*layout_, input.layout);
}

void Bounces::bake(const TransferInput& input, RenderRun& run) {
    const Stopwatch watch;
    const bool linked = linking_.run(input.versions, [&] {
        const auto report = [&run](double fraction) { run.progress.report("bake", fraction); };
        const WorldGeometry& geometry = input.geometry;
        run.workers.run([&] {
            links_.change() = LinkedSurfaces(
                geometry, find_links({.positions = geometry.positions,
                                      .normals = geometry.normals,
                                      .triangles = geometry.triangles,
                                      .present = presence_of(geometry)},
                                     sides_of(geometry), *input.directions, *input.visibility, report));
        });
    });
    const bool weighted = weighting_.run(input.versions, input.materials, [&] {
        LinkedSurfaces& links = links_.change();
        links.find_weights(input.geometry);
    });
    if (linked || weighted) run.statistics.bake_ms += watch.milliseconds();
}

void Bounces::relight(const TransferInput& input, const VisibilityProduct& shadows, RenderRun& run) {
    const Stopwatch watch;
    light_links(input, run);
    relighting_.run(links_.version(), tables_.version(), input.light_version, lit_.version(), input.bounces,
                    [&] {
                        find_direct(input, shadows, run);
                        iterate(input, run);
                        run.statistics.bounce_ms += watch.milliseconds();
                    });
}

void Bounces::light_links(const TransferInput& input, RenderRun& run) {
    const Version lights = input.local_lights != nullptr ? input.local_lights->version() : 0;
    lighting_.run(links_.version(), lights, [&] {
        if (input.local_lights == nullptr) {
            if (!lit_->empty()) lit_.change().clear();
            return;
        }
        LinkStokes& lit = lit_.change();
        lit.assign(static_cast<std::size_t>(input.channels),
                   std::vector<glm::vec4>(links_->links().size(), glm::vec4(0)));
        const std::span batches = links_->batches();
        tbb::combinable<std::uint64_t> rays;
        run.workers.for_blocks(
            batches.size(), "relight", run.progress, [&](std::size_t first, std::size_t last) {
                for (const LinkedSurfaces::Batch& batch : batches.subspan(first, last - first))
                    rays.local() += reflect_lights(input.geometry, *input.directions, *links_, batch,
                                                   input.local_lights->lighting(), lit)
                                        .rays;
            });
        run.statistics.light_rays += rays.combine(std::plus<>());
    });
}

void Bounces::find_direct(const TransferInput& input, const VisibilityProduct& shadows, RenderRun& run) {
    const std::size_t vertices = input.geometry.positions.size();
    const Relight rotation(input.layout, input.light);
    VertexLight whole(input.layout, input.channels, vertices);
    direct_.resize(*layout_, input.channels, vertices);
    run.workers.for_blocks(direct_.blocks(), "relight", run.progress,
                           [&](std::size_t first, std::size_t last) {
                               rotation.run(input.geometry.normals, first, last, whole);
                               shadows.run(whole, first, last);
                               for (std::size_t b = first; b < last; ++b)
                                   for (int c = 0; c < input.channels; ++c)
                                       for (std::size_t j = 0; j < places_.size(); ++j)
                                           direct_.block(b, c)[j] = whole.block(b, c)[places_[j]];
                           });
}

void Bounces::sum_rows(const FrameRotation& rotation, std::span<const glm::vec3> normals, std::size_t block) {
    for (int c = 0; c < rows_.channels(); ++c) {
        const std::span<Lanes> sum = rows_.block(block, c);
        const std::span<const Lanes> direct = direct_.block(block, c), bounced = light_->block(block, c);
        for (std::size_t j = 0; j < sum.size(); ++j)
            for (std::size_t i = 0; i < kLanes; ++i) sum[j][i] = direct[j][i] + bounced[j][i];
    }
    const std::size_t v = block * kLanes;
    rotation.into_world(normals.subspan(v, std::min(kLanes, normals.size() - v)), rows_, block);
    rows_.to_rows(block);
}

void Bounces::iterate(const TransferInput& input, RenderRun& run) {
    const std::span normals(input.geometry.normals);
    const Bounce bounce(input.geometry, *input.directions, *links_, *tables_, *layout_);
    const FrameRotation rotation(*layout_);
    VertexLight& light = light_.change();
    VertexLight next(*layout_, input.channels, normals.size());
    light = VertexLight(*layout_, input.channels, normals.size());
    rows_.resize(*layout_, input.channels, normals.size());
    stokes_.resize(static_cast<std::size_t>(input.channels));
    for (std::vector<glm::vec4>& channel : stokes_) channel.resize(links_->links().size());
    const std::span batches = links_->batches();
    const auto for_each = [&](std::size_t count, const auto& body) {
        run.workers.for_blocks(count, "relight", run.progress, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) body(k);
        });
    };

    double before = 0;
    left_ = 1;
    for (rounds_ = 0; rounds_ < input.bounces && left_ > kNegligible; ++rounds_) {
        for_each(rows_.blocks(), [&](std::size_t b) { sum_rows(rotation, normals, b); });
        for_each(batches.size(), [&](std::size_t k) { bounce.leave(batches[k], rows_, *lit_, stokes_); });
        for_each(next.blocks(), [&](std::size_t b) { bounce.arrive(b, stokes_, next); });
        const Powers powers = powers_of(direct_, light, next);
        std::swap(light, next);
        if (!(powers.all > 0)) {
            share_ = left_ = 0;
            continue;
        }
        share_ = std::sqrt(powers.bounced / powers.all);
        // In the end, the bounces to come are a geometric series.
        const double change = std::sqrt(powers.change / powers.all);
        const double ratio = rounds_ == 0 ? kLargestRatio : std::min(change / before, kLargestRatio);
        left_ = change * ratio / (1 - ratio);
        before = change;
    }
}

void Bounces::add_to(VertexLight& light, std::size_t first, std::size_t last) const {
    for (std::size_t b = first; b < last; ++b)
        for (int c = 0; c < light.channels(); ++c) {
            const std::span<const Lanes> from = light_->block(b, c);
            const std::span<Lanes> to = light.block(b, c);
            for (std::size_t j = 0; j < from.size(); ++j)
                for (std::size_t i = 0; i < kLanes; ++i) to[places_[j]][i] += from[j][i];
        }
}

void Bounces::count(Statistics& statistics) const {
    statistics.bounce_links = links_->links().size();
    statistics.bounce_rounds = static_cast<std::uint64_t>(rounds_);
    statistics.bounced_light = share_;
    statistics.bounced_left = left_;
    for (const auto& [material, table] : *tables_) statistics.response_bytes += table.bytes();
    statistics.transfer_bytes += links_->bytes() + direct_.bytes() + rows_.bytes() + light_->bytes();
    for (const LinkStokes* const kept : {&stokes_, &*lit_})
        for (const std::vector<glm::vec4>& channel : *kept)
            statistics.transfer_bytes += channel.size() * sizeof(glm::vec4);
}

}  // namespace nicol
