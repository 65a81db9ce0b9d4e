// SPDX-License-Identifier: MIT
// RGBA32F textures of one level.
#include "gl/texture.hpp"

#include <algorithm>
#include <string>

#include "error.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

std::string size_text(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

GLint wrap_mode(Wrap wrap) {
    switch (wrap) {
        case Wrap::clamp:
            return GL_CLAMP_TO_EDGE;
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::mirror:
            break;
    }
    return GL_MIRRORED_REPEAT;
}

void require_floats(const char* what, std::size_t given, int width, int height) {
    const std::size_t needed = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
    if (given != needed)
        throw Error(ErrorCode::invalid_argument, std::string(what) + ": " + size_text(width, height) +
                                                     " texels are " + std::to_string(needed) +
                                                     " floats, not " + std::to_string(given));
}

void require_unit(const char* what, unsigned unit, int limit) {
    if (unit >= static_cast<unsigned>(limit))
        throw Error(ErrorCode::invalid_argument, std::string(what) + ": unit " + std::to_string(unit) +
                                                     " is not below the limit of " + std::to_string(limit));
}

}  // namespace

Texture2D::Texture2D(std::shared_ptr<Context> context, const TextureDescription& description,
                     std::span<const float> texels, MemoryKind kind)
    : object_(std::move(context), ObjectKind::texture), description_(description) {
    const auto [width, height, filter, wrap_x, wrap_y] = description;
    const GladGLContext& gl = functions(*this->context(), "Texture2D");
    Context::State& state = this->context()->state();
    const int limit = state.limits.texture_size;
    if (width < 1 || height < 1 || width > limit || height > limit)
        throw Error(ErrorCode::invalid_argument, "a texture of " + size_text(width, height) +
                                                     " texels: each side must be 1 to " +
                                                     std::to_string(limit));
    if (!texels.empty()) require_floats("Texture2D", texels.size(), width, height);
    const std::string what = "a texture of " + size_text(width, height) + " texels";
    gl.TextureStorage2D(id(), 1, GL_RGBA32F, width, height);
    state.check(what);
    object_.account(kind, floats() * sizeof(float));
    const GLint mode = filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
    gl.TextureParameteri(id(), GL_TEXTURE_MIN_FILTER, mode);
    gl.TextureParameteri(id(), GL_TEXTURE_MAG_FILTER, mode);
    gl.TextureParameteri(id(), GL_TEXTURE_WRAP_S, wrap_mode(wrap_x));
    gl.TextureParameteri(id(), GL_TEXTURE_WRAP_T, wrap_mode(wrap_y));
    if (texels.empty())
        gl.ClearTexImage(id(), 0, GL_RGBA, GL_FLOAT, nullptr);
    else
        gl.TextureSubImage2D(id(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
    state.check(what);
}

void Texture2D::update(std::span<const float> texels) {
    update(0, 0, width(), height(), texels);
}

void Texture2D::update(int x, int y, int width, int height, std::span<const float> texels) {
    const GladGLContext& gl = functions(*context(), "Texture2D::update");
    if (x < 0 || y < 0 || width < 1 || height < 1 || x > this->width() - width || y > this->height() - height)
        throw Error(ErrorCode::invalid_argument, "Texture2D::update: " + size_text(width, height) +
                                                     " texels at (" + std::to_string(x) + ", " +
                                                     std::to_string(y) + ") do not lie in " +
                                                     size_text(this->width(), this->height()));
    require_floats("Texture2D::update", texels.size(), width, height);
    gl.TextureSubImage2D(id(), 0, x, y, width, height, GL_RGBA, GL_FLOAT, texels.data());
    context()->state().check("Texture2D::update");
}

void Texture2D::read(std::span<float> texels) const {
    const GladGLContext& gl = functions(*context(), "Texture2D::read");
    require_floats("Texture2D::read", texels.size(), width(), height());
    // In bands, because OpenGL counts the bytes of one transfer with 31 bits.
    constexpr std::size_t band_bytes = std::size_t{1} << 30;
    const std::size_t row_floats = static_cast<std::size_t>(width()) * 4;
    const int band = static_cast<int>(std::max<std::size_t>(1, band_bytes / (row_floats * sizeof(float))));
    for (int y = 0; y < height(); y += band) {
        const int rows = std::min(band, height() - y);
        const std::span<float> part = texels.subspan(static_cast<std::size_t>(y) * row_floats,
                                                     static_cast<std::size_t>(rows) * row_floats);
        gl.GetTextureSubImage(id(), 0, 0, y, 0, width(), rows, 1, GL_RGBA, GL_FLOAT,
                              static_cast<GLsizei>(part.size_bytes()), part.data());
    }
    context()->state().check("Texture2D::read");
}

void Texture2D::bind(unsigned unit) const {
    const GladGLContext& gl = functions(*context(), "Texture2D::bind");
    require_unit("Texture2D::bind", unit, context()->limits().texture_units);
    gl.BindTextureUnit(unit, id());
}

std::size_t Texture2D::floats() const noexcept {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 4;
}

}  // namespace nicol::gl
