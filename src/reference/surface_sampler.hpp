// SPDX-License-Identifier: MIT
// Sampler of directions towards the light, denser in the surface's lobes.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Mixture of the cosine-weighted hemisphere and, for each lobe width of the material below 1, of reflections
/// off the visible facets of a GGX surface of that roughness, which may differ between x and y. All
/// directions are in the surface's frame with the normal along z.
class SurfaceSampler {
public:
    explicit SurfaceSampler(const Material& material);

    /// Samples a unit direction towards the light for a unit `towards_viewer` above the horizon. point: in
    /// [0, 1)^2. A facet may reflect below the horizon. Such directions carry no light, and the density
    /// includes their share.
    [[nodiscard]] glm::dvec3 sample(const glm::dvec3& towards_viewer, const glm::dvec2& point) const;
    /// Returns the density per steradian over the whole sphere; above 0 everywhere above the horizon.
    [[nodiscard]] double pdf(const glm::dvec3& towards_viewer, const glm::dvec3& towards_light) const;

private:
    struct Lobe {
        glm::dvec2 roughness;
        double share;
    };
    std::vector<Lobe> lobes_;
    double cosine_share_ = 1;
};

}  // namespace nicol
