// SPDX-License-Identifier: MIT
// Light of local lights that passes glass on its way to the points that it lights.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "geometry/ray_scene.hpp"
#include "light/lane_light.hpp"
#include "material/dielectric.hpp"

namespace nicol {

/// Glass between points and lights. Light passes it straight on, dimmed as unpolarized light is: by Fresnel's
/// transmittance at each boundary, by its factors, and by the absorption of bodies. Nothing is focused.
/// Immutable; threads share it.
class GlassShadows {
public:
    /// Boundary that a ray meets.
    struct Crossing {
        const SmoothBoundary* boundary;  ///< null: a surface that no light passes
        glm::dvec3 normal;               ///< unit shading normal of the front
        double distance;                 ///< along the ray
        double offset;                   ///< distance from the surface at which the ray goes on
    };
    using FirstCrossing = std::function<std::optional<Crossing>(const Ray&)>;

    /// surfaces: all surfaces, glass included. first: first crossing of a ray with one of them.
    GlassShadows(std::shared_ptr<const RayScene> surfaces, FirstCrossing first);

    /// Multiplies the light of `points`, whose shadow rays are those of the packet and meet nothing but
    /// glass, by what the glass transmits. The light gets channels of its own if the glass has colour.
    void dim(const RayPacket& packet, std::uint32_t points, LaneLight& light) const;

    /// Returns the part of light that all glass on a ray transmits, the mean over channels; 0 beyond a
    /// surface that no light passes.
    [[nodiscard]] double transmittance(Ray ray) const;

private:
    /// Calls apply(factor_of, channels) for each boundary on a ray; factor_of(c): what it transmits in
    /// channel c, with the body before it. Returns whether no other surface is met.
    template <class Apply>
    bool for_crossings(Ray ray, const Apply& apply) const;

    std::shared_ptr<const RayScene> surfaces_;
    FirstCrossing first_;
};

}  // namespace nicol
