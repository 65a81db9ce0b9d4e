// SPDX-License-Identifier: MIT
// Tests of polarization elements of a scene.
#include "capi.hpp"

using namespace capi_test;

namespace {

std::uint32_t add_element(nicol_scene scene,
                          const nicol_polarization_element& element = NICOL_POLARIZATION_ELEMENT_INIT) {
    std::uint32_t id = 99;
    OK(nicol_scene_add_polarization_element(scene, &element, &id));
    return id;
}

std::vector<std::uint32_t> element_ids_of(nicol_scene scene) {
    std::uint32_t count = 99;
    OK(nicol_scene_get_polarization_element_count(scene, &count));
    std::vector<std::uint32_t> ids(count, 99);
    OK(nicol_scene_get_polarization_element_ids(scene, ids.data(), count));
    return ids;
}

void check_same(const nicol_polarization_element& a, const nicol_polarization_element& b) {
    const auto angle = [](double degrees) { return doctest::Approx(degrees).epsilon(1e-12); };
    CHECK(a.kind == b.kind);
    CHECK(a.outline == b.outline);
    CHECK(std::ranges::equal(a.to_world, b.to_world));
    CHECK(a.angle == angle(b.angle));
    CHECK(a.retardance == angle(b.retardance));
    CHECK(a.transmittance == b.transmittance);
}

/// Returns an element across the view of the front camera, at height z.
nicol_polarization_element before_camera(nicol_polarization_element_kind kind, double angle, double z) {
    nicol_polarization_element element = NICOL_POLARIZATION_ELEMENT_INIT;
    element.kind = kind;
    element.angle = angle;
    std::ranges::copy(placed(0, 0, z, 5).rows, element.to_world);
    return element;
}

}  // namespace

STAGE_TEST_CASE("an element is what it was given as, and may be given again") {
    nicol_polarization_element retarder = before_camera(NICOL_POLARIZATION_ELEMENT_RETARDER, -30, 1);
    retarder.outline = NICOL_POLARIZATION_ELEMENT_DISK;
    retarder.retardance = 127.5;
    retarder.transmittance = 0.25;
    const nicol_polarization_element elements[] = {
        NICOL_POLARIZATION_ELEMENT_INIT, retarder,
        before_camera(NICOL_POLARIZATION_ELEMENT_RIGHT_CIRCULAR, 0, 2),
        before_camera(NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR, 0, 2)};
    for (const nicol_polarization_element& element : elements) {
        nicol_polarization_element told = NICOL_POLARIZATION_ELEMENT_INIT;
        const std::uint32_t id = add_element(stage.scene, element);
        OK(nicol_scene_get_polarization_element(stage.scene, id, &told));
        check_same(told, element);
        OK(nicol_scene_set_polarization_element(stage.scene, id, &told));
    }
    CHECK(element_ids_of(stage.scene) == std::vector<std::uint32_t>{0, 1, 2, 3});
    OK(nicol_scene_add_polarization_element(stage.scene, &retarder, nullptr));
}

STAGE_TEST_CASE("textures of an element are told as handles, and outlive those that were given") {
    const nicol_spectrum two = spectrum({2}), three = spectrum({1, 2, 3});
    nicol_texture angle = make(nicol_texture_create_checkerboard, stage.context, &two, &two, nullptr);
    nicol_texture retardance =
        make(nicol_texture_create_checkerboard, stage.context, &three, &three, nullptr);
    nicol_polarization_element sheet = before_camera(NICOL_POLARIZATION_ELEMENT_RETARDER, 10, 1);
    sheet.angle_texture = angle;
    sheet.retardance_texture = retardance;
    const std::uint32_t id = add_element(stage.scene, sheet);
    for (const nicol_texture given : {angle, retardance}) OK(nicol_texture_release(given));
    nicol_polarization_element told = NICOL_POLARIZATION_ELEMENT_INIT;
    OK(nicol_scene_get_polarization_element(stage.scene, id, &told));
    check_same(told, sheet);
    CHECK(told.angle_texture == nullptr);
    OK(nicol_scene_get_polarization_element_textures(stage.scene, id, &told.angle_texture,
                                                     &told.retardance_texture));
    REQUIRE(told.angle_texture != nullptr);
    OK(nicol_scene_set_polarization_element(stage.scene, id, &told));
    for (const nicol_texture again : {told.angle_texture, told.retardance_texture})
        OK(nicol_texture_release(again));
    nicol_texture none = told.angle_texture;
    OK(nicol_scene_get_polarization_element_textures(stage.scene, add_element(stage.scene), &none, nullptr));
    CHECK(none == nullptr);

    nicol_texture colors = make(nicol_texture_create_vertex_colors, stage.context);
    sheet.angle_texture = nullptr;
    sheet.retardance_texture = colors;
    REFUSES(nicol_scene_add_polarization_element(stage.scene, &sheet, nullptr), "the colours of a mesh");
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    std::ranges::copy(nicol_polarization_element(NICOL_POLARIZATION_ELEMENT_INIT).to_world, sheet.to_world);
    REFUSES(nicol_sensor_add_element(&sensor, &sheet, 0), "a sensor's element has a texture");
    OK(nicol_texture_release(colors));
}

STAGE_TEST_CASE("ids of removed elements are not given again") {
    for (std::uint32_t id = 0; id < 3; ++id) CHECK(add_element(stage.scene) == id);
    OK(nicol_scene_remove_polarization_element(stage.scene, 1));
    CHECK(add_element(stage.scene) == 3);
    CHECK(element_ids_of(stage.scene) == std::vector<std::uint32_t>{0, 2, 3});
    nicol_polarization_element element = NICOL_POLARIZATION_ELEMENT_INIT;
    REFUSES(nicol_scene_remove_polarization_element(stage.scene, 1), "no element 1; it was removed");
    REFUSES(nicol_scene_set_polarization_element(stage.scene, 4, &element), "no element 4");
    REFUSES(nicol_scene_get_polarization_element(stage.scene, UINT32_MAX, &element), "no element 4294967295");
    std::uint32_t ids[3] = {};
    REFUSES(nicol_scene_get_polarization_element_ids(stage.scene, ids, 4), "the scene has 3 elements");
}

STAGE_TEST_CASE("fields of an element that are out of range are refused by name") {
    const struct {
        const char* name;
        std::function<void(nicol_polarization_element&)> spoil;
    } rows[] = {{"element->kind", [](nicol_polarization_element& p) { p.kind = 4; }},
                {"element->outline", [](nicol_polarization_element& p) { p.outline = 2; }},
                {"element->reserved", [](nicol_polarization_element& p) { p.reserved = 1; }},
                {"to_world", [](nicol_polarization_element& p) { p.to_world[0] = 0; }},
                {"to_world", [](nicol_polarization_element& p) { p.to_world[15] = 2; }},
                {"angle", [](nicol_polarization_element& p) { p.angle = INFINITY; }},
                {"retardance", [](nicol_polarization_element& p) { p.retardance = NAN; }},
                {"transmittance", [](nicol_polarization_element& p) { p.transmittance = 1.5; }}};
    const std::uint32_t id = add_element(stage.scene);
    for (const auto& row : rows) {
        nicol_polarization_element element = NICOL_POLARIZATION_ELEMENT_INIT;
        row.spoil(element);
        REFUSES(nicol_scene_add_polarization_element(stage.scene, &element, nullptr), row.name);
        REFUSES(nicol_scene_set_polarization_element(stage.scene, id, &element), row.name);
    }
    CHECK(element_ids_of(stage.scene) == std::vector<std::uint32_t>{0});
    nicol_polarization_element told = NICOL_POLARIZATION_ELEMENT_INIT;
    OK(nicol_scene_get_polarization_element(stage.scene, id, &told));
    check_same(told, NICOL_POLARIZATION_ELEMENT_INIT);
}

STAGE_TEST_CASE("the camera sees through elements, in one method as in the other, until they are gone") {
    nicol_camera narrow = stage.camera;
    narrow.fov = 0.5;  // crossed polarizers are black only along their normal
    nicol_render_options reference = plain_options();
    reference.method = NICOL_METHOD_REFERENCE;
    reference.samples = 4;
    const auto image = [&](const nicol_render_options& options) {
        OK(nicol_render(stage.scene, &narrow, &options, stage.framebuffer));
        return read_all(stage.framebuffer);
    };
    const std::vector<float> open = image(plain_options());
    const std::uint32_t first =
        add_element(stage.scene, before_camera(NICOL_POLARIZATION_ELEMENT_POLARIZER, 0, 2));
    const std::uint32_t second =
        add_element(stage.scene, before_camera(NICOL_POLARIZATION_ELEMENT_POLARIZER, 90, 2.5));
    for (const nicol_render_options& options : {plain_options(), reference})
        for (const float value : image(options)) CHECK(std::abs(value) < 1e-6F);
    const nicol_polarization_element circular =
        before_camera(NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR, 0, 2.5);
    OK(nicol_scene_set_polarization_element(stage.scene, second, &circular));
    const std::vector<float> left = image(plain_options());
    for (std::size_t i = 0; i < left.size(); i += 4) {
        CHECK(left[i + 3] == doctest::Approx(-left[i]));
        // The linear polarizer transmits (s0 + s1) / 2, and the circular one half of that.
        CHECK(left[i] == doctest::Approx(0.25F * (open[i] + open[i + 1])).epsilon(1e-4));
    }
    for (const std::uint32_t id : {first, second})
        OK(nicol_scene_remove_polarization_element(stage.scene, id));
    CHECK(image(plain_options()) == open);
}
