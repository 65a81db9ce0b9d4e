// SPDX-License-Identifier: MIT
// The planes of a framebuffer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "assets.hpp"

namespace nicol::capi {

struct PlaneKind {
    const char* name;
    std::size_t components;
    std::uint32_t aov = 0;  ///< AovBit of planes that a render makes on request
    bool coloured = aov == 0;
};

/// Throws Error(invalid_argument) unless it is a constant NICOL_PLANE_...
inline const PlaneKind& plane_kind(nicol_plane plane) {
    static constexpr std::array<PlaneKind, 14> kinds{{{"NICOL_PLANE_S0", 1},
                                                      {"NICOL_PLANE_S1", 1},
                                                      {"NICOL_PLANE_S2", 1},
                                                      {"NICOL_PLANE_S3", 1},
                                                      {"NICOL_PLANE_STOKES", 4},
                                                      {"NICOL_PLANE_DOLP", 1},
                                                      {"NICOL_PLANE_AOLP", 1},
                                                      {"NICOL_PLANE_DEPTH", 1, aov_depth},
                                                      {"NICOL_PLANE_NORMAL", 3, aov_normals},
                                                      {"NICOL_PLANE_POSITION", 3, aov_positions},
                                                      {"NICOL_PLANE_INSTANCE", 1, aov_instances},
                                                      {"NICOL_PLANE_VARIANCE", 4, aov_variance, true},
                                                      {"NICOL_PLANE_ALPHA", 1, aov_alpha},
                                                      {"NICOL_PLANE_POLARIZER", 1}}};
    require_constant(plane, NICOL_PLANE_POLARIZER, "plane", "NICOL_PLANE_...");
    return kinds[plane];
}

/// Throws Error(invalid_argument) for a name that ends as those of another kind of file than `own` do.
void require_suffix(const char* path, std::string_view own);

/// Throws Error(invalid_argument) unless the framebuffer has this channel.
inline void require_channel(std::uint32_t channel, int channels) {
    if (channel >= static_cast<std::uint32_t>(channels)) {
        refuse("channel is " + std::to_string(channel) + "; the framebuffer has " + std::to_string(channels) +
               ", counted from 0");
    }
}

/// Throws Error(invalid_argument) unless the plane has this channel: 0 for planes without channels.
inline void require_channel(const PlaneKind& kind, std::uint32_t channel, int channels) {
    if (kind.coloured) return require_channel(channel, channels);
    if (channel != 0) refuse(std::string("channel must be 0: ") + kind.name + " has none");
}

/// Throws Error(invalid_argument) unless the last render into the framebuffer made the plane.
inline void require_made(const PlaneKind& kind, const Framebuffer& framebuffer) {
    if ((framebuffer.aov_mask() & kind.aov) != kind.aov) {
        refuse(std::string("the plane ") + kind.name +
               " is not there: the options of the last render into the framebuffer did not ask for it");
    }
}

}  // namespace nicol::capi
