// SPDX-License-Identifier: MIT
// The reference method: its options and its statistics. An image by rays and the integral of light over
// directions, without harmonics; every error of the real-time methods is measured against it.
#pragma once

#include <cstdint>
#include <functional>

namespace nicol {

/// Most samples a pixel.
inline constexpr int kMaxReferenceSamples = 1 << 20;

struct ReferenceOptions {
    /// Camera rays a pixel, 1..kMaxReferenceSamples; each that hits a surface sends one ray towards the
    /// environment, one towards each small light (of more than 16 surfaces that shine, to one of them) and
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

}  // namespace nicol
