// SPDX-License-Identifier: MIT
// Lights of KHR_lights_punctual. They emit light along their -z, ours along +z.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/gltf_readers.hpp"
#include "import/xml_file.hpp"

namespace nicol::scene {
namespace {

glm::dvec3 color_of(const GltfDocument& document, const std::string& name, const tinygltf::Light& light) {
    if (light.color.empty()) return glm::dvec3(1);
    if (light.color.size() != 3)
        document.fail(name, "color has " + std::to_string(light.color.size()) + " numbers; expected 3");
    glm::dvec3 color;
    for (glm::length_t i = 0; i < 3; ++i) {
        color[i] = light.color[static_cast<std::size_t>(i)];
        if (!(color[i] >= 0 && std::isfinite(color[i])))
            document.fail(name, "color is " + std::to_string(color[i]) + "; expected a finite number from 0");
    }
    return color;
}

void read_cone(const GltfDocument& document, const std::string& name, const tinygltf::SpotLight& spot,
               LightDescription& light) {
    const double widest = std::numbers::pi / 2;
    constexpr double rounding = 1e-6;
    light.parameters.kind = LocalLight::Kind::spot;
    if (!(spot.outerConeAngle > 1e-4 && spot.outerConeAngle <= widest + rounding))
        document.fail(name + ".spot", "outerConeAngle is " + std::to_string(spot.outerConeAngle) +
                                          "; expected more than 0, up to pi / 2");
    light.parameters.cutoff_angle = std::min(spot.outerConeAngle, widest);
    if (!(spot.innerConeAngle >= 0 && spot.innerConeAngle < spot.outerConeAngle))
        document.fail(name + ".spot", "innerConeAngle is " + std::to_string(spot.innerConeAngle) +
                                          "; expected 0 or more, less than outerConeAngle");
    light.parameters.beam_width = std::min(spot.innerConeAngle, light.parameters.cutoff_angle);
}

}  // namespace

std::optional<LightDescription> read_gltf_light(const GltfDocument& document, const tinygltf::Node& node,
                                                const std::string& where, const glm::dmat4& to_world,
                                                GltfNotices& notices) {
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) return std::nullopt;
    const int index = extension->second.Get("light").GetNumberAsInt();
    const tinygltf::Light& source = document.at(document.model().lights, "lights", index, where);
    const std::string name = "lights[" + std::to_string(index) + "]";
    LightDescription light;
    light.id = node.name.empty() ? source.name : node.name;
    if (!(source.intensity >= 0 && std::isfinite(source.intensity)))
        document.fail(name, "intensity is " + std::to_string(source.intensity) +
                                "; expected a finite number of at least 0");
    light.value = source.intensity * color_of(document, name, source);
    light.parameters.to_world = gltf_view(document, where, "light", to_world);
    if (source.range != 0) notices.add("the range of lights is not followed; they reach any distance");
    if (source.type == "spot")
        read_cone(document, name, source.spot, light);
    else if (source.type == "directional")
        light.parameters.kind = LocalLight::Kind::directional;
    else if (source.type != "point")
        document.fail(name, "type is " + in_quotes(source.type) + "; expected directional, point or spot");
    return light;
}

}  // namespace nicol::scene
