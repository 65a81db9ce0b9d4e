// SPDX-License-Identifier: MIT
// Flat shapes of a <bsdf> that polarizes the light that passes: they become the Stokes state of a lamp, or
// plates of the scene.
#pragma once

#include <glm/vec3.hpp>
#include <pugixml.hpp>
#include <span>
#include <vector>

#include "import/scene_description.hpp"
#include "import/xml_document.hpp"
#include "light/polarization_state.hpp"
#include "polarization/plate.hpp"

namespace nicol::scene {

/// How light leaves plates.
struct LightBehindPlates {
    double brightness;  ///< over that before them
    PolarizationState state;
};

/// Light of `state` that travels along frame[2] and passes the plates, one or more, in their order. to_world:
/// from the axes of the state. Behind a polarizer the new state is that of all directions.
[[nodiscard]] LightBehindPlates behind(std::span<const PlacedPlate> plates, const PolarizationState& state,
                                       const Frame& frame, const glm::dmat3& to_world);

/// True of a <bsdf> of type polarizer, retarder or circular; false of null.
[[nodiscard]] bool is_plate_material(pugi::xml_node bsdf);

/// A plate with all but its outline and its place, of a <bsdf> of which is_plate_material() is true. Throws
/// as read_mitsuba_scene does.
[[nodiscard]] PolarizingPlate read_plate_material(const XmlDocument& document, pugi::xml_node bsdf);

/// The plates of one scene. A plate stands before a lamp, a rectangle or disk that shines from one side, if
/// it is parallel to it within 0.1 degrees, on the side that shines, nearer than a tenth of the smaller half
/// side, and all of the lamp, moved along its normal, lies on the plate.
class PolarizingPlates {
public:
    explicit PolarizingPlates(const XmlDocument& document) : document_(document) {}

    /// True of a rectangle or disk that does not shine, of a plate's material.
    [[nodiscard]] static bool are(const ShapeDescription& shape, pugi::xml_node bsdf);

    /// `place` is for messages. Throws as read_mitsuba_scene does; also of a polarizer or a retarder on a
    /// disk, whose axis would go round with the angle.
    void add(pugi::xml_node place, const ShapeDescription& shape, pugi::xml_node bsdf);

    /// Gives the lamps among the shapes the state and the brightness of their light behind the plates before
    /// them, nearest first. Returns the other plates.
    [[nodiscard]] std::vector<PlateDescription> put_before_lamps(std::vector<ShapeDescription>& shapes) const;

private:
    struct Plate {
        pugi::xml_node place;
        ShapeDescription shape;
        PolarizingPlate plate;
    };
    const XmlDocument& document_;
    std::vector<Plate> plates_;
};

}  // namespace nicol::scene
