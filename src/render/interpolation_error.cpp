// SPDX-License-Identifier: MIT
#include "render/interpolation_error.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "material/lobe_quadrature.hpp"

namespace nicol {
namespace {

constexpr double kPi = std::numbers::pi;

// Columns of the light's image, enough for the narrowest lobes that are not sampled.
constexpr int kColumns = 128;

// Lobes at least as wide are diffuse: they reflect the light around the normal.
constexpr double kDiffuse = 0.7;

// Places in a triangle: its corners, the middles of its edges, its middle.
constexpr std::size_t kPlaces = 8;  // the last one is not used
constexpr std::array<glm::vec3, 7> kBarycentrics{{{1, 0, 0},
                                                  {0, 1, 0},
                                                  {0, 0, 1},
                                                  {0.5F, 0.5F, 0},
                                                  {0, 0.5F, 0.5F},
                                                  {0.5F, 0, 0.5F},
                                                  {1 / 3.0F, 1 / 3.0F, 1 / 3.0F}}};
// Weights of the mean over a triangle, exact for polynomials of third degree.
constexpr std::array<double, 7> kWeights{3 / 60.0, 3 / 60.0, 3 / 60.0, 8 / 60.0,
                                         8 / 60.0, 8 / 60.0, 27 / 60.0};
static_assert(kLanes % kPlaces == 0);

// Directions around one of them, with solid angles.
struct Around {
    LaneVectors towards;
    std::array<double, kLanes> solid_angles;
};

// Returns directions that resolve a lobe around a unit vector in the xz plane.
std::vector<Around> directions_around(const glm::dvec3& middle, double lobe) {
    const glm::dvec3 across(middle.z, 0, -middle.x);
    std::vector<Around> out;
    for (const QuadratureNode& node : nodes_around(0, 0, kPi, lobe, kPi / 8)) {
        Around& ring = out.emplace_back();
        for (std::size_t i = 0; i < kLanes; ++i) {
            const double turn = 2 * kPi * (static_cast<double>(i) + 0.5) / kLanes;
            const glm::dvec3 aside = std::cos(turn) * across + std::sin(turn) * glm::dvec3(0, 1, 0);
            put(ring.towards, i, glm::vec3(std::cos(node.x) * middle + std::sin(node.x) * aside));
            ring.solid_angles[i] = node.weight * std::sin(node.x) * 2 * kPi / kLanes;
        }
    }
    return out;
}

// Returns the variance of a lobe of microfacets along each axis. Reflected directions deviate twice as much
// as the facets' normals. Of GGX, whose variance is infinite, it is that of the normal distribution with as
// high a peak.
double variance_of(double width, Distribution distribution) {
    return (distribution == Distribution::beckmann ? 2 : 1.5) * width * width;
}

double mean_weight(const Material& material, int term) {
    double sum = 0;
    for (int c = 0; c < material.channels(); ++c) sum += material.weight(term, c);
    return sum / material.channels();
}

}  // namespace

InterpolationError::Reflections InterpolationError::reflections(const Material& material) {
    const Material& even = material.isotropic();
    Reflections out;
    for (int t = 0; t < even.terms(); ++t) {
        const double width = even.lobe_width(t);
        out.push_back({.diffuse = width >= kDiffuse,
                       .variance = static_cast<float>(variance_of(width, even.distribution(t))),
                       .albedo = {}});
    }
    std::vector<LaneMueller> terms(out.size());
    for (std::size_t k = 0; k < kAngles; ++k) {
        // The last angle is grazing, where the albedo would be that of nothing.
        const double zenith = std::min(static_cast<double>(k) / static_cast<double>(kPerRadian), 0.48 * kPi);
        const glm::dvec3 viewer(std::sin(zenith), 0, std::cos(zenith));
        LaneVectors viewers;
        for (std::size_t i = 0; i < kLanes; ++i) put(viewers, i, glm::vec3(viewer));
        for (const Around& ring :
             directions_around(glm::dvec3(-viewer.x, 0, viewer.z), narrowest_lobe(material))) {
            even.evaluate_lanes(ring.towards, viewers, 1, terms);
            for (std::size_t t = 0; t < terms.size(); ++t) {
                double sum = 0;
                for (std::size_t i = 0; i < kLanes; ++i)
                    if (ring.towards.z[i] > 0)
                        sum +=
                            static_cast<double>(terms[t].m[0][i] * ring.towards.z[i]) * ring.solid_angles[i];
                out[t].albedo[k] += static_cast<float>(mean_weight(even, static_cast<int>(t)) * sum);
            }
        }
    }
    return out;
}

Lanes InterpolationError::reflected(const Reflections& reflections, const LaneVectors& normals,
                                    const LaneVectors& viewers, const glm::mat3& to_light) {
    Lanes out{};
    Lanes albedo;
    for (const Reflection& lobe : reflections) {
        Lanes variances;
        variances.value.fill(lobe.variance);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::vec3 normal = vector_at(normals, i), viewer = vector_at(viewers, i);
            const float cosine = std::clamp(glm::dot(normal, viewer), 0.0F, 1.0F);
            const float zenith = std::acos(cosine) * kPerRadian;
            const std::size_t below = std::min(kAngles - 2, static_cast<std::size_t>(zenith));
            const float part = zenith - static_cast<float>(below);
            albedo[i] = std::lerp(lobe.albedo[below], lobe.albedo[below + 1], part);
            put(seen_.towards, i,
                to_light * (lobe.diffuse ? normal : glm::normalize(2 * cosine * normal - viewer)));
        }
        light_->look_up(variances, seen_);
        for (const std::array<Lanes, 4>& channel : seen_.irradiance)
            for (std::size_t i = 0; i < kLanes; ++i) out[i] += albedo[i] * channel[0][i];
    }
    return out;
}

void InterpolationError::filter(const EnvironmentPtr& light) {
    filtering_.run(light, [&] { light_.emplace(*light, kColumns, LightPyramid::Kept::radiance); });
}

void InterpolationError::prepare(const Scene& scene, const EnvironmentPtr& light) {
    if (light == nullptr) return;
    filter(light);
    for (const Instance& instance : scene.instances()) {
        const auto [known, fresh] = reflections_.try_emplace(instance.material);
        if (fresh) known->second = reflections(*instance.material);
    }
}

double InterpolationError::of(const WorldGeometry& geometry, const SeenTriangles& seen,
                              const Projection& projection, const EnvironmentPtr& light,
                              const glm::dmat3& to_light) {
    if (light == nullptr) return 0;
    filter(light);
    if (reflections_.size() > geometry.ranges.size()) reflections_.clear();  // drops former materials

    const Viewpoint& view = projection.view;
    const glm::mat3 to_pyramid(to_light);
    double missed = 0;
    double power = 0;
    // Some triangles of one material, side by side.
    struct Batch {
        const Reflections* of = nullptr;
        // Shares of the image of places in view.
        std::array<std::array<double, kBarycentrics.size()>, kLanes / kPlaces> weights{};
        std::size_t size = 0;
        LaneVectors normals, viewers;
    } batch;
    for (std::size_t i = 0; i < kLanes; ++i) {  // lanes that are not used have directions as well
        put(batch.normals, i, glm::vec3(0, 0, 1));
        put(batch.viewers, i, glm::vec3(0, 0, 1));
    }
    const auto finish = [&] {
        if (batch.size == 0) return;
        const Lanes s0 = reflected(*batch.of, batch.normals, batch.viewers, to_pyramid);
        for (std::size_t t = 0; t < batch.size; ++t) {
            const float* const at = &s0.value[t * kPlaces];
            const glm::vec3 corners(at[0], at[1], at[2]);
            for (std::size_t k = 0; k < kWeights.size(); ++k) {
                const double weight = batch.weights[t][k];
                const auto here = static_cast<double>(at[k]);
                const double error = here - static_cast<double>(glm::dot(kBarycentrics[k], corners));
                missed += weight * error * error;
                power += weight * here * here;
            }
        }
        batch.size = 0;
    };

    seen.for_each(geometry, projection, [&](std::size_t i, double share) {
        const glm::uvec3& triangle = geometry.triangles[i];
        const MaterialPtr& material = geometry.ranges[range_of(geometry, triangle.x)].material;
        const auto [known, fresh] = reflections_.try_emplace(material);
        if (fresh) known->second = reflections(*material);
        if (batch.of != &known->second) {
            finish();
            batch.of = &known->second;
        }
        for (std::size_t k = 0; k < kBarycentrics.size(); ++k) {
            const std::size_t lane = batch.size * kPlaces + k;
            glm::vec3 place(0), normal(0);
            for (int corner = 0; corner < 3; ++corner) {
                place += kBarycentrics[k][corner] * geometry.positions[triangle[corner]];
                normal += kBarycentrics[k][corner] * geometry.normals[triangle[corner]];
            }
            const float length = glm::length(normal);
            put(batch.normals, lane, length > 0 ? normal / length : geometry.normals[triangle.x]);
            put(batch.viewers, lane, glm::vec3(view.towards(glm::dvec3(place))));
            batch.weights[batch.size][k] = in_view(projection, place) ? share * kWeights[k] : 0;
        }
        if (++batch.size == batch.weights.size()) finish();
    });
    finish();
    return power > 0 ? std::sqrt(missed / power) : 0;
}

}  // namespace nicol
