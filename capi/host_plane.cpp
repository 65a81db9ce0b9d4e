// SPDX-License-Identifier: MIT
// Planes of a framebuffer drawn into textures of the host.
#include <algorithm>

#include "host_image.hpp"
#include "planes.hpp"

namespace nicol::capi {
namespace {

/// Kinds of planes in the numbering of glsl/plane.frag.
enum class DrawnKind { stored, dolp, aolp };

DrawnKind kind_of(nicol_plane plane) {
    if (plane == NICOL_PLANE_DOLP) return DrawnKind::dolp;
    return plane == NICOL_PLANE_AOLP ? DrawnKind::aolp : DrawnKind::stored;
}

/// Binds the textures that hold the numbers of a plane from unit 0 on; returns the component of the first
/// texture where they begin.
int bind(Framebuffer& framebuffer, nicol_plane plane, const PlaneKind& kind, int channel) {
    if (kind.aov == 0) {
        for (const unsigned unit : {0U, 1U}) channel_texture(framebuffer, channel).bind(unit);
        return plane < NICOL_PLANE_STOKES ? static_cast<int>(plane) : 0;
    }
    const auto [attachments, first] = framebuffer.drawn_aov(static_cast<AovBit>(kind.aov));
    for (const int i : {0, 1})
        attachments->colour(std::min(first / 4 + i, attachments->colours() - 1))
            .bind(static_cast<unsigned>(i));
    return first % 4;
}

}  // namespace

HostImage plane_image(Framebuffer& framebuffer, nicol_plane plane, std::uint32_t channel) {
    const PlaneKind& kind = plane_kind(plane);
    require_channel(kind, channel, framebuffer.channels());
    require_made(kind, framebuffer);
    if (plane == NICOL_PLANE_VARIANCE)
        refuse("NICOL_PLANE_VARIANCE is not on the device; nicol_framebuffer_read_plane reads it");
    if (plane == NICOL_PLANE_POLARIZER)
        refuse("NICOL_PLANE_POLARIZER has an angle; nicol_framebuffer_draw_observation draws it");
    const bool ids = plane == NICOL_PLANE_INSTANCE;
    HostImage image{.fragment = "plane.frag", .textures = 2};
    if (kind.components == 1) image.formats = ids ? gl::BorrowedFormats::ids : gl::BorrowedFormats::numbers;
    if (ids) image.defines.push_back({.name = "IDS"});
    image.prepare = [&framebuffer, &kind, plane, channel](gl::Program& program) {
        const auto set = [&program](const char* name, int value) {
            if (program.uses(name)) program.set(name, value);  // ids have no kinds
        };
        set("first", bind(framebuffer, plane, kind, static_cast<int>(channel)));
        set("count", static_cast<int>(kind.components));
        set("kind", static_cast<int>(kind_of(plane)));
    };
    return image;
}

}  // namespace nicol::capi
