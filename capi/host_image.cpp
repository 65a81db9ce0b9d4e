// SPDX-License-Identifier: MIT
#include "host_image.hpp"

#include <cmath>
#include <glm/vec4.hpp>
#include <numbers>
#include <vector>

#include "gl/draw.hpp"
#include "progress.hpp"

namespace nicol::capi {
namespace {

/// Observers in the numbering of glsl/observe.frag.
enum class Observer { stokes, radiance, signed_component, dolp, aolp };

struct Observed {
    Observer observer = Observer::stokes;
    glm::vec4 analyzer{0.0F};
    int first = 0;  // first channel
    int channels = 1;
};

float stops(float exposure) {
    if (!(std::abs(exposure) <= 100)) {
        refuse("observation->exposure is " + std::to_string(exposure) + "; it must lie in -100 to 100 stops");
    }
    return std::exp2(exposure);
}

Observed observe(const nicol_observation& given, int channels) {
    Observed o{.channels = channels};
    switch (given.kind) {
        case NICOL_OBSERVATION_S0:
            o.observer = Observer::radiance;
            o.analyzer.x = stops(given.exposure);
            break;
        case NICOL_OBSERVATION_POLARIZER: {
            if (!std::isfinite(given.polarizer_angle)) refuse("observation->polarizer_angle must be finite");
            const double twice = static_cast<double>(given.polarizer_angle) * std::numbers::pi / 90;
            o.observer = Observer::radiance;
            o.analyzer = 0.5F * stops(given.exposure) * glm::vec4(1, std::cos(twice), std::sin(twice), 0);
            break;
        }
        case NICOL_OBSERVATION_S1:
        case NICOL_OBSERVATION_S2:
        case NICOL_OBSERVATION_S3:
            if (!(given.scale > 0) || !std::isfinite(given.scale)) {
                refuse(
                    "observation->scale is " + std::to_string(given.scale) +
                    "; it must be finite and above 0, since nothing is read back to find the largest value");
            }
            o.observer = Observer::signed_component;
            o.analyzer[static_cast<int>(given.kind)] = 1 / given.scale;
            break;
        case NICOL_OBSERVATION_DOLP:
            o.observer = Observer::dolp;
            break;
        case NICOL_OBSERVATION_AOLP:
            o.observer = Observer::aolp;
            break;
        default:
            refuse("observation->kind is " + std::to_string(given.kind) +
                   "; it must be one of NICOL_OBSERVATION_S0 to NICOL_OBSERVATION_POLARIZER");
    }
    if (o.observer == Observer::radiance && channels != 1 && channels != 3) {
        refuse("the framebuffer has " + std::to_string(channels) +
               " channels; s0 and polarizer need 1 (grey) or 3 (R G B)");
    }
    return o;
}

gl::Program& program(Session& session, int channels) {
    if (!session.observer) session.observer = std::make_shared<HostObserver>();
    auto& programs = session.observer->programs;
    auto found = programs.find(channels);
    if (found == programs.end()) {
        const gl::Define define{.name = "CHANNELS", .value = std::to_string(channels)};
        found = programs
                    .emplace(channels, gl::Program::graphics(session.gl, "fullscreen.vert", "observe.frag",
                                                             std::span(&define, 1)))
                    .first;
    }
    return found->second;
}

void draw(Session& session, Framebuffer& framebuffer, const Observed& observed,
          const nicol_texture_target& target) {
    if (target.bottom_up > 1) refuse("target->bottom_up must be 0 or 1");
    if (target.encoding > NICOL_ENCODING_SRGB) {
        refuse("target->encoding is " + std::to_string(target.encoding) +
               "; it must be one of NICOL_ENCODING_...");
    }
    const Stopwatch watch;
    session.gl->run([&] {
        gl::RenderTarget image(session.gl, target.texture);
        if (image.width() != framebuffer.width() || image.height() != framebuffer.height()) {
            refuse("target->texture is of " + std::to_string(image.width()) + " x " +
                   std::to_string(image.height()) + " pixels and the framebuffer of " +
                   std::to_string(framebuffer.width()) + " x " + std::to_string(framebuffer.height()) +
                   "; they must agree");
        }
        for (int c = 0; c < framebuffer.channels(); ++c) {
            if (channel_texture(framebuffer, c).id() == target.texture) {
                refuse("target->texture is the framebuffer's own");
            }
        }
        gl::Program& observe = program(session, observed.channels);
        const auto set = [&observe](const char* name, const auto& value) {
            if (observe.uses(name)) observe.set(name, value);
        };
        set("kind", static_cast<int>(observed.observer));
        set("analyzer", observed.analyzer);
        set("encode", target.encoding == NICOL_ENCODING_SRGB ? 1 : 0);
        set("bottom_up", static_cast<int>(target.bottom_up));
        for (int c = 0; c < observed.channels; ++c) {
            channel_texture(framebuffer, observed.first + c).bind(static_cast<unsigned>(c));
        }
        gl::draw_fullscreen(image, observe);
    });
    framebuffer.statistics().observe_ms += watch.milliseconds();
}

}  // namespace

void require_channel(const Framebuffer& framebuffer, std::uint32_t channel) {
    if (channel >= static_cast<std::uint32_t>(framebuffer.channels())) {
        refuse("channel is " + std::to_string(channel) + "; the framebuffer has " +
               std::to_string(framebuffer.channels()) + ", counted from 0");
    }
}

const gl::Texture2D& channel_texture(Framebuffer& framebuffer, int channel) {
    return framebuffer.groups()[static_cast<std::size_t>(channel / Framebuffer::kGroup)].colour(
        channel % Framebuffer::kGroup);
}

void draw_stokes(Session& session, Framebuffer& framebuffer, int channel,
                 const nicol_texture_target& target) {
    draw(session, framebuffer, {.first = channel}, target);
}

void draw_observation(Session& session, Framebuffer& framebuffer, const nicol_observation& given,
                      const nicol_texture_target& target) {
    draw(session, framebuffer, observe(given, framebuffer.channels()), target);
}

}  // namespace nicol::capi
