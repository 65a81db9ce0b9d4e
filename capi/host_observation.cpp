// SPDX-License-Identifier: MIT
// Observations drawn into textures of the host.
#include <cmath>
#include <glm/vec4.hpp>
#include <numbers>

#include "host_image.hpp"

namespace nicol::capi {
namespace {

/// Observers in the numbering of glsl/observe.frag.
enum class Observer { radiance, signed_component, dolp, aolp };

struct Observed {
    Observer observer = Observer::radiance;
    glm::vec4 analyzer{0.0F};
};

float stops(float exposure) {
    if (!(std::abs(exposure) <= 100)) {
        refuse("observation->exposure is " + std::to_string(exposure) + "; it must lie in -100 to 100 stops");
    }
    return std::exp2(exposure);
}

Observed observe(const nicol_observation& given, int channels) {
    Observed o;
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

}  // namespace

HostImage observation_image(Framebuffer& framebuffer, const nicol_observation& given) {
    const int channels = framebuffer.channels();
    const Observed observed = observe(given, channels);
    return {.fragment = "observe.frag",
            .defines = {{.name = "CHANNELS", .value = std::to_string(channels)}},
            .textures = channels,
            .prepare = [&framebuffer, observed, channels](gl::Program& program) {
                program.set("kind", static_cast<int>(observed.observer));
                program.set("analyzer", observed.analyzer);
                for (int c = 0; c < channels; ++c)
                    channel_texture(framebuffer, c).bind(static_cast<unsigned>(c));
            }};
}

}  // namespace nicol::capi
