// SPDX-License-Identifier: MIT
#include "scene/scene_lights.hpp"

#include <glm/trigonometric.hpp>

#include "scene/load_scene.hpp"

namespace nicol::scene {

SmallLight make_light(const LightDescription& d, const SceneChannels& channels, SceneTextures& textures) {
    SmallLight light;
    light.kind = d.kind;
    light.value = radiance(d.value, channels);
    for (double& value : light.value) value *= d.scale;
    light.to_world = glm::dmat4(rotation_of(d.to_world, "a light"));
    light.to_world[3] = d.to_world[3];
    light.angular_radius = d.angular_radius;
    light.cutoff_angle = d.cutoff_angle;
    light.beam_width = d.beam_width;
    if (d.texture) {
        light.texture = textures.color(*d.texture);
        light.aspect = textures.aspect(*d.texture);
    }
    light.fov = glm::radians(horizontal_fov(d.fov, d.fov_axis, light.aspect));
    light.state = d.state;
    return light;
}

EmissionPtr make_emission(const EmissionDescription& d, const SceneChannels& channels,
                          SceneTextures& textures) {
    Emission emission;
    emission.radiance = d.radiance.texture ? std::vector<double>{1} : radiance(d.radiance, channels);
    for (double& value : emission.radiance) value *= d.scale;
    if (d.radiance.texture) emission.texture = textures.color(*d.radiance.texture);
    emission.two_sided = d.two_sided;
    emission.state = d.state;
    return std::make_shared<const Emission>(std::move(emission));
}

}  // namespace nicol::scene
