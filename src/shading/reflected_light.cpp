// SPDX-License-Identifier: MIT
#include "shading/reflected_light.hpp"

#include <numbers>

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

template <class Number>
[[gnu::always_inline]] inline Vector3<Number> along(const LaneVectors& x, const LaneVectors& y,
                                                    const LaneVectors& z, std::size_t first,
                                                    const Vector3<Number>& v) {
    Vector3<Number> axis;
    Vector3<Number> out;
    load_part(x, first, axis);
    dot(axis, v, out.x);
    load_part(y, first, axis);
    dot(axis, v, out.y);
    load_part(z, first, axis);
    dot(axis, v, out.z);
    return out;
}

// Computes axes of a surface's frame by Duff et al. 2017, which needs neither a root nor a branch.
template <class Number>
[[gnu::always_inline]] inline void some_axes(const Vector3<Number>& n, Vector3<Number>& x,
                                             Vector3<Number>& y) {
    const Number sign = n.z < 0.0F ? Number{} - 1.0F : Number{} + 1.0F;
    const Number a = -1.0F / (sign + n.z);
    const Number b = n.x * n.y * a;
    x = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
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
    LaneVectors& tangent;
    LaneVectors& bitangent;
    const LaneVectors& normal;
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
        load_part(points.normal, first, n);
        some_axes(n, x_axis, y_axis);
        if (points.along != nullptr) {
            Vector3<Number> tangent;
            load_part(*points.along, first, tangent);
            axes_along(tangent, n, x_axis, y_axis);
        }
        store_part(x_axis, first, points.tangent);
        store_part(y_axis, first, points.bitangent);

        Vector3<Number> w;
        load_part(towards, first, w);
        const Vector3<Number> viewer = along(points.tangent, points.bitangent, points.normal, first, w);
        store_part(viewer, first, points.towards_viewer);
        const Vector3<Number> x =
            in_frame(theta_phi_axes(viewer),
                     along(points.tangent, points.bitangent, points.normal, first, x_axes.at(first, w)));
        Number cosine;
        Number sine;
        twice_the_angle(x.x, x.y, cosine, sine);
        store_part(cosine, first, points.frame_cosine);
        store_part(sine, first, points.frame_sine);
    }
}

// Directions towards the light in the surfaces' frames, and rotation from the light's frames to the theta-phi
// frames.
struct Incidence {
    LaneVectors towards_light;
    Lanes frame_cosine, frame_sine;
};

template <class Number>
[[gnu::always_inline]] inline void find_incidence(const LaneVectors& tangent, const LaneVectors& bitangent,
                                                  const LaneVectors& normal, const LaneLight& light,
                                                  Incidence& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> world;
        load_part(light.towards, first, world);
        const Vector3<Number> l = along(tangent, bitangent, normal, first, world);
        store_part(l, first, out.towards_light);
        if (light.components == 1) continue;
        load_part(light.x, first, world);
        const Vector3<Number> x = in_frame(theta_phi_axes(Vector3<Number>{-l.x, -l.y, -l.z}),
                                           along(tangent, bitangent, normal, first, world));
        Number cosine;
        Number sine;
        twice_the_angle<Number>(x.x, -x.y, cosine, sine);
        store_part(cosine, first, out.frame_cosine);
        store_part(sine, first, out.frame_sine);
    }
}

struct Reflection {
    std::span<const LaneMueller> terms;
    std::span<const float> weights;  // [channel][term]
    const LaneLight& light;
    const Incidence& incidence;
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
            if (components > 1)
                rotate(r.incidence.frame_cosine, r.incidence.frame_sine, first, incident[1], incident[2]);

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

}  // namespace

void ReflectedLight::set(const Views& views, std::span<const glm::vec3> positions,
                         std::span<const glm::vec3> normals, std::span<const glm::vec3> tangents) {
    for (std::size_t i = 0; i < kLanes; ++i) put(normal_, i, normals[i < normals.size() ? i : 0]);
    LaneVectors along;
    if (!tangents.empty())
        for (std::size_t i = 0; i < kLanes; ++i) put(along, i, tangents[i < tangents.size() ? i : 0]);
    const LitFrames frames{tangent_,        bitangent_,    normal_,    tangents.empty() ? nullptr : &along,
                           towards_viewer_, frame_cosine_, frame_sine_};
    with_sights(views, positions, [&]<class Sights>(const Sights& sights) {
        dispatch<find_frames<FourLanes, Sights>, find_frames<EightLanes, Sights>,
                 find_frames<AllLanes, Sights>>(sights, lane_points(positions), frames);
    });
}

std::uint32_t ReflectedLight::lit(const LaneLight& light) const {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float cosine = light.towards.x[i] * normal_.x[i] + light.towards.y[i] * normal_.y[i] +
                             light.towards.z[i] * normal_.z[i];
        const bool above = cosine > 0 && towards_viewer_.z[i] > 0;
        out |= (above ? 1U : 0U) << i;
    }
    return out & light.points;
}

void ReflectedLight::add(const Material& material, const LayerWeights* weights, const LaneLight& light,
                         std::uint32_t points, float factor, std::span<std::array<Lanes, 4>> out,
                         SampledTerms find_it) const {
    const auto has = [&](int term) {
        return !material.smooth(term) && !finds_lights(material, term, find_it);
    };
    add_terms(
        has, material, weights, light, points, [&](float cosine) { return factor * cosine; }, out);
}

void ReflectedLight::add_sampled(const Material& material, SampledTerms sampled, const Lobe& lobe,
                                 const LayerWeights* weights, const LaneLight& light, std::uint32_t points,
                                 float factor, std::span<std::array<Lanes, 4>> out) const {
    const auto has = [&](int term) {
        return is_sampled(material, term, sampled) && material.lobe(term) == lobe;
    };
    add_terms(
        has, material, weights, light, points, [&](float cosine) { return factor * cosine; }, out);
}

LaneVectors ReflectedLight::mirrored_directions() const {
    LaneVectors mirrored = towards_viewer_;
    for (std::size_t i = 0; i < kLanes; ++i) {
        mirrored.x[i] = -mirrored.x[i];
        mirrored.y[i] = -mirrored.y[i];
    }
    return in_world(mirrored);
}

LaneVectors ReflectedLight::in_world(const LaneVectors& local) const {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = local.x[i], y = local.y[i], z = local.z[i];
        out.x[i] = z * normal_.x[i] + x * tangent_.x[i] + y * bitangent_.x[i];
        out.y[i] = z * normal_.y[i] + x * tangent_.y[i] + y * bitangent_.y[i];
        out.z[i] = z * normal_.z[i] + x * tangent_.z[i] + y * bitangent_.z[i];
    }
    return out;
}

LaneVectors ReflectedLight::in_surface(const LaneVectors& world) const {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        Vector3<float> v;
        load_part(world, i, v);
        store_part(along(tangent_, bitangent_, normal_, i, v), i, out);
    }
    return out;
}

void ReflectedLight::add_mirrored(const Material& material, const LayerWeights* weights,
                                  const LaneLight& light, std::uint32_t points,
                                  std::span<std::array<Lanes, 4>> out) const {
    // In the mirror direction the facets' pBRDF is Fresnel's matrix times D / (4 cos^2) with D = 1 / (pi
    // alpha^2), without shadowing or masking.
    constexpr auto scale = static_cast<float>(4 * std::numbers::pi * kSmoothAlpha * kSmoothAlpha);
    add_terms([&](int term) { return material.smooth(term); }, material, weights, light, points,
              [](float cosine) { return scale * cosine * cosine; }, out);
}

template <class Has, class Scale>
void ReflectedLight::add_terms(const Has& has, const Material& material, const LayerWeights* weights,
                               const LaneLight& light, std::uint32_t points, const Scale& scale_at,
                               std::span<std::array<Lanes, 4>> out) const {
    points &= light.points;
    if (weights != nullptr) points &= weights->points;
    if (points == 0) return;

    Incidence incidence;
    dispatch<find_incidence<FourLanes>, find_incidence<EightLanes>, find_incidence<AllLanes>>(
        tangent_, bitangent_, normal_, light, incidence);
    Lanes scale;
    bool any = false;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float cosine = incidence.towards_light.z[i];
        const bool lit = (points >> i & 1) != 0 && cosine > 0 && towards_viewer_.z[i] > 0;
        scale[i] = lit ? scale_at(cosine) : 0;
        any = any || lit;
    }
    if (!any) return;

    const auto terms = static_cast<std::size_t>(material.terms());
    const std::span<LaneMueller> matrices = work_space<ReflectedLight, LaneMueller>(terms);
    material.evaluate_lanes(incidence.towards_light, towards_viewer_, light.components == 1 ? 1 : 4,
                            matrices);
    const std::span<float> term_weights = work_space<ReflectedLight, float>(terms * out.size());
    for (std::size_t t = 0; t < terms; ++t) {
        const int term = static_cast<int>(t);
        const bool some = has(term);
        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            const int own = material.channels() == 1 ? 0 : static_cast<int>(channel);
            term_weights[channel * terms + t] = some ? static_cast<float>(material.weight(term, own)) : 0.0F;
        }
    }
    dispatch<add_lanes<FourLanes>, add_lanes<EightLanes>, add_lanes<AllLanes>>(
        Reflection{matrices, term_weights, light, incidence, weights, scale, frame_cosine_, frame_sine_},
        out);
}

}  // namespace nicol
