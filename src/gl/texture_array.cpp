// SPDX-License-Identifier: MIT
#include "gl/texture_array.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "error.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {

TextureArray::TextureArray(std::shared_ptr<Context> context, int width, int height, int layers)
    : object_(std::move(context), ObjectKind::texture, GL_TEXTURE_2D_ARRAY),
      width_(width),
      height_(height),
      layers_(layers) {
    const GladGLContext& gl = functions(*object_.context(), "TextureArray");
    Context::State& state = object_.context()->state();
    const std::string what = "an array of " + std::to_string(layers) + " images of " + std::to_string(width) +
                             " x " + std::to_string(height) + " texels";
    if (std::min({width, height, layers}) < 1 || std::max(width, height) > state.limits.texture_size)
        throw Error(ErrorCode::invalid_argument, what + ": each side must be 1 to " +
                                                     std::to_string(state.limits.texture_size) +
                                                     ", and there must be a layer");
    constexpr std::size_t texel = 4 * sizeof(float);
    object_.account(MemoryKind::texture, static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                             static_cast<std::size_t>(layers) * texel);
    gl.TextureStorage3D(object_.id(), 1, GL_RGBA32F, width, height, layers);
    state.check(what);
}

void TextureArray::clear() {
    const GladGLContext& gl = functions(*object_.context(), "TextureArray::clear");
    Context::State& state = object_.context()->state();
    if (state.host_state != nullptr) state.host_state->prepare_uploads();
    gl.ClearTexImage(object_.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
    state.check_command("TextureArray::clear");
}

void TextureArray::bind_image() const {
    const GladGLContext& gl = functions(*object_.context(), "TextureArray::bind_image");
    Context::State& state = object_.context()->state();
    if (state.host_state != nullptr) state.host_state->prepare_image();
    gl.BindImageTexture(0, object_.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    state.check_command("TextureArray::bind_image");
}

void TextureArray::copy_layer(int layer, Texture2D& to) const {
    const GladGLContext& gl = functions(*object_.context(), "TextureArray::copy_layer");
    if (to.width() != width_ || to.height() != height_ || to.format() != Format::rgba32f || layer < 0 ||
        layer >= layers_)
        throw Error(ErrorCode::invalid_argument,
                    "TextureArray::copy_layer: no such layer, or a texture of another size or format");
    gl.CopyImageSubData(object_.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                        width_, height_, 1);
    object_.context()->state().check_command("TextureArray::copy_layer");
}

}  // namespace nicol::gl
