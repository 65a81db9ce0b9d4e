// SPDX-License-Identifier: MIT
#include "methods/bounce_columns.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "surfaces/plain_materials.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {
namespace {

// Numbers of the distant light whose columns are found together take at most so many bytes at the vertices.
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

ChannelGroups groups_of(const BounceInput& input) {
    const auto channels = static_cast<std::size_t>(input.scene.channels);
    const bool equal = input.surfaces.grey() && std::ranges::all_of(input.tables, [](const auto& table) {
                           return table.second.channels() == 1;
                       });
    ChannelGroups out(equal ? 1 : channels);
    for (std::size_t c = 0; c < channels; ++c) out[equal ? 0 : c].push_back(c);
    return out;
}

// Returns lights with one number of the layout each, from `first` on.
PshVector unit_lights(const LightLayout& layout, std::size_t first, std::size_t count) {
    PshVector out(layout.order(), static_cast<int>(count));
    for (std::size_t k = 0; k < count; ++k)
        for (const LightLayout::Term& term : layout.terms()[first + k])
            out.channel(static_cast<int>(k))[term.coefficient] += term.factor;
    return out;
}

/// Passes of one scene: what all channels and columns share.
class Passes {
public:
    /// verb: name of the step in reports of progress.
    Passes(const BounceInput& input, const char* verb)
        : input_(input),
          verb_(verb),
          arrival_(input.layout, input.scene.directions->directions(), link_frames()),
          components_(static_cast<std::size_t>(input.layout.kind())),
          scalar_(input.layout, LightKind::unpolarized, 1),
          all_(input.layout, input.layout.kind(), components_) {}

    [[nodiscard]] std::size_t components() const noexcept { return components_; }
    [[nodiscard]] BounceRows rows() const noexcept { return {.scalar = scalar_, .all = all_}; }

    /// start(bounce, block, out): sets the light of the first bounce at a block of receivers. end(bounce,
    /// block, sum, out): see LastBounce.
    template <class Start, class End>
    [[nodiscard]] BounceSeries run(std::size_t channel, std::size_t columns, double all, const Start& start,
                                   const End& end, RenderRun& run) const {
        const Bounce bounce(input_.scene.geometry, *input_.scene.directions, input_.surfaces, input_.tables,
                            arrival_, input_.layout, channel);
        return sum_bounces(
            bounce, input_.surfaces, scalar_,
            [&](std::size_t block, LightColumns& out) { start(bounce, block, out); },
            [&](std::size_t block, const LightColumns* sum, LightColumns& out) {
                end(bounce, block, sum, out);
            },
            {.numbers = input_.layout.size(), .columns = columns},
            {.verb = verb_,
             .bounces = input_.scene.bounces,
             .negligible = input_.scene.negligible_bounces,
             .all = all},
            run);
    }

private:
    const BounceInput& input_;
    const char* verb_;
    ArrivingLight arrival_;
    std::size_t components_;
    ReflectionRows scalar_;
    ReflectionRows all_;
};

/// Direct light at the vertices, in the world's axes.
class DirectLight {
public:
    DirectLight(const BounceInput& input, const LightLayout& light)
        : normals_(input.scene.geometry.normals),
          light_(light),
          low_(input.layout.order(), light.kind()),
          places_(places_in(low_, light)),
          back_(low_),
          shadows_(*input.scene.visibility, *input.scene.directions, normals_, light) {}

    [[nodiscard]] LightColumns columns(std::size_t first, std::size_t count, RenderRun& run) const {
        LightColumns out(normals_.size(), low_.size(), count);
        const Relight rotation(light_, unit_lights(light_, first, count));
        run.workers.for_blocks((normals_.size() + kLanes - 1) / kLanes, "bake", run.progress,
                               [&](std::size_t begin, std::size_t end) {
                                   VertexLight whole(light_, static_cast<int>(count), kLanes);
                                   VertexLight low(low_, static_cast<int>(count), kLanes);
                                   for (std::size_t b = begin; b < end; ++b) {
                                       const std::size_t v = b * kLanes;
                                       const std::span normals =
                                           normals_.subspan(v, std::min(kLanes, normals_.size() - v));
                                       rotation.run(normals, 0, 1, whole);
                                       shadows_.run(whole, b, b + 1, b);
                                       for (int c = 0; c < static_cast<int>(count); ++c)
                                           for (std::size_t j = 0; j < places_.size(); ++j)
                                               low.block(0, c)[j] = whole.block(0, c)[places_[j]];
                                       back_.into_world(normals, low, 0);
                                       put_columns(low, 0, v, out);
                                   }
                               });
        return out;
    }

private:
    std::span<const glm::vec3> normals_;
    const LightLayout& light_;
    LightLayout low_;
    std::vector<std::size_t> places_;
    FrameRotation back_;
    VisibilityProduct shadows_;
};

}  // namespace

std::vector<float> coverage_at_receivers(const BounceInput& input, RenderRun& run) {
    const LinkedSurfaces& surfaces = input.surfaces;
    const std::size_t numbers = input.layout.size();
    const ArrivingLight arrival(input.layout, input.scene.directions->directions(), link_frames());
    const Bounce bounce(input.scene.geometry, *input.scene.directions, surfaces, input.tables, arrival,
                        input.layout, 0);
    const LinkStokes ones(1, std::vector<glm::vec4>(surfaces.links().size(), glm::vec4(1, 0, 0, 0)));
    const LobePhotons none;
    constexpr std::array<std::size_t, 1> channel{0};
    const ReflectionRows scalar(input.layout, LightKind::unpolarized, 1);
    LightColumns columns(surfaces.receivers(), numbers, 1);
    run.workers.for_blocks(surfaces.blocks(), "bake", run.progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            bounce.gather(b, {ones, none}, channel, {.scalar = scalar, .all = scalar}, nullptr, columns);
    });
    std::vector<float> out(surfaces.receivers() * numbers);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = columns.value(i / numbers, i % numbers, 0);
    return out;
}

BounceColumns::BounceColumns(const BounceInput& input, std::optional<LightKind> light, RenderRun& run)
    : numbers_(input.layout.size()), groups_(groups_of(input)) {
    maps_.resize(groups_.size());
    left_.resize(groups_.size());
    if (!light) return;
    light_.emplace(std::min(kBouncingOrder, input.scene.layout.order()), *light);
    const std::size_t receivers = input.surfaces.receivers(), lights = this->lights();
    maps_.assign(groups_.size(), std::vector<float>(receivers * lights * numbers_));
    left_.assign(groups_.size(), std::vector<double>(lights));
    direct_.resize(receivers * lights);
    if (receivers == 0) return;
    std::optional<DirectLight> vertices;
    run.workers.run([&] { vertices.emplace(input, *light_); });
    const Passes passes(input, "bake");
    const ReflectionRows first_rows(input.layout, *light, passes.components());
    const std::size_t column_bytes =
        input.scene.geometry.positions.size() * first_rows.light().size() * sizeof(float);
    const std::size_t together = kMostBytes / column_bytes >= 2 * kLanes ? 2 * kLanes : kLanes;
    double all = 0;  // of the first number, which is that of even light
    for (std::size_t first = 0; first < lights; first += together) {
        const std::size_t count = std::min(together, lights - first);
        const LightColumns direct = vertices->columns(first, count, run);
        for (std::size_t r = 0; r < receivers; ++r)
            for (std::size_t k = 0; k < count; ++k) {
                const float mean = direct.value(input.surfaces.vertices()[r], 0, k);
                direct_[r * lights + first + k] = mean;
                if (first + k == 0) all += double{mean} * double{mean};
            }
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const BounceSeries series = passes.run(
                groups_[g].front(), count, all,
                [&](const Bounce& bounce, std::size_t block, LightColumns& out) {
                    bounce.reflect_vertices(block, first_rows, direct, out);
                },
                [&](const Bounce& bounce, std::size_t block, const LightColumns* sum, LightColumns& out) {
                    bounce.reflect_all(block, passes.rows(), direct, sum, out);
                },
                run);
            rounds_ = std::max(rounds_, series.rounds);
            std::ranges::copy(series.left, left_[g].begin() + static_cast<std::ptrdiff_t>(first));
            run.workers.for_vertices(0, receivers, receivers, "bake", run.progress,
                                     [&](std::size_t begin, std::size_t end) {
                                         for (std::size_t r = begin; r < end; ++r)
                                             for (std::size_t k = 0; k < count; ++k)
                                                 for (std::size_t j = 0; j < numbers_; ++j)
                                                     maps_[g][(r * lights + first + k) * numbers_ + j] =
                                                         series.light.value(r, j, k);
                                     });
        }
    }
}

std::vector<float> BounceColumns::numbers_of(const PshVector& light, int channels) const {
    std::vector<float> out;
    if (!light_) return out;
    for (int c = 0; c < channels; ++c) {
        const std::span<const double> from = light.channel(light.channels() == 1 ? 0 : c);
        for (const auto& [first, second] : light_->terms())
            out.push_back(static_cast<float>(first.factor * from[first.coefficient] +
                                             second.factor * from[second.coefficient]));
    }
    return out;
}

void BounceColumns::add(std::size_t receiver, std::span<const float> light, std::span<float> out) const {
    const std::size_t lights = this->lights();
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (const std::size_t c : groups_[g]) {
            const float* map = maps_[g].data() + receiver * lights * numbers_;
            float* const to = out.data() + c * numbers_;
            for (std::size_t k = 0; k < lights; ++k, map += numbers_) {
                const float factor = light[c * lights + k];
                for (std::size_t j = 0; j < numbers_; ++j) to[j] += factor * map[j];
            }
        }
}

void BounceColumns::add_gradient(std::size_t receiver, std::span<const float> bounced,
                                 std::span<double> light) const {
    const std::size_t lights = this->lights();
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (const std::size_t c : groups_[g]) {
            const float* map = maps_[g].data() + receiver * lights * numbers_;
            const float* const from = bounced.data() + c * numbers_;
            for (std::size_t k = 0; k < lights; ++k, map += numbers_)
                light[c * lights + k] += double{std::inner_product(from, from + numbers_, map, 0.0F)};
        }
}

double BounceColumns::direct(std::size_t receiver, const float* light) const {
    const std::size_t lights = this->lights();
    return std::inner_product(light, light + lights, direct_.data() + receiver * lights, 0.0);
}

double BounceColumns::left(std::span<const float> light) const {
    const std::size_t lights = this->lights();
    double sum = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (const std::size_t c : groups_[g])
            for (std::size_t k = 0; k < lights; ++k) {
                const auto factor = double{light[c * lights + k]};
                sum += factor * factor * left_[g][k];
            }
    return sum;
}

LitSeries BounceColumns::sum(const BounceInput& input, const ArrivingLamps& lit, RenderRun& run) const {
    const Passes passes(input, "relight");
    LitSeries out;
    for (const std::vector<std::size_t>& channels : groups_)
        out.push_back(passes.run(
            channels.front(), channels.size(), 0,
            [&](const Bounce& bounce, std::size_t block, LightColumns& first) {
                bounce.gather(block, lit, channels, passes.rows(), nullptr, first);
            },
            [&](const Bounce& bounce, std::size_t block, const LightColumns* sum, LightColumns& out) {
                bounce.gather(block, lit, channels, passes.rows(), sum, out);
            },
            run));
    return out;
}

std::size_t BounceColumns::bytes() const noexcept {
    std::size_t bytes = direct_.size() * sizeof(float);
    for (const std::vector<float>& map : maps_) bytes += map.size() * sizeof(float);
    return bytes;
}

}  // namespace nicol
