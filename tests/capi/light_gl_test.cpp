// SPDX-License-Identifier: MIT
// Tests of lights beside the environment, and of instances that emit light.
#include <numbers>

#include "capi.hpp"

using namespace capi_test;

namespace {

std::uint32_t add_light(nicol_scene scene, const nicol_light& light = NICOL_LIGHT_INIT) {
    std::uint32_t id = 99;
    OK(nicol_scene_add_light(scene, &light, &id));
    return id;
}

std::vector<std::uint32_t> light_ids_of(nicol_scene scene) {
    std::uint32_t count = 99;
    OK(nicol_scene_get_light_count(scene, &count));
    std::vector<std::uint32_t> ids(count, 99);
    OK(nicol_scene_get_light_ids(scene, ids.data(), count));
    return ids;
}

nicol_texture checkerboard(nicol_context context) {
    return make(nicol_texture_create_checkerboard, context, nullptr, nullptr, nullptr);
}

/// Returns a texture of 2 x 1 texels with this number of channels.
nicol_texture texels(nicol_context context, std::uint32_t channels, float value) {
    const std::vector<float> pixels(std::size_t{2} * channels, value);
    const nicol_texture_image image = image_of_texels(pixels, 2, 1, channels, NICOL_TEXEL_FLOAT32);
    return make(nicol_texture_create_image, context, &image, nullptr);
}

void check_same(const nicol_polarization& a, const nicol_polarization& b) {
    CHECK(a.dolp == b.dolp);
    CHECK(a.aolp == b.aolp);
    CHECK(a.docp == b.docp);
    CHECK(std::ranges::equal(a.axis, b.axis));
}

void check_same(const nicol_light& a, const nicol_light& b) {
    CHECK(a.kind == b.kind);
    CHECK(a.value.count == b.value.count);
    CHECK(std::equal(a.value.values, a.value.values + a.value.count, b.value.values));
    CHECK(std::ranges::equal(a.to_world, b.to_world));
    const auto angle = [](double degrees) { return doctest::Approx(degrees).epsilon(1e-12); };
    CHECK(a.angular_radius == angle(b.angular_radius));
    CHECK(a.cutoff_angle == angle(b.cutoff_angle));
    CHECK(a.beam_width == angle(b.beam_width));
    CHECK(a.fov == angle(b.fov));
    CHECK(a.aspect == b.aspect);
    check_same(a.polarization, b.polarization);
}

nicol_light turned(nicol_light_kind kind) {
    nicol_light light = NICOL_LIGHT_INIT;
    light.kind = kind;
    light.value = spectrum({1.5F, 0, 300});
    const Matrix to_world{{0, 0, 1, 2, 1, 0, 0, -3, 0, 1, 0, 4.5, 0, 0, 0, 1}};
    std::ranges::copy(to_world.rows, light.to_world);
    light.polarization = {0.6, -0.25, -0.8, {0, 2, 1}};
    return light;
}

}  // namespace

STAGE_TEST_CASE("a light is what it was given as, whatever its kind") {
    nicol_light sun = turned(NICOL_LIGHT_DIRECTIONAL), spot = turned(NICOL_LIGHT_SPOT),
                projector = turned(NICOL_LIGHT_PROJECTOR);
    sun.angular_radius = 0.27;
    spot.cutoff_angle = 90;
    spot.beam_width = 12.5;
    projector.fov = 100;
    projector.aspect = 1.25;
    const nicol_light lights[] = {NICOL_LIGHT_INIT, sun, turned(NICOL_LIGHT_POINT), spot, projector};
    std::vector<std::uint32_t> ids;
    for (const nicol_light& light : lights) ids.push_back(add_light(stage.scene, light));
    CHECK(ids == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
    for (const std::uint32_t id : ids) {
        nicol_light told = NICOL_LIGHT_INIT;
        nicol_texture texture = marker<nicol_texture>();
        OK(nicol_scene_get_light(stage.scene, id, &told, &texture));
        CHECK(texture == nullptr);
        nicol_light wanted = lights[id];
        if (wanted.value.count == 0) wanted.value = spectrum({1});
        check_same(told, wanted);
        // A reported light can be set again.
        OK(nicol_scene_set_light(stage.scene, id, &told));
    }
    CHECK(light_ids_of(stage.scene) == ids);
}

STAGE_TEST_CASE("ids of removed lights are not given again, and are apart from those of instances") {
    for (std::uint32_t id = 0; id < 3; ++id) CHECK(add_light(stage.scene) == id);
    OK(nicol_scene_remove_light(stage.scene, 1));
    CHECK(light_ids_of(stage.scene) == std::vector<std::uint32_t>{0, 2});
    CHECK(add_light(stage.scene) == 3);
    nicol_light told = NICOL_LIGHT_INIT, given = turned(NICOL_LIGHT_POINT);
    REFUSES(nicol_scene_remove_light(stage.scene, 1), "no light 1; it was removed");
    REFUSES(nicol_scene_set_light(stage.scene, 4, &given), "no light 4");
    REFUSES(nicol_scene_get_light(stage.scene, UINT32_MAX, &told, nullptr), "no light 4294967295");
    OK(nicol_scene_set_light(stage.scene, 2, &given));
    OK(nicol_scene_get_light(stage.scene, 2, &told, nullptr));
    check_same(told, given);
    std::uint32_t ids[3] = {};
    REFUSES(nicol_scene_get_light_ids(stage.scene, ids, 4), "the scene has 3 lights");
    std::uint32_t instances = 0;
    OK(nicol_scene_get_instance_count(stage.scene, &instances));
    CHECK(instances == 1);
}

STAGE_TEST_CASE("a light keeps its texture, and gives it as a handle") {
    nicol_light spot = turned(NICOL_LIGHT_SPOT);
    {
        const Owned texture(checkerboard(stage.context));
        spot.texture = texture;
        CHECK(add_light(stage.scene, spot) == 0);
    }
    nicol_light told = NICOL_LIGHT_INIT;
    Owned<nicol_texture> texture;
    OK(nicol_scene_get_light(stage.scene, 0, &told, &texture));
    CHECK(texture != nullptr);
    CHECK(told.texture == nullptr);
    told.texture = texture;
    OK(nicol_scene_set_light(stage.scene, 0, &told));
    nicol_texture untouched = marker<nicol_texture>();
    told.struct_size = 0;
    REFUSES(nicol_scene_get_light(stage.scene, 0, &told, &untouched), "struct_size");
    CHECK(untouched == marker<nicol_texture>());
}

STAGE_TEST_CASE("an instance emits light, and stops") {
    nicol_emission told = NICOL_EMISSION_INIT;
    Owned<nicol_texture> texture;
    OK(nicol_scene_get_emission(stage.scene, 0, &told, &texture));
    CHECK(told.radiance.count == 1);
    CHECK(told.radiance.values[0] == 0);
    nicol_emission given = NICOL_EMISSION_INIT;
    given.two_sided = 1;
    given.radiance = spectrum({1, 2, 300});
    given.polarization = {0.5, std::numbers::pi / 8, 0.1, {1, 1, 0}};
    const Owned image(texels(stage.context, 3, 4));
    given.texture = image;
    OK(nicol_scene_set_emission(stage.scene, 0, &given));
    OK(nicol_scene_get_emission(stage.scene, 0, &told, &texture));
    CHECK(told.two_sided == 1);
    CHECK(told.radiance.count == 3);
    CHECK(std::equal(told.radiance.values, told.radiance.values + 3, given.radiance.values));
    check_same(told.polarization, given.polarization);
    CHECK(texture != nullptr);
    CHECK(told.texture == nullptr);
    OK(nicol_scene_set_emission(stage.scene, 0, nullptr));
    OK(nicol_scene_get_emission(stage.scene, 0, &told, &texture));
    CHECK(told.radiance.values[0] == 0);
    CHECK(told.two_sided == 0);
    CHECK(texture == nullptr);
    REFUSES(nicol_scene_set_emission(stage.scene, 1, &given), "no instance 1");
    REFUSES(nicol_scene_get_emission(stage.scene, 1, &told, nullptr), "no instance 1");
}

STAGE_TEST_CASE("lights that cannot be are refused, by field") {
    const Owned covered(texels(stage.context, 4, 1)), negative(texels(stage.context, 1, -1));
    const Owned colors(make(nicol_texture_create_vertex_colors, stage.context));
    std::uint32_t id = 77;
    const auto adds = [&](const nicol_light& light) {
        const nicol_result result = nicol_scene_add_light(stage.scene, &light, &id);
        CHECK(id == 77);
        return result;
    };
    check_wrong(turned(NICOL_LIGHT_POINT), adds,
                {{"light->kind is 4", [](auto& l) { l.kind = 4; }},
                 {"light->reserved", [](auto& l) { l.reserved = 1; }},
                 {"light->value.count", [](auto& l) { l.value.count = 17; }},
                 {"value of a light is -1", [](auto& l) { l.value.values[1] = -1; }},
                 {"value of a light", [](auto& l) { l.value.values[2] = INFINITY; }},
                 {"value of a light", [](auto& l) { l.value.values[0] = NAN; }},
                 {"colour channels", [](auto& l) { l.value.count = 2; }},
                 {"to_world", [](auto& l) { l.to_world[0] = 2; }},
                 {"to_world", [](auto& l) { l.to_world[3] = NAN; }},
                 {"to_world", [](auto& l) { l.to_world[12] = 1; }},
                 {"dolp is 1.1", [](auto& l) { l.polarization.dolp = 1.1; }},
                 {"dolp", [](auto& l) { l.polarization.dolp = NAN; }},
                 {"docp is -1.5", [](auto& l) { l.polarization.docp = -1.5; }},
                 {"more polarized than light", [](auto& l) { l.polarization.dolp = 0.7; }},
                 {"aolp", [](auto& l) { l.polarization.aolp = INFINITY; }},
                 {"axis has no direction", [](auto& l) { std::ranges::fill(l.polarization.axis, 0.0); }},
                 {"only spots and projectors have a texture", [&](auto& l) { l.texture = negative; }}});
    check_wrong(turned(NICOL_LIGHT_DIRECTIONAL), adds,
                {{"light->angular_radius is 90.5", [](auto& l) { l.angular_radius = 90.5; }},
                 {"light->angular_radius", [](auto& l) { l.angular_radius = -0.1; }},
                 {"light->angular_radius", [](auto& l) { l.angular_radius = NAN; }}});
    check_wrong(turned(NICOL_LIGHT_SPOT), adds,
                {{"light->cutoff_angle is 91", [](auto& l) { l.cutoff_angle = 91; }},
                 {"light->cutoff_angle", [](auto& l) { l.cutoff_angle = l.beam_width = 0; }},
                 {"light->beam_width is 21", [](auto& l) { l.beam_width = 21; }},
                 {"light->beam_width", [](auto& l) { l.beam_width = -1; }},
                 {"channels", [&](auto& l) { l.texture = covered; }},
                 {"negative values", [&](auto& l) { l.texture = negative; }},
                 {"colours of a mesh", [&](auto& l) { l.texture = colors; }}});
    check_wrong(turned(NICOL_LIGHT_PROJECTOR), adds,
                {{"light->fov is 180", [](auto& l) { l.fov = 180; }},
                 {"light->fov", [](auto& l) { l.fov = 0; }},
                 {"aspect", [](auto& l) { l.aspect = 0; }},
                 {"aspect", [](auto& l) { l.aspect = HUGE_VAL; }}});
    const Owned elsewhere(make_context(NICOL_BACKEND_OSMESA));
    const Owned foreign(checkerboard(elsewhere));
    nicol_light spot = turned(NICOL_LIGHT_SPOT);
    spot.texture = foreign;
    FAILS(adds(spot), NICOL_ERROR_INVALID_HANDLE, "contexts");
    spot.texture = marker<nicol_texture>();
    FAILS(adds(spot), NICOL_ERROR_INVALID_HANDLE, "nicol_texture");
    CHECK(light_ids_of(stage.scene).empty());
}

STAGE_TEST_CASE("emissions that cannot be are refused, by field") {
    const Owned covered(texels(stage.context, 4, 1)), negative(texels(stage.context, 1, -1));
    const auto sets = [&](const nicol_emission& emission) {
        return nicol_scene_set_emission(stage.scene, 0, &emission);
    };
    check_wrong(nicol_emission NICOL_EMISSION_INIT, sets,
                {{"emission->two_sided is 2", [](auto& e) { e.two_sided = 2; }},
                 {"emission->reserved", [](auto& e) { e.reserved = 1; }},
                 {"emission->radiance.count", [](auto& e) { e.radiance.count = 17; }},
                 {"radiance of a surface is -2", [](auto& e) { e.radiance = spectrum({-2}); }},
                 {"radiance of a surface", [](auto& e) { e.radiance = spectrum({INFINITY}); }},
                 {"colour channels",
                  [](auto& e) {
                      e.radiance = spectrum({1, 1});
                  }},
                 {"dolp is 2", [](auto& e) { e.polarization.dolp = 2; }},
                 {"4 channels", [&](auto& e) { e.texture = covered; }},
                 {"negative values", [&](auto& e) { e.texture = negative; }}});
    // The corners of this mesh have no texture coordinates.
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint32_t indices[] = {0, 1, 2};
    nicol_mesh_data data = mesh_over(positions, indices);
    const Owned bare(make(nicol_mesh_create, stage.context, &data));
    const std::uint32_t id = add(stage.scene, bare, stage.material);
    const Owned image(checkerboard(stage.context));
    nicol_emission emission = NICOL_EMISSION_INIT;
    OK(nicol_scene_set_emission(stage.scene, id, &emission));
    emission.texture = image;
    REFUSES(nicol_scene_set_emission(stage.scene, id, &emission), "give it u, v");
}

STAGE_TEST_CASE("a light's channels must fit, and light of red, green and blue makes a grey scene coloured") {
    const Owned scene(empty_scene(stage.context));
    std::uint32_t channels = 0;
    add_light(scene);
    OK(nicol_scene_get_channels(scene, &channels));
    CHECK(channels == 1);
    const std::uint32_t id = add_light(scene, turned(NICOL_LIGHT_POINT));
    OK(nicol_scene_get_channels(scene, &channels));
    CHECK(channels == 3);
    nicol_light five = NICOL_LIGHT_INIT;
    five.value = spectrum({1, 2, 3, 4, 5});
    REFUSES(nicol_scene_set_light(scene, 0, &five), "colour channels");
    OK(nicol_scene_set_light(scene, id, &five));
    OK(nicol_scene_get_channels(scene, &channels));
    CHECK(channels == 5);
}

TEST_CASE("the sun of a sky is a light from the sky's sun") {
    nicol_sky sky = NICOL_SKY_INIT;
    sky.turbidity = 3;
    const float direction[] = {1, 2, 2};
    std::copy_n(direction, 3, sky.sun_direction);
    sky.radiance = spectrum({0.5, 0.5, 0.5});
    nicol_light sun = NICOL_LIGHT_INIT;
    OK(nicol_sky_get_sun(&sky, &sun));
    CHECK(sun.kind == NICOL_LIGHT_DIRECTIONAL);
    CHECK(sun.angular_radius == doctest::Approx(0.27));
    CHECK(sun.value.count == 3);
    CHECK(sun.value.values[0] > sun.value.values[2]);
    // The light travels along its +z, away from the sun.
    for (int i = 0; i < 3; ++i) CHECK(sun.to_world[4 * i + 2] == doctest::Approx(-direction[i] / 3));
    REFUSES(nicol_sky_get_sun(&sky, nullptr), "light");
    sky.sun_direction[1] = -1;
    REFUSES(nicol_sky_get_sun(&sky, &sun), "below the horizon");
}

STAGE_TEST_CASE("spheres have as many segments as asked for") {
    for (const std::uint32_t segments : {2U, 6U, 38U, 76U}) {
        const Owned ball(make(nicol_mesh_create_divided_sphere, stage.context, segments));
        std::uint32_t vertices = 0, triangles = 0;
        OK(nicol_mesh_get_size(ball, &vertices, &triangles));
        CHECK(vertices == 10 * segments * segments + 2);
    }
    nicol_mesh none = marker<nicol_mesh>();
    for (const std::uint32_t segments : {0U, 3U, 514U})
        REFUSES(nicol_mesh_create_divided_sphere(stage.context, segments, &none),
                "it must be even, 2 to 512");
    CHECK(none == marker<nicol_mesh>());
}

STAGE_TEST_CASE("the cylinder and the disc") {
    const double p0[] = {0, 0, 0}, p1[] = {0, 0, 2};
    std::uint32_t vertices = 0, triangles = 0;
    const Owned disc(make(nicol_mesh_create_disk, stage.context));
    OK(nicol_mesh_get_size(disc, &vertices, &triangles));
    CHECK(triangles == 180 * (2 * 15 + 1));
    const Owned cylinder(make(nicol_mesh_create_cylinder, stage.context, p0, p1, 0.5));
    OK(nicol_mesh_get_size(cylinder, &vertices, &triangles));
    CHECK(triangles == 180 * 2 * 32);
    nicol_mesh none = marker<nicol_mesh>();
    REFUSES(nicol_mesh_create_cylinder(stage.context, p0, p0, 0.5, &none), "two finite points that differ");
    REFUSES(nicol_mesh_create_cylinder(stage.context, p0, p1, 0, &none), "positive, finite radius");
    CHECK(none == marker<nicol_mesh>());
}
