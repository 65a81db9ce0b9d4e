// SPDX-License-Identifier: MIT
// Implementation of framebuffers and their attachments.
#include "gl/render_target.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "error.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

std::string text_of(const RenderTargetDescription& description) {
    return "a render target of " + std::to_string(description.width) + " x " +
           std::to_string(description.height) + " pixels with " + std::to_string(description.colours) +
           " colour attachments";
}

std::string text_of_status(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_UNDEFINED:
            return "GL_FRAMEBUFFER_UNDEFINED";
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT";
        case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
            return "GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "GL_FRAMEBUFFER_UNSUPPORTED";
        default:
            return "status " + std::to_string(status);
    }
}

const RenderTargetDescription& checked(const RenderTargetDescription& description, const Limits& limits) {
    const auto [width, height, colours, depth, format] = description;
    if (width < 1 || height < 1 || width > limits.target_size || height > limits.target_size)
        throw Error(ErrorCode::invalid_argument,
                    text_of(description) + ": each side must be 1 to " + std::to_string(limits.target_size));
    if (colours < 1 || colours > limits.colour_attachments)
        throw Error(ErrorCode::invalid_argument, text_of(description) + ": there may be 1 to " +
                                                     std::to_string(limits.colour_attachments));
    return description;
}

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

/// Returns the description of level 0 of a texture that is not ours.
RenderTargetDescription described(Context& context, unsigned texture) {
    const GladGLContext& gl = functions(context, "RenderTarget");
    const std::string what = "the texture " + std::to_string(texture);
    const auto refuse = [](const std::string& text) { throw Error(ErrorCode::invalid_argument, text); };
    if (gl.IsTexture(texture) != GL_TRUE) refuse(what + " does not exist in the host's context");
    if (HostState* const host = context.state().host_state) host->prepare_texture(0);
    if (target_of(context.state(), texture) != GL_TEXTURE_2D) refuse(what + " is not a GL_TEXTURE_2D");
    GLint format = 0, width = 0, height = 0;
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &width);
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &height);
    if (width < 1 || height < 1) refuse(what + " has no pixels yet");
    if (format != GL_RGBA8 && format != GL_SRGB8_ALPHA8 && format != GL_RGBA16F && format != GL_RGBA32F)
        refuse(what + " has the internal format " + std::to_string(format) +
               "; it must be GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F or GL_RGBA32F");
    context.state().check(what);
    return {.width = width, .height = height, .colours = 1, .depth = false};
}

std::shared_ptr<Context> required(std::shared_ptr<Context> context) {
    if (!context) throw Error(ErrorCode::invalid_argument, "a render target needs a context, not null");
    return context;
}

}  // namespace

RenderTarget::RenderTarget(const std::shared_ptr<Context>& context,
                           const RenderTargetDescription& description)
    : description_(checked(description, required(context)->limits())),
      framebuffer_(context, ObjectKind::framebuffer) {
    const GladGLContext& gl = functions(*context, "RenderTarget");
    Context::State& state = context->state();
    const auto [width, height, colours, has_depth, format] = description_;
    std::vector<GLenum> draw_buffers;
    for (int i = 0; i < colours; ++i) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        colours_.emplace_back(context, TextureDescription{.width = width, .height = height, .format = format},
                              std::span<const float>{}, MemoryKind::render_target);
        gl.NamedFramebufferTexture(id(), attachment, colours_.back().id(), 0);
        draw_buffers.push_back(attachment);
    }
    gl.NamedFramebufferDrawBuffers(id(), colours, draw_buffers.data());
    if (has_depth) {
        const Object& depth = depth_.emplace_back(context, ObjectKind::renderbuffer);
        gl.NamedRenderbufferStorage(depth.id(), GL_DEPTH_COMPONENT32F, width, height);
        state.check(text_of(description_) + " and depth");
        depth_.back().account(MemoryKind::render_target, sizeof(float) * static_cast<std::size_t>(width) *
                                                             static_cast<std::size_t>(height));
        gl.NamedFramebufferRenderbuffer(id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
    }
    const GLenum status = gl.CheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER);
    // Every driver can draw into these formats; an incomplete attachment is Mesa's only sign of missing
    // memory.
    const bool memory = status == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(memory ? ErrorCode::out_of_memory : ErrorCode::opengl,
                    text_of(description_) + ": the framebuffer is incomplete: " + text_of_status(status));
    state.check(text_of(description_));
    if (has_depth) clear_depth();
}

RenderTarget::RenderTarget(const std::shared_ptr<Context>& context, unsigned borrowed_texture)
    : description_(described(*required(context), borrowed_texture)),
      framebuffer_(context, ObjectKind::framebuffer) {
    const GladGLContext& gl = functions(*context, "RenderTarget");
    gl.NamedFramebufferTexture(id(), GL_COLOR_ATTACHMENT0, borrowed_texture, 0);
    const GLenum status = gl.CheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorCode::invalid_argument, "the texture " + std::to_string(borrowed_texture) +
                                                     " cannot be drawn into: " + text_of_status(status));
    context->state().check("drawing into a texture");
}

void RenderTarget::clear(const glm::vec4& colour) {
    for (int i = 0; i < colours(); ++i) clear_colour(i, colour);
    if (has_depth()) clear_depth();
}

void RenderTarget::clear_colour(int attachment, const glm::vec4& colour) {
    const GladGLContext& gl = functions(*context(), "RenderTarget::clear_colour");
    static_cast<void>(this->colour(attachment));  // throws for a missing attachment
    if (HostState* const host = context()->state().host_state) host->prepare_drawing();
    // The colour mask also applies to clearing.
    gl.ColorMaski(static_cast<GLuint>(attachment), GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (description_.format == Format::r32ui) {
        constexpr std::array<GLuint, 4> zero{};
        gl.ClearNamedFramebufferuiv(id(), GL_COLOR, attachment, zero.data());
    } else {
        gl.ClearNamedFramebufferfv(id(), GL_COLOR, attachment, &colour.x);
    }
    context()->state().check_command("RenderTarget::clear_colour");
}

void RenderTarget::clear_depth(float depth) {
    const GladGLContext& gl = functions(*context(), "RenderTarget::clear_depth");
    if (!has_depth())
        throw Error(ErrorCode::invalid_argument, "RenderTarget::clear_depth: the target has no depth buffer");
    if (!(depth >= 0.0f && depth <= 1.0f))
        throw Error(ErrorCode::invalid_argument,
                    "RenderTarget::clear_depth: " + std::to_string(depth) + " is not between 0 and 1");
    if (HostState* const host = context()->state().host_state) host->prepare_drawing();
    gl.DepthMask(GL_TRUE);  // the depth mask also applies to clearing
    gl.ClearNamedFramebufferfv(id(), GL_DEPTH, 0, &depth);
    context()->state().check_command("RenderTarget::clear_depth");
}

void RenderTarget::read(int attachment, std::span<float> pixels) const {
    colour(attachment).read(pixels);
}

void RenderTarget::read(int attachment, std::span<std::uint32_t> pixels) const {
    colour(attachment).read(pixels);
}

void RenderTarget::write(int attachment, std::span<const float> pixels) {
    colour(attachment).update(pixels);
}

Texture2D& RenderTarget::colour(int attachment) {
    static_cast<void>(std::as_const(*this).colour(attachment));  // throws for a missing attachment
    return colours_[static_cast<std::size_t>(attachment)];
}

const Texture2D& RenderTarget::colour(int attachment) const {
    if (attachment < 0 || static_cast<std::size_t>(attachment) >= colours_.size())
        throw Error(ErrorCode::invalid_argument, "RenderTarget: attachment " + std::to_string(attachment) +
                                                     " is not one of " + std::to_string(colours_.size()) +
                                                     ", counted from 0");
    return colours_[static_cast<std::size_t>(attachment)];
}

}  // namespace nicol::gl
