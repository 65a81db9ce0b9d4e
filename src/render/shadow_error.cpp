// SPDX-License-Identifier: MIT
#include "render/shadow_error.hpp"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "render/vertex_weights.hpp"
#include "visibility/hidden_light.hpp"

namespace nicol {
namespace {

// Returns the gradient over a triangle of a quantity that is linear between its corners; 0 without an area.
glm::vec3 gradient(const std::array<glm::vec3, 3>& corners, const std::array<float, 3>& values) {
    const glm::vec3 u = corners[1] - corners[0];
    const glm::vec3 v = corners[2] - corners[0];
    const glm::vec3 normal = glm::cross(u, v);
    const float square = glm::dot(normal, normal);
    if (!(square > 0)) return glm::vec3(0);
    return ((values[1] - values[0]) * glm::cross(v, normal) +
            (values[2] - values[0]) * glm::cross(normal, u)) /
           square;
}

// Returns twice the area of a triangle.
float area_of(const std::array<glm::vec3, 3>& corners) {
    return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

}  // namespace

ShadowError::Seen ShadowError::of(const SurfaceState& surfaces, bool done, const SeenTriangles& seen,
                                  const Projection& projection) {
    if (surfaces.visibility == nullptr) {
        of_all_ = 0;
        measuring_.reset();
        finding_.reset();
        irradiance_ = {};
        return {};
    }
    const WorldGeometry& geometry = surfaces.geometry;
    if (done || squares_.size() != geometry.triangles.size())
        measuring_.run(surfaces.versions, [&] { measure(surfaces); });
    double weights = 0, error = 0, irradiance = 0;
    seen.for_each(geometry, projection, [&](std::size_t i, double share) {
        if (squares_[i].irradiance < 0) return;
        weights += share;
        error += share * static_cast<double>(squares_[i].error);
        irradiance += share * static_cast<double>(squares_[i].irradiance);
    });
    if (!(irradiance > 0)) return {};
    return {.error = std::sqrt(error / irradiance), .brightness = irradiance / weights / all_};
}

void ShadowError::find_irradiance(const SurfaceState& surfaces) {
    if (!finding_.update(surfaces)) return;
    const std::vector<glm::vec3>& normals = surfaces.geometry.normals;
    const std::vector<float> before = std::exchange(irradiance_, std::vector<float>(normals.size()));
    const HiddenLight hidden(*surfaces.directions);
    tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t v) {
        const std::uint32_t former = finding_.former()[v];
        irradiance_[v] =
            former != kNoVertex ? before[former] : 1 - hidden.at(*surfaces.visibility, v, normals[v]).x;
    });
    finding_.complete();
}

void ShadowError::measure(const SurfaceState& surfaces) {
    find_irradiance(surfaces);
    const std::vector<float>& irradiance = irradiance_;
    const WorldGeometry& geometry = surfaces.geometry;
    const std::size_t vertices = geometry.positions.size();
    const auto corners = [&](const glm::uvec3& t) {
        return std::array{geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]};
    };
    std::vector<glm::vec3> gradients(vertices, glm::vec3(0));
    std::vector<float> areas(vertices, 0.0F);
    double all_areas = 0;
    for (const glm::uvec3& t : geometry.triangles) {
        const std::array<glm::vec3, 3> at = corners(t);
        const float area = area_of(at);
        all_areas += static_cast<double>(area);
        const glm::vec3 here = area * gradient(at, {irradiance[t.x], irradiance[t.y], irradiance[t.z]});
        for (glm::length_t k = 0; k < 3; ++k) {
            gradients[t[k]] += here;
            areas[t[k]] += area;
        }
    }
    for (std::size_t v = 0; v < vertices; ++v)
        if (areas[v] > 0) gradients[v] /= areas[v];

    squares_.resize(geometry.triangles.size());
    tbb::parallel_for(std::size_t{0}, squares_.size(), [&](std::size_t i) {
        const glm::uvec3& t = geometry.triangles[i];
        if (!surfaces.baked.empty() &&
            (surfaces.baked[t.x] == 0 || surfaces.baked[t.y] == 0 || surfaces.baked[t.z] == 0)) {
            squares_[i] = {.error = 0, .irradiance = -1};
            return;
        }
        // Errors at the middles of edges, and the mean squares of the quadratic functions through them and
        // of the linear one through the corners.
        float sum = 0, squares = 0, light = 0, lights = 0;
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            const float error =
                glm::dot(gradients[b] - gradients[a], geometry.positions[b] - geometry.positions[a]) / 8;
            sum += error;
            squares += error * error;
            light += irradiance[a];
            lights += irradiance[a] * irradiance[a];
        }
        squares_[i] = {.error = 4 * (squares + sum * sum) / 45, .irradiance = (lights + light * light) / 12};
    });

    // Half of the weight goes by area, and half is equal for all triangles, as in VertexWeights.
    double error = 0, light = 0;
    for (std::size_t i = 0; i < squares_.size(); ++i) {
        if (squares_[i].irradiance < 0) continue;
        const auto area = static_cast<double>(area_of(corners(geometry.triangles[i])));
        const double weight =
            (all_areas > 0 ? area / all_areas : 0) + 1 / static_cast<double>(squares_.size());
        error += weight * static_cast<double>(squares_[i].error);
        light += weight * static_cast<double>(squares_[i].irradiance);
    }
    of_all_ = light > 0 ? std::sqrt(error / light) : 0;

    const VertexWeights sampled(geometry, surfaces.baked);
    double weights = 0;
    all_ = 0;
    for (const auto& [material, group] : sampled.groups()) {
        double squares = 0;
        for (const std::uint32_t v : group.sample)
            squares += static_cast<double>(irradiance[v] * irradiance[v]);
        all_ += group.weight * squares / static_cast<double>(group.sample.size());
        weights += group.weight;
    }
    all_ = all_ > 0 ? all_ / weights : 1;
}

}  // namespace nicol
