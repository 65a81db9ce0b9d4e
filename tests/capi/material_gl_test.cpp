// SPDX-License-Identifier: MIT
// Tests of metals, measured and matrix materials, two-sided materials and callback materials.
#include <atomic>

#include "capi.hpp"
#include "material/material_projection.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"

using namespace capi_test;
using doctest::Approx;

namespace {

// Returns the planes of s0 of a square under a constant sky, 8 x 6 pixels, seen from the front or the back.
std::vector<std::vector<float>> planes_of(nicol_context context, nicol_material material, bool back = false,
                                          nicol_result wanted = NICOL_OK) {
    const Owned light(constant_light(context, {1}));
    const Owned mesh(rectangle(context));
    const Owned scene(simple_scene(context, light, mesh, material));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(scene, &channels));
    const Owned framebuffer(framebuffer_of(context, 8, 6, channels));
    const nicol_camera camera = camera_at({0.4, 0.3, back ? -1.2 : 1.2});
    const nicol_result result = nicol_render(scene, &camera, nullptr, framebuffer);
    CHECK(result == wanted);
    std::vector<std::vector<float>> out;
    for (std::uint32_t c = 0; c < channels && result == NICOL_OK; ++c)
        out.push_back(read_plane(framebuffer, NICOL_PLANE_S0, c));
    return out;
}

// Returns s0 of each channel at the middle of that square.
std::vector<float> middle_of(nicol_context context, nicol_material material, bool back = false,
                             nicol_result wanted = NICOL_OK) {
    std::vector<float> out;
    for (const std::vector<float>& plane : planes_of(context, material, back, wanted))
        out.push_back(plane[3 * 8 + 4]);
    return out;
}

bool same(const std::vector<float>& found, const std::vector<float>& wanted, double tolerance) {
    return std::ranges::equal(found, wanted,
                              [=](float a, float b) { return a == Approx(b).epsilon(tolerance); });
}

std::vector<float> conductor(nicol_context context, const nicol_conductor& parameters) {
    return middle_of(context, Owned(make(nicol_material_create_conductor, context, &parameters)));
}

// State of a Lambertian callback material.
struct Function {
    std::atomic<int> released = 0, calls = 0;
    std::atomic<bool> stop = false;
};

std::int32_t lambert(void* user, std::uint32_t channel, const double[3], const double[3],
                     double mueller[16]) {
    auto& f = *static_cast<Function*>(user);
    ++f.calls;
    std::fill_n(mueller, 16, 0.0);
    mueller[0] = 0.5 / pi * (channel + 1);
    return f.stop ? 0 : 1;
}

nicol_callback_material described(Function& function) {
    nicol_callback_material parameters = NICOL_CALLBACK_MATERIAL_INIT;
    parameters.mueller = lambert;
    parameters.user = &function;
    parameters.release = [](void* given) { ++static_cast<Function*>(given)->released; };
    return parameters;
}

}  // namespace

CONTEXT_TEST_CASE(
    "a metal by name is the metal by numbers, without an index a mirror, and smooth by default") {
    nicol_conductor gold = NICOL_CONDUCTOR_INIT;
    gold.alpha = 0.3F;
    gold.metal = "Au";
    const std::vector<float> named = conductor(context, gold);
    REQUIRE(named.size() == 3);
    CHECK(named[0] > 1.5F * named[2]);  // gold is yellow
    gold.metal = "gold";
    CHECK(conductor(context, gold) == named);
    gold.wavelengths = spectrum({600});
    CHECK(conductor(context, gold).size() == 1);

    // These are Mitsuba's values.
    nicol_conductor numbers = NICOL_CONDUCTOR_INIT;
    numbers.alpha = 0.3F;
    numbers.eta = spectrum({0.143F, 0.375F, 1.442F});
    numbers.k = spectrum({3.983F, 2.386F, 1.603F});
    numbers.metal = "";
    CHECK(same(conductor(context, numbers), named, 0.01));
    // Under constant light the direction of the brushing does not matter to a view along the normal.
    numbers.alpha_u = 0.6F;
    numbers.alpha_v = 0.15F;
    const std::vector<float> brushed = conductor(context, numbers);
    std::swap(numbers.alpha_u, numbers.alpha_v);
    CHECK(same(conductor(context, numbers), brushed, 0.05));
    CHECK(same(brushed, named, 0.1));
    CHECK_FALSE(same(brushed, named, 1e-3));

    nicol_conductor mirror = NICOL_CONDUCTOR_INIT;
    for (const float s0 : conductor(context, mirror)) CHECK(s0 == Approx(1).epsilon(0.01));
    mirror.specular_reflectance = spectrum({0.5F, 0.25F});
    mirror.distribution = NICOL_DISTRIBUTION_GGX;  // matters only for rough metals
    CHECK(same(conductor(context, mirror), {0.5F, 0.25F}, 0.01));
}

CONTEXT_TEST_CASE("a film makes colours on metal and plastic, and none if its thickness is 0") {
    nicol_conductor steel = NICOL_CONDUCTOR_INIT;
    steel.alpha = 0.3F;
    steel.metal = "Cr";
    const std::vector<float> bare = conductor(context, steel);
    steel.film.eta = 2.4F;
    CHECK(conductor(context, steel) == bare);
    steel.film.thickness = 50;
    const std::vector<float> coated = conductor(context, steel);
    REQUIRE(coated.size() == 3);
    CHECK_FALSE(same(coated, bare, 0.05));
    steel.film.k = 0.3F;
    CHECK(conductor(context, steel)[0] < coated[0]);
    steel.film.wavelengths = spectrum({550});
    steel.wavelengths = spectrum({550});
    CHECK(conductor(context, steel).size() == 1);

    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.film.thickness = 200;
    plastic.film.eta = 2.4F;
    const auto coloured = middle_of(context, Owned(make(nicol_material_create_pplastic, context, &plastic)));
    CHECK(coloured.size() == 3);

    nicol_material refused = nullptr;
    steel.film.thickness = -1;
    CHECK(nicol_material_create_conductor(context, &steel, &refused) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(std::string(nicol_last_error()).find("film_thickness") != std::string::npos);
}

CONTEXT_TEST_CASE("a texture varies the thickness of a film") {
    const auto even = [&](float factor) {
        const nicol_spectrum of_texture = spectrum({factor});
        return Owned(make(nicol_texture_create_checkerboard, context, &of_texture, &of_texture, nullptr));
    };
    nicol_conductor steel = NICOL_CONDUCTOR_INIT;
    steel.alpha = 0.3F;
    steel.metal = "Cr";
    steel.film.eta = 2.4F;
    steel.film.thickness = 130;
    const std::vector<float> wanted = conductor(context, steel);
    const Owned quarter = even(0.25F);
    steel.film_thickness_texture = quarter;
    steel.film_thickness_least = 90;
    steel.film.thickness = 250;
    CHECK(same(conductor(context, steel), wanted, 1e-4));

    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    const auto plastic_in_middle = [&] {
        return middle_of(context, Owned(make(nicol_material_create_pplastic, context, &plastic)));
    };
    plastic.film.eta = 2.4F;
    plastic.film.thickness = 50;
    const std::vector<float> thin = plastic_in_middle();
    plastic.film_thickness_texture = quarter;
    plastic.film.thickness = 200;
    CHECK(same(plastic_in_middle(), thin, 1e-4));

    nicol_material refused = nullptr;
    struct Film {
        float thickness, eta, nm;
    };
    const std::vector<Film> films{
        {NAN, 2.4F, 550}, {INFINITY, 2.4F, 550}, {10001, 2.4F, 550}, {90, INFINITY, 550}, {90, 2.4F, NAN}};
    for (const auto& [thickness, eta, nm] : films) {
        nicol_conductor wrong = steel;
        wrong.film = {
            .thickness = thickness, .eta = eta, .k = 0, .reserved = 0, .wavelengths = spectrum({nm})};
        CHECK(nicol_material_create_conductor(context, &wrong, &refused) == NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(std::string(nicol_last_error()).find("film") != std::string::npos);
    }
    steel.film_thickness_least = -1;
    CHECK(nicol_material_create_conductor(context, &steel, &refused) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(std::string(nicol_last_error()).find("least film_thickness") != std::string::npos);
    const Owned colors(make(nicol_texture_create_vertex_colors, context));
    plastic.film_thickness_texture = colors;
    CHECK(nicol_material_create_pplastic(context, &plastic, &refused) == NICOL_ERROR_UNSUPPORTED);
}

CONTEXT_TEST_CASE("a film is at either half of its texture what a film of one thickness is") {
    nicol_conductor steel = NICOL_CONDUCTOR_INIT;
    steel.alpha = 0.3F;
    steel.metal = "Cr";
    steel.film.eta = 2.4F;
    const auto planes = [&] {
        return planes_of(context, Owned(make(nicol_material_create_conductor, context, &steel)));
    };
    steel.film.thickness = 90;
    const auto thin = planes();
    steel.film.thickness = 250;
    const auto thick = planes();
    const std::vector<float> ramp{0, 0, 0, 0.25F, 0.75F, 1, 1, 1};
    nicol_texture_image image = NICOL_TEXTURE_IMAGE_INIT;
    image.type = NICOL_TEXEL_FLOAT32;
    image.width = 8;
    image.height = 1;
    image.channels = 1;
    image.pixels = ramp.data();
    image.byte_size = ramp.size() * sizeof(float);
    nicol_texture_options options = NICOL_TEXTURE_OPTIONS_INIT;
    options.filter = NICOL_TEXTURE_FILTER_NEAREST;
    const Owned texture(make(nicol_texture_create_image, context, &image, &options));
    steel.film_thickness_texture = texture;
    steel.film_thickness_least = 90;
    const auto both = planes();
    REQUIRE(both.size() == 3);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t row = 1; row < 5; ++row) {
            CHECK(both[c][row * 8 + 1] == Approx(thin[c][row * 8 + 1]).epsilon(1e-3));
            CHECK(both[c][row * 8 + 6] == Approx(thick[c][row * 8 + 6]).epsilon(1e-3));
            CHECK(std::abs(thin[c][row * 8 + 1] - thick[c][row * 8 + 1]) > 0.01F * thin[c][row * 8 + 1]);
        }
}

CONTEXT_TEST_CASE("plastic: a base under a boundary, smooth by default, coloured deeper if nonlinear") {
    const auto plastic = [&](const nicol_plastic& parameters) {
        return middle_of(context, Owned(make(nicol_material_create_plastic, context, &parameters)));
    };
    // White plastic returns all incident constant light.
    nicol_plastic white = NICOL_PLASTIC_INIT;
    white.diffuse_reflectance = spectrum({1});
    CHECK(same(plastic(white), {1}, 0.01));
    nicol_plastic linear = NICOL_PLASTIC_INIT;
    linear.diffuse_reflectance = spectrum({0.2F, 0.9F});
    linear.specular_reflectance = spectrum({0});
    nicol_plastic deeper = linear;
    deeper.nonlinear = 1;
    const std::vector<float> plain = plastic(linear), deep = plastic(deeper);
    REQUIRE(deep.size() == 2);
    // Nonlinear colour is r (1 - f) / (1 - r f), with f the internal diffuse reflectance of the boundary.
    constexpr float f = 0.591F;
    CHECK(deep[0] == Approx(plain[0] * (1 - f) / (1 - 0.2F * f)).epsilon(0.01));
    CHECK(deep[1] == Approx(plain[1] * (1 - f) / (1 - 0.9F * f)).epsilon(0.01));
}

CONTEXT_TEST_CASE("glass: a pane that transmits a part, and a body that absorbs by its thickness") {
    const auto glass = [&](const nicol_dielectric& parameters) {
        return middle_of(context, Owned(make(nicol_material_create_dielectric, context, &parameters)));
    };
    nicol_dielectric pane = NICOL_DIELECTRIC_INIT;
    pane.thin = 1;
    CHECK(same(glass(pane), {1}, 1e-3));
    pane.int_ior = 1.5F;
    pane.ext_ior = 1;
    pane.specular_transmittance = spectrum({0.25F, 0.5F});
    // The view is 22.6 degrees from the normal, where the pane reflects 0.078 of unpolarized light.
    CHECK(same(glass(pane), {0.078F + 0.25F * 0.922F, 0.078F + 0.5F * 0.922F}, 2e-3));

    // The rectangle bounds a body without an end.
    nicol_dielectric body = NICOL_DIELECTRIC_INIT;
    body.int_ior = body.ext_ior = 1;
    CHECK(same(glass(body), {1}, 1e-3));
    body.absorption = spectrum({0, 1});
    CHECK(same(glass(body), {1, 0}, 1e-3));
}

TEST_CASE("a measured material has the channels asked for") {
    const TemporaryFolder folder;
    const std::string path = folder.file("grey.pbsdf"), text = folder.write("text.pbsdf", "no table");
    // A Lambertian table whose reflectance is the wavelength / 1000 nm.
    const auto angles = nicol::test::even_angles(9, 0, pi / 2);
    write_bytes(path,
                nicol::test::make_pbsdf(nicol::test::even_angles(5, -pi, pi), angles, angles, {500, 600},
                                        [](std::size_t w, const glm::dvec3&, const glm::dvec3&) {
                                            nicol::Mueller m;
                                            m(0, 0) = (w == 0 ? 0.5 : 0.6) / pi;
                                            return m;
                                        })
                    .bytes());
    on_every_backend([&](nicol_context context) {
        const auto middle = [&](const nicol_measured* options) {
            return middle_of(context,
                             Owned(make(nicol_material_load_measured, context, path.c_str(), options)));
        };
        const std::vector<float> rgb = middle(nullptr);
        REQUIRE(rgb.size() == 3);
        CHECK(rgb[0] > rgb[2]);
        nicol_measured options = NICOL_MEASURED_INIT;
        CHECK(middle(&options) == rgb);
        options.wavelengths = spectrum({520, 700});
        CHECK(same(middle(&options), {0.52F, 0.6F}, 0.02));
        options.sampling = NICOL_WAVELENGTH_NEAREST;
        CHECK(same(middle(&options), {0.5F, 0.6F}, 0.02));

        nicol_material material = marker<nicol_material>();
        const auto load = [&](const std::string& file, const nicol_measured* given = nullptr) {
            return nicol_material_load_measured(context, file.c_str(), given, &material);
        };
        check_wrong(options, [&](const nicol_measured& given) { return load(path, &given); },
                    {{"sampling", [](auto& o) { o.sampling = 2; }},
                     {"wavelength", [](auto& o) { o.wavelengths = spectrum({1e9F}); }},
                     {"symmetrize", [](auto& o) { o.symmetrize = 2; }}});
        FAILS(load(folder.file("absent.pbsdf")), NICOL_ERROR_FILE_NOT_FOUND, "absent.pbsdf");
        FAILS(load(text), NICOL_ERROR_INVALID_FILE, "text.pbsdf");
        CHECK(material == marker<nicol_material>());
    });
}

TEST_CASE("a material by its coefficients") {
    const TemporaryFolder folder;
    const std::string path = folder.file("lambert.npz"), text = folder.write("text.npz", "no archive");
    const nicol::IsotropicMatrix matrix = nicol::project_material(*nicol::diffuse({0.4}), 0, 6);
    nicol::write_psh_matrix(path, std::vector{matrix, matrix});
    on_every_backend([&](nicol_context context) {
        const auto middle = [&](const nicol_psh_matrix* options) {
            return middle_of(context, Owned(make(nicol_material_load_psh, context, path.c_str(), options)));
        };
        const std::vector<float> plain = middle(nullptr);
        CHECK(same(plain, {0.4F, 0.4F}, 0.1));  // truncation causes ringing
        nicol_psh_matrix options = NICOL_PSH_MATRIX_INIT;
        CHECK(middle(&options) == plain);
        options.scale = spectrum({0.5F, 2});
        CHECK(same(middle(&options), {0.5F * plain[0], 2 * plain[1]}, 1e-4));
        options.symmetrize = 1;
        CHECK(same(middle(&options), {0.5F * plain[0], 2 * plain[1]}, 1e-4));

        nicol_material material = marker<nicol_material>();
        const auto load = [&](const std::string& file, const nicol_psh_matrix* given = nullptr) {
            return nicol_material_load_psh(context, file.c_str(), given, &material);
        };
        check_wrong(options, [&](const nicol_psh_matrix& given) { return load(path, &given); },
                    {{"scale", [](auto& o) { o.scale = spectrum({-1}); }},
                     {"scale",
                      [](auto& o) {
                          o.scale = spectrum({1, 2, 3});
                      }},
                     {"symmetrize", [](auto& o) { o.symmetrize = 2; }}});
        FAILS(load(text), NICOL_ERROR_INVALID_FILE, "text.npz");
        CHECK(material == marker<nicol_material>());
    });
}

CONTEXT_TEST_CASE("a function of the caller's serves as a material until nothing needs it") {
    Function function;
    nicol_callback_material parameters = described(function);
    parameters.channels = 2;
    const nicol_material material = make(nicol_material_create_callback, context, &parameters);
    CHECK(function.calls > 0);
    const nicol_material both = make(nicol_material_create_twosided, context, material);
    CHECK(same(middle_of(context, material), {0.5F, 1}, 1e-3));
    CHECK(middle_of(context, material, true) == std::vector<float>{0, 0});
    OK(nicol_material_release(material));
    CHECK(function.released == 0);
    CHECK(middle_of(context, both, true)[0] == Approx(0.5).epsilon(1e-3));
    CHECK(function.released == 0);
    // A callback that returns 0 stops the render.
    function.stop = true;
    static_cast<void>(middle_of(context, both, false, NICOL_ERROR_CANCELLED));
    CHECK(std::string(nicol_last_error()).find("callback") != std::string::npos);
    OK(nicol_material_release(both));
    CHECK(function.released == 1);
}

CONTEXT_TEST_CASE("functions that are no material are refused and given back") {
    Function function;
    const auto create = [&](const nicol_callback_material& parameters) {
        function.released = 0;
        nicol_material material = marker<nicol_material>();
        const nicol_result result = nicol_material_create_callback(context, &parameters, &material);
        CHECK(material == marker<nicol_material>());
        CHECK(function.released == 1);
        return result;
    };
    using P = nicol_callback_material;
    check_wrong(described(function), create,
                {{"mueller", [](P& p) { p.mueller = nullptr; }},
                 {"channels", [](P& p) { p.channels = 17; }},
                 {"channels", [](P& p) { p.channels = 0; }},
                 {"lobe_width", [](P& p) { p.lobe_width = 0; }},
                 {"reserved", [](P& p) { p.reserved = 1; }},
                 {"lobe_width", [](P& p) { p.lobe_width = NAN; }},
                 {"lobe_width", [](P& p) { p.lobe_width = -1; }},
                 {"lobe_width", [](P& p) { p.lobe_width = 1.5F; }},
                 {"lobe_width", [](P& p) { p.lobe_width = 1e-6F; }},
                 {"finite", [](P& p) {
                      p.mueller = [](void*, std::uint32_t, const double*, const double*, double* m) {
                          std::fill_n(m, 16, static_cast<double>(NAN));
                          return std::int32_t{1};
                      };
                  }}});
    nicol_callback_material parameters = described(function);
    function.stop = true;
    FAILS(create(parameters), NICOL_ERROR_CANCELLED, "callback");
    function.stop = false;
    function.released = 0;
    CHECK(nicol_material_create_callback(context, &parameters, nullptr) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(function.released == 1);
    CHECK(nicol_material_create_callback(nullptr, &parameters, nullptr) != NICOL_OK);
    CHECK(function.released == 2);
    parameters.release = nullptr;
    CHECK(nicol_material_create_callback(context, &parameters, nullptr) == NICOL_ERROR_INVALID_ARGUMENT);
    // A struct of size 0 may not be read at all.
    parameters = described(function);
    parameters.struct_size = 0;
    CHECK(nicol_material_create_callback(context, &parameters, nullptr) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(function.released == 2);
}

STAGE_TEST_CASE("a function must not use its context, and is told so rather than left hanging") {
    struct Inside {
        const Stage* stage;
        std::atomic<int> refused = 0, other = 0;
    } inside{&stage};
    nicol_callback_material parameters = NICOL_CALLBACK_MATERIAL_INIT;
    parameters.user = &inside;
    parameters.mueller = [](void* user, std::uint32_t, const double*, const double*,
                            double* m) -> std::int32_t {
        auto& self = *static_cast<Inside*>(user);
        const nicol_result result =
            nicol_render(self.stage->scene, &self.stage->camera, nullptr, self.stage->framebuffer);
        ++(result == NICOL_ERROR_INVALID_ARGUMENT ? self.refused : self.other);
        return grey_function().mueller(nullptr, 0, nullptr, nullptr, m);
    };
    middle_of(stage.context, Owned(make(nicol_material_create_callback, stage.context, &parameters)));
    CHECK(inside.refused > 0);
    CHECK(inside.other == 0);
    stage.render();  // the context still works
}
