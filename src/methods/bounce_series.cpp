// SPDX-License-Identifier: MIT
#include "methods/bounce_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "material/spatial_variation.hpp"
#include "methods/link_lights.hpp"
#include "simd/work_space.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {

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
      irradiance_(scalar_layout_),
      channel_(channel) {}

template <class Leave>
void Bounce::arrive(std::size_t block, bool only_coarse, std::size_t components, LightColumns& out,
                    const Leave& leave, const LobePhotons* photons,
                    std::span<const std::size_t> channels) const {
    const std::size_t lanes = out.lanes(), numbers = out.numbers(), first = block * kLanes;
    const std::size_t count = std::min(kLanes, surfaces_.receivers() - first);
    std::array<glm::vec3, kLanes> normals;
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] = geometry_.normals[surfaces_.vertices()[first + i]];
        std::fill_n(out.at(first + i), numbers * lanes, Lanes{});
    }
    const std::span<Lanes> stokes = work_space<Bounce, Lanes>(kLanes * components * lanes);
    const Arrived arrived{.first = first,
                          .normals = normals,
                          .irradiance = work_space<ArrivingIrradiance, Lanes>(kLanes * lanes),
                          .light = out};
    std::ranges::fill(arrived.irradiance, Lanes{});
    const std::size_t coarse_batches = surfaces_.coarse_batches(block).size();
    const std::span batches = surfaces_.batches(block);
    for (std::size_t b = 0; b < (only_coarse ? coarse_batches : batches.size()); ++b) {
        const bool coarse = b < coarse_batches;
        const std::size_t arriving = coarse ? components : 1;
        std::ranges::fill(stokes, Lanes{});
        leave(batches[b], coarse, stokes.data());
        for (std::size_t i = 0; i < batches[b].count; ++i) {
            const SurfaceLink& link = surfaces_.links()[batches[b].first + i];
            add(link.direction, link.receiver,
                {.scalar = only_coarse ? link.coarse_solid_angle : link.solid_angle,
                 .polarized = link.coarse_solid_angle},
                arriving, &stokes[i * arriving * lanes], arrived);
        }
    }
    if (photons != nullptr) add_photons(block, *photons, channels, components, arrived);
    const bool scalar = numbers == scalar_layout_.size();
    const LightLayout& layout = scalar ? scalar_layout_ : layout_;
    const FrameRotation& rotation = scalar ? scalar_rotation_ : rotation_;
    thread_local VertexLight light;
    light.resize(layout, static_cast<int>(out.columns()), kLanes);
    get_columns(out, first, light, 0);
    const std::span normals_of = std::span(normals).first(count);
    rotation.into_frames(normals_of, light, 0);
    add_mirror_image(layout, light, 0);
    for (std::size_t c = 0; c < out.columns(); ++c) {
        Lanes of_column{};
        for (std::size_t i = 0; i < count; ++i)
            of_column[i] = arrived.irradiance[i * lanes + c / kLanes][c % kLanes];
        irradiance_.set(of_column, light.block(0, static_cast<int>(c)));
    }
    rotation.into_world(normals_of, light, 0);
    put_columns(light, 0, first, out);
}

void Bounce::add(std::size_t direction, std::size_t receiver, const ArrivingLight::SolidAngles& solid_angles,
                 std::size_t components, const Lanes* stokes, const Arrived& out) const {
    const std::size_t lanes = out.light.lanes();
    arrival_.add(direction, solid_angles, components, lanes, stokes, out.light.at(receiver));
    const std::size_t in_block = receiver - out.first;
    const float cosine = glm::dot(directions_.directions()[direction], out.normals[in_block]);
    const float factor = std::max(0.0F, cosine) * solid_angles.scalar / std::numbers::pi_v<float>;
    Lanes* const irradiance = &out.irradiance[in_block * lanes];
    for (std::size_t k = 0; k < lanes; ++k)
        for (std::size_t i = 0; i < kLanes; ++i) irradiance[k][i] += factor * stokes[k][i];
}

void Bounce::add_photons(std::size_t block, const LobePhotons& photons, std::span<const std::size_t> channels,
                         std::size_t components, const Arrived& out) const {
    const std::size_t lanes = out.light.lanes();
    const std::span<Lanes> stokes = work_space<LobePhotons, Lanes>(components * lanes);
    for (std::size_t k = photons.first(block); k < photons.last(block); ++k) {
        std::ranges::fill(stokes, Lanes{});
        for (std::size_t c = 0; c < channels.size(); ++c)
            for (std::size_t p = 0; p < components; ++p)
                stokes[p * lanes + c / kLanes][c % kLanes] =
                    photons.stokes(k, channels[c])[static_cast<glm::length_t>(p)];
        const LobePhotons::Part& part = photons.part(k);
        add(part.direction, part.receiver, {.scalar = 1, .polarized = 1}, components, stokes.data(), out);
    }
}

const VertexLight& Bounce::find_rows(const LinkedSurfaces::Batch& batch, const ReflectionRows& rows) const {
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
    return out;
}

void Bounce::add_reflected(const LinkedSurfaces::Batch& batch, const ReflectionRows& rows, bool only_coarse,
                           const LightColumns* light, const LightColumns* bounced, Lanes* stokes) const {
    const std::size_t scalars = scalar_layout_.size(), all = rows.light().size();
    std::array<LinkLights, kLanes> links;
    for (std::size_t i = 0; i < batch.count; ++i) {
        const std::size_t index = batch.first + i;
        const SurfaceLink& link = surfaces_.links()[index];
        LinkLights& of = links[i];
        // s0 arrives in the solid angle of all links, but its part that polarization makes by coarse links.
        if (!only_coarse) of.share = link.coarse_solid_angle / link.solid_angle;
        if (bounced != nullptr && surfaces_.receiver_at(index) != kNoVertex) {
            of.add(bounced->at(surfaces_.receiver_at(index)), 1);
            if (bounced->numbers() > scalars) of.whole = of.count;
        }
        if (light != nullptr) {
            const glm::vec3 weights = corner_weights(link);
            for (glm::length_t k = 0; k < 3; ++k)
                of.add(light->at(geometry_.triangles[link.triangle][k]), weights[k]);
            if (light->numbers() > scalars) of.whole = of.count;
        }
    }
    std::size_t numbers = 0;
    for (const LightColumns* const columns : {light, bounced})
        if (columns != nullptr) numbers = std::max(numbers, std::min(columns->numbers(), all));
    links[0].prefetch();
    const VertexLight& found = find_rows(batch, rows);
    add_links({.rows = found.row(0),
               .row_size = all,
               .components = rows.components(),
               .scalars = scalars,
               .numbers = numbers,
               .lanes = (light != nullptr ? light : bounced)->lanes()},
              std::span<const LinkLights>(links).first(batch.count), stokes);
}

void Bounce::reflect_vertices(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                              LightColumns& out) const {
    arrive(block, true, rows.components(), out,
           [&](const LinkedSurfaces::Batch& batch, bool /*coarse*/, Lanes* stokes) {
               add_reflected(batch, rows, true, &light, nullptr, stokes);
           });
}

void Bounce::reflect_receivers(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                               LightColumns& out) const {
    arrive(block, true, rows.components(), out,
           [&](const LinkedSurfaces::Batch& batch, bool /*coarse*/, Lanes* stokes) {
               add_reflected(batch, rows, true, nullptr, &light, stokes);
           });
}

void Bounce::reflect_all(std::size_t block, const BounceRows& rows, const LightColumns& light,
                         const LightColumns* bounced, LightColumns& out) const {
    arrive(block, false, rows.all.components(), out,
           [&](const LinkedSurfaces::Batch& batch, bool coarse, Lanes* stokes) {
               add_reflected(batch, coarse ? rows.all : rows.scalar, false, &light, bounced, stokes);
           });
}

void Bounce::gather(std::size_t block, const ArrivingLamps& lamps, std::span<const std::size_t> channels,
                    const BounceRows& rows, const LightColumns* bounced, LightColumns& out) const {
    const std::size_t components = rows.all.components(), lanes = out.lanes();
    const auto leave = [&](const LinkedSurfaces::Batch& batch, bool coarse, Lanes* to) {
        if (bounced != nullptr)
            add_reflected(batch, coarse ? rows.all : rows.scalar, false, nullptr, bounced, to);
        const std::size_t arriving = coarse ? components : 1;
        for (std::size_t i = 0; i < batch.count; ++i)
            for (std::size_t c = 0; c < channels.size(); ++c)
                for (std::size_t p = 0; p < arriving; ++p)
                    to[(i * arriving + p) * lanes + c / kLanes][c % kLanes] +=
                        lamps.links[channels[c]][batch.first + i][static_cast<glm::length_t>(p)];
    };
    arrive(block, false, components, out, leave, &lamps.photons, channels);
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

// Sum of `count` terms of a geometric series that begins with its ratio.
double geometric(double ratio, int count) {
    return ratio * (1 - std::pow(ratio, count)) / (1 - ratio);
}

/// Sums over receivers of products of a column's first numbers.
struct Products {
    double old = 0;   // bounce before, with itself
    double both = 0;  // bounce before, with the bounce
    double now = 0;   // bounce, with itself
    double own = 0;   // all bounces, with themselves
};

// Writes the later bounces b = (I - K)^-1 K y of y = ratio x before + d as ratio / (1 - ratio) y + K d /
// ((1 - ratio) (I - K)), whose second term is the error.
Tail tail_of(const Products& of, double apart_before) {
    Tail out;
    if (!(of.old > 0)) return out;
    out.ratio = std::clamp(of.both / of.old, 0.0, kLargestRatio);
    out.apart = std::max(0.0, of.now - 2 * out.ratio * of.both + out.ratio * out.ratio * of.old);
    double decay = std::max(out.ratio, 0.5);
    if (apart_before > 0) decay = std::min(std::sqrt(out.apart / apart_before), kLargestRatio);
    const double factor = decay / ((1 - out.ratio) * (1 - decay));
    out.error = factor * factor * out.apart;
    return out;
}

// Adds factors, [column], times the light of some receivers to the numbers of s0.
void add_scalars(const LightColumns& from, std::span<const Lanes> factors, std::size_t first,
                 std::size_t last, LightColumns& to) {
    const std::size_t lanes = from.lanes();
    for (std::size_t r = first; r < last; ++r) {
        const Lanes* const light = from.at(r);
        Lanes* const sum = to.at(r);
        for (std::size_t j = 0; j < from.numbers(); ++j)
            for (std::size_t k = 0; k < lanes; ++k)
                for (std::size_t i = 0; i < kLanes; ++i)
                    sum[j * lanes + k][i] += factors[k][i] * light[j * lanes + k][i];
    }
}

// Sets the columns' products of some receivers.
void find_products(const LightColumns& before, const LightColumns& after, const LightColumns& sum,
                   std::size_t first, std::size_t last, std::span<Products> out) {
    std::ranges::fill(out, Products());
    for (std::size_t r = first; r < last; ++r)
        for (std::size_t c = 0; c < out.size(); ++c) {
            const auto x = double{before.value(r, 0, c)}, y = double{after.value(r, 0, c)},
                       all = double{sum.value(r, 0, c)};
            out[c].old += x * x;
            out[c].both += x * y;
            out[c].now += y * y;
            out[c].own += all * all;
        }
}

}  // namespace

BounceSeries sum_bounces(const Bounce& bounce, const LinkedSurfaces& surfaces, const ReflectionRows& scalar,
                         const FirstBounce& first, const LastBounce& last, const SeriesSize& size,
                         const SeriesEnd& end, RenderRun& run) {
    const std::size_t columns = size.columns, scalars = scalar.light().size();
    const std::size_t receivers = surfaces.receivers();
    BounceSeries out;
    out.rounds = 1;
    out.left.assign(columns, 0.0);
    // body(block, first receiver, end of its receivers)
    const auto for_blocks = [&](const auto& body) {
        run.workers.for_blocks(surfaces.blocks(), end.verb, run.progress,
                               [&](std::size_t begin, std::size_t last) {
                                   for (std::size_t b = begin; b < last; ++b)
                                       body(b, b * kLanes, std::min((b + 1) * kLanes, receivers));
                               });
    };
    out.light = LightColumns(receivers, size.numbers, columns);
    if (end.bounces == 1) {
        for_blocks([&](std::size_t b, std::size_t, std::size_t) { last(b, nullptr, out.light); });
        return out;
    }
    LightColumns sum = out.light;
    LightColumns before(receivers, scalars, columns), after = before;
    for_blocks([&](std::size_t b, std::size_t begin, std::size_t stop) {
        first(b, sum);
        for (std::size_t r = begin; r < stop; ++r)
            std::copy_n(sum.at(r), scalars * before.lanes(), before.at(r));
    });
    std::vector<Lanes> factors(before.lanes());
    std::vector<Products> products(surfaces.blocks() * columns);
    std::vector<Tail> tails(columns);
    // The last bounce is that of all components below.
    while (++out.rounds < end.bounces) {
        for (Lanes& factor : factors) factor.value.fill(1);
        for_blocks([&](std::size_t b, std::size_t begin, std::size_t stop) {
            bounce.reflect_receivers(b, scalar, before, after);
            add_scalars(after, factors, begin, stop, sum);
            find_products(before, after, sum, begin, stop, std::span(products).subspan(b * columns, columns));
        });
        double most = 0, power = end.all;
        for (std::size_t c = 0; c < columns; ++c) {
            Products all;
            for (std::size_t k = c; k < products.size(); k += columns) {
                all.old += products[k].old;
                all.both += products[k].both;
                all.now += products[k].now;
                all.own += products[k].own;
            }
            tails[c] = tail_of(all, tails[c].apart);
            most = std::max(most, tails[c].error);
            power = std::max(power, all.own);
        }
        std::swap(before, after);
        if (most > end.negligible * end.negligible * power && out.rounds < kMostRounds) continue;
        const int later = end.bounces - 1 - out.rounds;
        for (std::size_t c = 0; c < columns; ++c) {
            factors[c / kLanes][c % kLanes] = static_cast<float>(geometric(tails[c].ratio, later));
            out.left[c] = tails[c].error;
        }
        for_blocks([&](std::size_t, std::size_t begin, std::size_t stop) {
            add_scalars(before, factors, begin, stop, sum);
        });
        ++out.rounds;
        break;
    }
    for_blocks([&](std::size_t b, std::size_t, std::size_t) { last(b, &sum, out.light); });
    return out;
}

}  // namespace nicol
