// SPDX-License-Identifier: MIT
#include "devices/cpu/lane_boundary.hpp"

#include "material/frames.hpp"
#include "polarization/fresnel.hpp"
#include "shading/ray_spread.hpp"
#include "simd/all_lanes.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Index of the far side relative to the ray's, as Fresnel's formulas need it, on the outside and the inside.
template <class Real>
struct Sides {
    bool slab;
    std::array<Real, 2> eta;
    std::array<RelativeIndex<Real>, 2> index;
};

template <class Real>
Sides<Real> sides_of(const SmoothBoundary& boundary) {
    const bool slab = boundary.behind == SmoothBoundary::Behind::slab;
    const double outside = boundary.eta, inside = slab ? boundary.eta : 1 / boundary.eta;
    return {.slab = slab,
            .eta = {static_cast<Real>(outside), static_cast<Real>(inside)},
            .index = {RelativeIndex<Real>(outside), RelativeIndex<Real>(inside)}};
}

// Directions of the light that a boundary sends against a ray.
template <class Number>
struct Directions {
    Number cosine, square, root;  // root: eta times the cosine of refraction
    Vector3<Number> reflected, transmitted;
};

template <class Number>
[[gnu::always_inline]] inline Vector3<Number> sum(const Vector3<Number>& a, const Number& factor,
                                                  const Vector3<Number>& b) {
    return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

template <class Number>
[[gnu::always_inline]] inline Directions<Number> directions_at(const Number& eta, bool slab,
                                                               const Vector3<Number>& normal,
                                                               const Vector3<Number>& ray) {
    Directions<Number> out;
    dot(normal, ray, out.cosine);
    out.cosine = -out.cosine;
    const Number one = Number{} + 1.0;
    out.cosine = out.cosine < 1.0 ? out.cosine : one;
    out.square = eta * eta - 1.0 + out.cosine * out.cosine;
    out.root = out.square > 0.0 ? out.square : Number{};
    square_root(out.root);
    out.reflected = normalized_or(sum(ray, Number(2.0 * out.cosine), normal), 0.0F, ray);
    // Snell's law.
    out.transmitted = slab ? ray : normalized_or(sum(ray, Number(out.cosine - out.root), normal), 0.0F, ray);
    return out;
}

template <class Number>
[[gnu::always_inline]] inline void store_block(const ReflectionBlock<Number>& block, std::size_t first,
                                               std::array<Lanes, 4>& out) {
    store_part(block.a, first, out[0]);
    store_part(block.b, first, out[1]);
    store_part(block.c, first, out[2]);
    store_part(block.d, first, out[3]);
}

// Returns fresnel_transmission() as a block.
template <class Number, class Real>
[[gnu::always_inline]] inline ReflectionBlock<Number> transmission_block(const Number& cosine,
                                                                         const RelativeIndex<Real>& index) {
    ReflectionBlock<Number> out{};
    dielectric_transmission(cosine, index, out.a, out.b);
    out.c = (out.a + out.b) * (out.a - out.b);
    out.c = out.c > 0.0 ? out.c : Number{};
    square_root(out.c);
    return out;
}

template <class Condition, class Number>
[[gnu::always_inline]] inline ReflectionBlock<Number> choose(const Condition& condition,
                                                             const ReflectionBlock<Number>& a,
                                                             const ReflectionBlock<Number>& b) {
    return {condition ? a.a : b.a, condition ? a.b : b.b, condition ? a.c : b.c, condition ? a.d : b.d};
}

// Squared sine of the angle to the normal below which a ray counts as along it: rounding decides the
// direction of a smaller product of floats.
constexpr float kAlong = 1e-8F;

// Determines whether floats are good enough for all triangles: whether none has edges whose squares leave
// their range, nor is so narrow that its area is their rounding.
template <class Number>
[[gnu::always_inline]] inline void find_even(const LaneTriangles& triangles, bool& even) {
    constexpr float narrow = 1e-5F, small = 1e-30F, large = 1e30F;
    even = true;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        const Edges<Number> edges = edges_of<Number>(triangles.corners, first);
        const Vector3<Number> area = cross(edges.second, edges.third);
        Number a, b, c;
        dot(area, area, a);
        dot(edges.second, edges.second, b);
        dot(edges.third, edges.third, c);
        const Number both = b * c;
        even = even && all_lanes(a > narrow * both) && all_lanes(both > small) && all_lanes(both < large);
    }
}

template <class Number, class Real>
[[gnu::always_inline]] inline void split_all(const Sides<Real>& sides, const BoundaryHits& hits,
                                             LaneSplit& out) {
    const Number one = Number{} + 1.0;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        const auto load = [first](const LaneVectors& from) __attribute__((always_inline)) {
            Vector3<Number> to;
            load_part(from, first, to);
            return to;
        };
        const Vector3<Number> ray = load(hits.directions), received = load(hits.received_x);
        Number distance, b1, b2;
        load_part(hits.distances, first, distance);
        load_part(hits.b1, first, b1);
        load_part(hits.b2, first, b2);
        const Edges<Number> edges = edges_of<Number>(hits.triangles.corners, first);
        const Edges<Number> bent = edges_of<Number>(hits.triangles.normals, first);
        const Vector3<Number> position =
            sum(sum(load(hits.triangles.corners[0]), b1, edges.second), b2, edges.third);
        store_part(position, first, out.positions);
        const Vector3<Number> facet = normalized_or(cross(edges.second, edges.third), 0.0F, ray);
        store_part(facet, first, out.facets);
        const Vector3<Number> normal = normalized_or(
            sum(sum(load(hits.triangles.normals[0]), b1, bent.second), b2, bent.third), 0.0F, facet);

        // The interpolated normal says which side of the triangle is its front, as for viewed_side().
        Number agreement, seen;
        dot(facet, normal, agreement);
        dot(facet, ray, seen);
        const Number of_front = agreement < 0.0 ? -one : one;
        const auto inside = of_front * seen > 0.0, outside = of_front * seen <= 0.0;
        const Number sign = inside ? -one : one;
        const Number turned = of_front * sign;
        const Vector3<Number> side{turned * facet.x, turned * facet.y, turned * facet.z};
        const Vector3<Number> smooth{sign * normal.x, sign * normal.y, sign * normal.z};
        const Number eta = inside ? Number{} + sides.eta[1] : Number{} + sides.eta[0];
        Directions<Number> along = directions_at(eta, sides.slab, smooth, ray);
        // An interpolated normal may point a reflection into the surface.
        Number up, down;
        dot(along.reflected, side, up);
        dot(along.transmitted, side, down);
        down = along.square > 0.0 ? down : -one;
        Number consistent = along.cosine > 0.0 ? one : Number{};
        consistent = up > 0.0 ? consistent : Number{};
        consistent = down < 0.0 ? consistent : Number{};
        const auto regular = consistent > 0.0;
        Vector3<Number> facing = smooth;
        if (!all_lanes(regular)) {
            const Directions<Number> by_facet = directions_at(eta, sides.slab, side, ray);
            facing = choose(regular, smooth, side);
            along = {regular ? along.cosine : by_facet.cosine, regular ? along.square : by_facet.square,
                     regular ? along.root : by_facet.root,
                     choose(regular, along.reflected, by_facet.reflected),
                     choose(regular, along.transmitted, by_facet.transmitted)};
        }
        const Number cosine = along.cosine, root = along.root, square = along.square;
        store_part(along.reflected, first, out.reflected.towards_light);
        store_part(along.transmitted, first, out.transmitted.towards_light);
        store_part(cosine, first, out.cosines);
        store_part(Number(inside ? one : Number{}), first, out.inside);
        const Number scale = sides.slab ? one : 1.0 / (eta * eta);
        store_part(scale, first, out.radiance_scale);

        ReflectionBlock<Number> reflection, transmission;
        // Rays of one beam are mostly on one side.
        const bool all_inside = all_lanes(inside);
        if (all_inside || all_lanes(outside)) {
            const RelativeIndex<Real>& index = sides.index[all_inside ? 1 : 0];
            reflection = dielectric_reflection(cosine, index);
            transmission = transmission_block(cosine, index);
        } else {
            reflection = choose(inside, dielectric_reflection(cosine, sides.index[1]),
                                dielectric_reflection(cosine, sides.index[0]));
            transmission = choose(inside, transmission_block(cosine, sides.index[1]),
                                  transmission_block(cosine, sides.index[0]));
        }
        if (sides.slab) {
            const auto enters = transmission.a > 0.0;
            const SlabBlocks<Number> both = slab_blocks(reflection);
            reflection = choose(enters, both.reflection, reflection);
            transmission = choose(enters, both.transmission, ReflectionBlock<Number>{});
        }
        store_block(reflection, first, out.reflected.block);
        store_block(transmission, first, out.transmitted.block);

        // The plane of incidence, or any plane that contains a ray along the normal.
        const Vector3<Number> viewer{-ray.x, -ray.y, -ray.z};
        const Vector3<Number> s_axis = normalized_or(cross(facing, viewer), kAlong, received);
        store_part(s_axis, first, out.s_axes);
        Number c, s;
        dot(received, s_axis, c);
        dot(received, cross(viewer, s_axis), s);
        const Number both = 1.0 / (c * c + s * s);
        store_part(Number((c * c - s * s) * both), first, out.cosine2);
        store_part(Number(2.0 * c * s * both), first, out.sine2);

        Number backward;
        dot(facing, normal, backward);
        const Number bend_sign = backward < 0.0 ? -one : one;
        for (std::size_t i = 0; i < 2; ++i) {
            const Vector3<Number> change = load(hits.changes[i]);
            const Vector3<Number> place = moved_to(ray, distance, facet, change, load(hits.places[i]));
            store_part(place, first, out.places[i]);
            const Vector3<Number> along_normal = bend(edges, bent, place, normal);
            const Vector3<Number> bent_by{bend_sign * along_normal.x, bend_sign * along_normal.y,
                                          bend_sign * along_normal.z};
            store_part(reflected_change(ray, facing, bent_by, change), first, out.reflected.changes[i]);
            const Vector3<Number> refracted =
                sides.slab ? change : refracted_change(ray, facing, bent_by, eta, root, change);
            store_part(choose(square > 0.0, refracted, change), first, out.transmitted.changes[i]);
        }
    }
}

void take_block(const Mueller& from, std::size_t lane, std::array<Lanes, 4>& out) {
    out[0][lane] = static_cast<float>(from(0, 0));
    out[1][lane] = static_cast<float>(from(0, 1));
    out[2][lane] = static_cast<float>(from(2, 2));
    out[3][lane] = static_cast<float>(from(3, 2));
}

// Takes what of(cosine, inside) returns.
template <class Split>
void take_film(const Split& of, LaneSplit& out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const SlabSplit split = of(static_cast<double>(out.cosines[i]), out.inside[i] > 0);
        take_block(split.reflection, i, out.reflected.block);
        take_block(split.transmission, i, out.transmitted.block);
    }
}

}  // namespace

void split_lanes(const SmoothBoundary& boundary, const BoundaryHits& hits, LaneSplit& out) {
    bool even;
    dispatch<find_even<FourLanes>, find_even<EightLanes>, find_even<AllLanes>>(hits.triangles, even);
    if (even)
        dispatch<split_all<FourLanes, float>, split_all<EightLanes, float>, split_all<AllLanes, float>>(
            sides_of<float>(boundary), hits, out);
    else
        dispatch<split_all<TwoDoubles, double>, split_all<FourDoubles, double>,
                 split_all<EightDoubles, double>>(sides_of<double>(boundary), hits, out);
    if (boundary.film)
        take_film([&](double cosine, bool inside) { return mean_split_of(boundary, cosine, inside); }, out);
}

void take_channel(const SmoothBoundary& boundary, int channel, LaneSplit& split) {
    take_film([&](double cosine, bool inside) { return split_of(boundary, cosine, inside, channel); }, split);
}

}  // namespace nicol
