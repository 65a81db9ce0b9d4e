// SPDX-License-Identifier: MIT
// Tests of arguments refused by name, beyond the rules of contract_gl_test.cpp: one row per check. A check
// inside the library has one row per member here and is tested over its full range beside the library.
#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Wraps `create` and checks that a failing call makes no handle.
template <class Handle, class Parameters>
auto creates(nicol_result (*create)(nicol_context, const Parameters*, Handle*), nicol_context context) {
    return [=](const Parameters& parameters) {
        Handle handle = marker<Handle>();
        const nicol_result result = create(context, &parameters, &handle);
        CHECK(handle == marker<Handle>());
        return result;
    };
}

}  // namespace

TEST_CASE("contexts and devices that cannot be are refused") {
    nicol_context context = marker<nicol_context>();
    std::uint32_t count = 0;
    OK(nicol_device_count(&count));
    nicol_device_info info = NICOL_DEVICE_INFO_INIT;
    info.software = 7;
    for (const std::uint32_t bad : {0U, count + 1, UINT32_MAX})
        REFUSES(nicol_device_get_info(bad, &info), std::to_string(bad));
    CHECK(info.software == 7);
    check_wrong(nicol_context_options NICOL_CONTEXT_OPTIONS_INIT,
                [&](const auto& options) { return nicol_context_create(&options, &context); },
                {{"backend", [](auto& o) { o.backend = 3; }},
                 {"threads", [](auto& o) { o.threads = UINT32_MAX; }},
                 {"device", [](auto& o) { o.backend = NICOL_BACKEND_OSMESA, o.device = 1; }},
                 {"device", [](auto& o) { o.backend = NICOL_BACKEND_EGL, o.device = 999; }},
                 {"device", [](auto& o) { o.device = UINT32_MAX; }}});
    CHECK(context == marker<nicol_context>());
}

CONTEXT_TEST_CASE("light that cannot be is refused") {
    check_wrong(spectrum({1, 1, 1}), creates(nicol_environment_create_constant, context),
                {{"radiance.count", [](auto& s) { s.count = 17; }},
                 {"radiance", [](auto& s) { s.values[1] = -1; }},
                 {"radiance", [](auto& s) { s.values[1] = NAN; }}});
    nicol_sky hazy = NICOL_SKY_INIT;
    hazy.turbidity = 3;
    check_wrong(hazy, creates(nicol_environment_create_sky, context),
                {{"dop_max", [](auto& s) { s.dop_max = 1.01F; }},
                 {"dop_max", [](auto& s) { s.dop_max = -0.1F; }},
                 {"sun_direction", [](auto& s) { s.sun_direction[1] = 0; }},
                 {"sun_direction", [](auto& s) { s.sun_direction[1] = -0.5F; }},
                 {"radiance",
                  [](auto& s) {
                      s.radiance = spectrum({1, -1, 1});
                  }},
                 {"sky->radiance.count", [](auto& s) { s.radiance.count = 99; }},
                 {"turbidity", [](auto& s) { s.turbidity = 1; }},
                 {"ground_albedo", [](auto& s) { s.ground_albedo = -0.1F; }},
                 {"ground_albedo", [](auto& s) { s.ground_albedo = 1.5F; }}});

    std::vector<double> values(2 * 36, 0.0);
    values[0] = values[36] = 1;
    struct Coefficients {
        std::uint32_t order, channels;
        std::uint64_t count;
        std::size_t changed = 1;
        double value = 0;
    };
    nicol_environment light = marker<nicol_environment>();
    check_wrong(Coefficients{2, 2, 72},
                [&](const Coefficients& c) {
                    std::vector<double> changed = values;
                    changed[c.changed] = c.value;
                    return nicol_environment_create_psh(context, c.order, c.channels, changed.data(), c.count,
                                                        &light);
                },
                {{"channels", [](auto& c) { c.channels = 0, c.count = 0; }},
                 {"channels", [](auto& c) { c.channels = 17; }},
                 {"l = 2", [](auto& c) { c.changed = 9, c.value = 0.5; }}});  // coefficient p = 1 of l = 1
    CHECK(light == marker<nicol_environment>());
}

CONTEXT_TEST_CASE("materials that cannot be are refused") {
    check_wrong(spectrum({0.5F}), creates(nicol_material_create_diffuse, context),
                {{"reflectance.count", [](auto& s) { s.count = 17; }},
                 {"reflectance", [](auto& s) { s.values[0] = 1.1F; }}});
    check_wrong(nicol_pplastic NICOL_PPLASTIC_INIT, creates(nicol_material_create_pplastic, context),
                {{"distribution", [](auto& p) { p.distribution = 2; }},
                 {"int_ior", [](auto& p) { p.int_ior = -1.5F; }},
                 {"int_ior", [](auto& p) { p.int_ior = 0; }},
                 {"alpha", [](auto& p) { p.alpha = 0; }},
                 {"ext_ior", [](auto& p) { p.ext_ior = INFINITY; }},
                 {"alpha", [](auto& p) { p.alpha = 0.0005F; }},
                 {"diffuse_reflectance", [](auto& p) { p.diffuse_reflectance = spectrum({1.1F}); }},
                 {"diffuse_reflectance", [](auto& p) { p.diffuse_reflectance.count = 17; }},
                 {"specular_reflectance", [](auto& p) { p.specular_reflectance = spectrum({-0.1F}); }},
                 {"channels", [](auto& p) {
                      p.diffuse_reflectance = spectrum({0.5F, 0.5F});
                      p.specular_reflectance = spectrum({0.5F, 0.5F, 0.5F});
                  }}});
    check_wrong(nicol_plastic NICOL_PLASTIC_INIT, creates(nicol_material_create_plastic, context),
                {{"distribution", [](auto& p) { p.distribution = 2; }},
                 {"int_ior", [](auto& p) { p.int_ior = 0; }},
                 {"ext_ior", [](auto& p) { p.ext_ior = INFINITY; }},
                 {"alpha", [](auto& p) { p.alpha = 0.0005F; }},
                 {"nonlinear", [](auto& p) { p.nonlinear = 2; }},
                 {"diffuse_reflectance", [](auto& p) { p.diffuse_reflectance = spectrum({1.1F}); }},
                 {"specular_reflectance", [](auto& p) { p.specular_reflectance.count = 17; }}});
    check_wrong(nicol_principled NICOL_PRINCIPLED_INIT, creates(nicol_material_create_principled, context),
                {{"base_color", [](auto& p) { p.base_color = spectrum({1.1F}); }},
                 {"base_color.count", [](auto& p) { p.base_color.count = 17; }},
                 {"eta", [](auto& p) { p.eta = 0; }},
                 {"roughness", [](auto& p) { p.roughness = 1.5F; }},
                 {"anisotropic", [](auto& p) { p.anisotropic = -0.1F; }},
                 {"metallic", [](auto& p) { p.metallic = NAN; }},
                 {"spec_trans", [](auto& p) { p.spec_trans = 2; }},
                 {"spec_tint", [](auto& p) { p.spec_tint = -1; }},
                 {"sheen", [](auto& p) { p.sheen = 1.1F; }},
                 {"sheen_tint", [](auto& p) { p.sheen_tint = -0.1F; }},
                 {"flatness", [](auto& p) { p.flatness = 1.1F; }},
                 {"clearcoat", [](auto& p) { p.clearcoat = -0.1F; }},
                 {"clearcoat_gloss", [](auto& p) { p.clearcoat_gloss = 1.1F; }},
                 {"reserved", [](auto& p) { p.reserved = 1; }}});
    check_wrong(nicol_conductor NICOL_CONDUCTOR_INIT, creates(nicol_material_create_conductor, context),
                {{"Unobtainium", [](auto& p) { p.metal = "Unobtainium"; }},
                 {"metal", [](auto& p) { p.metal = "Au", p.eta = spectrum({1}); }},
                 {"metal", [](auto& p) { p.metal = "Au", p.k = spectrum({1}); }},
                 {"wavelength", [](auto& p) { p.metal = "Au", p.wavelengths = spectrum({300}); }},
                 {"wavelengths", [](auto& p) { p.wavelengths = spectrum({500}); }},
                 {"eta",
                  [](auto& p) {
                      p.eta = spectrum({1, 2}), p.k = spectrum({1, 2, 3});
                  }},
                 {"eta", [](auto& p) { p.eta = spectrum({-1}); }},
                 {"k.count", [](auto& p) { p.k.count = 17; }},
                 {"alpha", [](auto& p) { p.alpha = 1.5F; }},
                 {"distribution", [](auto& p) { p.distribution = 2; }},
                 {"reserved", [](auto& p) { p.reserved = 1; }},
                 {"specular_reflectance", [](auto& p) { p.specular_reflectance = spectrum({1.5F}); }}});
    check_wrong(nicol_dielectric NICOL_DIELECTRIC_INIT, creates(nicol_material_create_dielectric, context),
                {{"thin", [](auto& p) { p.thin = 2; }},
                 {"int_ior", [](auto& p) { p.int_ior = 0; }},
                 {"ext_ior", [](auto& p) { p.ext_ior = INFINITY; }},
                 {"specular_reflectance", [](auto& p) { p.specular_reflectance = spectrum({1.5F}); }},
                 {"specular_transmittance", [](auto& p) { p.specular_transmittance = spectrum({-0.1F}); }},
                 {"absorption", [](auto& p) { p.absorption = spectrum({-1}); }},
                 {"alpha", [](auto& p) { p.alpha = 1.5F; }},
                 {"distribution", [](auto& p) { p.distribution = 2; }},
                 {"absorption.count", [](auto& p) { p.absorption.count = 17; }},
                 {"absorption",
                  [](auto& p) {
                      p.absorption = spectrum({1, 2}), p.specular_reflectance = spectrum({1, 1, 1});
                  }},
                 {"specular_transmittance", [](auto& p) { p.thin = 1, p.absorption = spectrum({1}); }}});
}

CONTEXT_TEST_CASE("meshes that are none are refused") {
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, broken[] = {0, 0, 0, 1, NAN, 0, 0, 1, 0};
    static const float infinite[] = {INFINITY, 0, 1, 0, 0, 1, 0, 0, 1};
    static const std::uint32_t indices[] = {0, 1, 2}, outside[] = {0, 1, 3}, flat[] = {0, 1, 0};
    nicol_mesh_data data = mesh_over(positions, indices);
    check_wrong(data, creates(nicol_mesh_create, context),
                {{"positions", [](auto& d) { d.positions = nullptr; }},
                 {"indices", [](auto& d) { d.indices = nullptr; }},
                 {"data", [](auto& d) { d.vertex_count = 0; }},
                 {"data", [](auto& d) { d.triangle_count = 0; }},
                 {"data", [](auto& d) { d.indices = outside; }},
                 {"none of the 1 triangles has an area", [](auto& d) { d.indices = flat; }},
                 {"data", [](auto& d) { d.positions = broken; }},
                 {"data", [](auto& d) { d.normals = infinite; }},
                 {"the colour of vertex 0", [](auto& d) { d.colors = infinite; }},
                 {"the colour of face 0", [](auto& d) { d.face_colors = infinite; }},
                 {"texture coordinate 2", [](auto& d) { d.texcoords = broken; }},
                 {"but no texcoords", [](auto& d) { d.texcoord_count = 3; }},
                 {"but no texcoords", [](auto& d) { d.texcoord_indices = indices; }},
                 {"but no texcoords", [](auto& d) { d.tangents = positions; }},
                 {"the tangent of texture coordinate 0",
                  [](auto& d) { d.texcoords = positions, d.tangents = infinite; }},
                 {"without texcoord_indices it must be vertex_count, 3",
                  [](auto& d) { d.texcoords = positions, d.texcoord_count = 4; }},
                 {"uses texture coordinate 3, but there are only 3",
                  [](auto& d) { d.texcoords = positions, d.texcoord_indices = outside; }}});
}

CONTEXT_TEST_CASE("textures that cannot be are refused") {
    static const float values[] = {0, 0.5F, 1, NAN};
    nicol_texture_image image = NICOL_TEXTURE_IMAGE_INIT;
    image.type = NICOL_TEXEL_FLOAT32;
    image.width = 3;
    image.height = image.channels = 1;
    image.pixels = values;
    image.byte_size = sizeof values;
    nicol_texture texture = marker<nicol_texture>();
    const auto create = [&](const nicol_texture_image& given, const nicol_texture_options* options) {
        const nicol_result result = nicol_texture_create_image(context, &given, options, &texture);
        CHECK(texture == marker<nicol_texture>());
        return result;
    };
    check_wrong(image, [&](const auto& given) { return create(given, nullptr); },
                {{"pixels", [](auto& i) { i.pixels = nullptr; }},
                 {"type is 3; it must be one of NICOL_TEXEL_", [](auto& i) { i.type = 3; }},
                 {"reserved", [](auto& i) { i.reserved = 1; }},
                 {"0 x 1", [](auto& i) { i.width = 0; }},
                 {"3 x 0", [](auto& i) { i.height = 0; }},
                 {"32769 x 1", [](auto& i) { i.width = 32769; }},
                 {"product may be 201326592", [](auto& i) { i.width = i.height = 32768; }},
                 {"channels is 2; it must be 1, 3 or 4", [](auto& i) { i.channels = 2; }},
                 {"row_stride is 11; a row takes 12", [](auto& i) { i.row_stride = 11; }},
                 {"row_stride", [](auto& i) { i.row_stride = UINT64_MAX; }},
                 {"byte_size is 11; the image takes 12", [](auto& i) { i.byte_size = 11; }},
                 {"the image takes 24", [](auto& i) { i.height = 2; }},
                 {"pixel (3, 0) is not finite", [](auto& i) { i.width = 4; }}});
    check_wrong(nicol_texture_options NICOL_TEXTURE_OPTIONS_INIT,
                [&](const auto& options) {
                    CHECK(nicol_texture_load(context, "absent.png", &options, &texture) != NICOL_OK);
                    return create(image, &options);
                },
                {{"filter is 3; it must be one of NICOL_TEXTURE_FILTER_", [](auto& o) { o.filter = 3; }},
                 {"wrap is 3; it must be one of NICOL_TEXTURE_WRAP_", [](auto& o) { o.wrap = 3; }},
                 {"raw is 2; it must be 0 or 1", [](auto& o) { o.raw = 2; }},
                 {"last row of to_uv must be 0 0 1", [](auto& o) { o.to_uv[6] = 1; }},
                 {"to_uv has an element that is not finite", [](auto& o) { o.to_uv[2] = not_a_number; }}});
    check_wrong(
        spectrum({1, 1, 1}),
        [&](const nicol_spectrum& color) {
            const nicol_spectrum good = spectrum({0.5F});
            CHECK(nicol_texture_create_checkerboard(context, &color, &good, nullptr, &texture) != NICOL_OK);
            return nicol_texture_create_checkerboard(context, &good, &color, nullptr, &texture);
        },
        {{"color1 has 2 values; a colour has 1 or 3", [](auto& s) { s.count = 2; }},
         {"color1.count", [](auto& s) { s.count = 17; }},
         {"not finite", [](auto& s) { s.values[1] = INFINITY; }}});
    const TemporaryFolder folder;
    const std::string text = folder.write("text.png", "no image"), none = folder.file("none.exr");
    FAILS(nicol_texture_load(context, none.c_str(), nullptr, &texture), NICOL_ERROR_FILE_NOT_FOUND, none);
    FAILS(nicol_texture_load(context, text.c_str(), nullptr, &texture), NICOL_ERROR_UNSUPPORTED, text);
    CHECK(texture == marker<nicol_texture>());
}

CONTEXT_TEST_CASE("textures and materials that do not fit are refused") {
    const Owned texture(make(nicol_texture_create_vertex_colors, context));
    const Owned grey(diffuse(context, {0.5F})), colour(diffuse(context, {0.5F, 0.4F}));
    const Owned both(make(nicol_material_create_twosided, context, grey));
    nicol_material material = marker<nicol_material>();
    const auto stranger_refuses = [&](nicol_context other) {
        const Owned foreign(make(nicol_texture_create_vertex_colors, other));
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.alpha_texture = foreign;
        CHECK(nicol_material_create_pplastic(context, &plastic, &material) == NICOL_ERROR_INVALID_HANDLE);
        nicol_conductor metal = NICOL_CONDUCTOR_INIT;
        metal.specular_reflectance_texture = foreign;
        CHECK(nicol_material_create_conductor(context, &metal, &material) == NICOL_ERROR_INVALID_HANDLE);
        CHECK(nicol_material_create_scaled(context, grey, foreign, &material) == NICOL_ERROR_INVALID_HANDLE);
        CHECK(nicol_material_create_blend(context, grey, colour, foreign, &material) ==
              NICOL_ERROR_INVALID_HANDLE);
    };
    const Owned other(make_context(NICOL_BACKEND_OSMESA));
    stranger_refuses(other);
    check_refused({
        {"3 and 2 channels",
         [&] { return nicol_material_create_scaled(context, colour, texture, &material); }},
        {"mirrored_y is 2; it must be 0 or 1",
         [&] { return nicol_material_create_normal_map(context, grey, texture, 2, &material); }},
        {"scale",
         [&] { return nicol_material_create_bump_map(context, grey, texture, not_a_number, &material); }},
        {"angle",
         [&] { return nicol_material_create_rotated(context, grey, texture, not_a_number, &material); }},
    });
    CHECK(material == marker<nicol_material>());
}

CONTEXT_TEST_CASE("framebuffers that are too large or have no pixels are refused, others made") {
    struct Size {
        std::uint32_t width, height, channels;
    };
    nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
    const auto create = [&](const Size& s) {
        return nicol_framebuffer_create(context, s.width, s.height, s.channels, &framebuffer);
    };
    check_wrong(Size{4, 4, 1}, create,
                {{"0", [](auto& s) { s.width = 0; }},
                 {"16385", [](auto& s) { s.width = 16385; }},
                 {"4294967295", [](auto& s) { s.width = UINT32_MAX; }},
                 {"0", [](auto& s) { s.height = 0; }},
                 {"16385", [](auto& s) { s.height = 16385; }},
                 {"channels", [](auto& s) { s.channels = 0; }},
                 {"channels", [](auto& s) { s.channels = 17; }},
                 {"pixels", [](auto& s) { s.width = s.height = 16384; }},
                 {"pixels", [](auto& s) {
                      s = {16384, 16384, 16};
                  }}});
    CHECK(framebuffer == marker<nicol_framebuffer>());
    for (const Size& size : {Size{1, 1, 1}, Size{1, 300, 16}, Size{8192, 1, 1}, Size{7, 5, 5}}) {
        OK(create(size));
        Size found{};
        OK(nicol_framebuffer_get_size(framebuffer, &found.width, &found.height, &found.channels));
        CHECK((found.width == size.width && found.height == size.height));
        CHECK(found.channels == size.channels);
        OK(nicol_framebuffer_release(framebuffer));
    }
}

STAGE_TEST_CASE("scenes refuse transforms, instances and lights that do not fit, and stay as they were") {
    const std::vector<float> before = stage.image();
    const Matrix to_world;
    const double(&identity)[16] = to_world.rows;
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = stage.mesh;
    instance.material = stage.material;
    std::uint32_t id = 42;
    const std::vector<Wrong<Matrix>> lost = {{"to_world", [](auto& m) { m.rows[0] = 0; }},
                                             {"to_world", [](auto& m) { m.rows[7] = NAN; }},
                                             {"to_world", [](auto& m) { m.rows[12] = 0.1; }}};
    check_wrong(
        to_world, [&](const Matrix& m) { return nicol_scene_set_transform(stage.scene, 0, m.rows); }, lost);
    check_wrong(
        to_world,
        [&](const Matrix& m) {
            std::copy_n(m.rows, 16, instance.to_world);
            return nicol_scene_add_instance(stage.scene, &instance, &id);
        },
        lost);
    // Environments accept only a rotation and a scale.
    check_wrong(to_world,
                [&](const Matrix& m) {
                    return nicol_scene_set_environment(stage.scene, stage.environment, m.rows, 1);
                },
                {{"to_world", [](auto& m) { m.rows[0] = -1; }},
                 {"to_world", [](auto& m) { m.rows[1] = 0.5; }},
                 {"to_world", [](auto& m) { m.rows[5] = 0; }},
                 {"to_world", [](auto& m) { m.rows[10] = NAN; }}});
    for (const double bad : {-1.0, not_a_number, HUGE_VAL})
        REFUSES(nicol_scene_set_environment(stage.scene, stage.environment, nullptr, bad), "scale");
    std::copy_n(identity, 16, instance.to_world);
    instance.flags = 8;
    std::array<std::uint32_t, 2> ids = {7, 7};
    check_refused({
        {"instance->flags is 8", [&] { return nicol_scene_add_instance(stage.scene, &instance, &id); }},
        {"flags is 9", [&] { return nicol_scene_set_instance_flags(stage.scene, 0, 9); }},
        {"instance 4", [&] { return nicol_scene_set_instance_flags(stage.scene, 4, 0); }},
        {"instance 4", [&] { return nicol_scene_set_transform(stage.scene, 4, identity); }},
        {"instance", [&] { return nicol_scene_set_transform(stage.scene, UINT32_MAX, identity); }},
        {"count is 2", [&] { return nicol_scene_get_instance_ids(stage.scene, ids.data(), 2); }},
        {"count is 0", [&] { return nicol_scene_get_instance_ids(stage.scene, ids.data(), 0); }},
        {"ids", [&] { return nicol_scene_get_instance_ids(stage.scene, nullptr, 1); }},
    });
    CHECK(id == 42);
    CHECK(ids == std::array<std::uint32_t, 2>{7, 7});
    CHECK(stage.image() == before);
}

STAGE_TEST_CASE("light is refused where an image could not hold it, and the image stays finite") {
    const std::vector<float> before = stage.image();
    nicol_render_options options = plain_options();
    options.samples = 4;
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE, NICOL_METHOD_REFERENCE}) {
        CAPTURE(method);
        options.method = method;
        const auto render = [&](double scale) {
            OK(nicol_scene_set_environment(stage.scene, stage.environment, nullptr, scale));
            return nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer);
        };
        REFUSES(render(1e300), "too bright");
        REFUSES(render(1e38), "too bright");
        OK(render(1e25));
        CHECK(std::isfinite(largest(stage.image())));
    }
    OK(nicol_scene_set_environment(stage.scene, stage.environment, nullptr, 1));
    options = plain_options();
    OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
    CHECK(stage.image() == before);
}

STAGE_TEST_CASE("cameras and options out of range are refused, and the image stays") {
    const std::vector<float> before = stage.image();
    check_wrong(stage.camera,
                [&](const nicol_camera& camera) {
                    return nicol_render(stage.scene, &camera, nullptr, stage.framebuffer);
                },
                {{"projection", [](auto& c) { c.projection = 2; }},
                 {"fov", [](auto& c) { c.fov = 180; }},
                 {"fov", [](auto& c) { c.fov = 0; }},
                 {"near_clip", [](auto& c) { c.near_clip = -1; }},
                 {"near_clip", [](auto& c) { c.near_clip = 0; }},
                 {"far_clip", [](auto& c) { c.far_clip = 0.001; }},
                 {"to_world", [](auto& c) { c.to_world[0] *= -1; }},  // mirrored
                 {"to_world", [](auto& c) { std::fill_n(c.to_world, 16, 0.0); }},
                 {"to_world", [](auto& c) { c.to_world[15] = 2; }}});
    check_wrong(
        nicol_render_options NICOL_RENDER_OPTIONS_INIT,
        [&](const nicol_render_options& options) {
            nicol_job job = marker<nicol_job>();
            // Errors that are visible at once are refused before a job is created.
            if (options.shadows > 1)
                CHECK(nicol_render_async(stage.scene, &stage.camera, &options, stage.framebuffer, &job) ==
                      NICOL_ERROR_INVALID_ARGUMENT);
            CHECK(job == marker<nicol_job>());
            return stage.try_render(options);
        },
        {{"order_low", [](auto& o) { o.order_low = 33; }},
         {"order_low", [](auto& o) { o.order_low = UINT32_MAX - 1; }},
         {"order_high", [](auto& o) { o.order_high = 65; }},
         {"order_high", [](auto& o) { o.order_high = UINT32_MAX - 1; }},
         {"tolerance", [](auto& o) { o.tolerance = -1; }},
         {"tolerance", [](auto& o) { o.tolerance = not_a_number; }},
         {"high_orders", [](auto& o) { o.high_orders = 3; }},
         {"shade_at", [](auto& o) { o.shade_at = 3; }},
         {"refine_tolerance", [](auto& o) { o.refine_tolerance = -1e-9; }},
         {"refine_tolerance", [](auto& o) { o.refine_tolerance = not_a_number; }},
         {"pixel_samples is 1025; it must lie in 1 to 1024", [](auto& o) { o.pixel_samples = 1025; }},
         {"pixel_samples", [](auto& o) { o.pixel_samples = UINT32_MAX; }},
         {"split_lights is 65; it must lie in 0 to 64", [](auto& o) { o.split_lights = 65; }},
         {"split_lights is -2", [](auto& o) { o.split_lights = -2; }},
         {"light_samples is 0; it must lie in 1 to 1024", [](auto& o) { o.light_samples = 0; }},
         {"light_samples", [](auto& o) { o.light_samples = 1025; }},
         {"light_samples", [](auto& o) { o.light_samples = UINT32_MAX; }},
         {"bsdf_samples is 1025; it must lie in 0 to 1024", [](auto& o) { o.bsdf_samples = 1025; }},
         {"bsdf_samples", [](auto& o) { o.bsdf_samples = UINT32_MAX; }},
         {"max_depth is -2; it must be 1 or more", [](auto& o) { o.max_depth = -2; }},
         {"shadows", [](auto& o) { o.shadows = 2; }},
         {"high_order_shadows", [](auto& o) { o.high_order_shadows = 2; }},
         {"shadows", [](auto& o) { o.shadows = 2, o.method = NICOL_METHOD_REFERENCE; }},
         {"bake_directions", [](auto& o) { o.bake_directions = 1; }},
         {"bake_directions", [](auto& o) { o.bake_directions = 65537; }},
         {"physical", [](auto& o) { o.physical = 2; }},
         {"bake_budget_ms is -1", [](auto& o) { o.bake_budget_ms = -1; }},
         {"bake_budget_ms", [](auto& o) { o.bake_budget_ms = not_a_number; }},
         {"time_budget_ms is -1", [](auto& o) { o.time_budget_ms = -1; }},
         {"time_budget_ms", [](auto& o) { o.time_budget_ms = not_a_number; }},
         {"filter.kind is 6; it must be one of NICOL_FILTER_", [](auto& o) { o.filter.kind = 6; }},
         {"filter.reserved must be 0", [](auto& o) { o.filter.reserved = 1; }},
         {"filter.size is 5",
          [](auto& o) {
              o.filter = {NICOL_FILTER_GAUSSIAN, 0, 5, 0, 0};
          }},
         {"filter.b is 2", [](auto& o) { o.filter.b = 2; }},
         {"filter.c", [](auto& o) { o.filter.c = not_a_number; }},
         {"dering", [](auto& o) { o.dering = -1e-9; }},
         {"dering", [](auto& o) { o.dering = not_a_number; }},
         {"components", [](auto& o) { o.components = 2; }},
         {"disabled_optimisations", [](auto& o) { o.disabled_optimisations = 512; }},
         {"aovs is", [](auto& o) { o.aovs = 2 * NICOL_AOV_ALPHA; }},
         {"aovs is", [](auto& o) { o.aovs = 2 * NICOL_AOV_ALPHA, o.method = NICOL_METHOD_REFERENCE; }},
         {"reference method alone", [](auto& o) { o.aovs = NICOL_AOV_VARIANCE; }},
         {"reference method alone",
          [](auto& o) { o.aovs = NICOL_AOV_VARIANCE, o.method = NICOL_METHOD_DENSE; }},
         {"samples is 1; the variance",
          [](auto& o) { o.aovs = NICOL_AOV_VARIANCE, o.method = NICOL_METHOD_REFERENCE, o.samples = 1; }},
         {"samples", [](auto& o) { o.samples = 0, o.method = NICOL_METHOD_REFERENCE; }},
         {"samples", [](auto& o) { o.samples = (1 << 20) + 1, o.method = NICOL_METHOD_REFERENCE; }},
         {"executor is 3; it must be one of NICOL_EXECUTOR_", [](auto& o) { o.executor = 3; }},
         {"executor is 4294967295", [](auto& o) { o.executor = UINT32_MAX; }}});
    nicol_render_options options = plain_options();
    options.method = 77;
    FAILS(stage.try_render(options), NICOL_ERROR_UNSUPPORTED, "method");
    CHECK(read_all(stage.framebuffer) == before);
}

STAGE_TEST_CASE("planes that do not fit are refused and nothing is written") {
    nicol_render_options options = plain_options();
    options.aovs = NICOL_AOV_DEPTH | NICOL_AOV_INSTANCE;
    OK(stage.try_render(options));
    std::vector<std::uint32_t> pixels(24 * 16 * 12, 0xabcdef01);
    nicol_plane_buffer good = NICOL_PLANE_BUFFER_INIT;
    good.plane = NICOL_PLANE_S0;
    good.pixels = pixels.data();
    good.byte_size = 4 * pixels.size();
    using B = nicol_plane_buffer;
    check_wrong(good, [&](const B& to) { return nicol_framebuffer_read_plane(stage.framebuffer, &to); },
                {{"plane is 14", [](B& b) { b.plane = 14; }},
                 {"polarizer_angle", [](B& b) { b.plane = NICOL_PLANE_POLARIZER, b.polarizer_angle = NAN; }},
                 {"plane", [](B& b) { b.plane = UINT32_MAX; }},
                 {"format", [](B& b) { b.format = 4; }},
                 {"NICOL_FORMAT_FLOAT32", [](B& b) { b.format = NICOL_FORMAT_UINT32; }},
                 {"NICOL_FORMAT_UINT32",
                  [](B& b) { b.plane = NICOL_PLANE_INSTANCE, b.format = NICOL_FORMAT_FLOAT32; }},
                 {"NICOL_FORMAT_UINT32",
                  [](B& b) { b.plane = NICOL_PLANE_INSTANCE, b.format = NICOL_FORMAT_FLOAT16; }},
                 {"channel is 3", [](B& b) { b.channel = 3; }},
                 {"channel", [](B& b) { b.plane = NICOL_PLANE_DEPTH, b.channel = 1; }},
                 {"channel", [](B& b) { b.plane = NICOL_PLANE_DEPTH, b.channel = NICOL_ALL_CHANNELS; }},
                 {"NICOL_PLANE_NORMAL is not there", [](B& b) { b.plane = NICOL_PLANE_NORMAL; }},
                 {"NICOL_PLANE_VARIANCE is not there", [](B& b) { b.plane = NICOL_PLANE_VARIANCE; }},
                 {"NICOL_PLANE_ALPHA is not there", [](B& b) { b.plane = NICOL_PLANE_ALPHA; }},
                 {"NICOL_PLANE_POSITION is not there", [](B& b) { b.plane = NICOL_PLANE_POSITION; }},
                 {"pixels", [](B& b) { b.pixels = nullptr; }},
                 {"byte_size", [](B& b) { b.byte_size = 24 * 16 * 4 - 1; }},
                 {"byte_size", [](B& b) { b.format = NICOL_FORMAT_FLOAT16, b.byte_size = 24 * 16 * 2 - 1; }},
                 {"byte_size", [](B& b) { b.row_stride = 100, b.byte_size = 100 * 15 + 95; }},
                 {"byte_size",
                  [](B& b) {
                      b.plane = NICOL_PLANE_STOKES, b.channel = NICOL_ALL_CHANNELS;
                      b.byte_size = 24 * 16 * 48 - 1;
                  }},
                 {"aligned", [](B& b) { b.pixels = static_cast<char*>(b.pixels) + 2; }},
                 {"row_stride", [](B& b) { b.row_stride = 92; }},
                 {"row_stride", [](B& b) { b.row_stride = 98; }},
                 {"row_stride", [](B& b) { b.row_stride = UINT64_MAX - 3; }},
                 {"row_stride", [](B& b) { b.format = NICOL_FORMAT_FLOAT16, b.row_stride = 49; }}});
    const auto read = [&](nicol_plane plane, std::uint32_t channel, std::uint64_t stride,
                          std::uint64_t size) {
        return nicol_framebuffer_read(stage.framebuffer, plane, channel,
                                      reinterpret_cast<float*>(pixels.data()), stride, size);
    };
    check_refused({
        {"byte_size", [&] { return read(NICOL_PLANE_S0, 0, 0, 24 * 16 * 4 - 1); }},
        {"row_stride", [&] { return read(NICOL_PLANE_S0, 0, 92, 6144); }},
        {"plane is 14", [&] { return read(14, 0, 0, 6144); }},
        {"NICOL_FORMAT_UINT32", [&] { return read(NICOL_PLANE_INSTANCE, 0, 0, 6144); }},
        {"channel", [&] { return read(NICOL_PLANE_S0, NICOL_ALL_CHANNELS, 0, 6144); }},
    });
    for (const std::uint32_t value : pixels) REQUIRE(value == 0xabcdef01);
    const Owned fresh(framebuffer_of(stage.context, 4, 4, 1));
    good.plane = NICOL_PLANE_DEPTH;
    REFUSES(nicol_framebuffer_read_plane(fresh, &good), "not there");
}

STAGE_TEST_CASE("observations out of range are refused, and no file is made") {
    stage.render();
    const TemporaryFolder folder;
    const std::string path = folder.file("image.png");
    check_wrong(
        nicol_observation NICOL_OBSERVATION_INIT,
        [&](const auto& image) {
            return nicol_framebuffer_write_png(stage.framebuffer, &image, path.c_str());
        },
        {{"kind", [](auto& p) { p.kind = 7; }},
         {"exposure", [](auto& p) { p.exposure = NAN; }},
         {"scale", [](auto& p) { p.kind = NICOL_OBSERVATION_S1, p.scale = -1; }},
         {"scale", [](auto& p) { p.kind = NICOL_OBSERVATION_S3, p.scale = NAN; }},
         {"angle", [](auto& p) { p.kind = NICOL_OBSERVATION_POLARIZER, p.polarizer_angle = INFINITY; }}});
    CHECK(folder.names().empty());
}
