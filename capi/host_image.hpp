// SPDX-License-Identifier: MIT
// Images drawn into textures of the host by OpenGL alone.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gl/program.hpp"
#include "handles.hpp"

namespace nicol::capi {

/// Programs by fragment shader and defines, kept for later images.
struct HostPrograms {
    std::map<std::string, gl::Program> programs;
};

/// An image that a fragment shader makes from a framebuffer, pixel by pixel.
struct HostImage {
    const char* fragment;  ///< file of the fragment shader
    std::vector<gl::Define> defines = {};
    int textures = 0;  ///< number of texture units that prepare() binds, from 0 on
    gl::BorrowedFormats formats = gl::BorrowedFormats::colours;
    std::function<void(gl::Program&)> prepare = {};  ///< binds textures and sets uniforms
};

/// Returns the texture of a colour channel.
const gl::Texture2D& channel_texture(Framebuffer& framebuffer, int channel);

/// Draws an image of the framebuffer into a target, and into the target's depth where there is one. Throws
/// Error(invalid_argument) for a target that cannot be drawn into or has another size, and
/// Error(not_current).
void draw(Session& session, Framebuffer& framebuffer, const HostImage& image,
          const nicol_texture_target& target);

/// Return the images of nicol_framebuffer_draw_observation and nicol_framebuffer_draw_plane. Both must be
/// drawn while the framebuffer lives. Throw Error(invalid_argument) for what cannot be drawn.
HostImage observation_image(Framebuffer& framebuffer, const nicol_observation& observation);
HostImage plane_image(Framebuffer& framebuffer, nicol_plane plane, std::uint32_t channel);

}  // namespace nicol::capi
