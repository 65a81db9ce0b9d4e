// SPDX-License-Identifier: MIT
#include "gl/borrowed_texture.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "error.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

struct TextureTarget {
    GLenum target, binding;
};
constexpr std::array kTextureTargets{
    TextureTarget{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
    TextureTarget{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    TextureTarget{GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
    TextureTarget{GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY},
    TextureTarget{GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    TextureTarget{GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
    TextureTarget{GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
    TextureTarget{GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
    TextureTarget{GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY},
    TextureTarget{GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
    TextureTarget{GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY}};

/// Returns the target of an existing texture; 0 if an extension defines the target. The function binds the
/// texture and checks the bindings, because Mesa's compatibility contexts do not answer
/// glGetTextureParameteriv(GL_TEXTURE_TARGET).
GLenum target_of(const Context::State& state, GLuint texture) {
    const GladGLContext& gl = state.gl;
    const auto bound = [&state](const TextureTarget& target) {
        return static_cast<GLuint>(state.integer(target.binding));
    };
    gl.ActiveTexture(GL_TEXTURE0);
    std::array<GLuint, kTextureTargets.size()> before{};
    std::ranges::transform(kTextureTargets, before.begin(), bound);
    gl.BindTextureUnit(0, texture);
    const auto found = std::ranges::find(kTextureTargets, texture, bound);
    if (found == kTextureTargets.end()) return 0;
    gl.BindTexture(found->target, before[static_cast<std::size_t>(found - kTextureTargets.begin())]);
    return found->target;
}

struct NamedFormat {
    GLint value;
    const char* name;
};
#define NICOL_FORMAT_NAME(format) \
    NamedFormat {                 \
        format, #format           \
    }
constexpr std::array kNumbers{NICOL_FORMAT_NAME(GL_RGBA8),   NICOL_FORMAT_NAME(GL_SRGB8_ALPHA8),
                              NICOL_FORMAT_NAME(GL_RGBA16F), NICOL_FORMAT_NAME(GL_RGBA32F),
                              NICOL_FORMAT_NAME(GL_R16F),    NICOL_FORMAT_NAME(GL_R32F)};
constexpr auto kColours = std::span(kNumbers).first(4);
constexpr std::array kIds{NICOL_FORMAT_NAME(GL_R32UI)};
constexpr std::array kDepths{NICOL_FORMAT_NAME(GL_DEPTH_COMPONENT16), NICOL_FORMAT_NAME(GL_DEPTH_COMPONENT24),
                             NICOL_FORMAT_NAME(GL_DEPTH_COMPONENT32F), NICOL_FORMAT_NAME(GL_DEPTH24_STENCIL8),
                             NICOL_FORMAT_NAME(GL_DEPTH32F_STENCIL8)};
#undef NICOL_FORMAT_NAME

std::span<const NamedFormat> formats_of(BorrowedFormats formats) {
    switch (formats) {
        case BorrowedFormats::numbers:
            return kNumbers;
        case BorrowedFormats::ids:
            return kIds;
        case BorrowedFormats::depths:
            return kDepths;
        case BorrowedFormats::stokes:
            return std::span(kNumbers).subspan(3, 1);
        default:
            return kColours;
    }
}

std::string names_of(std::span<const NamedFormat> formats) {
    std::string names = formats.front().name;
    for (std::size_t i = 1; i < formats.size(); ++i)
        names += std::string(i + 1 < formats.size() ? ", " : " or ") + formats[i].name;
    return names;
}

}  // namespace

BorrowedSize borrowed_size(Context& context, unsigned texture, BorrowedFormats accepted) {
    const GladGLContext& gl = functions(context, "borrowed_size");
    const std::span<const NamedFormat> formats = formats_of(accepted);
    const std::string what = "the texture " + std::to_string(texture);
    const auto refuse = [](const std::string& text) { throw Error(ErrorCode::invalid_argument, text); };
    if (gl.IsTexture(texture) != GL_TRUE) refuse(what + " does not exist in the host's context");
    if (HostState* const host = context.state().host_state) host->prepare_texture(0);
    if (target_of(context.state(), texture) != GL_TEXTURE_2D) refuse(what + " is not a GL_TEXTURE_2D");
    GLint format = 0;
    BorrowedSize size{};
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &size.width);
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &size.height);
    if (size.width < 1 || size.height < 1) refuse(what + " has no pixels yet");
    if (std::ranges::find(formats, format, &NamedFormat::value) == formats.end())
        refuse(what + " has the internal format " + std::to_string(format) + "; it must be " +
               names_of(formats));
    context.state().check(what);
    return size;
}

}  // namespace nicol::gl
