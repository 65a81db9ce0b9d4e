// SPDX-License-Identifier: MIT
// Textures and layers of a material, on the device.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "material/spatial_variation.hpp"

namespace nicol {

/// Textures and layers of a material as glsl/texture.glsl and glsl/pixel_texture.comp read them. All members
/// must be called inside run() of the context.
class VariationBuffers {
public:
    /// Throws Error(unsupported) for textures of more texels than the driver lets a shader reach.
    VariationBuffers(const std::shared_ptr<gl::Context>& context, const SpatialVariation& variation);

    /// Binds the buffers of texture.glsl's words and texels.
    void bind(unsigned table, unsigned texels) const;
    /// Returns the value of the define TEXTURES.
    [[nodiscard]] int textures() const noexcept { return textures_; }
    [[nodiscard]] std::size_t layers() const noexcept { return layers_; }

private:
    int textures_ = 0;
    std::size_t layers_;
    std::optional<gl::Buffer> table_;
    std::optional<gl::Buffer> texels_;
};

}  // namespace nicol
