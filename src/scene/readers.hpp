// SPDX-License-Identifier: MIT
// One reader for each kind of object in a scene.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "scene/scene_description.hpp"
#include "scene/xml_document.hpp"

namespace nicol::scene {

class Plugin;

/// What is read and makes no difference, collected into one sentence; and sentences of their own.
class Notices {
public:
    explicit Notices(const XmlDocument& document) : document_(document) {}
    /// "sampler "independent"" and the like.
    void add_unfollowed(pugi::xml_node node, const std::string& what);
    void add(pugi::xml_node node, const std::string& sentence);
    [[nodiscard]] std::vector<std::string> take();

private:
    const XmlDocument& document_;
    std::string first_place_;
    std::vector<std::string> unfollowed_;
    std::vector<std::string> sentences_;
};

// Each takes the element of one plug-in, reads all of it, and throws as read_mitsuba_scene does.

[[nodiscard]] SensorDescription read_sensor(const XmlDocument& document, pugi::xml_node node,
                                            Notices& notices);
/// `left`: how many bsdfs it may still be made of, itself counted; the other form begins a tree of them.
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node, int& left);
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node);
/// One that is made of others; none if the plug-in is of another type. The id is left empty.
[[nodiscard]] std::optional<MaterialDescription> read_nested_material(const XmlDocument& document,
                                                                      Plugin& plugin, int& left);
[[nodiscard]] TextureSpecificationPtr read_texture(const XmlDocument& document, pugi::xml_node node);
[[nodiscard]] EmitterDescription read_emitter(const XmlDocument& document, pugi::xml_node node,
                                              Notices& notices);
void read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices);
/// All but the material. `bsdf` receives the <bsdf>, null if there is none.
[[nodiscard]] ShapeDescription read_shape(const XmlDocument& document, pugi::xml_node node,
                                          pugi::xml_node& bsdf);
/// The <shape>s of a shapegroup.
[[nodiscard]] std::vector<pugi::xml_node> read_group(const XmlDocument& document, pugi::xml_node node);
/// The shapegroup of an instance; all of `instance` is set but the kind and what depends on it.
[[nodiscard]] pugi::xml_node read_instance(const XmlDocument& document, pugi::xml_node node,
                                           ShapeDescription& instance);

}  // namespace nicol::scene
