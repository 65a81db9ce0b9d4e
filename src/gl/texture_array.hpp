// SPDX-License-Identifier: MIT
// Two-dimensional images of one size and four floats, which one dispatch writes.
#pragma once

#include <cstddef>
#include <memory>

#include "gl/object.hpp"
#include "gl/texture.hpp"

namespace nicol::gl {

/// An array of layers of RGBA32F texels. All members must be called inside run().
class TextureArray {
public:
    /// Makes an array, whose content is unspecified. Throws Error(invalid_argument) for a size outside the
    /// limits, Error(out_of_memory) if the driver cannot hold it.
    TextureArray(std::shared_ptr<Context> context, int width, int height, int layers);

    /// Makes all texels zero.
    void clear();
    /// Binds all layers for a `layout(binding = 0, rgba32f) writeonly uniform image2DArray`, the only image
    /// of a program.
    void bind_image() const;
    /// Copies a layer to a texture of equal size and four floats.
    void copy_layer(int layer, Texture2D& to) const;

private:
    Object object_;
    int width_, height_, layers_;
};

}  // namespace nicol::gl
