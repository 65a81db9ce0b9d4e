// SPDX-License-Identifier: MIT
// Save and restore of the host's OpenGL state that this library changes or depends on.
#pragma once

#include <array>
#include <vector>

#include "gl/host_program.hpp"
#include "gl/state.hpp"

namespace nicol::gl {

/// Saves the host's state on construction and sets the state of a fresh context of our own; restores the
/// host's state on destruction. The saved state is that which draw calls, dispatches, uploads and reads
/// change or depend on:
///   capabilities   depth, stencil and scissor test, culling, blending, logical operation, dithering, polygon
///                  offset and smoothing, sample masks, primitive restart, rasterizer discard, clip distances
///                  and depth clamp, sRGB writes; of compatibility contexts alpha test and stipple
///   values         viewports and depth ranges, colour and depth masks, blend functions and equations, depth
///                  function, culled and front face, polygon mode, clip control, provoking vertex, pixel
///                  storage; of compatibility contexts pixel transfer and clamping of colours
///   bindings       program with its subroutines, vertex array, draw framebuffer, pixel buffers, active
///                  texture; 2D textures and samplers of the first units, storage buffers (kTextureUnits and
///                  so on); the first image
/// Everything else is used without binding it.
class HostState {
public:
    static constexpr int kTextureUnits = 16;
    static constexpr int kStorageBindings = 16;

    explicit HostState(const Context::State& state);
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

private:
    struct Viewport {
        std::array<GLfloat, 4> rectangle;
        std::array<GLdouble, 2> depth_range;
        GLboolean scissor;
    };
    struct DrawBuffer {
        std::array<GLboolean, 4> mask;
        GLboolean blend;
        std::array<GLenum, 4> functions;  ///< source and destination factors of the colours, then of alpha
        GLenum colour_equation, alpha_equation;
    };
    struct TextureUnit {
        GLint texture, sampler;
    };
    struct StorageBinding {
        GLint name;
        GLint64 start, size;
    };
    struct ImageUnit {
        GLint texture, level, layered, layer, access, format;
    };

    void save();
    void save_units();
    void set();
    void set_pixels() const;
    void put_back_units() const;
    void put_back_pixels() const;
    void enable(GLenum capability, GLboolean on) const;
    [[nodiscard]] GLuint name(GLenum binding) const;

    const Context::State& state_;
    const GladGLContext& gl_;
    std::vector<GLenum> capability_names_;
    std::vector<GLboolean> capabilities_;
    std::vector<GLint> pixel_stores_;
    std::vector<GLfloat> pixel_transfers_;
    GLint clamp_fragments_ = 0;
    std::vector<Viewport> viewports_;
    std::vector<DrawBuffer> draw_buffers_;
    std::vector<TextureUnit> texture_units_;
    std::vector<StorageBinding> storage_;
    ImageUnit image_{};
    GLboolean depth_mask_ = GL_TRUE;
    GLint depth_function_ = 0, culled_ = 0, front_ = 0, provoking_ = 0, clip_origin_ = 0, clip_depth_ = 0;
    std::array<GLint, 2> polygon_mode_{};
    HostProgram program_;
    GLuint vertex_array_ = 0, framebuffer_ = 0, pack_ = 0, unpack_ = 0, storage_buffer_ = 0;
    GLint active_texture_ = 0;
};

}  // namespace nicol::gl
