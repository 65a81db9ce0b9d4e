// SPDX-License-Identifier: MIT
// Predicted error of shading at vertices.
#pragma once

#include <array>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "light/light_pyramid.hpp"
#include "material/material.hpp"
#include "render/seen_triangles.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"
#include "surfaces/geometry.hpp"
#include "versioned.hpp"

namespace nicol {

/// Predicts what linear interpolation between shaded vertices misses. Each lobe of a material reflects the
/// mean light in a blob around its mirror direction, a diffuse one around the normal. The prediction compares
/// this reflection at places within a triangle with what is interpolated between its corners. Shadows are
/// ignored, because pixels interpolate the shadows of vertices as well.
class InterpolationError {
public:
    /// Returns the error of s0, relative to its RMS over the triangles that face the viewer in the image,
    /// weighted by what they cover of the image. seen: a sample of the geometry's triangles. projection: of
    /// the geometry's axes. light: null: none. to_light: from the geometry's axes to the light's.
    [[nodiscard]] double of(const WorldGeometry& geometry, const SeenTriangles& seen,
                            const Projection& projection, const EnvironmentPtr& light,
                            const glm::dmat3& to_light);

    /// Computes what of() needs of the light and of the instances' materials: beside a bake.
    void prepare(const Scene& scene, const EnvironmentPtr& light);

private:
    static constexpr std::size_t kAngles = 12;  // from 0 to pi/2
    static constexpr float kPerRadian = (kAngles - 1) * 2 / std::numbers::pi_v<float>;

    // Reflection of a term.
    struct Reflection {
        bool diffuse;                       // reflects the light around the normal
        float variance;                     // of the lobe along each axis, in square radians
        std::array<float, kAngles> albedo;  // reflected part of even light, by zenith angle of the viewer
    };
    using Reflections = std::vector<Reflection>;

    [[nodiscard]] static Reflections reflections(const Material& material);
    void filter(const EnvironmentPtr& light);
    // Returns the reflected s0 at places with unit normals and unit vectors towards the viewer.
    [[nodiscard]] Lanes reflected(const Reflections& reflections, const LaneVectors& normals,
                                  const LaneVectors& viewers, const glm::mat3& to_light);

    std::map<MaterialPtr, Reflections> reflections_;
    Stage<EnvironmentPtr> filtering_;
    std::optional<LightPyramid> light_;
    LaneLight seen_;  // work space of reflected()
};

}  // namespace nicol
