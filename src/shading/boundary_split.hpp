// SPDX-License-Identifier: MIT
// Reflection and transmission of light that reaches a viewer from a smooth boundary.
#pragma once

#include "material/dielectric.hpp"
#include "polarization/mueller.hpp"
#include "polarization/stokes.hpp"

namespace nicol {

/// Light that a smooth boundary reflects, or transmits, to a viewer, without the factors of its material.
struct BoundaryPart {
    glm::dvec3 towards_light;
    Frame incident;  ///< frame of the light that arrives against towards_light
    /// Matrix from the radiance that arrives, in `incident`, to the radiance that the viewer receives; the
    /// mean over the channels of a film, see mueller_of().
    Mueller mueller;
    double share;  ///< fraction of the power of unpolarized light that arrives
    /// Factor by which refraction changes radiance: light that enters a body of higher index is compressed
    /// into a smaller solid angle. The radiance divided by the square of the index stays the same.
    double radiance_scale;
    double weight = 1;  ///< factor of `mueller` beside radiance_scale and what the boundary splits
};

/// Both parts; the share of one is 0 if the boundary does not make it.
struct BoundarySplit {
    BoundaryPart reflected;
    BoundaryPart transmitted;
    glm::dvec3 normal;  ///< unit normal that both parts follow, on the viewer's side
    double eta;         ///< index of the far side relative to the viewer's
    bool inside;        ///< whether the viewer is on the inside
    /// Rotation from frames along the s-axis to the viewer's frame; undefined without a film.
    Mueller into_received;
    double cosine;  ///< cosine between the normal and the direction towards the viewer
};

/// A surface as seen from one side. The vectors are unit normals on the viewer's side.
struct ViewedSide {
    glm::dvec3 side;    ///< the surface's own normal
    glm::dvec3 facing;  ///< the shading normal, unless it deviates by more than a right angle
    bool inside;        ///< whether the viewer is on the inside
};
/// geometric: unit normal of the surface itself, either sign. normal: unit shading normal of the front.
[[nodiscard]] ViewedSide viewed_side(const glm::dvec3& geometric, const glm::dvec3& normal,
                                     const glm::dvec3& towards_viewer);

/// Returns what a boundary sends to a viewer in the frame `received`. geometric: unit normal of the surface
/// itself, either sign. normal: unit shading normal of the front; where it would reflect light into the
/// surface, the geometric normal takes its place.
[[nodiscard]] BoundarySplit split_at(const SmoothBoundary& boundary, const glm::dvec3& geometric,
                                     const glm::dvec3& normal, const Frame& received);

/// Returns the matrix of `part`, which is a member of `split`, in a channel.
[[nodiscard]] Mueller mueller_of(const SmoothBoundary& boundary, const BoundarySplit& split,
                                 const BoundaryPart& part, int channel);

/// Returns the body through which light travels before it reaches the boundary as `part` of `split`; null:
/// none, which assumes that bodies do not overlap. around: body between the boundary and the viewer, or null.
[[nodiscard]] const SmoothBoundary* body_before(const SmoothBoundary& boundary, const BoundarySplit& split,
                                                const BoundaryPart& part, const SmoothBoundary* around);

/// The same for the light that a boundary reflects or transmits. inside: whether its viewer is on the inside.
[[nodiscard]] inline const SmoothBoundary* body_before(const SmoothBoundary& boundary, bool inside,
                                                       bool reflects, const SmoothBoundary* around) {
    if (boundary.behind == SmoothBoundary::Behind::slab) return around;
    return inside == reflects ? &boundary : nullptr;
}

/// Returns the fraction of a channel's light that a body transmits over a distance, which may be infinite.
/// body: null for none.
[[nodiscard]] double transmitted_by(const SmoothBoundary* body, int channel, double distance);

}  // namespace nicol
