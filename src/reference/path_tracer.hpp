// SPDX-License-Identifier: MIT
// Paths of light from the camera backwards: each surface on a path reflects light of the scene's lights and
// of the next surface.
#pragma once

#include <cstdint>
#include <span>

#include "polarization/mueller.hpp"
#include "reference/low_discrepancy.hpp"
#include "reference/path_vertex.hpp"
#include "reference/scene_lights.hpp"
#include "reference/traced_scene.hpp"

namespace nicol {

/// Estimator of the light that reaches the camera along rays. Immutable; threads share it.
class PathTracer {
public:
    /// Keeps references to both arguments. max_depth: largest number of ray segments from the camera to a
    /// light, as in Mitsuba: 1 is light that the camera sees directly, 2 adds light that is reflected once.
    PathTracer(const TracedScene& scene, const SceneLights& lights, int max_depth);

    /// First stream of the points that add() takes; add() uses later streams, too.
    static constexpr std::uint32_t kFirstStream = 1;
    /// Adds, for each channel, an estimate of the Stokes vector of the light that travels against the ray, in
    /// the frame `received`, whose z is -ray.direction. The points of this index choose the path. Returns
    /// whether the ray meets a surface.
    bool add(const Ray& ray, const Frame& received, const LowDiscrepancy& points, std::uint32_t index,
             std::span<Stokes> sum, PathWorkspace& workspace) const;

private:
    void begin(const Ray& ray, const Frame& received, std::size_t channels, PathWorkspace& workspace) const;
    /// Adds the light that surfaces reflect along a path that has met its first surface.
    void follow(RayHit found, glm::dvec3 direction, Frame received, const LowDiscrepancy& points,
                std::uint32_t index, std::span<Stokes> sum, PathWorkspace& workspace) const;

    const TracedScene& scene_;
    const SceneLights& lights_;
    int max_depth_;
};

}  // namespace nicol
