// SPDX-License-Identifier: MIT
#include "methods/bounce_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "material/spatial_variation.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {
namespace {

// Adds share x row x light to Stokes components, [component][Lanes of columns].
[[gnu::always_inline]] inline void add_product(const float* row, std::size_t components, std::size_t numbers,
                                               float share, const Lanes* light, std::size_t lanes,
                                               Lanes* stokes) {
    for (std::size_t k = 0; k < lanes; ++k)
        for (std::size_t p = 0; p < components; ++p) {
            LaneVector sum{};
            for (std::size_t j = 0; j < numbers; ++j) {
                LaneVector number;
                load(light + j * lanes + k, number);
                sum += row[p * numbers + j] * number;
            }
            LaneVector before;
            load(stokes + p * lanes + k, before);
            before += share * sum;
            store(stokes + p * lanes + k, before);
        }
}

}  // namespace

Bounce::Bounce(const WorldGeometry& geometry, const DirectionSet& directions, const LinkedSurfaces& surfaces,
               const BounceTables& tables, const ArrivingLight& arrival, const LightLayout& layout,
               std::size_t channel)
    : geometry_(geometry),
      directions_(directions),
      surfaces_(surfaces),
      tables_(tables),
      arrival_(arrival),
      layout_(layout),
      scalar_layout_(layout.order(), LightKind::unpolarized),
      rotation_(layout),
      scalar_rotation_(scalar_layout_),
      channel_(channel) {}

template <class Leave>
void Bounce::arrive(std::size_t block, std::size_t components, LightColumns& out, const Leave& leave) const {
    const std::size_t lanes = out.lanes(), numbers = out.numbers(), first = block * kLanes;
    const std::size_t count = std::min(kLanes, surfaces_.receivers() - first);
    const std::size_t size = components * lanes;
    std::array<glm::vec3, kLanes> normals;
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] = geometry_.normals[surfaces_.vertices()[first + i]];
        std::fill_n(out.at(first + i), numbers * lanes, Lanes{});
    }
    const std::span<Lanes> stokes = work_space<Bounce, Lanes>(kLanes * size);
    for (const LinkedSurfaces::Batch& batch : surfaces_.batches(block)) {
        std::ranges::fill(stokes, Lanes{});
        leave(batch, stokes.data());
        for (std::size_t i = 0; i < batch.count; ++i) {
            const SurfaceLink& link = surfaces_.links()[batch.first + i];
            arrival_.add(link.direction, link.solid_angle, components, lanes, &stokes[i * size],
                         out.at(link.receiver));
        }
    }
    const bool scalar = numbers == scalar_layout_.size();
    const LightLayout& layout = scalar ? scalar_layout_ : layout_;
    const FrameRotation& rotation = scalar ? scalar_rotation_ : rotation_;
    thread_local VertexLight light;
    light.resize(layout, static_cast<int>(out.columns()), kLanes);
    get_columns(out, first, light, 0);
    const std::span normals_of = std::span(normals).first(count);
    rotation.into_frames(normals_of, light, 0);
    add_mirror_image(layout, light, 0);
    rotation.into_world(normals_of, light, 0);
    put_columns(light, 0, first, out);
}

void Bounce::find_rows(const LinkedSurfaces::Batch& batch, const ReflectionRows& rows,
                       VertexLight& out) const {
    std::array<glm::vec3, kLanes> sights, normals;
    for (std::size_t i = 0; i < batch.count; ++i) {
        const SurfaceLink& link = surfaces_.links()[batch.first + i];
        // Seen from the link's receiver, its end is somewhere along its direction.
        sights[i] = directions_.directions()[link.direction];
        normals[i] = normal_at_end(geometry_, link, sights[i]);
    }
    const MaterialPtr& material = geometry_.ranges[batch.range].material;
    thread_local std::vector<const ResponseTable*> layers;
    layers.clear();
    if (const SpatialVariation* const variation = material->variation())
        for (const MaterialLayer& layer : variation->layers) layers.push_back(&tables_.at(layer.material));
    else
        layers.push_back(&tables_.at(material));
    rows.run(layers, surfaces_.weights(batch), channel_, frames_, std::span(sights).first(batch.count),
             std::span(normals).first(batch.count), out);
}

template <class Visit>
void Bounce::reflect(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                     LightColumns& out, const Visit& visit) const {
    thread_local VertexLight factors;
    const std::size_t lanes = light.lanes(), size = rows.components() * lanes;
    arrive(block, rows.components(), out, [&](const LinkedSurfaces::Batch& batch, Lanes* stokes) {
        find_rows(batch, rows, factors);
        for (std::size_t i = 0; i < batch.count; ++i)
            visit(batch.first + i, [&](std::size_t point, float share) {
                dispatch<add_product>(factors.row(i), rows.components(), light.numbers(), share,
                                      light.at(point), lanes, stokes + i * size);
            });
    });
}

void Bounce::reflect_vertices(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                              LightColumns& out) const {
    reflect(block, rows, light, out, [&](std::size_t index, const auto& add) {
        const SurfaceLink& link = surfaces_.links()[index];
        const glm::vec3 shares = corner_weights(link);
        for (glm::length_t k = 0; k < 3; ++k) add(geometry_.triangles[link.triangle][k], shares[k]);
    });
}

void Bounce::reflect_receivers(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                               LightColumns& out) const {
    reflect(block, rows, light, out, [&](std::size_t index, const auto& add) {
        const std::uint32_t receiver = surfaces_.receiver_at(index);
        if (receiver != kNoVertex) add(receiver, 1.0F);
    });
}

void Bounce::gather(std::size_t block, const LinkStokes& stokes, std::span<const std::size_t> channels,
                    LightColumns& out) const {
    constexpr std::size_t components = 4;
    const std::size_t lanes = out.lanes();
    arrive(block, components, out, [&](const LinkedSurfaces::Batch& batch, Lanes* to) {
        for (std::size_t i = 0; i < batch.count; ++i)
            for (std::size_t c = 0; c < channels.size(); ++c)
                for (std::size_t p = 0; p < components; ++p)
                    to[(i * components + p) * lanes + c / kLanes][c % kLanes] =
                        stokes[channels[c]][batch.first + i][static_cast<glm::length_t>(p)];
    });
}

namespace {

// Largest ratio of a bounce to the one before. A closed surface that absorbs nothing has 1.
constexpr double kLargestRatio = 0.99;
// Bounces after which the geometric series is taken as it is. What is left is known; more bounces would take
// more time than they are worth.
constexpr int kMostRounds = 24;

/// Estimates for a column after a bounce.
struct Tail {
    double ratio = 0;  // of a bounce to the one before, as far as they are alike
    double apart = 0;  // squared norm of the rest of the bounce, which is not like the one before
    double error = 0;  // squared norm of the error if all later bounces are taken to be alike
};

// Adds the light of one bounce to the numbers of s0.
void add_scalars(const LightColumns& from, LightColumns& to) {
    for (std::size_t r = 0; r < from.points(); ++r)
        for (std::size_t j = 0; j < from.numbers() * from.lanes(); ++j)
            for (std::size_t i = 0; i < kLanes; ++i) to.at(r)[j][i] += from.at(r)[j][i];
}

// Sum of `count` terms of a geometric series that begins with its ratio.
double geometric(double ratio, int count) {
    return ratio * (1 - std::pow(ratio, count)) / (1 - ratio);
}

// Writes the later bounces b = (I - K)^-1 K y of y = ratio x before + d as ratio / (1 - ratio) y + K d /
// ((1 - ratio) (I - K)), whose second term is the error.
Tail tail_of(const LightColumns& before, const LightColumns& after, std::size_t column, double apart_before) {
    double old = 0, both = 0, now = 0;
    for (std::size_t r = 0; r < after.points(); ++r) {
        const auto x = double{before.value(r, 0, column)}, y = double{after.value(r, 0, column)};
        old += x * x;
        both += x * y;
        now += y * y;
    }
    Tail out;
    if (!(old > 0)) return out;
    out.ratio = std::clamp(both / old, 0.0, kLargestRatio);
    out.apart = std::max(0.0, now - 2 * out.ratio * both + out.ratio * out.ratio * old);
    double decay = std::max(out.ratio, 0.5);
    if (apart_before > 0) decay = std::min(std::sqrt(out.apart / apart_before), kLargestRatio);
    const double factor = decay / ((1 - out.ratio) * (1 - decay));
    out.error = factor * factor * out.apart;
    return out;
}

}  // namespace

BounceSeries sum_bounces(const Bounce& bounce, const LinkedSurfaces& surfaces, const ReflectionRows& scalar,
                         const ReflectionRows& all, LightColumns first, const SeriesEnd& end,
                         RenderRun& run) {
    const std::size_t columns = first.columns(), scalars = scalar.light().size();
    BounceSeries out;
    out.rounds = 1;
    out.left.assign(columns, 0.0);
    out.light = std::move(first);
    if (end.bounces == 1) return out;

    const auto for_blocks = [&](const auto& body) {
        run.workers.for_blocks(surfaces.blocks(), end.verb, run.progress,
                               [&](std::size_t begin, std::size_t last) {
                                   for (std::size_t b = begin; b < last; ++b) body(b);
                               });
    };
    LightColumns sum = out.light;
    LightColumns before(surfaces.receivers(), scalars, columns), after = before;
    for (std::size_t r = 0; r < surfaces.receivers(); ++r)
        std::copy_n(out.light.at(r), scalars * before.lanes(), before.at(r));
    std::vector<Tail> tails(columns);
    // The last bounce is that of all components below.
    while (++out.rounds < end.bounces) {
        for_blocks([&](std::size_t b) { bounce.reflect_receivers(b, scalar, before, after); });
        add_scalars(after, sum);
        double most = 0, power = end.all;
        for (std::size_t c = 0; c < columns; ++c) {
            tails[c] = tail_of(before, after, c, tails[c].apart);
            most = std::max(most, tails[c].error);
            double own = 0;
            for (std::size_t r = 0; r < surfaces.receivers(); ++r) {
                const auto value = double{sum.value(r, 0, c)};
                own += value * value;
            }
            power = std::max(power, own);
        }
        std::swap(before, after);
        if (most > end.negligible * end.negligible * power && out.rounds < kMostRounds) continue;
        const int later = end.bounces - 1 - out.rounds;
        for (std::size_t c = 0; c < columns; ++c) {
            const auto factor = static_cast<float>(geometric(tails[c].ratio, later));
            out.left[c] = tails[c].error;
            for (std::size_t r = 0; r < surfaces.receivers(); ++r)
                for (std::size_t j = 0; j < scalars; ++j) {
                    const std::size_t at = j * sum.lanes() + c / kLanes;
                    sum.at(r)[at][c % kLanes] += factor * before.at(r)[at][c % kLanes];
                }
        }
        ++out.rounds;
        break;
    }
    LightColumns last(surfaces.receivers(), sum.numbers(), columns);
    for_blocks([&](std::size_t b) { bounce.reflect_receivers(b, all, sum, last); });
    for (std::size_t r = 0; r < surfaces.receivers(); ++r)
        for (std::size_t j = 0; j < sum.numbers() * sum.lanes(); ++j)
            for (std::size_t i = 0; i < kLanes; ++i) out.light.at(r)[j][i] += last.at(r)[j][i];
    return out;
}

}  // namespace nicol
