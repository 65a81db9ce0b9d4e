// SPDX-License-Identifier: MIT
// Textures that belong to the host.
#pragma once

#include "gl/context.hpp"

namespace nicol::gl {

/// Formats that a borrowed texture may have.
enum class BorrowedFormats {
    colours,  ///< RGBA8, SRGB8_ALPHA8, RGBA16F or RGBA32F
    numbers,  ///< those, R16F or R32F
    ids,      ///< R32UI
    depths,   ///< depth, with or without stencil
    stokes,   ///< RGBA32F
};

struct BorrowedSize {
    int width = 0, height = 0;
    bool operator==(const BorrowedSize&) const = default;
};

/// Returns the size of level 0 of a texture, which must be a GL_TEXTURE_2D of one of the formats. Must be
/// called inside run(). Throws Error(invalid_argument) that names the texture.
[[nodiscard]] BorrowedSize borrowed_size(Context& context, unsigned texture, BorrowedFormats formats);

}  // namespace nicol::gl
