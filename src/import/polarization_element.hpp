// SPDX-License-Identifier: MIT
// Flat shapes of a <bsdf> that polarizes the light that passes: they become the Stokes state of an area
// light, or elements of the scene.
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

/// How light leaves elements.
struct LightBehindElements {
    double brightness;  ///< over that before them
    PolarizationState state;
};

/// Light of `state` that travels along frame[2] and passes the elements, one or more, in their order.
/// to_world: from the axes of the state. Behind a polarizer the new state is that of all directions.
[[nodiscard]] LightBehindElements behind(std::span<const PlacedElement> elements,
                                         const PolarizationState& state, const Frame& frame,
                                         const glm::dmat3& to_world);

/// True of a <bsdf> of type polarizer, retarder or circular; false of null.
[[nodiscard]] bool is_element_material(pugi::xml_node bsdf);

/// An element with all but its outline and its place, of a <bsdf> of which is_element_material() is true.
/// Throws as read_mitsuba_scene does.
[[nodiscard]] PolarizationElement read_element_material(const XmlDocument& document, pugi::xml_node bsdf);

/// The elements of one scene. An element stands before an area light, a rectangle or disk that emits light
/// from one side, if it is parallel to it within 0.1 degrees, on the side that emits light, nearer than a
/// tenth of the smaller half side, and all of the area light, moved along its normal, lies on the element.
class PolarizationElements {
public:
    explicit PolarizationElements(const XmlDocument& document) : document_(document) {}

    /// True of a rectangle or disk that emits no light, of an element's material.
    [[nodiscard]] static bool are(const ShapeDescription& shape, pugi::xml_node bsdf);

    /// `place` is for messages. Throws as read_mitsuba_scene does; also of a polarizer or a retarder on a
    /// disk, whose axis would go round with the angle.
    void add(pugi::xml_node place, const ShapeDescription& shape, pugi::xml_node bsdf);

    /// Gives the area lights among the shapes the state and the brightness of their light behind the elements
    /// before them, nearest first. Returns the other elements.
    [[nodiscard]] std::vector<ElementDescription> put_before_area_lights(
        std::vector<ShapeDescription>& shapes) const;

private:
    struct Element {
        pugi::xml_node place;
        ShapeDescription shape;
        PolarizationElement element;
    };
    const XmlDocument& document_;
    std::vector<Element> elements_;
};

}  // namespace nicol::scene
