// SPDX-License-Identifier: MIT
// <emitter>s that are local lights.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>
#include <string_view>

#include "geometry/perpendicular.hpp"
#include "import/plugin.hpp"
#include "import/readers.hpp"
#include "import/text.hpp"
#include "scene/camera.hpp"

namespace nicol::scene {

namespace {

using Kind = LocalLight::Kind;

/// A light given by a place or a direction has its axis in the world's axes, else in its own.
void read_place(Plugin& plugin, const char* name, LocalLight& light) {
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

void read_directional(const XmlDocument& /*document*/, Plugin& plugin, LightDescription& light) {
    light.value = plugin.color("irradiance", 1.0);
    light.parameters.angular_radius = read_degrees(plugin, "angular_radius", 0.0, 0.0, 90.0);
    read_place(plugin, "direction", light.parameters);
}

void read_point(const XmlDocument& /*document*/, Plugin& plugin, LightDescription& light) {
    light.value = plugin.color("intensity", 1.0);
    read_place(plugin, "position", light.parameters);
}

void read_spot(const XmlDocument& document, Plugin& plugin, LightDescription& light) {
    constexpr double narrowest = 0.01;
    light.value = plugin.color("intensity", 1.0);
    const double cutoff = plugin.number("cutoff_angle", 20.0, narrowest, 90.0);
    light.parameters.cutoff_angle = glm::radians(cutoff);
    light.parameters.beam_width = read_degrees(plugin, "beam_width", 0.75 * cutoff, 0.0, cutoff);
    if (const pugi::xml_node texture = plugin.texture("texture"))
        light.texture = read_texture(document, texture);
    light.parameters.to_world = plugin.transform("to_world");
}

void read_projector(const XmlDocument& document, Plugin& plugin, LightDescription& light) {
    const TexturedColor irradiance = read_color(document, plugin, "irradiance", 1.0, kNoLimit);
    light.texture = irradiance.texture;
    if (!light.texture) light.value = irradiance;
    // A white surface that faces Mitsuba's projector at distance 1 has the radiance `irradiance`, in contrast
    // to its documentation.
    light.scale = std::numbers::pi * plugin.number("scale", 1.0, 0.0, kNoLimit);
    read_field_of_view(plugin, light.fov, light.fov_axis);
    light.parameters.to_world = plugin.transform("to_world");
}

/// A type of <emitter>, its kind of light, and the reader of its parameters.
struct LightType {
    std::string_view name;
    Kind kind;
    void (*read)(const XmlDocument& document, Plugin& plugin, LightDescription& light);
};

/// In the order in which messages name them.
constexpr std::array kLightTypes = {LightType{"directional", Kind::directional, read_directional},
                                    LightType{"point", Kind::point, read_point},
                                    LightType{"spot", Kind::spot, read_spot},
                                    LightType{"projector", Kind::projector, read_projector}};

}  // namespace

std::optional<LightDescription> read_light(const XmlDocument& document, Plugin& plugin) {
    const auto* const type =
        std::ranges::find(kLightTypes, std::string_view(plugin.type()), &LightType::name);
    if (type == kLightTypes.end()) return std::nullopt;
    LightDescription light;
    light.id = plugin.id();
    light.parameters.kind = type->kind;
    light.parameters.state = read_polarization(plugin);
    type->read(document, plugin, light);
    return light;
}

std::string light_type_names() {
    return joined(kLightTypes, &LightType::name);
}

}  // namespace nicol::scene
