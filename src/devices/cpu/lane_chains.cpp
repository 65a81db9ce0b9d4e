// SPDX-License-Identifier: MIT
#include "devices/cpu/lane_chains.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "material/reflectance.hpp"
#include "shading/light_samples.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

template <class Number>
[[gnu::always_inline]] inline Vector3<Number> in_lanes(const glm::dvec3& v) {
    return {Number{} + v.x, Number{} + v.y, Number{} + v.z};
}

template <class Number>
[[gnu::always_inline]] inline Vector3<Number> plus(const Vector3<Number>& a, const Vector3<Number>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

// Clamps x to 0 to `most`.
template <class Number>
[[gnu::always_inline]] inline void clamp_to(const Number& most, Number& x) {
    x = x > 0.0 ? x : Number{};
    x = x < most ? x : most;
}

template <class Number>
[[gnu::always_inline]] inline void begin_all(const ChainSamples& samples, LaneChains& out, Lanes& along) {
    const Projection& projection = samples.projection;
    const Viewpoint& view = projection.view;
    const CameraAxes camera = view.axes();
    const double size = projection.sample_size * std::sqrt(samples.weight);
    const std::array steps{2 * size * projection.half_width / samples.width * view.right,
                           -2 * size * projection.half_height / samples.height * view.up};
    const double by_x = 2.0 / samples.width * projection.half_width;
    const double by_y = -2.0 / samples.height * projection.half_height;
    const double at_x = (projection.shift.x - 1) * projection.half_width;
    const double at_y = (projection.shift.y + 1) * projection.half_height;
    const Number one = Number{} + 1.0;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number x, y;
        load_vector(samples.x.data() + first, x);
        load_vector(samples.y.data() + first, y);
        x = at_x + by_x * x;
        y = at_y + by_y * y;
        const Vector3<Number> beside{x * view.right.x + y * view.up.x, x * view.right.y + y * view.up.y,
                                     x * view.right.z + y * view.up.z};
        const Vector3<Number> eye = in_lanes<Number>(view.eye), forward = in_lanes<Number>(view.forward);
        const Vector3<Number> origin = view.orthographic ? plus(eye, beside) : eye;
        const Vector3<Number> ray =
            view.orthographic ? forward : normalized_or(plus(forward, beside), 0.0F, forward);
        store_part(origin, first, out.origins);
        store_part(ray, first, out.rays.directions);
        const Vector3<Number> received{-ray.x, -ray.y, -ray.z};
        const Vector3<Number> frame_x = camera_x(camera.up, camera.right, received);
        store_part(normalized_or(frame_x, 0.0F, camera.right), first, out.rays.received_x);
        Number ahead;
        dot(ray, forward, ahead);
        for (std::size_t i = 0; i < 2; ++i) {
            const Vector3<Number> step = in_lanes<Number>(steps[i]);
            Number rise;
            dot(step, ray, rise);
            const Vector3<Number> across = minus_scaled(step, rise, ray);
            const Vector3<Number> none{};
            const Vector3<Number> turned{ahead * across.x, ahead * across.y, ahead * across.z};
            store_part(view.orthographic ? across : none, first, out.rays.places[i]);
            store_part(view.orthographic ? none : turned, first, out.rays.changes[i]);
        }

        // The points of the triangles that the rays meet, inside the triangles.
        const Edges<Number> edges = edges_of<Number>(samples.triangles.corners, first);
        Vector3<Number> corner;
        load_part(samples.triangles.corners[0], first, corner);
        const Vector3<Number> begin = minus_scaled(origin, one, corner);
        const Vector3<Number> across = cross(ray, edges.third), beneath = cross(begin, edges.second);
        Number determinant, b1, b2, distance;
        dot(edges.second, across, determinant);
        const auto runs_along = determinant == 0.0;
        store_part(Number(runs_along ? one : Number{}), first, along);
        const Number inverse = 1.0 / (runs_along ? one : determinant);
        dot(begin, across, b1);
        dot(ray, beneath, b2);
        dot(edges.third, beneath, distance);
        b1 *= inverse;
        b2 *= inverse;
        clamp_to(one, b1);
        clamp_to(Number(1.0 - b1), b2);
        distance *= inverse;
        store_part(b1, first, out.rays.b1);
        store_part(b2, first, out.rays.b2);
        store_part(Number(distance > 0.0 ? distance : Number{}), first, out.rays.distances);
    }
}

// Loads a where `first_chosen` is 1, and b where it is 0.
template <class Number>
[[gnu::always_inline]] inline void choose_part(const Lanes& a, const Lanes& b, const Number& first_chosen,
                                               std::size_t first, Number& to) {
    Number of_a, of_b;
    load_part(a, first, of_a);
    load_part(b, first, of_b);
    to = first_chosen > 0.5F ? of_a : of_b;
}
template <class Number>
[[gnu::always_inline]] inline void choose_part(const LaneVectors& a, const LaneVectors& b,
                                               const Number& first_chosen, std::size_t first,
                                               Vector3<Number>& to) {
    choose_part(a.x, b.x, first_chosen, first, to.x);
    choose_part(a.y, b.y, first_chosen, first, to.y);
    choose_part(a.z, b.z, first_chosen, first, to.z);
}

template <class Number>
[[gnu::always_inline]] inline void continue_all(const LaneChains& from, const LaneSplit& split,
                                                const LaneChoice& choice, LaneChains& out, Lanes& outside) {
    const LanePart &r = split.reflected, &t = split.transmitted;
    const auto of_reflected = static_cast<float>(choice.reflectance);
    const auto of_transmitted = static_cast<float>(choice.transmittance);
    const Number one = Number{} + 1.0F;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number reflects, probability, scale;
        load_part(choice.reflects, first, reflects);
        load_part(choice.probabilities, first, probability);
        load_part(split.radiance_scale, first, scale);
        scale = reflects > 0.5F ? one : scale;
        Vector3<Number> direction;
        choose_part(r.towards_light, t.towards_light, reflects, first, direction);
        store_part(direction, first, out.rays.directions);

        // The start is beside the triangle, on the side of the ray, see leaving().
        Vector3<Number> facet, position, corner;
        load_part(split.facets, first, facet);
        load_part(split.positions, first, position);
        Number offset{}, side;
        for (const LaneVectors& corners : from.rays.triangles.corners) {
            load_part(corners, first, corner);
            raise(corner, offset);
        }
        offset *= static_cast<float>(kRayOffset);
        dot(facet, direction, side);
        store_part(Number(side > 0.0F ? one : Number{}), first, outside);
        const Number back = side < 0.0F ? offset : -offset;
        store_part(minus_scaled(position, back, facet), first, out.origins);

        Vector3<Number> s_axis;
        load_part(split.s_axes, first, s_axis);
        store_part(s_axis, first, out.rays.received_x);
        for (std::size_t i = 0; i < 2; ++i) {
            Vector3<Number> place, change;
            load_part(split.places[i], first, place);
            store_part(place, first, out.rays.places[i]);
            choose_part(r.changes[i], t.changes[i], reflects, first, change);
            store_part(change, first, out.rays.changes[i]);
        }

        Number a, b, c, d, carried;
        choose_part(r.block[0], t.block[0], reflects, first, a);
        choose_part(r.block[1], t.block[1], reflects, first, b);
        choose_part(r.block[2], t.block[2], reflects, first, c);
        choose_part(r.block[3], t.block[3], reflects, first, d);
        load_part(from.carried, first, carried);
        const Number factor = reflects > 0.5F ? Number{} + of_reflected : Number{} + of_transmitted;
        store_part(Number(carried * factor * a / probability), first, out.carried);
        a *= scale;
        b *= scale;
        c *= scale;
        d *= scale;
        Number cosine, sine;
        load_part(split.cosine2, first, cosine);
        load_part(split.sine2, first, sine);
        for (std::size_t row = 0; row < 16; row += 4) {
            Number s0, s1, s2, s3;
            load_part(from.matrices[row], first, s0);
            load_part(from.matrices[row + 1], first, s1);
            load_part(from.matrices[row + 2], first, s2);
            load_part(from.matrices[row + 3], first, s3);
            const Number along = cosine * s1 - sine * s2, across = sine * s1 + cosine * s2;
            store_part(Number(a * s0 + b * along), first, out.matrices[row]);
            store_part(Number(b * s0 + a * along), first, out.matrices[row + 1]);
            store_part(Number(c * across + d * s3), first, out.matrices[row + 2]);
            store_part(Number(c * s3 - d * across), first, out.matrices[row + 3]);
        }
    }
}

template <class Number>
[[gnu::always_inline]] inline void scale_all(const Lanes& from, const LaneChoice& choice, float of_reflected,
                                             float of_transmitted, Lanes& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number factor, reflects, probability;
        load_part(from, first, factor);
        load_part(choice.reflects, first, reflects);
        load_part(choice.probabilities, first, probability);
        factor *= reflects > 0.5F ? Number{} + of_reflected : Number{} + of_transmitted;
        store_part(Number(factor / probability), first, out);
    }
}

[[gnu::always_inline]] inline void seed_all(const std::array<std::uint32_t, kLanes>& from,
                                            const Lanes& reflects, std::uint32_t onward,
                                            std::array<std::uint32_t, kLanes>& out) {
    for (std::size_t i = 0; i < kLanes; ++i)
        out[i] = sample_seed(from[i], onward + (reflects[i] > 0.5F ? 1U : 0U));
}

template <class Number>
[[gnu::always_inline]] inline void find_all(const LaneChains& chains, const glm::mat3& to_light,
                                            LaneSky& out) {
    const auto turned = [&to_light](const Vector3<Number>& v) __attribute__((always_inline)) {
        return Vector3<Number>{to_light[0].x * v.x + to_light[1].x * v.y + to_light[2].x * v.z,
                               to_light[0].y * v.x + to_light[1].y * v.y + to_light[2].y * v.z,
                               to_light[0].z * v.x + to_light[1].z * v.y + to_light[2].z * v.z};
    };
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> direction, x, right, down;
        load_part(chains.rays.directions, first, direction);
        load_part(chains.rays.received_x, first, x);
        store_part(turned(direction), first, out.directions);
        store_part(turned(x), first, out.x);
        load_part(chains.rays.changes[0], first, right);
        load_part(chains.rays.changes[1], first, down);
        Number of_right, of_down;
        dot(right, right, of_right);
        dot(down, down, of_down);
        store_part(Number((of_right + of_down) * (1 / 24.0F)), first,
                   out.variances);  // RaySpread::variance()
    }
}

// Adds light that the chains which `some` marks by 1 find.
template <class Number>
[[gnu::always_inline]] inline void add_all(const LaneChains& chains, const Lanes& some, const LaneSky& sky,
                                           const LaneLight& light, float scale, std::size_t components,
                                           std::span<std::array<Lanes, 4>> sums) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number reached;
        load_part(some, first, reached);
        const auto lit = reached > 0.5F;
        // From the light's frame into that of the chain: both have z along the light.
        Number cosine = Number{} + 1.0F, sine{};
        if (light.components > 1) {
            Vector3<Number> towards, own, x;
            load_part(light.towards, first, towards);
            load_part(sky.x, first, own);
            load_part(light.x, first, x);
            Number c, s;
            dot(own, x, c);
            dot(own, cross(x, towards), s);
            cosine = c * c - s * s;
            sine = 2.0F * c * s;
        }
        for (std::size_t channel = 0; channel < sums.size(); ++channel) {
            const std::array<Lanes, 4>& of = light.irradiance[light.irradiance.size() == 1 ? 0 : channel];
            Number factor;
            load_part(chains.factors[channel], first, factor);
            factor *= scale;
            std::array<Number, 4> arriving{};
            for (std::size_t q = 0; q < light.components; ++q) load_part(of[q], first, arriving[q]);
            const Number along = cosine * arriving[1] + sine * arriving[2];
            arriving[2] = cosine * arriving[2] - sine * arriving[1];
            arriving[1] = along;
            for (std::size_t p = 0; p < components; ++p) {
                Number sum{}, entry, total;
                for (std::size_t q = 0; q < light.components; ++q) {
                    load_part(chains.matrices[4 * p + q], first, entry);
                    sum += entry * arriving[q];
                }
                load_part(sums[channel][p], first, total);
                total += lit ? factor * sum : Number{};
                store_part(total, first, sums[channel][p]);
            }
        }
    }
}

// Returns the bits of lanes that are not 0.
std::uint32_t bits_of(const Lanes& lanes) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) out |= (lanes[i] != 0 ? 1U : 0U) << i;
    return out;
}

}  // namespace

std::uint32_t begin_chains(const ChainSamples& samples, LaneChains& out) {
    Lanes along;
    dispatch<begin_all<TwoDoubles>, begin_all<FourDoubles>, begin_all<EightDoubles>>(samples, out, along);
    out.rays.triangles = samples.triangles;
    out.carried.value.fill(1);
    for (std::size_t i = 0; i < out.matrices.size(); ++i)
        out.matrices[i].value.fill(i % 5 == 0 ? static_cast<float>(samples.weight) : 0.0F);
    return bits_of(along);
}

void continue_factors(const LaneChains& from, const SmoothBoundary& boundary, const LaneChoice& choice,
                      std::uint32_t onward, LaneChains& out) {
    dispatch<seed_all>(from.seeds, choice.reflects, onward, out.seeds);
    out.factors.resize(from.factors.size());
    for (std::size_t c = 0; c < out.factors.size(); ++c) {
        const auto channel = static_cast<int>(c);
        dispatch<scale_all<FourLanes>, scale_all<EightLanes>, scale_all<AllLanes>>(
            from.factors[c], choice, static_cast<float>(of_channel(boundary.reflectance, channel)),
            static_cast<float>(of_channel(boundary.transmittance, channel)), out.factors[c]);
    }
}

std::uint32_t continue_chains(const LaneChains& from, const LaneSplit& split, const LaneChoice& choice,
                              LaneChains& out) {
    Lanes outside;
    dispatch<continue_all<FourLanes>, continue_all<EightLanes>, continue_all<AllLanes>>(from, split, choice,
                                                                                        out, outside);
    return bits_of(outside);
}

void find_sky(const LaneChains& chains, const glm::mat3& to_light, LaneSky& out) {
    dispatch<find_all<FourLanes>, find_all<EightLanes>, find_all<AllLanes>>(chains, to_light, out);
}

void add_light(const LaneChains& chains, std::uint32_t some, const LaneSky& sky, const LaneLight& light,
               float scale, std::size_t components, std::span<std::array<Lanes, 4>> sums) {
    Lanes reached;
    for (std::size_t i = 0; i < kLanes; ++i) reached[i] = static_cast<float>(some >> i & 1);
    dispatch<add_all<FourLanes>, add_all<EightLanes>, add_all<AllLanes>>(chains, reached, sky, light, scale,
                                                                         components, sums);
}

RayPacket packet_of(const LaneChains& chains) {
    RayPacket out{.origin_x = chains.origins.x.value,
                  .origin_y = chains.origins.y.value,
                  .origin_z = chains.origins.z.value,
                  .direction_x = chains.rays.directions.x.value,
                  .direction_y = chains.rays.directions.y.value,
                  .direction_z = chains.rays.directions.z.value,
                  .farthest = {}};
    out.farthest.fill(std::numeric_limits<float>::max());
    return out;
}

}  // namespace nicol
