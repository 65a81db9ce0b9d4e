// SPDX-License-Identifier: MIT
// Polarization elements of a scene.
#include <glm/trigonometric.hpp>

#include "assets.hpp"
#include "element.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

using Kind = PolarizationElement::Kind;
using Outline = PolarizationElement::Outline;
static_assert(static_cast<int>(Kind::polarizer) == NICOL_POLARIZATION_ELEMENT_POLARIZER &&
              static_cast<int>(Kind::retarder) == NICOL_POLARIZATION_ELEMENT_RETARDER &&
              static_cast<int>(Kind::right_circular) == NICOL_POLARIZATION_ELEMENT_RIGHT_CIRCULAR &&
              static_cast<int>(Kind::left_circular) == NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR);
static_assert(static_cast<int>(Outline::rectangle) == NICOL_POLARIZATION_ELEMENT_RECTANGLE &&
              static_cast<int>(Outline::disk) == NICOL_POLARIZATION_ELEMENT_DISK);

nicol_polarization_element element_to(const PolarizationElement& element) {
    nicol_polarization_element out = NICOL_POLARIZATION_ELEMENT_INIT;
    out.kind = static_cast<nicol_polarization_element_kind>(element.kind);
    out.outline = static_cast<nicol_polarization_element_outline>(element.outline);
    write_matrix(element.to_world, out.to_world);
    out.angle = glm::degrees(element.angle);
    out.retardance = glm::degrees(element.retardance);
    out.transmittance = element.transmittance;
    return out;
}

}  // namespace

namespace nicol::capi {

nicol_polarization_element read_element(const nicol_polarization_element* element) {
    const nicol_polarization_element given =
        read_struct(element, nicol_polarization_element NICOL_POLARIZATION_ELEMENT_INIT, "element");
    require_constant(given.kind, NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR, "element->kind",
                     "NICOL_POLARIZATION_ELEMENT_...");
    require_constant(given.outline, NICOL_POLARIZATION_ELEMENT_DISK, "element->outline",
                     "NICOL_POLARIZATION_ELEMENT_...");
    if (given.reserved != 0) refuse("element->reserved must be 0");
    return given;
}

PolarizationElement element_from(const nicol_polarization_element& given) {
    return {.kind = static_cast<Kind>(given.kind),
            .outline = static_cast<Outline>(given.outline),
            .to_world = matrix(given.to_world),
            .angle = glm::radians(given.angle),
            .retardance = glm::radians(given.retardance),
            .transmittance = given.transmittance};
}

}  // namespace nicol::capi

namespace {

SceneElement textured_from(const nicol_scene_impl& scene, const nicol_polarization_element* element) {
    const nicol_polarization_element given = read_element(element);
    return {element_from(given),
            {.angle = texture_of(given.angle_texture, scene),
             .retardance = texture_of(given.retardance_texture, scene)}};
}

}  // namespace

nicol_result nicol_scene_add_polarization_element(nicol_scene scene,
                                                  const nicol_polarization_element* element, uint32_t* id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const SceneElement given = textured_from(self, element);
        const Edit edit(self);
        const std::uint32_t added = self.content->scene.add_element(given);
        if (id != nullptr) *id = added;
    });
}

nicol_result nicol_scene_set_polarization_element(nicol_scene scene, uint32_t id,
                                                  const nicol_polarization_element* element) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const SceneElement given = textured_from(self, element);
        const Edit edit(self);
        self.content->scene.set_element(id, given);
    });
}

nicol_result nicol_scene_remove_polarization_element(nicol_scene scene, uint32_t id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        self.content->scene.remove_element(id);
    });
}

nicol_result nicol_scene_get_polarization_element(nicol_scene scene, uint32_t id,
                                                  nicol_polarization_element* element) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        write_struct(element, element_to(self.content->scene.element(id)), "element");
    });
}

nicol_result nicol_scene_get_polarization_element_textures(nicol_scene scene, uint32_t id,
                                                           nicol_texture* angle, nicol_texture* retardance) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        const ElementTextures& textures = self.content->scene.element(id).textures;
        write_handle(self.session, textures.angle, angle,
                     [&] { write_handle(self.session, textures.retardance, retardance, [] {}); });
    });
}

nicol_result nicol_scene_get_polarization_element_count(nicol_scene scene, uint32_t* elements) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(elements, "elements");
        const Edit edit(self);
        *elements = static_cast<uint32_t>(self.content->scene.element_ids().size());
    });
}

nicol_result nicol_scene_get_polarization_element_ids(nicol_scene scene, uint32_t* ids, uint64_t count) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        write_ids(self.content->scene.element_ids(), ids, count, "elements");
    });
}

NICOL_INITIALISER(nicol_polarization_element, NICOL_POLARIZATION_ELEMENT_INIT)
