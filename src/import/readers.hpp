// SPDX-License-Identifier: MIT
// One reader for each kind of object in a scene.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "import/scene_description.hpp"
#include "import/sentences.hpp"
#include "import/xml_document.hpp"

namespace nicol::scene {

class Plugin;
struct NestedObject;

/// Notices: one sentence that collects the ignored elements, and separate sentences.
class Notices {
public:
    explicit Notices(const XmlDocument& document) : document_(document) {}
    /// "sampler "independent"" and the like.
    void add_unfollowed(pugi::xml_node node, const std::string& what);
    void add(pugi::xml_node node, const std::string& sentence);
    /// The same, unless this has added the sentence at another place.
    void add_once(pugi::xml_node node, const std::string& sentence);
    [[nodiscard]] std::vector<std::string> take();

private:
    const XmlDocument& document_;
    std::string first_place_;
    std::vector<std::string> unfollowed_;
    Sentences sentences_;
    std::unordered_set<std::string> said_;  // by add_once(), without their places
};

// Each takes the element of one plug-in, reads all of it, and throws as read_mitsuba_scene does.

[[nodiscard]] SensorDescription read_sensor(const XmlDocument& document, pugi::xml_node node,
                                            Notices& notices);
/// `left`: how many bsdfs it may still be made of, itself counted; the other form begins a tree of them.
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node,
                                                Notices& notices, int& left);
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node,
                                                Notices& notices);
[[nodiscard]] TextureSpecificationPtr read_texture(const XmlDocument& document, pugi::xml_node node);
/// Adds to the environment or the lights of the scene.
void read_emitter(const XmlDocument& document, const NestedObject& object, Notices& notices,
                  SceneDescription& scene);
/// Reads an <emitter> inside a <shape>.
[[nodiscard]] EmissionDescription read_emission(const XmlDocument& document, pugi::xml_node node,
                                                Notices& notices);
[[nodiscard]] IntegratorDescription read_integrator(const XmlDocument& document, pugi::xml_node node,
                                                    Notices& notices);
/// All but the material. `bsdf` receives the <bsdf>, null if there is none.
[[nodiscard]] ShapeDescription read_shape(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                                          pugi::xml_node& bsdf);
/// The <shape>s of a shapegroup.
[[nodiscard]] std::vector<pugi::xml_node> read_group(const XmlDocument& document, pugi::xml_node node);
/// The shapegroup of an instance; all of `instance` is set but the kind and what depends on it.
[[nodiscard]] pugi::xml_node read_instance(const XmlDocument& document, pugi::xml_node node,
                                           ShapeDescription& instance);

// These take parameters of a plug-in. The first two read what is theirs if it is of one of their types.

[[nodiscard]] std::optional<EnvironmentDescription> read_environment(Plugin& plugin);
[[nodiscard]] std::optional<LightDescription> read_light(const XmlDocument& document, Plugin& plugin);
[[nodiscard]] PolarizationState read_polarization(Plugin& plugin);
/// A colour in [0, most], or a texture.
[[nodiscard]] TexturedColor read_color(const XmlDocument& document, Plugin& plugin, const char* name,
                                       double otherwise, double most);
/// By fov and fov_axis, or by focal_length.
void read_field_of_view(Plugin& plugin, double& fov, SensorDescription::FovAxis& axis);

}  // namespace nicol::scene
