// SPDX-License-Identifier: MIT
// Triangles that an image may show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/projection.hpp"
#include "surfaces/geometry.hpp"
#include "surfaces/surface_state.hpp"
#include "versioned.hpp"

namespace nicol {

/// Returns whether a place is in an image.
[[nodiscard]] inline bool in_view(const Projection& projection, const glm::vec3& place) {
    const glm::dvec4 p = projection.world_to_clip * glm::dvec4(place, 1);
    return std::max({std::abs(p.x), std::abs(p.y), p.z}) <= p.w && p.z >= 0;
}

/// Returns the share of an image that a triangle covers if nothing hides it; 0 if it faces away from the
/// viewer. grazing: only the part counts whose cosine between normal and viewer is smaller; the cosine is
/// that in the middle of the field of view.
[[nodiscard]] double shown_share(const Projection& projection, const std::array<glm::vec3, 3>& corners,
                                 double grazing = 1);

/// A sample of a geometry's triangles, from which images take those that they show. Half of the sample goes
/// by area, so that the few triangles of a large wall are in it, and half is equal for all triangles.
class SeenTriangles {
public:
    /// Takes a sample if `version` is not that of the last call.
    void update(const WorldGeometry& geometry, Version version);
    /// The same for the state's geometry; returns this object.
    const SeenTriangles& update(const SurfaceState& surfaces) {
        update(surfaces.geometry, surfaces.versions.geometry);
        return *this;
    }

    /// Calls use(index, share) for triangles of the sample that face the viewer and are in view, whether
    /// others hide them or not. The shares of an image stand for the triangles that the sample leaves out.
    template <class Use>
    void for_each(const WorldGeometry& geometry, const Projection& projection, const Use& use,
                  double grazing = 1) const {
        for (const Sampled& sampled : sample_) {
            const glm::uvec3& t = geometry.triangles[sampled.triangle];
            const double share = shown_share(
                projection, {geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]},
                grazing);
            if (share > 0) use(std::size_t{sampled.triangle}, sampled.weight * share);
        }
    }

private:
    struct Sampled {
        std::uint32_t triangle;
        double weight;  // number of triangles that it stands for
    };
    std::vector<Sampled> sample_;
    Stage<Version> sampling_;
};

}  // namespace nicol
