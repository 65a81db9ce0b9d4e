// SPDX-License-Identifier: MIT
// Images drawn into textures of the host by OpenGL alone.
#pragma once

#include <cstdint>
#include <map>

#include "gl/program.hpp"
#include "handles.hpp"

namespace nicol::capi {

/// Programs by number of channels, kept for later images.
struct HostObserver {
    std::map<int, gl::Program> programs;
};

/// Throws Error(invalid_argument) unless the framebuffer has this channel.
void require_channel(const Framebuffer& framebuffer, std::uint32_t channel);
const gl::Texture2D& channel_texture(Framebuffer& framebuffer, int channel);

/// Draws one channel into a target, as draw_observation() draws an observation. Both functions throw
/// Error(invalid_argument) for a target that cannot be drawn into or has another size, and
/// Error(not_current).
void draw_stokes(Session& session, Framebuffer& framebuffer, int channel, const nicol_texture_target& target);
void draw_observation(Session& session, Framebuffer& framebuffer, const nicol_observation& observation,
                      const nicol_texture_target& target);

}  // namespace nicol::capi
