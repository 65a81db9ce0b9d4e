// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>

#include "material/microfacet.hpp"
#include "shading/reflected_nodes.hpp"
#include "simd/all_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_exponential.hpp"

namespace nicol {
namespace {

constexpr float kLeastCosine = 1e-6F;
constexpr float kLeastAcross = 1e-12F;  // smallest square of the sine of the angle to the normal
constexpr float kLeastShare = 1e-6F;
constexpr float kWidestBlob = 0.5F;  // largest variance, in square radians
// The horizon does not limit a blob this many standard deviations above it whose mean facet_visibility() is
// within half a percent of the value in its middle. The second derivative of GGX's, over its value, is about
// 1.1 alpha^2 / z^4.
constexpr float kAbove = 2;
constexpr float kCurved = 110;
constexpr float kMostMoved = 8;  // largest exponent of the ratio of two distributions of nodes

// Returns 1 over the density of facets of these slopes, in standard deviations; 0 if it is 0.
template <class Number>
[[gnu::always_inline]] inline void sparsity(const Facets<float>& facets, const glm::vec2& deviations,
                                            const Number& x, const Number& y, Number& out) {
    const Vector3<Number> steep{deviations.x * x, deviations.y * y, Number{} + 1.0F};
    const Number length2 = steep.x * steep.x + steep.y * steep.y + 1.0F;
    density(facets, steep, length2, out);
    out = out > 0.0F ? 1.0F / out : Number{};
}

// Computes facet_visibility() from a direction of any height.
template <class Number>
[[gnu::always_inline]] inline void visible_share(const Facets<float>& facets,
                                                 const Vector3<Number>& direction, Number& out) {
    const Number height = direction.z > 0.0F ? direction.z : Number{};
    visibility_over_cosine(facets, {direction.x, direction.y, height}, out);
    out *= height;
}

// Limits a node's blob to what its facets can see: computes the mean of facet_visibility() over the blob, and
// moves and narrows the blob by its weight. Near the horizon the mean differs from the value in the middle,
// because the visible share falls to 0 there and stays 0 below. The blob is represented by two directions,
// a standard deviation above and below.
template <class Number>
[[gnu::always_inline]] inline void limit_blob(const Facets<float>& facets, std::size_t first,
                                              ReflectedNode& node, Number& mean) {
    Vector3<Number> towards, seen;
    Number variance;
    load_part(node.towards, first, towards);
    load_part(node.seen, first, seen);
    load_part(node.variances, first, variance);
    const Number some = variance < kWidestBlob ? variance : Number{} + kWidestBlob;
    Number deviation = some;
    square_root(deviation);
    const Number sine = deviation * (1.0F - some * (1 / 6.0F));
    const Number cosine = 1.0F - some * (0.5F - some * (1 / 24.0F));
    Number across2 = towards.x * towards.x + towards.y * towards.y;
    across2 = across2 > kLeastAcross ? across2 : Number{} + kLeastAcross;
    Number across = across2;
    square_root(across);
    const Number slope = towards.z / across;
    const Number upper = cosine - sine * slope, lower = cosine + sine * slope;
    Number above, below;
    visible_share(facets, {upper * towards.x, upper * towards.y, cosine * towards.z + sine * across}, above);
    visible_share(facets, {lower * towards.x, lower * towards.y, cosine * towards.z - sine * across}, below);
    const Number sum = above + below;
    mean = 0.5F * sum;
    const Number excess = (above - below) / (sum > kLeastShare ? sum : Number{} + kLeastShare);
    const Number rise = deviation * excess;
    store_part(Vector3<Number>{seen.x - rise * slope * towards.x, seen.y - rise * slope * towards.y,
                               seen.z + rise * across},
               first, node.seen);
    store_part(Number(variance * (1.0F - 0.5F * excess * excess)), first, node.variances);
}

// Returns whether all blobs of a part of the lanes are so far above the horizon that limit_blob() would
// change next to nothing.
template <class Number>
[[gnu::always_inline]] inline bool above_horizon(const Facets<float>& facets, std::size_t first,
                                                 const ReflectedNode& node) {
    Vector3<Number> towards;
    Number variance;
    load_part(node.towards, first, towards);
    load_part(node.variances, first, variance);
    const Number x = facets.alpha * towards.x, y = facets.alpha_y * towards.y;
    const Number across2 = towards.x * towards.x + towards.y * towards.y;
    const Number height = towards.z > 0.0F ? towards.z : Number{};
    const Number height2 = height * height;
    const Number straight = height2 * height2 * across2 - kCurved * variance * (x * x + y * y);
    const Number clear = height2 - kAbove * kAbove * variance;
    return all_lanes((straight < clear ? straight : clear) > 0.0F);
}

// Stores the weight of a node that is evaluated in its own direction. factor: weight there.
template <class Number>
[[gnu::always_inline]] inline void store_weight(const Facets<float>& facets, std::size_t first,
                                                const Number& factor, ReflectedNode& node) {
    if (above_horizon<Number>(facets, first, node)) {
        store_part(factor, first, node.weights);
        return;
    }
    Vector3<Number> towards;
    load_part(node.towards, first, towards);
    Number mean, there;
    limit_blob(facets, first, node, mean);
    visible_share(facets, towards, there);
    store_part(Number(factor * mean / (there > kLeastShare ? there : Number{} + kLeastShare)), first,
               node.weights);
}

}  // namespace

template <class Number>
[[gnu::always_inline]] inline ReflectedNodes::NodeFacets<Number> ReflectedNodes::reflect_part(
    const ReflectedNodes& r, const GridNodes& nodes, std::size_t first, ReflectedNode& out) {
    NodeFacets<Number> node;
    Number a, b, axis_x, axis_y, other_x, other_y, lobe, blob_x, blob_y;
    load_part(nodes.x, first, a);
    load_part(nodes.y, first, b);
    load_part(r.slopes_[0][0], first, axis_x);
    load_part(r.slopes_[0][1], first, axis_y);
    load_part(r.slopes_[1][0], first, other_x);
    load_part(r.slopes_[1][1], first, other_y);
    Vector3<Number> viewer;
    load_part(r.towards_viewer_, first, viewer);

    // A facet of these slopes, and what it mirrors to the viewer.
    Number middle_x, middle_y;
    load_part(r.middle_[0], first, middle_x);
    load_part(r.middle_[1], first, middle_y);
    const Number x = middle_x + axis_x * a + other_x * b;
    const Number y = middle_y + axis_y * a + other_y * b;
    const Vector3<Number> steep{r.deviations_.x * x, r.deviations_.y * y, Number{} + 1.0F};
    Number length = steep.x * steep.x + steep.y * steep.y + 1.0F;
    square_root(length);
    const Number cosine = 1.0F / length;
    const Vector3<Number> half{steep.x * cosine, steep.y * cosine, cosine};
    Number along;
    dot(viewer, half, along);
    const Vector3<Number> towards{2.0F * along * half.x - viewer.x, 2.0F * along * half.y - viewer.y,
                                  2.0F * along * half.z - viewer.z};
    store_part(towards, first, out.towards);

    // The nodes are those of the slopes that the viewer sees.
    Number rest_x, rest_y, narrowing;
    load_part(r.rests_[0], first, rest_x);
    load_part(r.rests_[1], first, rest_y);
    load_part(r.narrowing_, first, narrowing);
    rest_x *= a;
    rest_y *= b;
    Number moved = 0.5F * (rest_x * rest_x + rest_y * rest_y - x * x - y * y) - kMostMoved;
    moved = moved < 0.0F ? moved : Number{};
    moved = moved > -80.0F ? moved : Number{} - 80.0F;
    exponential(moved);
    load_part(nodes.weights, first, node.weight);
    node.x = x;
    node.y = y;
    node.factor = 4.0F * std::exp(kMostMoved) * narrowing * moved * length * node.weight *
                  (along > kLeastCosine ? along : Number{});

    // How a change of the slopes along the grid's x, and of both slopes, changes the direction, relative
    // to the same changes in the middle of the grid.
    const Number slope_x = r.deviations_.x * axis_x, slope_y = r.deviations_.y * axis_y;
    const Number rise = slope_x * half.x + slope_y * half.y;
    const Number turn = slope_x * viewer.x + slope_y * viewer.y - along * rise;
    Number way = turn * turn + along * along * (slope_x * slope_x + slope_y * slope_y - rise * rise);
    Number middle_way, middle_area;
    load_part(r.middle_way_, first, middle_way);
    load_part(r.middle_area_, first, middle_area);
    const Number least = Number{} + 1e-20F;
    way = cosine * cosine * (way > least ? way : least) / (middle_way > least ? middle_way : least);
    square_root(way);
    Number area = along * cosine * cosine * cosine / (middle_area > least ? middle_area : least);
    area = area > 0.0F ? area : Number{};
    load_part(r.lobes_, first, lobe);
    load_part(r.blob_x_, first, blob_x);
    load_part(r.blob_y_, first, blob_y);
    Number width_x, width_y;
    load_part(nodes.widths_x, first, width_x);
    load_part(nodes.widths_y, first, width_y);
    blob_x *= width_x * (1.0F + lobe * (way - 1.0F));
    blob_y *= width_y * (1.0F + lobe * (area / way - 1.0F));
    const Number blob = blob_x > blob_y ? blob_x : blob_y;
    store_part(Number(blob * blob), first, out.variances);

    Vector3<Number> move, other_move, shift;
    load_part(r.moves_[0], first, move);
    load_part(r.moves_[1], first, other_move);
    load_part(r.pixels_.shift, first, shift);
    store_part(Vector3<Number>{towards.x + shift.x + a * move.x + b * other_move.x,
                               towards.y + shift.y + a * move.y + b * other_move.y,
                               towards.z + shift.z + a * move.z + b * other_move.z},
               first, out.seen);
    return node;
}

template <class Number>
[[gnu::always_inline]] inline void ReflectedNodes::reflect(const ReflectedNodes& r, const GridNodes& nodes,
                                                           ReflectedNode& out) {
    const bool mirror = r.deviations_ == glm::vec2(0.0F);
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        const NodeFacets<Number> node = reflect_part<Number>(r, nodes, first, out);
        if (mirror) {  // its density is infinite, and no other facets hide what it shows
            store_part(node.weight, first, out.weights);
            continue;
        }
        Number inverse;
        sparsity(r.facets_, r.deviations_, node.x, node.y, inverse);
        store_weight(r.facets_, first, Number(node.factor * inverse), out);
    }
}

template <class Number>
[[gnu::always_inline]] inline void ReflectedNodes::reflect_pair(const ReflectedNodes& r,
                                                                const std::array<GridNodes, 2>& nodes,
                                                                ReflectedPair& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            ReflectedNode& node = out.nodes[n];
            const NodeFacets<Number> facets = reflect_part<Number>(r, nodes[n], first, node);
            Number share;
            if (above_horizon<Number>(r.facets_, first, node)) {
                Vector3<Number> towards;
                load_part(node.towards, first, towards);
                visible_share(r.facets_, towards, share);
            } else {
                limit_blob(r.facets_, first, node, share);
            }
            store_part(Number(facets.factor * share), first, node.weights);
        }
    }
}

template <class Number>
[[gnu::always_inline]] inline void ReflectedNodes::find_direction(const ReflectedNodes& r,
                                                                  const ReflectedPair& pair,
                                                                  const PairLight& light,
                                                                  PairDirection& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> one, two, lean, viewer;
        load_part(pair.nodes[0].towards, first, one);
        load_part(pair.nodes[1].towards, first, two);
        load_part(light.lean, first, lean);
        load_part(r.towards_viewer_, first, viewer);
        Number brightness, other;
        load_part(light.brightness[0], first, brightness);
        load_part(light.brightness[1], first, other);
        const Number both = brightness + other;
        const Number part = other / (both > 0.0F ? both : Number{} + 1.0F);
        const Vector3<Number> towards = normalized_or(
            Vector3<Number>{one.x + part * (two.x - one.x) + lean.x, one.y + part * (two.y - one.y) + lean.y,
                            one.z + part * (two.z - one.z) + lean.z},
            0.0F, Vector3<float>{0, 0, 1});
        store_part(towards, first, out.towards);

        const Vector3<Number> half{towards.x + viewer.x, towards.y + viewer.y, towards.z + viewer.z};
        Number length2, facets, share;
        dot(half, half, length2);
        density(r.facets_, half, length2, facets);
        visible_share(r.facets_, towards, share);
        facets *= share > kLeastShare ? share : Number{} + kLeastShare;
        store_part(Number(facets > 0.0F ? 1.0F / facets : Number{}), first, out.factors);
    }
}

ReflectedNodes::GridNodes ReflectedNodes::grid_nodes(std::size_t k) const {
    GridNodes nodes;
    if (one_grid_ && k < grids_[0]->size()) {
        const NodeGrid& grid = *grids_[0];
        nodes.x.value.fill(grid.x[k]);
        nodes.y.value.fill(grid.y[k]);
        nodes.weights.value.fill(share_ * grid.weights[k]);
        nodes.widths_x.value.fill(grid.widths_x[k]);
        nodes.widths_y.value.fill(grid.widths_y[k]);
        return nodes;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        const NodeGrid& grid = *grids_[i];
        const bool has = k < grid.size();
        const std::size_t own = has ? k : 0;
        nodes.x[i] = grid.x[own];
        nodes.y[i] = grid.y[own];
        nodes.weights[i] = has ? share_ * grid.weights[own] : 0.0F;
        nodes.widths_x[i] = grid.widths_x[own];
        nodes.widths_y[i] = grid.widths_y[own];
    }
    return nodes;
}

ReflectedNode ReflectedNodes::node(std::size_t k) const {
    const GridNodes nodes = grid_nodes(k);
    ReflectedNode out;
    dispatch<reflect<FourLanes>, reflect<EightLanes>, reflect<AllLanes>>(*this, nodes, out);
    return out;
}

ReflectedPair ReflectedNodes::pair(std::size_t k) const {
    const std::array nodes{grid_nodes(2 * k), grid_nodes(2 * k + 1)};
    ReflectedPair out;
    dispatch<reflect_pair<FourLanes>, reflect_pair<EightLanes>, reflect_pair<AllLanes>>(*this, nodes, out);
    return out;
}

PairDirection ReflectedNodes::direction_of(const ReflectedPair& pair, const PairLight& light) const {
    PairDirection out;
    dispatch<find_direction<FourLanes>, find_direction<EightLanes>, find_direction<AllLanes>>(*this, pair,
                                                                                              light, out);
    return out;
}

}  // namespace nicol
