// SPDX-License-Identifier: MIT
#include "shading/reflected_light.hpp"

#include <algorithm>
#include <vector>

#include "material/conductor.hpp"
#include "polarization/lane_points.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_parts.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Computes the cosine and sine of twice the angle between (x, y), of any length but 0, and the x axis.
template <class Number>
[[gnu::always_inline]] inline void twice_the_angle(const Number& x, const Number& y, Number& cosine,
                                                   Number& sine) {
    const Number inverse = 1.0F / (x * x + y * y);
    cosine = (x * x - y * y) * inverse;
    sine = 2.0F * x * y * inverse;
}

// Computes the axes with x nearest to the unit `along`; leaves x unchanged if `along` is parallel to n.
template <class Number>
[[gnu::always_inline]] inline void axes_along(const Vector3<Number>& along, const Vector3<Number>& n,
                                              Vector3<Number>& x, Vector3<Number>& y) {
    Number number;
    dot(along, n, number);
    x = normalized_or(minus_scaled(along, number, n), 1e-10F, x);
    y = cross(n, x);
}

struct LitFrames {
    LaneFrames& frames;
    const LaneVectors* along;  // tangents; null: any axes are valid
    LaneVectors& towards_viewer;
    Lanes& frame_cosine;
    Lanes& frame_sine;
};

template <class Number, class Sights>
[[gnu::always_inline]] inline void find_frames(const Sights& sights, const LanePoints& positions,
                                               const LitFrames& points) {
    // Double precision is needed because the difference of two positions loses digits.
    LaneVectors towards;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Vector3<float> w = sight_at(sights, positions, i);
        towards.x.value[i] = w.x;
        towards.y.value[i] = w.y;
        towards.z.value[i] = w.z;
    }
    const auto x_axes = frame_x(sights);
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> n, x_axis, y_axis;
        load_part(points.frames.z, first, n);
        some_axes(n, x_axis, y_axis);
        if (points.along != nullptr) {
            Vector3<Number> tangent;
            load_part(*points.along, first, tangent);
            axes_along(tangent, n, x_axis, y_axis);
        }
        store_part(x_axis, first, points.frames.x);
        store_part(y_axis, first, points.frames.y);

        Vector3<Number> w;
        load_part(towards, first, w);
        const Vector3<Number> viewer = along(points.frames, first, w);
        store_part(viewer, first, points.towards_viewer);
        const Vector3<Number> x =
            in_frame(theta_phi_axes(viewer), along(points.frames, first, x_axes.at(first, w)));
        Number cosine;
        Number sine;
        twice_the_angle(x.x, x.y, cosine, sine);
        store_part(cosine, first, points.frame_cosine);
        store_part(sine, first, points.frame_sine);
    }
}

// Rotations from the light's frames to the theta-phi frames.
struct Rotations {
    Lanes cosine, sine;
};

// Computes the rotations from axes in the surfaces' frames.
template <class Number>
[[gnu::always_inline]] inline void find_rotations(const LaneVectors& towards_light, const LaneVectors& x_axes,
                                                  Rotations& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> l, x_axis;
        load_part(towards_light, first, l);
        load_part(x_axes, first, x_axis);
        const Vector3<Number> x = in_frame(theta_phi_axes(Vector3<Number>{-l.x, -l.y, -l.z}), x_axis);
        Number cosine;
        Number sine;
        twice_the_angle<Number>(x.x, -x.y, cosine, sine);
        store_part(cosine, first, out.cosine);
        store_part(sine, first, out.sine);
    }
}

struct Reflection {
    std::span<const LaneMueller> terms;
    std::span<const float> weights;  // [channel][term]
    const LaneLight& light;
    const Rotations& rotations;  // unset if the light is unpolarized
    const LayerWeights* layer;
    const Lanes& scale;  // 0 for points without contribution
    const Lanes& frame_cosine;
    const Lanes& frame_sine;
};

// Rotates (s1, s2) into a frame that is rotated by half of the given angle.
template <class Number>
[[gnu::always_inline]] inline void rotate(const Lanes& cosine, const Lanes& sine, std::size_t first,
                                          Number& s1, Number& s2) {
    Number c;
    Number s;
    load_part(cosine, first, c);
    load_part(sine, first, s);
    const Number former = s1;
    s1 = c * former + s * s2;
    s2 = c * s2 - s * former;
}

template <class Number>
[[gnu::always_inline]] inline void add_lanes(const Reflection& r, std::span<std::array<Lanes, 4>> out) {
    const std::size_t components = r.light.components;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number scale;
        load_part(r.scale, first, scale);
        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            const std::array<Lanes, 4>& irradiance =
                r.light.irradiance[r.light.irradiance.size() == 1 ? 0 : channel];
            std::array<Number, 4> incident{};
            for (std::size_t q = 0; q < components; ++q) load_part(irradiance[q], first, incident[q]);
            if (components > 1) rotate(r.rotations.cosine, r.rotations.sine, first, incident[1], incident[2]);

            std::array<Number, 4> sum{};
            for (std::size_t t = 0; t < r.terms.size(); ++t) {
                const float weight = r.weights[channel * r.terms.size() + t];
                if (weight == 0) continue;
                for (std::size_t q = 0; q < components; ++q) {
                    const Number of_column = weight * incident[q];
                    for (std::size_t p = 0; p < 4; ++p) {
                        Number entry;
                        load_part(r.terms[t].m[4 * p + q], first, entry);
                        sum[p] += entry * of_column;
                    }
                }
            }
            rotate(r.frame_cosine, r.frame_sine, first, sum[1], sum[2]);

            Number factor = scale;
            if (r.layer != nullptr) {
                Number weight;
                load_part(r.layer->of(channel), first, weight);
                factor *= weight;
            }
            // Lanes that no light reaches may hold anything, infinities included.
            const auto lit = scale > 0.0F;
            for (std::size_t p = 0; p < 4; ++p) {
                Number total;
                load_part(out[channel][p], first, total);
                total += lit ? factor * sum[p] : Number{};
                store_part(total, first, out[channel][p]);
            }
        }
    }
}

// Computes the factors of the reflected light: 0 at points that reflect none. towards_light, towards_viewer:
// heights of unit directions over the surfaces. any: whether a factor is not 0.
template <class Number>
[[gnu::always_inline]] inline void find_scales(std::uint32_t points, const ScaleByCosine& by,
                                               const Lanes& towards_light, const Lanes& towards_viewer,
                                               Lanes& out, bool& any) {
    Lanes wanted;
    for (std::size_t i = 0; i < kLanes; ++i) wanted[i] = static_cast<float>(points >> i & 1);
    Number most{};
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number some, cosine, viewer;
        load_part(wanted, first, some);
        load_part(towards_light, first, cosine);
        load_part(towards_viewer, first, viewer);
        some = viewer > 0.0F ? some : Number{};
        const Number lit = cosine > 0.0F ? cosine : Number{};
        const Number scale = some * lit * (by.by_cosine + by.by_square * lit);
        store_part(scale, first, out);
        most += scale;
    }
    float sum = 0;
    for (std::size_t i = 0; i < kPart<Number>; ++i) sum += most[i];
    any = sum > 0;
}

}  // namespace

void ReflectedLight::set(const Views& views, std::span<const glm::vec3> positions,
                         std::span<const glm::vec3> normals, std::span<const glm::vec3> tangents) {
    for (std::size_t i = 0; i < kLanes; ++i) put(frames_.z, i, normals[i < normals.size() ? i : 0]);
    LaneVectors along;
    if (!tangents.empty())
        for (std::size_t i = 0; i < kLanes; ++i) put(along, i, tangents[i < tangents.size() ? i : 0]);
    const LitFrames frames{frames_, tangents.empty() ? nullptr : &along, towards_viewer_, frame_cosine_,
                           frame_sine_};
    with_sights(views, positions, [&]<class Sights>(const Sights& sights) {
        dispatch<find_frames<FourLanes, Sights>, find_frames<EightLanes, Sights>,
                 find_frames<AllLanes, Sights>>(sights, lane_points(positions), frames);
    });
}

std::uint32_t ReflectedLight::lit(const LaneLight& light) const {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const LaneVectors& normal = frames_.z;
        const float cosine = light.towards.x[i] * normal.x[i] + light.towards.y[i] * normal.y[i] +
                             light.towards.z[i] * normal.z[i];
        const bool above = cosine > 0 && towards_viewer_.z[i] > 0;
        out |= (above ? 1U : 0U) << i;
    }
    return out & light.points;
}

template <class Has>
std::span<const float> ReflectedLight::weights_of(const Material& material, std::size_t channels,
                                                  const Has& has) {
    const auto terms = static_cast<std::size_t>(material.terms());
    const std::span<float> out = work_space<ReflectedLight, float>(terms * channels);
    for (std::size_t t = 0; t < terms; ++t) {
        const int term = static_cast<int>(t);
        const bool some = has(term);
        for (std::size_t channel = 0; channel < channels; ++channel) {
            const int own = static_cast<int>(channel) % material.channels();
            out[channel * terms + t] = some ? static_cast<float>(material.weight(term, own)) : 0.0F;
        }
    }
    return out;
}

void ReflectedLight::add(const Material& material, const LayerWeights* weights, const LaneLight& light,
                         std::uint32_t points, float factor, std::span<std::array<Lanes, 4>> out,
                         SampledTerms find_it, bool all_sampled_find_it) const {
    const auto has = [&](int term) {
        return !material.smooth(term) && !(all_sampled_find_it ? is_sampled(material, term, find_it)
                                                               : finds_lights(material, term, find_it));
    };
    add_terms({material, weights_of(material, out.size(), has)}, weights, light, directions_of(light), points,
              {.by_cosine = factor, .by_square = 0}, out);
}

std::span<const Lobe> ReflectedLight::sampled_lobes(const Material& material, SampledTerms sampled) {
    thread_local std::vector<Lobe> lobes;
    lobes.clear();
    for (int term = 0; term < material.terms(); ++term) {
        if (material.smooth(term) || !is_sampled(material, term, sampled)) continue;
        const Lobe lobe = material.lobe(term);
        if (std::ranges::find(lobes, lobe) == lobes.end()) lobes.push_back(lobe);
    }
    return lobes;
}

WeightedTerms ReflectedLight::sampled_terms(const Material& material, SampledTerms sampled, const Lobe& lobe,
                                            std::size_t channels) {
    const auto has = [&](int term) {
        return is_sampled(material, term, sampled) && material.lobe(term) == lobe;
    };
    return {material, weights_of(material, channels, has)};
}

void ReflectedLight::add_sampled(const WeightedTerms& terms, const LayerWeights* weights,
                                 const LaneLight& light, std::uint32_t points,
                                 std::span<std::array<Lanes, 4>> out) const {
    add_terms(terms, weights, light, {light.towards, light.x}, points, {.by_cosine = 1, .by_square = 0}, out);
}

LaneVectors ReflectedLight::mirrored_directions() const {
    LaneVectors mirrored = towards_viewer_;
    for (std::size_t i = 0; i < kLanes; ++i) {
        mirrored.x[i] = -mirrored.x[i];
        mirrored.y[i] = -mirrored.y[i];
    }
    out_of_frames(frames_, mirrored, mirrored);
    return mirrored;
}

void ReflectedLight::add_mirrored(const Material& material, const LayerWeights* weights,
                                  const LaneLight& light, std::uint32_t points,
                                  std::span<std::array<Lanes, 4>> out) const {
    constexpr auto scale = static_cast<float>(kMirrorScale);
    const auto has = [&](int term) { return material.smooth(term); };
    add_terms({material, weights_of(material, out.size(), has)}, weights, light, directions_of(light), points,
              {.by_cosine = 0, .by_square = scale}, out);
}

ReflectedLight::Directions ReflectedLight::directions_of(const LaneLight& light) const {
    Directions out;
    into_frames(frames_, light.towards, out.towards);
    if (light.components > 1) into_frames(frames_, light.x, out.x);
    return out;
}

void ReflectedLight::add_terms(const WeightedTerms& terms, const LayerWeights* weights,
                               const LaneLight& light, const Directions& directions, std::uint32_t points,
                               const ScaleByCosine& scale_at, std::span<std::array<Lanes, 4>> out) const {
    points &= light.points;
    if (weights != nullptr) points &= weights->points;
    Lanes scale;
    bool any = false;
    dispatch<find_scales<FourLanes>, find_scales<EightLanes>, find_scales<AllLanes>>(
        points, scale_at, directions.towards.z, towards_viewer_.z, scale, any);
    if (!any) return;

    Rotations rotations;
    if (light.components > 1)
        dispatch<find_rotations<FourLanes>, find_rotations<EightLanes>, find_rotations<AllLanes>>(
            directions.towards, directions.x, rotations);
    const Material& material = terms.material;
    const std::span<LaneMueller> matrices =
        work_space<ReflectedLight, LaneMueller>(static_cast<std::size_t>(material.terms()));
    material.evaluate_lanes(directions.towards, towards_viewer_, light.components == 1 ? 1 : 4, matrices);
    dispatch<add_lanes<FourLanes>, add_lanes<EightLanes>, add_lanes<AllLanes>>(
        Reflection{matrices, terms.weights, light, rotations, weights, scale, frame_cosine_, frame_sine_},
        out);
}

}  // namespace nicol
