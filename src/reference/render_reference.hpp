// SPDX-License-Identifier: MIT
// The reference method: an image by rays and the integral of light over directions, without harmonics; every
// error of the real-time methods is measured against it.
#pragma once

#include <cstdint>
#include <functional>

#include "image/aovs.hpp"
#include "image/stokes_image.hpp"
#include "reference/direct_light.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Most samples a pixel.
inline constexpr int kMaxReferenceSamples = 1 << 20;

struct ReferenceOptions {
    /// Camera rays a pixel, 1..kMaxReferenceSamples; each that hits a surface sends one ray towards the
    /// environment, one towards each local light (of more than 16 emissive surfaces, to one of them) and
    /// one into the surface's lobe. Powers of two are stratified best.
    int samples = 256;
    bool shadows = true;  ///< whether surfaces hide light from each other
    /// The image has one channel, the luminance of three.
    bool luminance = false;
    /// The same seed gives the same image whatever the number of threads; another one gives other noise.
    std::uint64_t seed = 0;
    int threads = 0;         ///< 0: one a core, which is also the most
    std::uint32_t aovs = 0;  ///< to make, bits of AovBit (image/aovs.hpp)
    /// Called about ten times a second on the calling thread with "trace" and the fraction done; false stops
    /// the render with Error(cancelled).
    std::function<bool(const char* verb, double fraction)> progress;
};

struct ReferenceStatistics {
    std::uint64_t triangles = 0;
    std::uint64_t camera_rays = 0;
    std::uint64_t shadow_rays = 0;
    double build_ms = 0;  ///< the ray hierarchy and the table of the light
    double trace_ms = 0;
};

/// For each pixel the mean, over the pixel's square, of the light towards the camera in the frame field of
/// the viewpoint. Where a ray meets a surface this is the integral over the hemisphere about the interpolated
/// normal of M(towards light, towards viewer) L(towards light) cos, L being that of the environment, of small
/// lights and of emissive surfaces, where no triangle is in the way if shadows are asked for; 0 where the
/// viewer is behind that normal, unless the material is two-sided; and what the surface emits itself.
/// Elsewhere it is the environment. Elements before that act on it. `projection` must have been made for this
/// width and height. Throws Error(invalid_argument) for options or sizes out of range, the variance of a
/// single sample among them, Error(out_of_memory), Error(cancelled), and what the environment and the
/// materials throw. `aovs`, where not null, gets the AOVs of the options: the variance as PixelEstimate has
/// it, the others by the rays through the pixels' centres.
[[nodiscard]] StokesImage render_reference(const Scene& scene, const Projection& projection, int width,
                                           int height, const ReferenceOptions& options,
                                           ReferenceStatistics& statistics,
                                           Strategy strategy = Strategy::both, Aovs* aovs = nullptr);

}  // namespace nicol
