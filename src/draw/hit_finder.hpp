// SPDX-License-Identifier: MIT
// Interface of what finds the surface that each sample of an image shows.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "draw/visibility_buffer.hpp"
#include "scene/projection.hpp"
#include "surfaces/refined_surfaces.hpp"

namespace nicol {

/// Image whose hits are wanted.
struct HitRequest {
    const RefinedSurfaces& surfaces;
    const Projection& projection;  ///< projection of the surfaces' axes
    int width, height;
    std::span<const glm::dvec2> offsets;  ///< offsets of the samples, as in sample_pattern()
    VisibilityBuffer::Kept kept;
};

/// All finders find the same hits, except where a sample lies on the edge of a triangle within rounding.
class HitFinder {
public:
    virtual ~HitFinder() = default;

    /// Fills `out`, in several steps of the context, between which other calls use OpenGL. Outside run() of
    /// the context, unless the caller's step must contain them all.
    virtual void find(const HitRequest& request, VisibilityBuffer& out) = 0;
};

}  // namespace nicol
