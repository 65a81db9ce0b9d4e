// SPDX-License-Identifier: MIT
// Hits by rays.
#pragma once

#include <memory>

#include "draw/hit_finder.hpp"
#include "stage/workers.hpp"
#include "surfaces/drawn_rays.hpp"
#include "versioned.hpp"

namespace nicol {

/// Finder that traces one ray per sample of a pixel, on threads: for triangles much finer than pixels.
class TracedHits final : public HitFinder {
public:
    /// rays: hierarchy that is shared with other users.
    TracedHits(Workers& workers, DrawnRays& rays) : workers_(workers), rays_(rays) {}

    /// Uses no OpenGL. The hits must be wanted on the host alone. Throws what RayScene throws.
    void find(const HitRequest& request, VisibilityBuffer& out) override;
    /// Frees the hierarchy, unless it has other users.
    void clear() noexcept;

private:
    Workers& workers_;
    DrawnRays& rays_;
    Stage<Version, Version> building_;  // surfaces, materials
    std::shared_ptr<const DrawnTriangles> triangles_;
};

/// Returns whether rays find the hits of a request at lower cost than drawing without a graphics processor.
/// images: number of such images that the picture is the mean of. The answer depends on nothing that was
/// kept, so that a picture does not depend on the pictures before it.
[[nodiscard]] bool rays_cost_less(const HitRequest& request, double images);

}  // namespace nicol
