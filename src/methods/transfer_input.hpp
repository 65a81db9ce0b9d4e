// SPDX-License-Identifier: MIT
// Input of every transfer method.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/psh.hpp"
#include "material/followed_terms.hpp"
#include "surfaces/surface_state.hpp"

namespace nicol {

class LocalLights;

/// Surfaces, and the distant light's coefficients.
struct TransferInput : SurfaceState {
    const LightLayout& layout;
    const PshVector& light;  ///< coefficients in the geometry's axes; one channel if all are equal
    Version light_version;   ///< version of `light` and the order of `layout`
    int channels;            ///< channels of the image
    SampledTerms sampled;    ///< terms of materials that are not reflected in harmonics
    /// Whether pixels are shaded instead of vertices. If so, relight leaves light in the geometry's axes,
    /// which can be interpolated.
    bool at_pixels = false;
    /// Whether rays from pixels show what followed terms of follows_lobes() reflect of other surfaces.
    bool follows_lobes = false;
    /// Whether the vertices' light is direct light alone, and pixels add what terms that rays do not follow
    /// reflect of bounced light. If not, bounced light is part of the vertices' light.
    bool bounces_apart = false;
    /// Largest number of times that light is reflected before the reflection that is shaded; 0: direct light.
    /// Above 0, the surfaces have visibility and the light has the image's channels.
    int bounces = 0;
    int bounce_order = 0;  ///< order of bounced light, at most that of `light`
    /// Components of bounced light. If it does not stay apart, `layout` has them, too.
    LightKind bounced = LightKind::unpolarized;
    /// Error of the bounced light, relative to all light, that ends the bounces earlier.
    double negligible_bounces = 0;
    const LocalLights* local_lights = nullptr;  ///< lights that bounce beside the distant light; null: none
    /// Number of leading components of reflected light that are shaded even if they are zero.
    std::size_t least_components = 1;
    /// Number of leading components of reflected light that are shaded if they are not zero.
    std::size_t most_components = 4;
    /// Returns 1 for each vertex whose light the image may show, else 0. Empty: the image may show all.
    std::function<std::span<const std::uint8_t>()> seen = {};

    /// Returns whether rays follow what surfaces of a material reflect of other surfaces.
    [[nodiscard]] bool follows(const Material& material) const {
        return follows_lobes && nicol::follows_lobes(material);
    }
};

/// Stokes vectors of vertices, [channel of the image][vertex].
using VertexStokes = std::vector<std::vector<glm::vec4>>;

}  // namespace nicol
