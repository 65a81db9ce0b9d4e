// SPDX-License-Identifier: MIT
// What surfaces reflect of local lights: the material's own pBRDF, light by light, with shadows by rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "material/layer_weights.hpp"
#include "material/material.hpp"
#include "polarization/viewpoint.hpp"
#include "shading/light_source.hpp"

namespace nicol {

/// Points of surfaces, in the axes of lights and rays; at most kLanes.
struct LitPoints {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;  ///< unit, of shading
    /// Where texture coordinate u grows, unit or 0, for anisotropic materials. Empty: the material is none.
    std::span<const glm::vec3> tangents;
    /// Unit: light from below these is hidden by the surface itself, though a texture turns the normal
    /// towards it. Empty: no texture does.
    std::span<const glm::vec3> facets;
    std::span<const glm::vec3> origins;  ///< where shadow rays start
    std::span<const std::uint32_t> seeds;
    bool shadowed;  ///< something may be in the way; else no ray is traced
};

/// What they are made of: layers and, of a material that varies, as many weights.
struct LitMaterial {
    std::span<const Material* const> layers;
    std::span<const LayerWeights> weights;  ///< empty: 1
};

/// Whether a material, or a layer of its variation(), has smooth terms, or others.
[[nodiscard]] bool has_terms(const Material& material, bool smooth);

/// Immutable; threads share it.
class LocalLighting {
public:
    /// rays: what casts shadows, null: nothing; must outlive this. samples: places of a
    /// light that is seen wide; of narrower ones fewer.
    LocalLighting(std::vector<LightSourcePtr> sources, const RayScene* rays, int samples);

    /// Adds to out[c][i] channel c's Stokes vector towards the viewpoint, in the camera's frame field, of
    /// point i. Returns the number of rays.
    std::uint64_t add(const Viewpoint& view, const LitPoints& points, const LitMaterial& material,
                      std::span<const std::span<glm::vec4>> out) const;

private:
    std::vector<LightSourcePtr> sources_;
    const RayScene* rays_;
    std::uint32_t samples_;
};

}  // namespace nicol
