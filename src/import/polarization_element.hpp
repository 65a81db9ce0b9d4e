// SPDX-License-Identifier: MIT
// Flat shapes whose <bsdf> polarizes the light that passes. They become the Stokes state of an area light, or
// elements of the scene.
#pragma once

#include <glm/vec3.hpp>
#include <pugixml.hpp>
#include <span>
#include <vector>

#include "import/scene_description.hpp"
#include "import/xml_document.hpp"
#include "light/polarization_state.hpp"
#include "polarization/element.hpp"

namespace nicol::scene {

/// Light behind elements.
struct LightBehindElements {
    double brightness;  ///< brightness divided by the brightness before the elements
    PolarizationState state;
};

/// Returns the light of a state after it has passed the elements, one or more, in their order. The light
/// travels along frame[2]. to_world: transform from the axes of the state. Behind a polarizer the new state
/// holds for all directions.
[[nodiscard]] LightBehindElements behind(std::span<const PlacedElement> elements,
                                         const PolarizationState& state, const Frame& frame,
                                         const glm::dmat3& to_world);

/// Returns whether a <bsdf> has the type polarizer, retarder or circular; false for null.
[[nodiscard]] bool is_element_material(pugi::xml_node bsdf);

/// Reads an element, except its outline and its place, from a <bsdf> for which is_element_material() is true.
/// Throws what read_mitsuba_scene throws.
[[nodiscard]] ElementDescription read_element_material(const XmlDocument& document, pugi::xml_node bsdf);

/// Elements of one scene. An area light here is a rectangle or disk that emits light from one side. An
/// element stands before an area light if
/// - both are parallel within 0.1 degrees,
/// - the element is on the side that emits light, nearer than a tenth of the smaller half side, and
/// - the whole area light, moved along its normal, lies on the element.
/// An element with textures stands before the camera, and so do elements farther from the light.
class PolarizationElements {
public:
    explicit PolarizationElements(const XmlDocument& document) : document_(document) {}

    /// Returns whether a shape is a rectangle or disk that emits no light and has an element's material.
    [[nodiscard]] static bool are(const ShapeDescription& shape, pugi::xml_node bsdf);

    /// Adds an element. place: for messages. Throws what read_mitsuba_scene throws, and also for a polarizer
    /// or a retarder on a disk, because its axis would rotate with the angle.
    void add(pugi::xml_node place, const ShapeDescription& shape, pugi::xml_node bsdf);

    /// Gives the area lights among the shapes the state and the brightness of their light behind the elements
    /// before them, nearest first. Returns the other elements.
    [[nodiscard]] std::vector<ElementDescription> put_before_area_lights(
        std::vector<ShapeDescription>& shapes) const;

private:
    struct Element {
        ShapeDescription shape;
        ElementDescription element;
    };
    const XmlDocument& document_;
    std::vector<Element> elements_;
};

}  // namespace nicol::scene
