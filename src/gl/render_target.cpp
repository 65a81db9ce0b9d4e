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

RenderTargetDescription described(Context& context, const BorrowedTextures& borrowed) {
    const BorrowedSize size = borrowed_size(context, borrowed.colour, borrowed.formats);
    if (borrowed.depth != 0 && borrowed_size(context, borrowed.depth, BorrowedFormats::depths) != size)
        throw Error(ErrorCode::invalid_argument, "the depth texture " + std::to_string(borrowed.depth) +
                                                     " has another size than the texture " +
                                                     std::to_string(borrowed.colour));
    return {.width = size.width, .height = size.height, .colours = 1, .depth = borrowed.depth != 0};
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
    const auto [width, height, colours, has_depth, format] = description_;
    for (int i = 0; i < colours; ++i)
        colours_.emplace_back(context, TextureDescription{.width = width, .height = height, .format = format},
                              std::span<const float>{}, MemoryKind::render_target);
    attach();
}

RenderTarget::RenderTarget(std::vector<Texture2D> colours)
    : description_{.width = colours.at(0).width(),
                   .height = colours[0].height(),
                   .colours = static_cast<int>(colours.size()),
                   .format = colours[0].format()},
      colours_(std::move(colours)),
      framebuffer_(colours_[0].context(), ObjectKind::framebuffer) {
    static_cast<void>(checked(description_, context()->limits()));
    attach();
}

void RenderTarget::attach() {
    const GladGLContext& gl = functions(*context(), "RenderTarget");
    Context::State& state = context()->state();
    const auto [width, height, colours, has_depth, format] = description_;
    std::vector<GLenum> draw_buffers;
    for (const Texture2D& colour : colours_) {
        draw_buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw_buffers.size()));
        gl.NamedFramebufferTexture(id(), draw_buffers.back(), colour.id(), 0);
    }
    gl.NamedFramebufferDrawBuffers(id(), colours, draw_buffers.data());
    if (has_depth) {
        Object& depth = depth_.emplace_back(context(), ObjectKind::renderbuffer);
        depth.account(MemoryKind::render_target,
                      sizeof(float) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        gl.NamedRenderbufferStorage(depth.id(), GL_DEPTH_COMPONENT32F, width, height);
        state.check(text_of(description_) + " and depth");
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

RenderTarget::RenderTarget(const std::shared_ptr<Context>& context, const BorrowedTextures& borrowed)
    : description_(described(*required(context), borrowed)), framebuffer_(context, ObjectKind::framebuffer) {
    const GladGLContext& gl = functions(*context, "RenderTarget");
    gl.NamedFramebufferTexture(id(), GL_COLOR_ATTACHMENT0, borrowed.colour, 0);
    if (borrowed.depth != 0) gl.NamedFramebufferTexture(id(), GL_DEPTH_ATTACHMENT, borrowed.depth, 0);
    const GLenum status = gl.CheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorCode::invalid_argument, "the texture " + std::to_string(borrowed.colour) +
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
