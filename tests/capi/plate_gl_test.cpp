// SPDX-License-Identifier: MIT
// Polarizing plates of a scene.
#include "capi.hpp"

using namespace capi_test;

namespace {

std::uint32_t add_plate(nicol_scene scene, const nicol_plate& plate = NICOL_PLATE_INIT) {
    std::uint32_t id = 99;
    OK(nicol_scene_add_plate(scene, &plate, &id));
    return id;
}

std::vector<std::uint32_t> plate_ids_of(nicol_scene scene) {
    std::uint32_t count = 99;
    OK(nicol_scene_get_plate_count(scene, &count));
    std::vector<std::uint32_t> ids(count, 99);
    OK(nicol_scene_get_plate_ids(scene, ids.data(), count));
    return ids;
}

void check_same(const nicol_plate& a, const nicol_plate& b) {
    const auto angle = [](double degrees) { return doctest::Approx(degrees).epsilon(1e-12); };
    CHECK(a.kind == b.kind);
    CHECK(a.outline == b.outline);
    CHECK(std::ranges::equal(a.to_world, b.to_world));
    CHECK(a.angle == angle(b.angle));
    CHECK(a.retardance == angle(b.retardance));
    CHECK(a.transmittance == b.transmittance);
}

/// Across the view of the front camera, at this height.
nicol_plate before_camera(nicol_plate_kind kind, double angle, double z) {
    nicol_plate plate = NICOL_PLATE_INIT;
    plate.kind = kind;
    plate.angle = angle;
    std::ranges::copy(placed(0, 0, z, 5).rows, plate.to_world);
    return plate;
}

}  // namespace

STAGE_TEST_CASE("a plate is what it was given as, and may be given again") {
    nicol_plate retarder = before_camera(NICOL_PLATE_RETARDER, -30, 1);
    retarder.outline = NICOL_PLATE_DISK;
    retarder.retardance = 127.5;
    retarder.transmittance = 0.25;
    const nicol_plate plates[] = {NICOL_PLATE_INIT, retarder, before_camera(NICOL_PLATE_RIGHT_CIRCULAR, 0, 2),
                                  before_camera(NICOL_PLATE_LEFT_CIRCULAR, 0, 2)};
    for (const nicol_plate& plate : plates) {
        nicol_plate told = NICOL_PLATE_INIT;
        const std::uint32_t id = add_plate(stage.scene, plate);
        OK(nicol_scene_get_plate(stage.scene, id, &told));
        check_same(told, plate);
        OK(nicol_scene_set_plate(stage.scene, id, &told));
    }
    CHECK(plate_ids_of(stage.scene) == std::vector<std::uint32_t>{0, 1, 2, 3});
    OK(nicol_scene_add_plate(stage.scene, &retarder, nullptr));
}

STAGE_TEST_CASE("ids of removed plates are not given again") {
    for (std::uint32_t id = 0; id < 3; ++id) CHECK(add_plate(stage.scene) == id);
    OK(nicol_scene_remove_plate(stage.scene, 1));
    CHECK(add_plate(stage.scene) == 3);
    CHECK(plate_ids_of(stage.scene) == std::vector<std::uint32_t>{0, 2, 3});
    nicol_plate plate = NICOL_PLATE_INIT;
    REFUSES(nicol_scene_remove_plate(stage.scene, 1), "no plate 1; it was removed");
    REFUSES(nicol_scene_set_plate(stage.scene, 4, &plate), "no plate 4");
    REFUSES(nicol_scene_get_plate(stage.scene, UINT32_MAX, &plate), "no plate 4294967295");
    std::uint32_t ids[3] = {};
    REFUSES(nicol_scene_get_plate_ids(stage.scene, ids, 4), "the scene has 3 plates");
}

STAGE_TEST_CASE("fields of a plate that are out of range are refused by name") {
    const struct {
        const char* name;
        std::function<void(nicol_plate&)> spoil;
    } rows[] = {{"plate->kind", [](nicol_plate& p) { p.kind = 4; }},
                {"plate->outline", [](nicol_plate& p) { p.outline = 2; }},
                {"plate->reserved", [](nicol_plate& p) { p.reserved = 1; }},
                {"to_world", [](nicol_plate& p) { p.to_world[0] = 0; }},
                {"to_world", [](nicol_plate& p) { p.to_world[15] = 2; }},
                {"angle", [](nicol_plate& p) { p.angle = INFINITY; }},
                {"retardance", [](nicol_plate& p) { p.retardance = NAN; }},
                {"transmittance", [](nicol_plate& p) { p.transmittance = 1.5; }}};
    const std::uint32_t id = add_plate(stage.scene);
    for (const auto& row : rows) {
        nicol_plate plate = NICOL_PLATE_INIT;
        row.spoil(plate);
        REFUSES(nicol_scene_add_plate(stage.scene, &plate, nullptr), row.name);
        REFUSES(nicol_scene_set_plate(stage.scene, id, &plate), row.name);
    }
    CHECK(plate_ids_of(stage.scene) == std::vector<std::uint32_t>{0});
    nicol_plate told = NICOL_PLATE_INIT;
    OK(nicol_scene_get_plate(stage.scene, id, &told));
    check_same(told, NICOL_PLATE_INIT);
}

STAGE_TEST_CASE("the camera sees through plates, in one method as in the other, until they are gone") {
    nicol_camera narrow = stage.camera;
    narrow.fov = 0.5;  // crossed polarizers are black along their normal alone
    nicol_render_options reference = plain_options();
    reference.method = NICOL_METHOD_REFERENCE;
    reference.samples = 4;
    const auto image = [&](const nicol_render_options& options) {
        OK(nicol_render(stage.scene, &narrow, &options, stage.framebuffer));
        return read_all(stage.framebuffer);
    };
    const std::vector<float> open = image(plain_options());
    const std::uint32_t first = add_plate(stage.scene, before_camera(NICOL_PLATE_POLARIZER, 0, 2));
    const std::uint32_t second = add_plate(stage.scene, before_camera(NICOL_PLATE_POLARIZER, 90, 2.5));
    for (const nicol_render_options& options : {plain_options(), reference})
        for (const float value : image(options)) CHECK(std::abs(value) < 1e-6F);
    const nicol_plate circular = before_camera(NICOL_PLATE_LEFT_CIRCULAR, 0, 2.5);
    OK(nicol_scene_set_plate(stage.scene, second, &circular));
    const std::vector<float> left = image(plain_options());
    for (std::size_t i = 0; i < left.size(); i += 4) {
        CHECK(left[i + 3] == doctest::Approx(-left[i]));
        // The polarizer, then half of it.
        CHECK(left[i] == doctest::Approx(0.25F * (open[i] + open[i + 1])).epsilon(1e-4));
    }
    for (const std::uint32_t id : {first, second}) OK(nicol_scene_remove_plate(stage.scene, id));
    CHECK(image(plain_options()) == open);
}
