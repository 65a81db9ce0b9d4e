// SPDX-License-Identifier: MIT
// Predicted error of shadows between baked vertices.
#pragma once

#include <vector>

#include "render/seen_triangles.hpp"
#include "scene/projection.hpp"
#include "surfaces/surface_state.hpp"
#include "surfaces/vertex_stage.hpp"
#include "versioned.hpp"

namespace nicol {

/// Predicts what linear interpolation of shadows between baked vertices misses, for even light. The error
/// along an edge follows from the change of the irradiance's gradient, whose value at a vertex is the mean
/// over the triangles around it, as in the error estimate of Zienkiewicz and Zhu for finite elements.
class ShadowError {
public:
    /// An image, as far as its surfaces are baked.
    struct Seen {
        double error = 0;  ///< error of the irradiance, relative to its RMS
        /// Mean square of the irradiance in the image, over that of all surfaces.
        double brightness = 1;
    };

    /// Returns the error of the irradiance on all surfaces, relative to its RMS, as the last call of of()
    /// found it; 0 if there was none or if nothing is hidden. It stays the same when the camera moves.
    [[nodiscard]] double of_all() const noexcept { return of_all_; }
    /// Returns what the triangles that face the viewer say, weighted by what they cover of the image. `seen`
    /// is a sample of the surfaces' triangles. done: whether the bake of the surfaces is done; otherwise,
    /// shadows of an earlier state of the same triangles are good enough. Runs on the threads of the calling
    /// thread's TBB arena after a change of the surfaces; later calls examine the sample.
    [[nodiscard]] Seen of(const SurfaceState& surfaces, bool done, const SeenTriangles& seen,
                          const Projection& projection);

private:
    // Mean squares over a triangle.
    struct Squares {
        float error, irradiance;
    };

    void measure(const SurfaceState& surfaces);

    // Sets irradiance_. Keeps the values of vertices whose visibility and normal have not changed since the
    // last call.
    void find_irradiance(const SurfaceState& surfaces);

    Stage<SurfaceVersions> measuring_;
    VertexStage<> finding_{{.renumbers = true}};
    std::vector<float> irradiance_;  // by vertex, of finding_
    std::vector<Squares> squares_;   // by triangle; irradiance < 0: not baked
    double all_ = 1;                 // mean square of the irradiance, of all surfaces
    double of_all_ = 0;
};

}  // namespace nicol
