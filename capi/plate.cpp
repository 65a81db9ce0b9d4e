// SPDX-License-Identifier: MIT
// Polarizing plates of a scene.
#include <glm/trigonometric.hpp>

#include "assets.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

using Kind = PolarizingPlate::Kind;
using Outline = PolarizingPlate::Outline;
static_assert(static_cast<int>(Kind::polarizer) == NICOL_PLATE_POLARIZER &&
              static_cast<int>(Kind::retarder) == NICOL_PLATE_RETARDER &&
              static_cast<int>(Kind::right_circular) == NICOL_PLATE_RIGHT_CIRCULAR &&
              static_cast<int>(Kind::left_circular) == NICOL_PLATE_LEFT_CIRCULAR);
static_assert(static_cast<int>(Outline::rectangle) == NICOL_PLATE_RECTANGLE &&
              static_cast<int>(Outline::disk) == NICOL_PLATE_DISK);

PolarizingPlate plate_from(const nicol_plate* plate) {
    const nicol_plate given = read_struct(plate, nicol_plate NICOL_PLATE_INIT, "plate");
    require_constant(given.kind, NICOL_PLATE_LEFT_CIRCULAR, "plate->kind", "NICOL_PLATE_...");
    require_constant(given.outline, NICOL_PLATE_DISK, "plate->outline", "NICOL_PLATE_...");
    if (given.reserved != 0) refuse("plate->reserved must be 0");
    return {.kind = static_cast<Kind>(given.kind),
            .outline = static_cast<Outline>(given.outline),
            .to_world = matrix(given.to_world),
            .angle = glm::radians(given.angle),
            .retardance = glm::radians(given.retardance),
            .transmittance = given.transmittance};
}

nicol_plate plate_to(const PolarizingPlate& plate) {
    nicol_plate out = NICOL_PLATE_INIT;
    out.kind = static_cast<nicol_plate_kind>(plate.kind);
    out.outline = static_cast<nicol_plate_outline>(plate.outline);
    write_matrix(plate.to_world, out.to_world);
    out.angle = glm::degrees(plate.angle);
    out.retardance = glm::degrees(plate.retardance);
    out.transmittance = plate.transmittance;
    return out;
}

}  // namespace

nicol_result nicol_scene_add_plate(nicol_scene scene, const nicol_plate* plate, uint32_t* id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const PolarizingPlate given = plate_from(plate);
        const Edit edit(self);
        const std::uint32_t added = self.content->scene.add_plate(given);
        if (id != nullptr) *id = added;
    });
}

nicol_result nicol_scene_set_plate(nicol_scene scene, uint32_t id, const nicol_plate* plate) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const PolarizingPlate given = plate_from(plate);
        const Edit edit(self);
        self.content->scene.set_plate(id, given);
    });
}

nicol_result nicol_scene_remove_plate(nicol_scene scene, uint32_t id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        self.content->scene.remove_plate(id);
    });
}

nicol_result nicol_scene_get_plate(nicol_scene scene, uint32_t id, nicol_plate* plate) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        write_struct(plate, plate_to(self.content->scene.plate(id)), "plate");
    });
}

nicol_result nicol_scene_get_plate_count(nicol_scene scene, uint32_t* plates) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(plates, "plates");
        const Edit edit(self);
        *plates = static_cast<uint32_t>(self.content->scene.plate_ids().size());
    });
}

nicol_result nicol_scene_get_plate_ids(nicol_scene scene, uint32_t* ids, uint64_t count) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        write_ids(self.content->scene.plate_ids(), ids, count, "plates");
    });
}
