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

// Adds share times the sum of row[j] * light[j * step]. Four sums side by side do not wait for each other.
[[gnu::always_inline]] inline void add_dot_product(const float* row, std::size_t numbers, float share,
                                                   const Lanes* light, std::size_t step, LaneVector& out) {
    constexpr std::size_t sums = 4;
    LaneVector of[sums] = {};
    std::size_t j = 0;
    for (; j + sums <= numbers; j += sums)
        for (std::size_t k = 0; k < sums; ++k) {
            LaneVector number;
            load(light + (j + k) * step, number);
            of[k] += row[j + k] * number;
        }
    for (; j < numbers; ++j) {
        LaneVector number;
        load(light + j * step, number);
        of[0] += row[j] * number;
    }
    out += share * ((of[0] + of[1]) + (of[2] + of[3]));
}

// Adds rows x light to Stokes components, [component][Lanes of columns]. scalars: count of the numbers of s0;
// weight: of the light; share: factor of the others' part of s0.
[[gnu::always_inline]] inline void add_product(const float* rows, std::size_t row_size,
                                               std::size_t components, std::size_t scalars,
                                               std::size_t numbers, float weight, float share,
                                               const Lanes* light, std::size_t lanes, Lanes* stokes) {
    for (std::size_t k = 0; k < lanes; ++k)
        for (std::size_t p = 0; p < components; ++p) {
            const float* const row = rows + p * row_size;
            LaneVector sum;
            load(stokes + p * lanes + k, sum);
            add_dot_product(row, scalars, weight, light + k, lanes, sum);
            if (numbers > scalars)
                add_dot_product(row + scalars, numbers - scalars, weight * (p == 0 ? share : 1.0F),
                                light + scalars * lanes + k, lanes, sum);
            store(stokes + p * lanes + k, sum);
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

struct Bounce::BatchRows {
    const LinkedSurfaces::Batch& batch;
    const ReflectionRows& of;
    const VertexLight& rows;
};

template <class Leave>
void Bounce::arrive(std::size_t block, bool only_coarse, std::size_t components, LightColumns& out,
                    const Leave& leave) const {
    const std::size_t lanes = out.lanes(), numbers = out.numbers(), first = block * kLanes;
    const std::size_t count = std::min(kLanes, surfaces_.receivers() - first);
    std::array<glm::vec3, kLanes> normals;
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] = geometry_.normals[surfaces_.vertices()[first + i]];
        std::fill_n(out.at(first + i), numbers * lanes, Lanes{});
    }
    const std::span<Lanes> stokes = work_space<Bounce, Lanes>(kLanes * components * lanes);
    const std::size_t coarse_batches = surfaces_.coarse_batches(block).size();
    const std::span batches = surfaces_.batches(block);
    for (std::size_t b = 0; b < (only_coarse ? coarse_batches : batches.size()); ++b) {
        const bool coarse = b < coarse_batches;
        const std::size_t arriving = coarse ? components : 1;
        std::ranges::fill(stokes, Lanes{});
        leave(batches[b], coarse, stokes.data());
        for (std::size_t i = 0; i < batches[b].count; ++i) {
            const SurfaceLink& link = surfaces_.links()[batches[b].first + i];
            arrival_.add(link.direction,
                         {.scalar = only_coarse ? link.coarse_solid_angle : link.solid_angle,
                          .polarized = link.coarse_solid_angle},
                         arriving, lanes, &stokes[i * arriving * lanes], out.at(link.receiver));
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

Bounce::BatchRows Bounce::find_rows(const LinkedSurfaces::Batch& batch, const ReflectionRows& rows) const {
    thread_local VertexLight out;
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
    return {.batch = batch, .of = rows, .rows = out};
}

template <class Points>
void Bounce::add_reflected(const BatchRows& rows, bool only_coarse, const LightColumns& light,
                           const Points& points, Lanes* stokes) const {
    const std::size_t components = rows.of.components(), lanes = light.lanes();
    const std::size_t numbers = std::min(light.numbers(), rows.of.light().size());
    for (std::size_t i = 0; i < rows.batch.count; ++i) {
        const std::size_t index = rows.batch.first + i;
        // s0 arrives in the solid angle of all links, but its part that polarization makes by coarse links.
        const SurfaceLink& link = surfaces_.links()[index];
        const float share = only_coarse ? 1.0F : link.coarse_solid_angle / link.solid_angle;
        points(index, [&](std::uint32_t at, float weight) {
            dispatch<add_product>(rows.rows.row(i), rows.of.light().size(), components, scalar_layout_.size(),
                                  numbers, weight, share, light.at(at), lanes,
                                  stokes + i * components * lanes);
        });
    }
}

void Bounce::reflect_vertices(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                              LightColumns& out) const {
    const auto corners = [&](std::size_t index, const auto& add) {
        const SurfaceLink& link = surfaces_.links()[index];
        const glm::vec3 weights = corner_weights(link);
        for (glm::length_t k = 0; k < 3; ++k) add(geometry_.triangles[link.triangle][k], weights[k]);
    };
    arrive(block, true, rows.components(), out,
           [&](const LinkedSurfaces::Batch& batch, bool /*coarse*/, Lanes* stokes) {
               add_reflected(find_rows(batch, rows), true, light, corners, stokes);
           });
}

void Bounce::reflect_receivers(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                               LightColumns& out) const {
    const auto receivers = [&](std::size_t index, const auto& add) {
        if (surfaces_.receiver_at(index) != kNoVertex) add(surfaces_.receiver_at(index), 1.0F);
    };
    arrive(block, true, rows.components(), out,
           [&](const LinkedSurfaces::Batch& batch, bool /*coarse*/, Lanes* stokes) {
               add_reflected(find_rows(batch, rows), true, light, receivers, stokes);
           });
}

void Bounce::reflect_all(std::size_t block, const BounceRows& rows, const LightColumns& light,
                         const LightColumns* bounced, LightColumns& out) const {
    const auto corners = [&](std::size_t index, const auto& add) {
        const SurfaceLink& link = surfaces_.links()[index];
        const glm::vec3 weights = corner_weights(link);
        for (glm::length_t k = 0; k < 3; ++k) add(geometry_.triangles[link.triangle][k], weights[k]);
    };
    const auto receivers = [&](std::size_t index, const auto& add) {
        if (surfaces_.receiver_at(index) != kNoVertex) add(surfaces_.receiver_at(index), 1.0F);
    };
    arrive(block, false, rows.all.components(), out,
           [&](const LinkedSurfaces::Batch& batch, bool coarse, Lanes* stokes) {
               const BatchRows found = find_rows(batch, coarse ? rows.all : rows.scalar);
               add_reflected(found, false, light, corners, stokes);
               if (bounced != nullptr) add_reflected(found, false, *bounced, receivers, stokes);
           });
}

void Bounce::gather(std::size_t block, const LinkStokes& stokes, std::span<const std::size_t> channels,
                    const BounceRows& rows, const LightColumns* bounced, LightColumns& out) const {
    const auto receivers = [&](std::size_t index, const auto& add) {
        if (surfaces_.receiver_at(index) != kNoVertex) add(surfaces_.receiver_at(index), 1.0F);
    };
    const std::size_t components = rows.all.components(), lanes = out.lanes();
    arrive(block, false, components, out, [&](const LinkedSurfaces::Batch& batch, bool coarse, Lanes* to) {
        if (bounced != nullptr)
            add_reflected(find_rows(batch, coarse ? rows.all : rows.scalar), false, *bounced, receivers, to);
        const std::size_t arriving = coarse ? components : 1;
        for (std::size_t i = 0; i < batch.count; ++i)
            for (std::size_t c = 0; c < channels.size(); ++c)
                for (std::size_t p = 0; p < arriving; ++p)
                    to[(i * arriving + p) * lanes + c / kLanes][c % kLanes] +=
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
                         LightColumns first, const LastBounce& last, const SeriesEnd& end, RenderRun& run) {
    const std::size_t columns = first.columns(), scalars = scalar.light().size();
    BounceSeries out;
    out.rounds = 1;
    out.left.assign(columns, 0.0);
    const auto for_blocks = [&](const auto& body) {
        run.workers.for_blocks(surfaces.blocks(), end.verb, run.progress,
                               [&](std::size_t begin, std::size_t last) {
                                   for (std::size_t b = begin; b < last; ++b) body(b);
                               });
    };
    LightColumns sum = std::move(first);
    out.light = LightColumns(surfaces.receivers(), sum.numbers(), columns);
    if (end.bounces == 1) {
        for_blocks([&](std::size_t b) { last(b, nullptr, out.light); });
        return out;
    }
    LightColumns before(surfaces.receivers(), scalars, columns), after = before;
    for (std::size_t r = 0; r < surfaces.receivers(); ++r)
        std::copy_n(sum.at(r), scalars * before.lanes(), before.at(r));
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
    for_blocks([&](std::size_t b) { last(b, &sum, out.light); });
    return out;
}

}  // namespace nicol
