// SPDX-License-Identifier: MIT
#include "specular/tap_moments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/lobe_quadrature.hpp"
#include "polarization/lane_points.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_parts.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Angle, squared, below which the great circle between two directions is not looked at: their frames then
// differ by less than this.
constexpr float kNear2 = 1e-6F;

/// Tap in single precision.
struct LaneTap {
    Vector3<float> x, y, z;
    const ZonalKernel* kernel;
};

/// Sixteen directions towards light, the theta and phi axes of the propagation frames, and weights.
struct Incident {
    LaneVectors theta, phi, light;
    Lanes weight;
};

/// Weighted kernels of sixteen directions at a tap: of s0 and s3, and of s1 + i s2.
struct LaneKernel {
    Lanes scalar, real, imaginary;
};

// Computes the kernels of a tap at directions towards light.
template <class Number>
[[gnu::always_inline]] inline void look_up(const LaneTap& tap, const Vector3<Number>& light, Number& spin0,
                                           Number& spin2) {
    const Vector3<Number> apart{tap.z.x + light.x, tap.z.y + light.y, tap.z.z + light.z};
    Number distance2;
    dot(apart, apart, distance2);
    tap.kernel->at(distance2, spin0, spin2);
}

// Computes the kernel of s0 and s3.
template <class Number>
[[gnu::always_inline]] inline void evaluate_scalar_kernel(const LaneTap& tap, const Incident& incident,
                                                          Lanes& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Number weight;
        load_part(incident.light, first, light);
        load_part(incident.weight, first, weight);
        Number scalar;
        Number spin2;
        look_up(tap, light, scalar, spin2);
        store_part<Number>(weight * scalar, first, out);
    }
}

// Computes what light from each direction adds to a tap. Light of spin 2 is transported along the great
// circle, see tap_response().
template <class Number>
[[gnu::always_inline]] inline void evaluate_kernel(const LaneTap& tap, const Incident& incident,
                                                   LaneKernel& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> theta;
        Vector3<Number> phi;
        Vector3<Number> light;
        Number weight;
        load_part(incident.theta, first, theta);
        load_part(incident.phi, first, phi);
        load_part(incident.light, first, light);
        load_part(incident.weight, first, weight);

        Number scalar;
        Number spin2;
        look_up(tap, light, scalar, spin2);

        Number start_x, start_y, end_x, end_y, same_x, same_y;
        dot(tap.z, theta, start_x);
        dot(tap.z, phi, start_y);
        dot(light, tap.x, end_x);
        dot(light, tap.y, end_y);
        dot(tap.x, theta, same_x);
        dot(tap.x, phi, same_y);
        const auto near = start_x * start_x + start_y * start_y < kNear2;
        // The signs of both vectors do not matter, because their rotation is squared.
        const Number x = near ? same_x : -start_x * end_x - start_y * end_y;
        const Number y = near ? same_y : start_x * end_y - start_y * end_x;
        const Number size2 = x * x + y * y;
        const Number inverse = weight * spin2 / (size2 > 1e-30F ? size2 : Number{} + 1.0F);
        store_part<Number>(weight * scalar, first, out.scalar);
        store_part<Number>((x * x - y * y) * inverse, first, out.real);
        store_part<Number>(-2.0F * x * y * inverse, first, out.imaginary);
    }
}

/// Elements of Mueller matrices that are summed.
enum class Elements { scalar, column, all };

// Returns the elements of the matrices, of which the first `columns` are known.
Elements elements_of(std::span<const LaneMueller> muellers, std::size_t columns) {
    const bool depolarizing = std::ranges::all_of(muellers, [=](const LaneMueller& mueller) {
        float sum = 0;
        for (std::size_t e = 1; e < 16; ++e)
            for (std::size_t i = 0; i < kLanes && e % 4 < columns; ++i)
                sum += std::abs(mueller.m[e].value[i]);
        return sum == 0;
    });
    return depolarizing ? Elements::scalar : columns == 1 ? Elements::column : Elements::all;
}

// Adds sixteen directions to the sums [p][q] of one tap and term, lane by lane.
[[gnu::always_inline]] inline void add_lanes(const LaneKernel& kernel, const LaneMueller& mueller,
                                             Lanes* sums) {
    for (std::size_t p = 0; p < 4; ++p) {
        const Lanes* m = &mueller.m[4 * p];
        Lanes* to = sums + 4 * p;
#pragma omp simd
        for (std::size_t i = 0; i < kLanes; ++i) {
            to[0].value[i] += kernel.scalar.value[i] * m[0].value[i];
            to[1].value[i] +=
                kernel.real.value[i] * m[1].value[i] - kernel.imaginary.value[i] * m[2].value[i];
            to[2].value[i] +=
                kernel.imaginary.value[i] * m[1].value[i] + kernel.real.value[i] * m[2].value[i];
            to[3].value[i] += kernel.scalar.value[i] * m[3].value[i];
        }
    }
}

template <class Number>
[[gnu::always_inline]] inline void add_directions(std::span<const LaneTap> taps, const Incident& incident,
                                                  std::span<const LaneMueller> muellers, Elements elements,
                                                  Lanes* sums) {
    for (const LaneTap& tap : taps) {
        LaneKernel kernel;
        if (elements != Elements::all) {
            evaluate_scalar_kernel<Number>(tap, incident, kernel.scalar);
            const std::size_t end = elements == Elements::scalar ? 1 : 16;
            for (const LaneMueller& mueller : muellers) {
                for (std::size_t e = 0; e < end; e += 4)
#pragma omp simd
                    for (std::size_t i = 0; i < kLanes; ++i)
                        sums[e].value[i] += kernel.scalar.value[i] * mueller.m[e].value[i];
                sums += 16;
            }
            continue;
        }
        evaluate_kernel<Number>(tap, incident, kernel);
        for (const LaneMueller& mueller : muellers) {
            add_lanes(kernel, mueller, sums);
            sums += 16;
        }
    }
}

std::vector<LaneTap> in_lanes(std::span<const Tap> taps, std::span<const ZonalKernel> kernels) {
    std::vector<LaneTap> out;
    for (const Tap& tap : taps) {
        out.push_back({.x = in_floats(components(tap.frame[0])),
                       .y = in_floats(components(tap.frame[1])),
                       .z = in_floats(components(tap.frame[2])),
                       .kernel = &kernels[static_cast<std::size_t>(tap.lobe)]});
    }
    return out;
}

// Returns directions that resolve a lobe about the mirror direction, with the factor cos(theta) of the
// reflection integral in their weights.
std::vector<Incident> directions_about(double theta_out, double lobe, bool half) {
    const LobePanels narrow = lobe_panels(theta_out, lobe);
    const std::vector<QuadratureNode> azimuths = nodes_around(pi, 0, pi, narrow.azimuth, pi / 8);
    struct Azimuth {
        float cos_phi, sin_phi, weight;
    };
    std::vector<Azimuth> circle;
    for (const QuadratureNode& azimuth : azimuths) {
        const auto s = static_cast<float>(std::sin(azimuth.x));
        circle.push_back({static_cast<float>(std::cos(azimuth.x)), s, static_cast<float>(azimuth.weight)});
        if (half) continue;
        circle.push_back(circle.back());
        circle.back().sin_phi = -s;
    }
    const std::vector<QuadratureNode> zeniths = nodes_around(theta_out, 0, pi / 2, narrow.zenith, pi / 8);
    const std::size_t count = zeniths.size() * circle.size();
    std::vector<Incident> out((count + kLanes - 1) / kLanes);
    std::size_t n = 0;
    for (const QuadratureNode& zenith : zeniths) {
        const auto s = static_cast<float>(std::sin(zenith.x));
        const auto c = static_cast<float>(std::cos(zenith.x));
        const float weight = static_cast<float>(zenith.weight) * s * c;
        for (const Azimuth& at : circle) {
            Incident& to = out[n / kLanes];
            const std::size_t i = n % kLanes;
            put(to.theta, i, {c * at.cos_phi, c * at.sin_phi, -s});
            put(to.phi, i, {at.sin_phi, -at.cos_phi, 0});
            put(to.light, i, {s * at.cos_phi, s * at.sin_phi, c});
            to.weight[i] = weight * at.weight;
            ++n;
        }
    }
    // The lanes beyond the last direction have no weight, but must be directions.
    for (; n % kLanes != 0; ++n) {
        Incident& to = out.back();
        put(to.theta, n % kLanes, {1, 0, 0});
        put(to.phi, n % kLanes, {0, 1, 0});
        put(to.light, n % kLanes, {0, 0, 1});
        to.weight[n % kLanes] = 0;
    }
    return out;
}

}  // namespace

std::vector<std::vector<TapRows>> tap_moments(const Material& material, double theta_out,
                                              std::span<const Tap> taps, std::span<const ZonalKernel> kernels,
                                              std::size_t columns) {
    const auto terms = static_cast<std::size_t>(material.terms());
    const double lobe = std::min(0.25, narrowest_lobe(material));
    const std::vector<Incident> directions = directions_about(theta_out, lobe, material.mirror_symmetric());
    const std::vector<LaneTap> lane_taps = in_lanes(taps, kernels);

    LaneVectors viewer;
    for (std::size_t i = 0; i < kLanes; ++i)
        put(viewer, i, glm::vec3(glm::dvec3(std::sin(theta_out), 0, std::cos(theta_out))));
    std::vector<LaneMueller> muellers(terms);
    std::vector<Lanes> sums(16 * terms * taps.size());
    for (const Incident& incident : directions) {
        material.evaluate_lanes(incident.light, viewer, columns, muellers);
        dispatch<add_directions<FourLanes>, add_directions<EightLanes>, add_directions<AllLanes>>(
            std::span(lane_taps), incident, std::span<const LaneMueller>(muellers),
            elements_of(muellers, columns), sums.data());
    }

    std::vector<std::vector<TapRows>> out(taps.size(), std::vector<TapRows>(terms));
    const Lanes* sum = sums.data();
    for (std::vector<TapRows>& of_terms : out)
        for (TapRows& rows : of_terms)
            for (TapVector& row : rows)
                for (double& value : row) {
                    for (const float lane : sum->value) value += static_cast<double>(lane);
                    ++sum;
                }
    return out;
}

}  // namespace nicol
