// SPDX-License-Identifier: MIT
// Transpose of the shade step: from gradients of Stokes vectors to gradients of the light that is shaded.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "harmonics/light_layout.hpp"
#include "material/layer_weights.hpp"
#include "material/response_table.hpp"
#include "polarization/views.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Sets blocks of light to the gradient of the light that Shade::run() of a material's layers takes. stokes:
/// the gradient of the Stokes vectors that it writes, [channel][position]; the light has as many channels.
/// layers: [layer]; weights: [block of sixteen][layer]. Calls for different blocks may run side by side.
void shade_gradient(const LightLayout& layout, std::span<const ResponseTable* const> layers,
                    std::span<const LayerWeights> weights, const Views& views,
                    std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                    std::span<const std::span<glm::vec4>> stokes, VertexLight& light);

}  // namespace nicol
