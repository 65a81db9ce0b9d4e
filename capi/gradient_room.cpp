// SPDX-License-Identifier: MIT
#include "gradient_room.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "assets.hpp"
#include "handles.hpp"
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

GradientRoom::GradientRoom(const nicol_gradient* given, const nicol_scene_impl& scene)
    : room_(read_struct(given, nicol_gradient NICOL_GRADIENT_INIT, "gradient")) {
    if (room_.reserved != 0) refuse("gradient->reserved must be 0");
    if ((room_.texels == nullptr) != (room_.texture == nullptr))
        refuse("gradient->texels and gradient->texture: give both or neither");
    if (room_.environment == nullptr && room_.lights == nullptr && room_.instances == nullptr &&
        room_.texels == nullptr)
        refuse("gradient has no room: environment, lights, instances and texels are NULL");
    texture_ = texture_of(room_.texture, scene);
}

WantedGradients GradientRoom::wanted() const {
    return {.environment = room_.environment != nullptr,
            .lights = room_.lights != nullptr,
            .instances = room_.instances != nullptr,
            .texture = texture_};
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
    if (texture_ == nullptr || texture_->describe().levels.empty()) return;
    const TextureImage& image = texture_->describe().levels.front();
    const std::array<int, 3> sides{image.height, image.width, image.channels};
    std::uint64_t texels = 1;
    for (const int side : sides) texels *= static_cast<std::uint64_t>(side);
    check_room(room_.texels, room_.texels_count, texels, "texels",
               std::to_string(image.height) + " rows of " + std::to_string(image.width) + " texels of " +
                   std::to_string(image.channels) + " channels");
}

void GradientRoom::write(const Gradients& gradients) const {
    std::ranges::copy(gradients.environment.data(), room_.environment);
    std::ranges::copy(gradients.lights, room_.lights);
    std::ranges::copy(gradients.instances, room_.instances);
    std::ranges::copy(gradients.texels, room_.texels);
}

NICOL_INITIALISER(nicol_gradient, NICOL_GRADIENT_INIT)
