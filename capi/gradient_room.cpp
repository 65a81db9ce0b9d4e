// SPDX-License-Identifier: MIT
#include "gradient_room.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "harmonics/psh.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

void check_room(const double* room, std::uint64_t count, std::uint64_t needed, const char* name,
                const std::string& shape) {
    if (room == nullptr || count == needed) return;
    refuse("gradient->" + std::string(name) + "_count is " + std::to_string(count) + "; the gradient has " +
           std::to_string(needed) + " numbers, " + shape);
}

}  // namespace

GradientRoom::GradientRoom(const nicol_gradient* given)
    : room_(read_struct(given, nicol_gradient NICOL_GRADIENT_INIT, "gradient")) {
    if (room_.reserved != 0) refuse("gradient->reserved must be 0");
    if (room_.environment == nullptr && room_.lights == nullptr && room_.instances == nullptr)
        refuse("gradient has no room: environment, lights and instances are NULL");
}

WantedGradients GradientRoom::wanted() const {
    return {.environment = room_.environment != nullptr,
            .lights = room_.lights != nullptr,
            .instances = room_.instances != nullptr};
}

void GradientRoom::check(const Scene& scene, const RenderOptions& options) const {
    const auto channels = static_cast<std::uint64_t>(scene.channels());
    const std::string planes = std::to_string(channels) + " channels";
    check_room(room_.environment, room_.environment_count, channels * 4 * psh_count(options.order_low),
               "environment", planes + " of 4 (order_low + 1)^2");
    check_room(room_.lights, room_.lights_count, scene.lights().size() * channels * 4, "lights",
               std::to_string(scene.lights().size()) + " lights of " + planes + " of 4");
    check_room(room_.instances, room_.instances_count, scene.instances().size() * channels, "instances",
               std::to_string(scene.instances().size()) + " instances of " + planes);
}

void GradientRoom::write(const Gradients& gradients) const {
    std::ranges::copy(gradients.environment.data(), room_.environment);
    std::ranges::copy(gradients.lights, room_.lights);
    std::ranges::copy(gradients.instances, room_.instances);
}

NICOL_INITIALISER(nicol_gradient, NICOL_GRADIENT_INIT)
