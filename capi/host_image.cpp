// SPDX-License-Identifier: MIT
#include "host_image.hpp"

#include <cmath>
#include <glm/vec2.hpp>

#include "gl/draw.hpp"
#include "initialiser.hpp"
#include "planes.hpp"
#include "progress.hpp"

namespace nicol::capi {
namespace {

constexpr int kTextureUnits = 16;  // as many as every driver has in a fragment shader

gl::Program& program(Session& session, const HostImage& image, bool depth) {
    std::vector<gl::Define> defines = image.defines;
    if (depth) defines.push_back({.name = "HOST_DEPTH", .value = std::to_string(image.textures)});
    std::string key = image.fragment;
    for (const gl::Define& define : defines) key += ' ' + define.name + '=' + define.value;
    if (!session.host_programs) session.host_programs = std::make_shared<HostPrograms>();
    auto& programs = session.host_programs->programs;
    auto found = programs.find(key);
    if (found == programs.end()) {
        found = programs
                    .emplace(std::move(key),
                             gl::Program::graphics(session.gl, "fullscreen.vert", image.fragment, defines))
                    .first;
    }
    return found->second;
}

bool reversed(const nicol_texture_target& target) {
    return target.depth_mapping == NICOL_DEPTH_MAPPING_PERSPECTIVE_REVERSED ||
           target.depth_mapping == NICOL_DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED;
}
bool orthographic(const nicol_texture_target& target) {
    return target.depth_mapping == NICOL_DEPTH_MAPPING_ORTHOGRAPHIC ||
           target.depth_mapping == NICOL_DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED;
}

/// Returns (x, y) of the host's depth: x + y * distance, or x + y / distance in perspective.
glm::vec2 mapping(const nicol_texture_target& target) {
    const double near = target.depth_near, far = target.depth_far;
    const double at_near = orthographic(target) ? near : 1 / near;
    const double at_far = orthographic(target) ? far : far == 0 ? 0 : 1 / far;
    // Depth is linear in these: 0 at the near plane and 1 at the far plane, or the other way round.
    const double zero = reversed(target) ? at_far : at_near, one = reversed(target) ? at_near : at_far;
    return {-zero / (one - zero), 1 / (one - zero)};
}

void check(const nicol_texture_target& target) {
    if (target.bottom_up > 1) refuse("target->bottom_up must be 0 or 1");
    require_constant(target.encoding, NICOL_ENCODING_SRGB, "target->encoding", "NICOL_ENCODING_...");
    require_constant(target.depth_mapping, NICOL_DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED, "target->depth_mapping",
                     "NICOL_DEPTH_MAPPING_...");
    if (target.depth_texture == 0) return;
    const double near = target.depth_near, far = target.depth_far;
    const bool endless = far == 0 && !orthographic(target);
    if (!std::isfinite(near) || !std::isfinite(far) || !(orthographic(target) || near > 0) ||
        !(endless || far > near)) {
        refuse(
            "target->depth_near is " + std::to_string(near) + " and depth_far " + std::to_string(far) +
            "; they must be finite and depth_far larger, in perspective depth_near above 0 and depth_far 0 "
            "for a projection without a far plane");
    }
}

/// Sets what an image in the host's depth buffer needs.
void prepare_depth(gl::Program& program, Framebuffer& framebuffer, const nicol_texture_target& target,
                   int unit) {
    const auto [attachments, first] = framebuffer.drawn_aov(aov_depth);
    attachments->colour(first / 4).bind(static_cast<unsigned>(unit));
    program.set("distance_component", first % 4);
    program.set("orthographic", orthographic(target) ? 1 : 0);
    program.set("depth_mapping", mapping(target));
}

}  // namespace

const gl::Texture2D& channel_texture(Framebuffer& framebuffer, int channel) {
    return framebuffer.groups()[static_cast<std::size_t>(channel / Framebuffer::kGroup)].colour(
        channel % Framebuffer::kGroup);
}

void draw(Session& session, Framebuffer& framebuffer, const HostImage& image,
          const nicol_texture_target& target) {
    check(target);
    const bool depth = target.depth_texture != 0;
    if (depth && image.textures >= kTextureUnits)
        refuse("target->depth_texture needs a framebuffer of at most " + std::to_string(kTextureUnits - 1) +
               " channels");
    if (depth) require_made(plane_kind(NICOL_PLANE_DEPTH), framebuffer);
    const Stopwatch watch;
    session.gl->run([&] {
        gl::RenderTarget drawn(
            session.gl, {.colour = target.texture, .formats = image.formats, .depth = target.depth_texture});
        if (drawn.width() != framebuffer.width() || drawn.height() != framebuffer.height()) {
            refuse("target->texture is of " + std::to_string(drawn.width()) + " x " +
                   std::to_string(drawn.height()) + " pixels and the framebuffer of " +
                   std::to_string(framebuffer.width()) + " x " + std::to_string(framebuffer.height()) +
                   "; they must agree");
        }
        for (int c = 0; c < framebuffer.channels(); ++c) {
            if (channel_texture(framebuffer, c).id() == target.texture) {
                refuse("target->texture is the framebuffer's own");
            }
        }
        gl::Program& observe = program(session, image, depth);
        image.prepare(observe);
        observe.set("bottom_up", static_cast<int>(target.bottom_up));
        if (observe.uses("encode")) observe.set("encode", target.encoding == NICOL_ENCODING_SRGB ? 1 : 0);
        if (!depth) {
            gl::draw_fullscreen(drawn, observe);
        } else {
            prepare_depth(observe, framebuffer, target, image.textures);
            gl::draw_fullscreen(
                drawn, observe,
                {.depth_test = gl::DepthTest::nearer_or_equal, .reversed_depth = reversed(target)});
        }
    });
    framebuffer.statistics().observe_ms += watch.milliseconds();
}

}  // namespace nicol::capi

NICOL_INITIALISER(nicol_texture_target, NICOL_TEXTURE_TARGET_INIT)
