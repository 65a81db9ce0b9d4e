// SPDX-License-Identifier: MIT
#include "shading/facet_samples.hpp"

#include <algorithm>
#include <cmath>

#include "material/microfacet.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_angle.hpp"

namespace nicol {
namespace {

constexpr float kLeastCosine = 1e-6F;

struct Samples {
    const LaneVectors& viewers;
    Lanes x, y;  // points of a disk, or slopes over alpha
};

template <class Number>
struct Sample {
    Vector3<Number> viewer;
    Number x, y;
};

template <class Number>
[[gnu::always_inline]] inline void load(const Samples& samples, std::size_t first, Sample<Number>& out) {
    load_part(samples.viewers, first, out.viewer);
    load_part(samples.x, first, out.x);
    load_part(samples.y, first, out.y);
}

// Mirrors the viewer at a unit half vector. Returns the cosine between the two.
template <class Number>
[[gnu::always_inline]] inline void mirror(const Vector3<Number>& viewer, const Vector3<Number>& half,
                                          std::size_t first, LaneVectors& lights, Number& along) {
    dot(viewer, half, along);
    store_part(Vector3<Number>{2.0F * along * half.x - viewer.x, 2.0F * along * half.y - viewer.y,
                               2.0F * along * half.z - viewer.z},
               first, lights);
}

// A point of the disk is projected to the half sphere of normals, stretched to which the facets are round, as
// the viewer sees it.
template <class Number>
[[gnu::always_inline]] inline void sample_seen(const Facets<float>& facets, const Samples& samples,
                                               LaneVectors& lights, Lanes& densities) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Sample<Number> sample;
        load(samples, first, sample);
        Vector3<Number> viewer = sample.viewer;
        viewer.z = viewer.z > kLeastCosine ? viewer.z : Number{} + kLeastCosine;

        const Vector3<Number> stretched =
            normalized_or(Vector3<Number>{facets.alpha * viewer.x, facets.alpha_y * viewer.y, viewer.z}, 0.0F,
                          Vector3<float>{0, 0, 1});
        const Vector3<Number> across = normalized_or(Vector3<Number>{-stretched.y, stretched.x, Number{}},
                                                     1e-12F, Vector3<float>{1, 0, 0});
        const Vector3<Number> up = cross(stretched, across);
        const Number a = sample.x;
        const Number half_chord2 = 1.0F - a * a;
        Number half_chord = half_chord2 > 0.0F ? half_chord2 : Number{};
        square_root(half_chord);
        const Number share = 0.5F * (1.0F + stretched.z);
        const Number b = (1.0F - share) * half_chord + share * sample.y;
        const Number rest2 = 1.0F - a * a - b * b;
        Number rest = rest2 > 0.0F ? rest2 : Number{};
        square_root(rest);
        const Number rise = a * across.z + b * up.z + rest * stretched.z;
        const Vector3<Number> half =
            normalized_or(Vector3<Number>{facets.alpha * (a * across.x + b * up.x + rest * stretched.x),
                                          facets.alpha_y * (a * across.y + b * up.y + rest * stretched.y),
                                          rise > kLeastCosine ? rise : Number{} + kLeastCosine},
                          0.0F, Vector3<float>{0, 0, 1});
        Number along, seen, of_facets;
        mirror(viewer, half, first, lights, along);
        visibility_over_cosine(facets, viewer, seen);
        density(facets, half, Number{} + 1.0F, of_facets);
        store_part(Number(0.25F * seen * of_facets), first, densities);
    }
}

// The facets have the sampled slopes.
template <class Number>
[[gnu::always_inline]] inline void sample_all(const Facets<float>& facets, const Samples& samples,
                                              LaneVectors& lights, Lanes& densities) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Sample<Number> sample;
        load(samples, first, sample);
        const Vector3<Number> half = normalized_or(
            Vector3<Number>{facets.alpha * sample.x, facets.alpha_y * sample.y, Number{} + 1.0F}, 0.0F,
            Vector3<float>{0, 0, 1});
        Number along, of_facets;
        mirror(sample.viewer, half, first, lights, along);
        density(facets, half, Number{} + 1.0F, of_facets);
        along = along > kLeastCosine ? along : Number{} + kLeastCosine;
        store_part(Number(0.25F * of_facets * half.z / along), first, densities);
    }
}

}  // namespace

void sample_facets(const Lobe& lobe, const LaneVectors& towards_viewer, const Lanes& u, const Lanes& v,
                   LaneVectors& towards_light, Lanes& density) {
    const bool ggx = lobe.distribution == Distribution::ggx;
    const Facets<float> facets{lobe.distribution, static_cast<float>(lobe.alpha.x),
                               static_cast<float>(lobe.alpha.y)};
    Samples samples{.viewers = towards_viewer, .x = {}, .y = {}};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float radius = std::sqrt(ggx ? u[i] : -std::log1p(-std::min(u[i], 1 - 1e-6F)));
        turn(v[i], samples.x[i], samples.y[i]);
        samples.x[i] *= radius;
        samples.y[i] *= radius;
    }
    if (ggx)
        dispatch<sample_seen<FourLanes>, sample_seen<EightLanes>, sample_seen<AllLanes>>(
            facets, samples, towards_light, density);
    else
        dispatch<sample_all<FourLanes>, sample_all<EightLanes>, sample_all<AllLanes>>(facets, samples,
                                                                                      towards_light, density);
}

}  // namespace nicol
