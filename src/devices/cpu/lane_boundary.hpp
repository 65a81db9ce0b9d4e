// SPDX-License-Identifier: MIT
// Sixteen rays that meet a smooth boundary.
#pragma once

#include <array>

#include "material/dielectric.hpp"
#include "polarization/lane_points.hpp"
#include "surfaces/lane_triangles.hpp"

namespace nicol {

/// Rays that meet triangles of one boundary.
struct BoundaryHits {
    LaneVectors directions;  ///< unit directions of the rays
    LaneVectors
        received_x;  ///< x axes of the frames in which the light that travels against them is received
    Lanes distances, b1, b2;                     ///< as in RayHit
    std::array<LaneVectors, 2> places, changes;  ///< as RaySpread::places and RaySpread::directions
    LaneTriangles triangles;
};

/// Light that the boundary reflects, or transmits, to the starts of the rays, see BoundaryPart.
struct LanePart {
    LaneVectors towards_light;  ///< unit
    /// The matrix without the factors of the material, in the frames along the s-axis.
    std::array<Lanes, 4> block;  ///< ReflectionBlock's a, b, c and d; a: fraction of unpolarized power
    std::array<LaneVectors, 2> changes;  ///< of the direction, as BoundaryHits::changes
};

/// The light that leaves the boundary, see BoundarySplit.
struct LaneSplit {
    LaneVectors positions;
    LaneVectors facets;    ///< unit normals of the triangles' fronts
    LaneVectors s_axes;    ///< x axes of the frames of the light that arrives
    Lanes cosines;         ///< cosines between the normal and the directions towards the rays' starts
    Lanes inside;          ///< 1: the ray travels inside the body; else 0
    Lanes radiance_scale;  ///< BoundaryPart::radiance_scale of the transmitted light
    Lanes cosine2, sine2;  ///< of twice the angle from the frame along the s-axis to the received one
    std::array<LaneVectors, 2> places;  ///< RaySpread::places on the surface
    LanePart reflected, transmitted;
};

/// Splits the light of all rays. A film's matrices are the means over its channels.
void split_lanes(const SmoothBoundary& boundary, const BoundaryHits& hits, LaneSplit& out);
/// Replaces the blocks by those of a channel of a boundary with a film.
void take_channel(const SmoothBoundary& boundary, int channel, LaneSplit& split);

}  // namespace nicol
