// SPDX-License-Identifier: MIT
// The reference method: an image by rays and the integral of light over directions, without harmonics. The
// errors of the real-time methods are measured against this image.
#pragma once

#include <cstdint>
#include <functional>

#include "image/aovs.hpp"
#include "image/reconstruction_filter.hpp"
#include "image/stokes_image.hpp"
#include "reference/path_tracer.hpp"
#include "scene/path_depth.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"
#include "worker_pool.hpp"

namespace nicol {

/// Largest number of samples per pixel.
inline constexpr int kMaxReferenceSamples = 1 << 20;

struct ReferenceOptions {
    /// Camera rays per pixel, 1..kMaxReferenceSamples. At each surface that a path meets, one ray goes
    /// towards the environment, one towards each local light (towards one of the emissive surfaces if there
    /// are more than 16) and one into the surface's lobe, which is also the path's next segment. Powers of
    /// two are stratified best.
    int samples = 256;
    /// Largest number of segments of a path from the camera to a light, 1..kUnlimitedDepth. 1 is light that
    /// the camera sees directly, 2 adds light that a surface reflects once, and so on. From the fifth surface
    /// on, Russian roulette ends paths at random without a bias.
    int max_depth = kDirectLightDepth;
    /// Whether surfaces hide light from each other. If not, max_depth is at most 2.
    bool shadows = true;
    /// Whether the image has one channel, the luminance of three.
    bool luminance = false;
    /// Seed of the noise. Equal seeds give equal images for any number of threads; other seeds give other
    /// noise.
    std::uint64_t seed = 0;
    ReconstructionFilter filter{};  ///< weights of samples around a pixel
    WorkerOptions workers{};
    std::uint32_t aovs = 0;  ///< AOVs to make, bits of AovBit (image/aovs.hpp)
    /// Callback, called about ten times a second on the calling thread with "trace" and the fraction done. If
    /// it returns false, the render stops with Error(cancelled).
    std::function<bool(const char* verb, double fraction)> progress;
};

struct ReferenceStatistics {
    std::uint64_t triangles = 0;
    std::uint64_t camera_rays = 0;
    std::uint64_t shadow_rays = 0;
    double build_ms = 0;  ///< time for the ray hierarchy and the table of the light
    double trace_ms = 0;
};

/// Returns, for each pixel, the mean, weighted by the filter, of the light towards the camera, in the frame
/// field of the viewpoint. If a ray meets no surface, the light is that of the environment. If a ray meets a
/// surface, the light is the surface's own emission plus the integral over the hemisphere about the
/// interpolated normal of M(towards light, towards viewer) L(towards light) cos. L is the light of the
/// environment, of local lights and of emissive surfaces; with shadows, only where no triangle is in the way.
/// With a max_depth above 2, L is also what the triangle in the way reflects of max_depth - 1 segments.
/// The integral is 0 if the viewer is behind the normal, unless the material is two-sided. Polarization
/// elements in front act on the light. `projection` must have been made for this width and height. Throws
/// Error(invalid_argument) for options or sizes out of range, including the variance of a single sample,
/// Error(out_of_memory), Error(cancelled), and the errors of the environment and the materials. `aovs`, if
/// not null, gets the AOVs of the options: the variance as in PixelEstimate, the others by rays through the
/// pixels' centres.
[[nodiscard]] StokesImage render_reference(const Scene& scene, const Projection& projection, int width,
                                           int height, const ReferenceOptions& options,
                                           ReferenceStatistics& statistics,
                                           Strategy strategy = Strategy::both, Aovs* aovs = nullptr);

}  // namespace nicol
