// SPDX-License-Identifier: MIT
// One reader for each kind of object in a scene.
#pragma once

#include <pugixml.hpp>

#include "nicol/scene_description.hpp"
#include "scene/xml_document.hpp"

namespace nicol::scene {

// Each takes the element of one plug-in, reads all of it, and throws as read_mitsuba_scene does.

[[nodiscard]] SensorDescription read_sensor(const XmlDocument& document, pugi::xml_node node);
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node);
[[nodiscard]] EmitterDescription read_emitter(const XmlDocument& document, pugi::xml_node node);
/// All but the material. `bsdf` receives the nested <bsdf> or <ref>, null if there is none.
[[nodiscard]] ShapeDescription read_shape(const XmlDocument& document, pugi::xml_node node,
                                          pugi::xml_node& bsdf);

}  // namespace nicol::scene
