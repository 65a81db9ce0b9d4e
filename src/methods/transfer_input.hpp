// SPDX-License-Identifier: MIT
// What every method of transfer starts from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/psh.hpp"
#include "surfaces/surface_state.hpp"

namespace nicol {

/// A scene as numbers.
struct TransferInput : SurfaceState {
    const LightLayout& layout;
    const PshVector& light;  ///< in the geometry's axes, scaled; one channel where all are equal
    Version light_version;   ///< another for each layout, too
    int channels;            ///< of the image
    /// Pixels are shaded, not vertices: relight leaves light in the geometry's axes, which can be
    /// interpolated.
    bool at_pixels = false;
    /// Of reflected light: the first so many components are shaded even where they are zero ...
    std::size_t least_components = 1;
    /// ... and so many where they are not.
    std::size_t most_components = 4;
};

/// One Stokes vector a vertex for each channel of the image.
using VertexStokes = std::vector<std::vector<glm::vec4>>;

}  // namespace nicol
