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
    /// Adds an ignored element, such as `sampler "independent"`, to the sentence of all ignored elements.
    void add_unfollowed(pugi::xml_node node, const std::string& what);
    void add(pugi::xml_node node, const std::string& sentence);
    /// Adds a sentence unless add_once() has added it at another place.
    void add_once(pugi::xml_node node, const std::string& sentence);
    [[nodiscard]] std::vector<std::string> take();

private:
    const XmlDocument& document_;
    std::string first_place_;
    std::vector<std::string> unfollowed_;
    Sentences sentences_;
    std::unordered_set<std::string> said_;  // by add_once(), without their places
};

// Each of these functions reads the whole element of one plug-in, and throws what read_mitsuba_scene throws.

[[nodiscard]] SensorDescription read_sensor(const XmlDocument& document, pugi::xml_node node,
                                            Notices& notices);
/// Reads a <bsdf>. left: number of bsdfs that the material may still have, including this one. The form
/// without `left` reads the outermost <bsdf> of a material.
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node,
                                                Notices& notices, int& left);
[[nodiscard]] MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node,
                                                Notices& notices);
[[nodiscard]] TextureSpecificationPtr read_texture(const XmlDocument& document, pugi::xml_node node);
/// Reads an <emitter> and adds it to the environment or the lights of the scene.
void read_emitter(const XmlDocument& document, const NestedObject& object, Notices& notices,
                  SceneDescription& scene);
/// Reads an <emitter> inside a <shape>.
[[nodiscard]] EmissionDescription read_emission(const XmlDocument& document, pugi::xml_node node,
                                                Notices& notices);
[[nodiscard]] IntegratorDescription read_integrator(const XmlDocument& document, pugi::xml_node node,
                                                    Notices& notices);
/// Reads a <shape> except its material. bsdf: receives the <bsdf>; null if there is none.
[[nodiscard]] ShapeDescription read_shape(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                                          pugi::xml_node& bsdf);
/// Returns the <shape>s of a shapegroup.
[[nodiscard]] std::vector<pugi::xml_node> read_group(const XmlDocument& document, pugi::xml_node node);
/// Returns the shapegroup of an instance. Sets `instance`, except its kind and the members that depend on the
/// kind.
[[nodiscard]] pugi::xml_node read_instance(const XmlDocument& document, pugi::xml_node node,
                                           ShapeDescription& instance);

// These functions read parameters of a plug-in. read_environment() and read_light() return nothing for a
// plug-in of another type.

[[nodiscard]] std::optional<EnvironmentDescription> read_environment(Plugin& plugin);
[[nodiscard]] std::optional<LightDescription> read_light(const XmlDocument& document, Plugin& plugin);
/// Returns the types that read_light() reads, for messages.
[[nodiscard]] std::string light_type_names();
[[nodiscard]] PolarizationState read_polarization(Plugin& plugin);
/// Reads a colour in [0, most], or a texture.
[[nodiscard]] TexturedColor read_color(const XmlDocument& document, Plugin& plugin, const char* name,
                                       double otherwise, double most);
/// Reads a field of view from fov and fov_axis, or from focal_length.
void read_field_of_view(Plugin& plugin, double& fov, SensorDescription::FovAxis& axis);

}  // namespace nicol::scene
