// SPDX-License-Identifier: MIT
// Textures of numbers that are linear functions of others.
#pragma once

#include "texture/texture.hpp"

namespace nicol {

/// Returns a texture of one channel: factor t + offset, t being the first channel of `texture`, clamped to
/// 0..1. Throws Error(unsupported) for colours of a mesh, alone or as a factor, and Error(invalid_argument)
/// for null.
[[nodiscard]] TexturePtr affine_texture(const TexturePtr& texture, float factor, float offset);

}  // namespace nicol
