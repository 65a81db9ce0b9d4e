// SPDX-License-Identifier: MIT
// Chains of neighbouring samples that show one smooth boundary, sixteen at a time.
#include <algorithm>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <vector>

#include "devices/cpu/chain_numbers.hpp"
#include "devices/cpu/lane_chains.hpp"
#include "devices/cpu/smooth_chains.hpp"
#include "draw/visibility_buffer.hpp"
#include "light/light_pyramid.hpp"
#include "material/reflectance.hpp"
#include "shading/light_samples.hpp"
#include "simd/lane_transpose.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {
namespace {

// Bundles of fewer chains are slower than single chains.
constexpr std::size_t kFewest = 4;
// Rays after fewer events than this may leave a convex body where others left it.
constexpr int kGuessedEvents = 4;

// Calls body(i) for each lane whose bit is set.
template <class Body>
void for_lanes(std::uint32_t bits, const Body& body) {
    for (; bits != 0; bits &= bits - 1) body(static_cast<std::size_t>(std::countr_zero(bits)));
}

// Returns the triangles at which a thread's rays have left convex bodies after some events, by the columns of
// their pixels. They may be those of another scene.
std::span<std::uint32_t> exits_of(int events, std::size_t columns) {
    thread_local std::vector<std::uint32_t> exits;
    if (exits.size() < kGuessedEvents * columns) exits.resize(kGuessedEvents * columns, ~0U);
    return std::span(exits).subspan(static_cast<std::size_t>(events) * columns, columns);
}

}  // namespace

// Samples of one boundary, side by side, and the light that they receive.
struct SmoothChains::Bundle {
    std::size_t number;  // of the range
    const VertexRange& range;
    const SmoothBoundary& boundary;
    bool convex;  // whether the boundary is that of a convex body with nothing inside
    std::array<Shown, kLanes> shown;
    std::array<std::uint32_t, kLanes> columns;  // of the pixels
    std::vector<std::array<Lanes, 4>>& sums;    // Stokes vectors, by channel
    std::vector<Chain>& chains;                 // that leave the bundle
    Ends& ends;

    // Returns whether a triangle is one of the boundary.
    [[nodiscard]] bool shows(const WorldGeometry& geometry, std::uint32_t triangle) const {
        if (triangle >= geometry.triangles.size()) return false;
        const std::uint32_t corner = geometry.triangles[triangle].x;
        return corner >= range.first && corner < range.last;
    }
};

void SmoothChains::follow_bundles(std::vector<Shown>& shown, std::vector<Chain>& chains, Ends& ends,
                                  Image out) const {
    thread_local std::vector<LaneChains> levels;
    thread_local std::vector<std::array<Lanes, 4>> sums;
    levels.resize(std::max(levels.size(), static_cast<std::size_t>(input_.smooth_events) + 1));
    if (!std::ranges::is_sorted(shown, {}, &Shown::range)) std::ranges::stable_sort(shown, {}, &Shown::range);
    for (std::size_t begin = 0; begin < shown.size();) {
        std::size_t end = begin + 1;
        while (end < std::min(begin + kLanes, shown.size()) && shown[end].range == shown[begin].range) ++end;
        const std::span some = std::span(shown).subspan(begin, end - begin);
        begin = end;
        const VertexRange& vertices = input_.geometry.ranges[some.front().range];
        const SmoothBoundary& boundary = *vertices.material->smooth_boundary();
        if (some.size() < kFewest || boundary.film) {
            for (const Shown& sample : some) {
                chains.push_back(first_chain(sample.pixel, sample.sample, ends));
                chains.back().shown = sample.triangle;
            }
            continue;
        }
        sums.assign(out.size(), {});
        Bundle bundle{.number = some.front().range,
                      .range = vertices,
                      .boundary = boundary,
                      .convex = input_.smooth->convex().has(some.front().range),
                      .shown = {},
                      .columns = {},
                      .sums = sums,
                      .chains = chains,
                      .ends = ends};
        for (std::size_t i = 0; i < kLanes; ++i) bundle.shown[i] = some[std::min(i, some.size() - 1)];
        begin_bundle(some.size(), levels.front(), bundle);
        if (input_.smooth_events > 0 && levels.front().active != 0) pass(levels, bundle);
        const bool in_row = some.size() == kLanes && some.back().pixel - some.front().pixel == kLanes - 1 &&
                            input_.hits.offsets().size() == 1;
        for (std::size_t c = 0; c < out.size(); ++c) {
            if (in_row) {
                add_fours(sums[c].data(), kLanes, &out[c][some.front().pixel]);
                continue;
            }
            for (std::size_t i = 0; i < some.size(); ++i)
                out[c][some[i].pixel] +=
                    glm::vec4(sums[c][0][i], sums[c][1][i], sums[c][2][i], sums[c][3][i]);
        }
    }
}

void SmoothChains::begin_bundle(std::size_t count, LaneChains& out, Bundle& bundle) const {
    const auto columns = static_cast<std::uint32_t>(input_.hits.width());
    std::array<double, kLanes> x, y;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const auto& [pixel, sample, triangle, range] = bundle.shown[i];
        const glm::dvec2& offset = input_.hits.offsets()[sample];
        const std::uint32_t row = pixel / columns;
        bundle.columns[i] = pixel - row * columns;
        x[i] = bundle.columns[i] + 0.5 + offset.x;
        y[i] = row + 0.5 + offset.y;
        out.met[i] = triangle;
        out.seeds[i] =
            sample_seed(static_cast<std::uint32_t>(pixel * kMostPixelSamples + sample), input_.seed);
        out.bodies[i] = nullptr;
    }
    const LaneTriangles triangles = LaneTriangles::of(input_.geometry, out.met);
    const std::uint32_t undefined =
        begin_chains({.projection = input_.projection,
                      .width = input_.hits.width(),
                      .height = input_.hits.height(),
                      .x = x,
                      .y = y,
                      .triangles = triangles,
                      .weight = 1 / static_cast<double>(input_.hits.offsets().size())},
                     out);
    out.factors.resize(bundle.sums.size());
    for (Lanes& factors : out.factors) factors.value.fill(1);
    out.open = 0;
    out.events = 0;
    out.active = ((1U << count) - 1) & ~undefined;
    // Rays that run along their triangles are traced as single chains.
    for (std::size_t i = 0; i < count; ++i)
        if ((undefined >> i & 1) != 0)
            bundle.chains.push_back(first_chain(bundle.shown[i].pixel, bundle.shown[i].sample, bundle.ends));
}

void SmoothChains::meet(std::span<LaneChains> levels, Bundle& bundle) const {
    LaneChains& chains = levels.front();
    const std::uint32_t traced = chains.active & ~chains.open;
    const bool guesses = bundle.convex && chains.events < kGuessedEvents;
    const std::span exits = guesses ? exits_of(chains.events, static_cast<std::size_t>(input_.hits.width()))
                                    : std::span<std::uint32_t>();
    std::uint32_t sky = chains.active & chains.open;
    std::uint32_t met = 0;
    if (static_cast<std::size_t>(std::popcount(traced)) < kFewest) {
        // Few chains of many bundles go on side by side as single ones.
        for_lanes(traced,
                  [&](std::size_t i) { bundle.chains.push_back(single(chains, i, kNoTriangle, bundle)); });
    } else {
        bundle.ends.rays += static_cast<std::uint64_t>(std::popcount(traced));
        if (guesses) met = leave(chains, traced, exits, bundle);
        if (traced != met) trace(chains, traced & ~met, met, sky, bundle);
    }
    if (guesses) for_lanes(met, [&](std::size_t i) { exits[bundle.columns[i]] = chains.met[i]; });
    absorb(chains, sky | met, met, bundle);
    if (sky != 0 && input_.sky != nullptr) add_sky(chains, sky, bundle);
    chains.active = met;
    if (met != 0 && chains.events != input_.smooth_events) pass(levels, bundle);
}

std::uint32_t SmoothChains::leave(LaneChains& chains, std::uint32_t some,
                                  std::span<const std::uint32_t> exits, const Bundle& bundle) const {
    std::uint32_t guessed = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::uint32_t exit = exits[bundle.columns[i]];
        const bool known = bundle.shows(input_.geometry, exit);
        chains.met[i] = known ? exit : bundle.shown[i].triangle;
        guessed |= (known ? 1U : 0U) << i;
    }
    guessed &= some;
    if (guessed == 0) return 0;
    LaneMeetings found;
    const std::uint32_t met =
        input_.smooth->convex().leave(bundle.number, chains.origins, chains.rays.directions, guessed,
                                      chains.met, chains.rays.triangles, found);
    chains.rays.distances = found.distances;
    chains.rays.b1 = found.b1;
    chains.rays.b2 = found.b2;
    return met;
}

void SmoothChains::trace(LaneChains& chains, std::uint32_t some, std::uint32_t& met, std::uint32_t& sky,
                         Bundle& bundle) const {
    HitPacket hits{};
    const std::uint32_t found =
        input_.smooth->intersect(packet_of(chains), static_cast<std::uint16_t>(some), hits);
    sky |= some & ~found;
    std::uint32_t traced = 0;
    for_lanes(found, [&](std::size_t i) {
        if (!bundle.shows(input_.geometry, hits.triangle[i])) {
            bundle.chains.push_back(single(chains, i, hits.triangle[i], bundle));
            return;
        }
        traced |= 1U << i;
        chains.met[i] = hits.triangle[i];
        chains.rays.distances[i] = hits.distance[i];
        chains.rays.b1[i] = hits.b1[i];
        chains.rays.b2[i] = hits.b2[i];
    });
    met |= traced;
    if (met == 0) return;
    const std::uint32_t any = chains.met[static_cast<std::size_t>(std::countr_zero(met))];
    for (std::size_t i = 0; i < kLanes; ++i)
        if ((met >> i & 1) == 0) chains.met[i] = any;
    if (bundle.convex && traced != 0) {
        // Rays that were traced end at the same bits as rays whose exit was guessed.
        std::array<std::uint32_t, kLanes> exits = chains.met;
        LaneMeetings at;
        const std::uint32_t left = input_.smooth->convex().leave(
            bundle.number, chains.origins, chains.rays.directions, traced, exits, chains.rays.triangles, at);
        for_lanes(left, [&](std::size_t i) {
            chains.met[i] = exits[i];
            chains.rays.distances[i] = at.distances[i];
            chains.rays.b1[i] = at.b1[i];
            chains.rays.b2[i] = at.b2[i];
        });
    }
    chains.rays.triangles = LaneTriangles::of(input_.geometry, chains.met);
}

void SmoothChains::pass(std::span<LaneChains> levels, Bundle& bundle) const {
    const LaneChains& chains = levels.front();
    const SmoothBoundary& boundary = bundle.boundary;
    LaneSplit split;
    split_lanes(boundary, chains.rays, split);
    LaneChoice choice{.reflects = {},
                      .probabilities = {},
                      .reflectance = mean_factor(boundary.reflectance),
                      .transmittance = mean_factor(boundary.transmittance)};
    choice.probabilities.value.fill(1);
    std::uint32_t both = 0, one = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        if ((chains.active >> i & 1) == 0) continue;
        const double reflected = choice.reflectance * static_cast<double>(split.reflected.block[0][i]);
        const double transmitted = choice.transmittance * static_cast<double>(split.transmitted.block[0][i]);
        const double sum = reflected + transmitted;
        if (!(sum > 0)) continue;
        if (std::min(reflected, transmitted) * static_cast<double>(chains.carried[i]) >= kBothCarry) {
            both |= 1U << i;
            continue;
        }
        one |= 1U << i;
        const bool reflects = fraction(chains.seeds[i]) * sum < reflected;
        choice.reflects[i] = reflects ? 1 : 0;
        choice.probabilities[i] = static_cast<float>((reflects ? reflected : transmitted) / sum);
    }
    const std::span rest = levels.subspan(1);
    if ((both | one) != 0) {
        go_on(chains, split, choice, both | one, rest.front(), bundle);
        meet(rest, bundle);
    }
    if (both == 0) return;
    choice.reflects.value.fill(1);
    choice.probabilities.value.fill(1);
    go_on(chains, split, choice, both, rest.front(), bundle);
    meet(rest, bundle);
}

void SmoothChains::go_on(const LaneChains& from, const LaneSplit& split, const LaneChoice& choice,
                         std::uint32_t some, LaneChains& to, const Bundle& bundle) const {
    const SmoothBoundary& boundary = bundle.boundary;
    const std::uint32_t outside = continue_chains(from, split, choice, to);
    to.active = some;
    to.open = 0;
    to.events = from.events + 1;
    for (std::size_t i = 0; i < kLanes; ++i) {
        if ((some >> i & 1) == 0) continue;
        const bool reflects = choice.reflects[i] > 0;
        to.bodies[i] = body_before(boundary, split.inside[i] > 0, reflects, from.bodies[i]);
        if ((outside >> i & 1) != 0 && input_.smooth->open(from.met[i])) to.open |= 1U << i;
    }
    continue_factors(from, boundary, choice, kFirstOnward, to);
}

void SmoothChains::add_sky(const LaneChains& chains, std::uint32_t some, Bundle& bundle) const {
    thread_local LaneLight light;
    LaneSky sky;
    find_sky(chains, to_light_, sky);
    light.towards = sky.directions;
    input_.sky->look_up(sky.variances, light);
    add_light(chains, some, sky, light, static_cast<float>(input_.light_scale), input_.most_components,
              bundle.sums);
}

void SmoothChains::absorb(LaneChains& chains, std::uint32_t some, std::uint32_t met,
                          const Bundle& bundle) const {
    if (black(bundle.boundary.absorption)) return;
    for (std::size_t i = 0; i < kLanes; ++i) {
        if ((some >> i & 1) == 0 || chains.bodies[i] == nullptr) continue;
        const double distance = (met >> i & 1) != 0 ? static_cast<double>(chains.rays.distances[i])
                                                    : std::numeric_limits<double>::infinity();
        double mean = 0;
        for (std::size_t c = 0; c < chains.factors.size(); ++c) {
            const double factor = transmitted_by(chains.bodies[i], static_cast<int>(c), distance);
            chains.factors[c][i] *= static_cast<float>(factor);
            mean += factor / static_cast<double>(chains.factors.size());
        }
        chains.carried[i] *= static_cast<float>(mean);
    }
}

SmoothChains::Chain SmoothChains::single(const LaneChains& chains, std::size_t lane, std::uint32_t triangle,
                                         const Bundle& bundle) const {
    const std::uint32_t pixel = bundle.shown[lane].pixel;
    const glm::dvec3 direction(vector_at(chains.rays.directions, lane));
    const glm::dvec3 x(vector_at(chains.rays.received_x, lane));
    std::vector<glm::mat4>& matrices = bundle.ends.matrices;
    Chain out{.way = {.pixel = pixel, .matrices = static_cast<std::uint32_t>(matrices.size())},
              .ray = {.origin = glm::dvec3(vector_at(chains.origins, lane)),
                      .direction = glm::normalize(direction)},
              .spread = {},
              .blur = 0,
              .received = Frame(x, glm::cross(-direction, x), -direction),
              .carried = static_cast<double>(chains.carried[lane]),
              .events = chains.events,
              .lit = false,
              .lobes_lit = false,
              .scattered = false,
              .body = chains.bodies[lane],
              .seed = chains.seeds[lane],
              .pixel_seed = sample_seed(pixel, input_.seed),
              .sample = bundle.shown[lane].sample,
              .shown = triangle};
    for (std::size_t k = 0; k < 2; ++k) {
        out.spread.places[k] = vector_at(chains.rays.places[k], lane);
        out.spread.directions[k] = vector_at(chains.rays.changes[k], lane);
    }
    glm::mat4 mueller;
    for (std::size_t i = 0; i < chains.matrices.size(); ++i)
        mueller[static_cast<glm::length_t>(i % 4)][static_cast<glm::length_t>(i / 4)] =
            chains.matrices[i][lane];
    for (const Lanes& factors : chains.factors) matrices.push_back(factors[lane] * mueller);
    return out;
}

}  // namespace nicol
