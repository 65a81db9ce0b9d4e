// SPDX-License-Identifier: MIT
// <emitter> of a place or a direction of its own.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "geometry/perpendicular.hpp"
#include "import/plugin.hpp"
#include "import/readers.hpp"
#include "scene/camera.hpp"

namespace nicol::scene {

namespace {

using Kind = LocalLight::Kind;

/// A light given by a place or a direction has its axis in the world's axes, else in its own.
void read_place(Plugin& plugin, const char* name, LightDescription& light) {
    if (!plugin.has(name)) {
        plugin.pass_over({name});
        light.to_world = plugin.transform("to_world");
        return;
    }
    if (plugin.has("to_world")) plugin.fail("to_world", std::string("is given beside ") + name);
    const glm::dvec3 given = plugin.vector(name, std::nullopt);
    if (light.kind == Kind::point) {
        light.to_world[3] = glm::dvec4(given, 1);
        return;
    }
    const double length = glm::length(given);
    if (!(length > 0) || !std::isfinite(length))
        plugin.fail(name, "has no direction; expected the vector along which the light travels");
    light.to_world = look_at(glm::dvec3(0), given / length, perpendicular(given / length));
    light.state.axis = glm::transpose(glm::dmat3(light.to_world)) * light.state.axis;
}

double read_degrees(Plugin& plugin, const char* name, double otherwise, double least, double most) {
    return glm::radians(plugin.number(name, otherwise, least, most));
}

void read_spot(const XmlDocument& document, Plugin& plugin, LightDescription& light) {
    constexpr double narrowest = 0.01;
    light.value = plugin.color("intensity", 1.0);
    const double cutoff = plugin.number("cutoff_angle", 20.0, narrowest, 90.0);
    light.cutoff_angle = glm::radians(cutoff);
    light.beam_width = read_degrees(plugin, "beam_width", 0.75 * cutoff, 0.0, cutoff);
    if (const pugi::xml_node texture = plugin.texture("texture"))
        light.texture = read_texture(document, texture);
    light.to_world = plugin.transform("to_world");
}

void read_projector(const XmlDocument& document, Plugin& plugin, LightDescription& light) {
    const TexturedColor irradiance = read_color(document, plugin, "irradiance", 1.0, kNoLimit);
    light.texture = irradiance.texture;
    if (!light.texture) light.value = irradiance;
    // A white surface that faces Mitsuba's projector at distance 1 has the radiance `irradiance`, in contrast
    // to its documentation.
    light.scale = std::numbers::pi * plugin.number("scale", 1.0, 0.0, kNoLimit);
    read_field_of_view(plugin, light.fov, light.fov_axis);
    light.to_world = plugin.transform("to_world");
}

}  // namespace

std::optional<LightDescription> read_light(const XmlDocument& document, Plugin& plugin) {
    LightDescription light;
    light.id = plugin.id();
    light.state = read_polarization(plugin);
    if (plugin.type() == "directional") {
        light.kind = Kind::directional;
        light.value = plugin.color("irradiance", 1.0);
        light.angular_radius = read_degrees(plugin, "angular_radius", 0.0, 0.0, 90.0);
        read_place(plugin, "direction", light);
    } else if (plugin.type() == "point") {
        light.kind = Kind::point;
        light.value = plugin.color("intensity", 1.0);
        read_place(plugin, "position", light);
    } else if (plugin.type() == "spot") {
        light.kind = Kind::spot;
        read_spot(document, plugin, light);
    } else if (plugin.type() == "projector") {
        light.kind = Kind::projector;
        read_projector(document, plugin, light);
    } else {
        return std::nullopt;
    }
    return light;
}

}  // namespace nicol::scene
