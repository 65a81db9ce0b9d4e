// SPDX-License-Identifier: MIT
// Sizes of assets, for the context's memory monitor.
#pragma once

#include <cstdint>

#include "geometry/mesh.hpp"
#include "light/environment.hpp"
#include "material/material.hpp"
#include "scene/scene.hpp"
#include "texture/texture.hpp"

namespace nicol::capi {

/// Each returns the bytes of an asset's arrays. A material has those of a measured table alone, because its
/// textures are assets of their own.
[[nodiscard]] std::uint64_t bytes_of(const Mesh& mesh);
[[nodiscard]] std::uint64_t bytes_of(const Texture& texture);
[[nodiscard]] std::uint64_t bytes_of(const Environment& environment);
[[nodiscard]] std::uint64_t bytes_of(const Material& material);
/// Returns the bytes of all meshes, textures, measured tables and light of a scene, each counted once.
[[nodiscard]] std::uint64_t bytes_of(const Scene& scene);

}  // namespace nicol::capi
