// SPDX-License-Identifier: MIT
// Implementation of textures of one level.
#include "gl/texture.hpp"

#include <algorithm>
#include <string>
#include <tuple>

#include "error.hpp"
#include "gl/borrowed_texture.hpp"
#include "gl/host_state.hpp"
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

// Memory layout of a format's numbers.
struct Layout {
    GLenum internal, format, type;
    std::size_t components;
};

Layout layout_of(Format format) {
    switch (format) {
        case Format::r32f:
            return {GL_R32F, GL_RED, GL_FLOAT, 1};
        case Format::r32ui:
            return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1};
        case Format::rgba32f:
            break;
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4};
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
    const auto [width, height, filter, wrap_x, wrap_y, format] = description;
    const Layout layout = layout_of(format);
    const GladGLContext& gl = functions(*this->context(), "Texture2D");
    Context::State& state = this->context()->state();
    const int limit = state.limits.texture_size;
    if (width < 1 || height < 1 || width > limit || height > limit)
        throw Error(ErrorCode::invalid_argument, "a texture of " + size_text(width, height) +
                                                     " texels: each side must be 1 to " +
                                                     std::to_string(limit));
    if (!texels.empty()) check_numbers("Texture2D", true, texels.size(), width, height);
    const std::string what = "a texture of " + size_text(width, height) + " texels";
    object_.account(kind, numbers() * sizeof(float));
    gl.TextureStorage2D(id(), 1, layout.internal, width, height);
    state.check(what);
    const GLint mode = filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
    gl.TextureParameteri(id(), GL_TEXTURE_MIN_FILTER, mode);
    gl.TextureParameteri(id(), GL_TEXTURE_MAG_FILTER, mode);
    gl.TextureParameteri(id(), GL_TEXTURE_WRAP_S, wrap_mode(wrap_x));
    gl.TextureParameteri(id(), GL_TEXTURE_WRAP_T, wrap_mode(wrap_y));
    if (state.host_state != nullptr) state.host_state->prepare_uploads();
    if (texels.empty())
        gl.ClearTexImage(id(), 0, layout.format, layout.type, nullptr);
    else
        gl.TextureSubImage2D(id(), 0, 0, 0, width, height, layout.format, layout.type, texels.data());
    state.check(what);
}

Texture2D Texture2D::borrowed(std::shared_ptr<Context> context, unsigned texture) {
    const BorrowedSize size = borrowed_size(*context, texture, BorrowedFormats::stokes);
    const GladGLContext& gl = functions(*context, "Texture2D::borrowed");
    GLint immutable = GL_FALSE;
    gl.GetTextureParameteriv(texture, GL_TEXTURE_IMMUTABLE_FORMAT, &immutable);
    if (immutable != GL_TRUE)
        throw Error(
            ErrorCode::invalid_argument,
            "the texture " + std::to_string(texture) +
                " may lose its storage; it must be allocated by glTexStorage2D or glTextureStorage2D");
    return {Object::borrowed(std::move(context), ObjectKind::texture, texture),
            {.width = size.width, .height = size.height}};
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
    check_numbers("Texture2D::update", true, texels.size(), width, height);
    const Layout layout = layout_of(format());
    if (HostState* const host = context()->state().host_state) host->prepare_uploads();
    gl.TextureSubImage2D(id(), 0, x, y, width, height, layout.format, layout.type, texels.data());
    context()->state().check_command("Texture2D::update");
}

void Texture2D::read(std::span<float> texels) const {
    check_numbers("Texture2D::read", true, texels.size(), width(), height());
    read(texels.data());
}

void Texture2D::read(std::span<std::uint32_t> texels) const {
    check_numbers("Texture2D::read", false, texels.size(), width(), height());
    read(texels.data());
}

void Texture2D::read(void* texels) const {
    const GladGLContext& gl = functions(*context(), "Texture2D::read");
    const Layout layout = layout_of(format());
    if (HostState* const host = context()->state().host_state) host->prepare_reads();
    // Texels are read in bands, because OpenGL counts the bytes of one transfer with 31 bits.
    constexpr std::size_t band_bytes = std::size_t{1} << 30;
    const std::size_t row_bytes = static_cast<std::size_t>(width()) * layout.components * sizeof(float);
    const int band = static_cast<int>(std::max<std::size_t>(1, band_bytes / row_bytes));
    for (int y = 0; y < height(); y += band) {
        const int rows = std::min(band, height() - y);
        gl.GetTextureSubImage(id(), 0, 0, y, 0, width(), rows, 1, layout.format, layout.type,
                              static_cast<GLsizei>(static_cast<std::size_t>(rows) * row_bytes),
                              static_cast<std::byte*>(texels) + static_cast<std::size_t>(y) * row_bytes);
    }
    context()->state().check("Texture2D::read");
}

void Texture2D::check_numbers(const char* what, bool floats, std::size_t given, int width, int height) const {
    if (floats == (format() == Format::r32ui))
        throw Error(ErrorCode::invalid_argument,
                    std::string(what) + ": the texels are " + (floats ? "unsigned integers" : "floats"));
    const std::size_t needed =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * layout_of(format()).components;
    if (given != needed)
        throw Error(ErrorCode::invalid_argument, std::string(what) + ": " + size_text(width, height) +
                                                     " texels are " + std::to_string(needed) +
                                                     " numbers, not " + std::to_string(given));
}

void Texture2D::bind(unsigned unit) const {
    std::ignore = functions(*context(), "Texture2D::bind");
    require_unit("Texture2D::bind", unit, context()->limits().texture_units);
    if (HostState* const host = context()->state().host_state) host->prepare_texture(unit);
    Context::State::want(context()->state().textures, unit, GLuint{id()});
}

void Texture2D::copy_from(const Texture2D& other) {
    const GladGLContext& gl = functions(*context(), "Texture2D::copy_from");
    if (other.width() != width() || other.height() != height() || other.format() != format())
        throw Error(ErrorCode::invalid_argument,
                    "Texture2D::copy_from: textures of different sizes or formats");
    gl.CopyImageSubData(other.id(), GL_TEXTURE_2D, 0, 0, 0, 0, id(), GL_TEXTURE_2D, 0, 0, 0, 0, width(),
                        height(), 1);
    context()->state().check_command("Texture2D::copy_from");
}

void Texture2D::bind_image() const {
    const GladGLContext& gl = functions(*context(), "Texture2D::bind_image");
    if (HostState* const host = context()->state().host_state) host->prepare_image();
    gl.BindImageTexture(0, id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, layout_of(format()).internal);
    context()->state().check_command("Texture2D::bind_image");
}

std::size_t Texture2D::numbers() const noexcept {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) *
           layout_of(format()).components;
}

}  // namespace nicol::gl
