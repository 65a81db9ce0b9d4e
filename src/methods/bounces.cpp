// SPDX-License-Identifier: MIT
#include "methods/bounces.hpp"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <utility>

#include "harmonics/layout_gradient.hpp"
#include "methods/lobe_photons.hpp"
#include "shading/channel_spans.hpp"
#include "shading/light_samples.hpp"
#include "simd/lane_transpose.hpp"
#include "surfaces/local_lights.hpp"
#include "visibility/bake_origins.hpp"

namespace nicol {
namespace {

// Samples of wide lights. The light serves a prediction alone, which is a mean over receivers.
constexpr std::uint32_t kPredictionSamples = 4;

/// Returns, for each receiver and channel, [receiver][channel], the first number of even light that
/// irradiates the receiver as much as the local lights do. input.local_lights must not be null.
std::vector<float> local_light_at_receivers(const TransferInput& input, const LinkedSurfaces& surfaces,
                                            RenderRun& run) {
    const WorldGeometry& geometry = input.geometry;
    const auto all_channels = static_cast<std::size_t>(input.channels);
    std::vector<float> out(surfaces.receivers() * all_channels);
    std::vector<glm::vec3> unit_normals;
    unit_normals.reserve(geometry.normals.size());
    for (const glm::vec3& normal : geometry.normals) unit_normals.push_back(glm::normalize(normal));
    // A vertex at the border of an emissive surface lies in its plane, from which it gets no light.
    const std::vector<glm::vec3> origins = bake_origins(
        {.positions = geometry.positions, .normals = geometry.normals, .triangles = geometry.triangles},
        unit_normals);
    // Such a surface reflects even light as it is, whose first number is the square root of 4 pi.
    const MaterialPtr white = diffuse({1});
    const std::array<const Material*, 1> layers{white.get()};
    const auto first_number = static_cast<float>(std::sqrt(4 * std::numbers::pi));
    run.workers.for_blocks(
        surfaces.blocks(), "relight", run.progress, [&](std::size_t first, std::size_t last) {
            std::array<glm::vec3, kLanes> positions, normals;
            std::array<std::uint32_t, kLanes> seeds;
            std::array<Viewpoint, kLanes> views;
            std::vector<glm::vec4> sums;
            for (std::size_t block = first; block < last; ++block) {
                const std::size_t begin = block * kLanes;
                const std::size_t count = std::min(kLanes, surfaces.receivers() - begin);
                for (std::size_t i = 0; i < count; ++i) {
                    const std::uint32_t v = surfaces.vertices()[begin + i];
                    positions[i] = origins[v];
                    normals[i] = unit_normals[v];
                    seeds[i] = sample_seed(static_cast<std::uint32_t>(begin + i), 0);
                    views[i] = link_frames();
                    views[i].orthographic = true;
                    views[i].forward = glm::dvec3(-unit_normals[v]);
                }
                sums.clear();
                const std::vector<std::span<glm::vec4>> channels = channel_spans(sums, all_channels, count);
                input.local_lights->lighting().add_lights(Views(std::span(views).first(count)),
                                                          {.positions = std::span(positions).first(count),
                                                           .normals = std::span(normals).first(count),
                                                           .tangents = {},
                                                           .origins = std::span(positions).first(count),
                                                           .seeds = std::span(seeds).first(count),
                                                           .shadowed = true},
                                                          {.layers = layers, .weights = {}},
                                                          kPredictionSamples, channels);
                for (std::size_t c = 0; c < all_channels; ++c)
                    for (std::size_t i = 0; i < count; ++i)
                        out[(begin + i) * all_channels + c] = first_number * channels[c][i].x;
            }
        });
    return out;
}

// Vertices for one receiver, of which there are more only in small scenes, see find_receivers().
constexpr std::uint64_t kVerticesOfReceiver = 4;

// Returns the components that a light has, which may be fewer than those of its layout; none: it is dark.
std::optional<LightKind> kind_of(const PshVector& light) {
    std::array<double, 4> largest{};
    for (std::size_t i = 0; i < light.data().size(); ++i)
        largest[i % 4] = std::max(largest[i % 4], std::abs(light.data()[i]));
    // A rotation leaves rounding errors in components that are zero.
    const double threshold = 1e-9 * largest[0];
    if (largest[3] > threshold) return LightKind::full;
    if (std::max(largest[1], largest[2]) > threshold) return LightKind::linear;
    if (largest[0] > 0) return LightKind::unpolarized;
    return std::nullopt;
}

Receivers receivers_of(const TransferInput& input, RenderRun& run) {
    const WorldGeometry& geometry = input.geometry;
    const BakeGeometry baked = link_geometry(geometry);
    const TriangleSides sides = sides_of(geometry);
    const LinkSearch search(baked, sides, *input.directions, *input.visibility);
    return find_receivers(baked, search, *input.visibility,
                          [&run](double fraction) { run.progress.report("bake", fraction); });
}

}  // namespace

void Bounces::set_cache(std::filesystem::path folder, CacheNotice notice) {
    tables_.set_cache(std::move(folder), std::move(notice));
}

void Bounces::clear() {
    if (light_->blocks() == 0 && links_->receivers() == 0) return;
    light_.change() = VertexLight();
    links_.change() = LinkedSurfaces();
    columns_.change() = BounceColumns();
    lit_.change().clear();
    linking_.reset();
    weighting_.reset();
    solving_.reset();
    lighting_.reset();
    relighting_.reset();
    covering_.reset();
    coverage_ = at_receivers_ = local_ = {};
    rows_ = VertexLight();
    share_ = left_ = 0;
}

void Bounces::project(const TransferInput& input, RenderRun& run) {
    layout_.emplace(input.bounce_order, input.bounced);
    tables_.project(input, {}, *layout_, run);
    places_ = input.bounces_apart ? std::vector<std::size_t>() : places_in(*layout_, input.layout);
}

void Bounces::bake(const TransferInput& input, RenderRun& run) {
    const Stopwatch watch;
    bool changed = linking_.run(input.versions, [&] {
        run.workers.run([&] { links_.change() = LinkedSurfaces(input.geometry, receivers_of(input, run)); });
    });
    changed |= weighting_.run(input.versions, input.materials,
                              [&] { links_.change().find_weights(input.geometry); });
    const bool covers =
        input.at_pixels && std::ranges::any_of(input.geometry.ranges, [&](const VertexRange& range) {
            return any_sampled(*range.material, input.sampled);
        });
    makes_rows_ = input.bounces_apart || covers;
    if (covers)
        changed |= covering_.run(links_.version(), layout_->order(), layout_->kind(), [&] {
            coverage_ = coverage_at_receivers({input, *links_, *tables_.tables(), *layout_}, run);
        });
    if (covers_ != covers) {
        covers_ = covers;
        relighting_.reset();
    }
    std::optional<LightKind> kind = kind_of(input.light);
    // Light with all numbers may lack components that gradients are wanted by.
    if (kind && input.layout.kind() == LightKind::full) kind = LightKind::full;
    changed |= solving_.run(
        links_.version(), tables_.tables().version(), kind, input.channels, input.bounces,
        input.negligible_bounces, [&] {
            columns_.change() = BounceColumns({input, *links_, *tables_.tables(), *layout_}, kind, run);
        });
    if (changed) run.statistics.bake_ms += watch.milliseconds();
}

void Bounces::relight(const TransferInput& input, RenderRun& run) {
    const Stopwatch watch;
    light_links(input, run);
    const bool changed = relighting_.run(columns_.version(), input.light_version, lit_.version(),
                                         input.at_pixels, makes_rows_, input.bounces_apart, [&] {
                                             combine(input, run);
                                             interpolate(input, run);
                                         });
    if (changed) run.statistics.bounce_ms += watch.milliseconds();
}

void Bounces::light_links(const TransferInput& input, RenderRun& run) {
    const bool any = input.local_lights != nullptr && input.local_lights->lighting().any_source();
    lighting_.run(columns_.version(), any ? input.local_lights->version() : 0, [&] {
        LitSeries& lit = lit_.change();
        lit.clear();
        local_.clear();
        if (!any || links_->receivers() == 0) return;
        LinkStokes stokes(static_cast<std::size_t>(input.channels),
                          std::vector<glm::vec4>(links_->links().size(), glm::vec4(0)));
        tbb::combinable<std::uint64_t> rays;
        run.workers.for_blocks(
            links_->blocks(), "relight", run.progress, [&](std::size_t first, std::size_t last) {
                for (std::size_t block = first; block < last; ++block)
                    for (const LinkedSurfaces::Batch& batch : links_->batches(block))
                        rays.local() += reflect_lights(input.geometry, *input.directions, *links_, batch,
                                                       input.local_lights->lighting(), stokes)
                                            .rays;
            });
        run.statistics.light_rays += rays.combine(std::plus<>());
        local_ = local_light_at_receivers(input, *links_, run);
        const LobePhotons photons(input, *links_, run);
        lit = columns_->sum({input, *links_, *tables_.tables(), *layout_}, {stokes, photons}, run);
    });
}

void Bounces::combine(const TransferInput& input, RenderRun& run) {
    const std::size_t numbers = layout_->size();
    const auto channels = static_cast<std::size_t>(input.channels);
    const std::vector<float> light = columns_->numbers_of(input.light, input.channels);
    const std::size_t lights = light.size() / channels;
    // Coverage by surfaces is one channel more, which is 0 if nothing asks for it.
    const std::size_t size = (channels + (makes_rows_ ? 1 : 0)) * numbers;
    at_receivers_.assign(links_->receivers() * size, 0.0F);
    std::vector<glm::dvec2> powers(links_->receivers());  // of bounced and of all light
    const auto combine_at = [&](std::size_t r) {
        const std::span row = std::span(at_receivers_).subspan(r * size, channels * numbers);
        if (covers_) std::copy_n(coverage_.data() + r * numbers, numbers, row.data() + channels * numbers);
        columns_->add(r, light, row);
        for (std::size_t g = 0; g < lit_->size(); ++g)
            for (std::size_t k = 0; k < columns_->groups()[g].size(); ++k)
                for (std::size_t j = 0; j < numbers; ++j)
                    row[columns_->groups()[g][k] * numbers + j] += (*lit_)[g].light.value(r, j, k);
        for (std::size_t c = 0; c < channels; ++c) {
            const auto own = double{row[c * numbers]};
            const double local = local_.empty() ? 0.0 : double{local_[r * channels + c]};
            const double both = own + local + columns_->direct(r, light.data() + c * lights);
            powers[r] += glm::dvec2(own * own, both * both);
        }
    };
    run.workers.for_vertices(0, powers.size(), powers.size(), "relight", run.progress,
                             [&](std::size_t begin, std::size_t end) {
                                 for (std::size_t r = begin; r < end; ++r) combine_at(r);
                             });
    double all = 0, bounced = 0, left = columns_->left(light);
    for (const glm::dvec2& power : powers) {
        bounced += power.x;
        all += power.y;
    }
    for (const BounceSeries& series : *lit_)
        for (const double error : series.left) left += error;
    share_ = all > 0 ? std::sqrt(bounced / all) : 0;
    left_ = all > 0 ? std::sqrt(left / all) : 0;
}

void Bounces::interpolate(const TransferInput& input, RenderRun& run) {
    const std::span normals(input.geometry.normals);
    const FrameRotation rotation(*layout_);
    VertexLight& light = light_.change();
    light.resize(*layout_, input.channels, input.bounces_apart ? 0 : normals.size());
    rows_.resize(*layout_, input.channels + 1, makes_rows_ ? normals.size() : 0);
    const std::size_t size = makes_rows_ ? rows_.row_size() : light.row_size();
    const std::size_t blocks = std::max(light.blocks(), rows_.blocks());
    run.workers.for_blocks(blocks, "relight", run.progress, [&](std::size_t begin, std::size_t end) {
        std::vector<float> sums(kLanes * size);
        for (std::size_t block = begin; block < end; ++block) {
            const std::size_t first = block * kLanes, count = std::min(kLanes, normals.size() - first);
            std::ranges::fill(sums, 0.0F);
            std::array<const float*, kLanes> rows;
            for (std::size_t i = 0; i < kLanes; ++i) {
                float* const row = sums.data() + i * size;
                rows[i] = row;
                if (i >= count) continue;
                const Receivers::Blend& blend = links_->blends()[first + i];
                for (std::size_t k = 0; k < blend.weights.size(); ++k) {
                    if (blend.weights[k] == 0) continue;
                    const float* const from = at_receivers_.data() + blend.receivers[k] * size;
                    for (std::size_t j = 0; j < size; ++j) row[j] += blend.weights[k] * from[j];
                }
            }
            if (makes_rows_) {
                to_lanes(rows, size, rows_.block(block, 0).data());
                rows_.to_rows(block);
            }
            if (input.bounces_apart) continue;
            to_lanes(rows, light.row_size(), light.block(block, 0).data());
            if (!input.at_pixels) rotation.into_frames(normals.subspan(first, count), light, block);
        }
    });
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

PshVector Bounces::gradient(const std::function<const float*(std::size_t)>& row, const LightLayout& light,
                            int channels) const {
    PshVector out(light.order(), channels);
    if (!columns_->light()) return out;
    const std::size_t numbers = layout_->size(), planes = static_cast<std::size_t>(channels);
    const std::size_t size = planes * numbers;
    std::vector<float> receivers(links_->receivers() * size);
    for (std::size_t v = 0; v < links_->blends().size(); ++v) {
        const float* const from = row(v);
        const Receivers::Blend& blend = links_->blends()[v];
        for (std::size_t k = 0; k < blend.weights.size(); ++k) {
            if (from == nullptr || blend.weights[k] == 0) continue;
            float* to = receivers.data() + blend.receivers[k] * size;
            for (std::size_t c = 0; c < planes; ++c)
                for (std::size_t j = 0; j < numbers; ++j)
                    *to++ += blend.weights[k] * from[c * light.size() + places_[j]];
        }
    }
    std::vector<double> of_light(planes * columns_->light()->size());
    for (std::size_t r = 0; r < links_->receivers(); ++r)
        columns_->add_gradient(r, std::span(receivers).subspan(r * size, size), of_light);
    return with_order(gradient_by_coefficients(of_light, *columns_->light(), channels), light.order());
}

std::uint64_t Bounces::bytes_of_vertex(std::optional<LightKind> light, LightKind bounced, int channels) {
    const auto planes = static_cast<std::uint64_t>(channels);
    const std::uint64_t numbers = LightLayout(highest_bounce_order(light.has_value()), bounced).size();
    const std::uint64_t lights = light ? LightLayout(kBouncingOrder, *light).size() : 0;
    const std::uint64_t light_of_one = planes * numbers * sizeof(float);
    const std::uint64_t coverage = numbers * sizeof(float);
    // Links to all parts of the strata above the surface, the map for materials that differ in all channels,
    // the light of local lights and all light, both with coverage.
    const std::uint64_t receiver =
        kLinkStrata / 2 * kPartsOfStratum * (sizeof(SurfaceLink) + sizeof(std::uint32_t)) +
        (planes * numbers + 1) * lights * sizeof(float) + 2 * (light_of_one + coverage);
    // The light, and the rows for sampled terms.
    return receiver / kVerticesOfReceiver + 2 * light_of_one + coverage + sizeof(Receivers::Blend);
}

void Bounces::count(Statistics& statistics) const {
    int rounds = columns_->rounds();
    for (const BounceSeries& series : *lit_) rounds = std::max(rounds, series.rounds);
    statistics.bounce_links = links_->links().size();
    statistics.bounce_rounds = static_cast<std::uint64_t>(rounds);
    statistics.bounced_light = share_;
    statistics.bounced_left = left_;
    for (const auto& [material, table] : *tables_.tables()) statistics.response_bytes += table.bytes();
    statistics.transfer_bytes += links_->bytes() + columns_->bytes() + light_->bytes() + rows_.bytes() +
                                 (coverage_.size() + at_receivers_.size() + local_.size()) * sizeof(float);
    for (const BounceSeries& series : *lit_) statistics.transfer_bytes += series.light.bytes();
}

}  // namespace nicol
