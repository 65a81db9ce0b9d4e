// SPDX-License-Identifier: MIT
// Metals, measured and matrix materials, two sides, and functions of the caller's.
#include <atomic>
#include <cmath>
#include <numbers>

#include "capi.hpp"
#include "material/material_projection.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"

using namespace capi_test;
using doctest::Approx;

namespace {

constexpr double pi = std::numbers::pi;

// s0 of each channel in the middle of a square under a constant sky, seen from its front or its back.
std::vector<float> middle_of(nicol_context context, nicol_material material, bool back = false,
                             nicol_result wanted = NICOL_OK) {
    const Owned environment(constant_light(context, {1}));
    const Owned mesh(rectangle(context));
    const Owned scene(simple_scene(context, environment, mesh, material));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(scene, &channels));
    const Owned framebuffer(framebuffer_of(context, 8, 6, channels));
    nicol_camera camera = NICOL_CAMERA_INIT;
    const double origin[] = {0.4, 0.3, back ? -1.2 : 1.2}, target[] = {0, 0, 0}, up[] = {0, 1, 0};
    OK(nicol_camera_look_at(&camera, origin, target, up));
    const nicol_result result = nicol_render(scene, &camera, nullptr, framebuffer);
    CHECK(result == wanted);
    std::vector<float> out;
    for (std::uint32_t c = 0; c < channels && result == NICOL_OK; ++c)
        out.push_back(read_plane(framebuffer, NICOL_PLANE_S0, c)[3 * 8 + 4]);
    return out;
}

std::vector<float> conductor(nicol_context context, const nicol_conductor& parameters) {
    Owned<nicol_material> material;
    OK(nicol_material_create_conductor(context, &parameters, &material));
    return middle_of(context, material);
}

// Lambertian with a polarizing part, as a function.
struct Function {
    float reflectance = 0.5F;
    std::atomic<int> released = 0;
    std::atomic<int> calls = 0;
    std::atomic<bool> stop = false;
    nicol_context context = nullptr;
    nicol_result inside = NICOL_OK;
};

std::int32_t lambert(void* user, std::uint32_t channel, const double[3], const double[3],
                     double mueller[16]) {
    auto& f = *static_cast<Function*>(user);
    ++f.calls;
    for (int i = 0; i < 16; ++i) mueller[i] = 0;
    mueller[0] = static_cast<double>(f.reflectance) / pi * (channel + 1);
    return f.stop ? 0 : 1;
}

void release(void* user) {
    ++static_cast<Function*>(user)->released;
}

nicol_callback_material described(Function& function) {
    nicol_callback_material parameters = NICOL_CALLBACK_MATERIAL_INIT;
    parameters.mueller = lambert;
    parameters.user = &function;
    parameters.release = release;
    return parameters;
}

}  // namespace

TEST_CASE("a metal by name is the metal by numbers, without an index a mirror, and smooth by default") {
    on_every_backend([](nicol_context context) {
        nicol_conductor gold = NICOL_CONDUCTOR_INIT;
        gold.alpha = 0.3F;
        gold.metal = "Au";
        const std::vector<float> named = conductor(context, gold);
        REQUIRE(named.size() == 3);
        CHECK(named[0] > 1.5F * named[2]);  // gold is yellow
        gold.metal = "gold";
        CHECK(conductor(context, gold) == named);
        gold.wavelengths = spectrum({611.4F, 549.1F, 464.2F});
        const std::vector<float> chosen = conductor(context, gold);
        for (std::size_t i = 0; i < named.size(); ++i) CHECK(chosen[i] == Approx(named[i]).epsilon(1e-4));
        gold.wavelengths = spectrum({600});
        CHECK(conductor(context, gold).size() == 1);

        // Values of Johnson and Christy near 620, 549 and 464 nm.
        nicol_conductor numbers = NICOL_CONDUCTOR_INIT;
        numbers.alpha = 0.3F;
        numbers.eta = spectrum({0.21F, 0.43F, 1.38F});
        numbers.k = spectrum({3.27F, 2.46F, 1.91F});
        numbers.metal = "";
        const std::vector<float> given = conductor(context, numbers);
        for (std::size_t c = 0; c < 3; ++c) CHECK(given[c] == Approx(named[c]).epsilon(0.03));

        nicol_conductor mirror = NICOL_CONDUCTOR_INIT;
        for (const float s0 : conductor(context, mirror)) CHECK(s0 == Approx(1).epsilon(0.01));
        mirror.specular_reflectance = spectrum({0.5F, 0.25F});
        mirror.distribution = NICOL_DISTRIBUTION_GGX;  // of rough ones alone
        const std::vector<float> dimmed = conductor(context, mirror);
        REQUIRE(dimmed.size() == 2);
        CHECK(dimmed[0] == Approx(0.5).epsilon(0.01));
        CHECK(dimmed[1] == Approx(0.25).epsilon(0.01));
    });
}

TEST_CASE("a measured material has the channels asked for") {
    const TemporaryFolder folder;
    const std::string path = folder.file("grey.pbsdf");
    // Lambertian, its reflectance the wavelength / 1000 nm.
    write_bytes(path, nicol::test::make_pbsdf(nicol::test::even_angles(5, -pi, pi),
                                              nicol::test::even_angles(9, 0, pi / 2),
                                              nicol::test::even_angles(9, 0, pi / 2), {500, 600},
                                              [](std::size_t w, const glm::dvec3&, const glm::dvec3&) {
                                                  nicol::Mueller m;
                                                  m(0, 0) = (w == 0 ? 0.5 : 0.6) / pi;
                                                  return m;
                                              })
                          .bytes());
    on_every_backend([&](nicol_context context) {
        nicol_material material = nullptr;
        const auto middle = [&](const nicol_measured* options) {
            OK(nicol_material_load_measured(context, path.c_str(), options, &material));
            return middle_of(context, Owned(material));
        };
        const std::vector<float> rgb = middle(nullptr);
        REQUIRE(rgb.size() == 3);
        CHECK(rgb[0] > rgb[2]);
        nicol_measured options = NICOL_MEASURED_INIT;
        CHECK(middle(&options) == rgb);
        options.wavelengths = spectrum({520, 700});
        const std::vector<float> linear = middle(&options);
        REQUIRE(linear.size() == 2);
        CHECK(linear[0] == Approx(0.52).epsilon(0.02));
        CHECK(linear[1] == Approx(0.6).epsilon(0.02));
        options.sampling = NICOL_WAVELENGTH_NEAREST;
        CHECK(middle(&options)[0] == Approx(0.5).epsilon(0.02));

        material = marker<nicol_material>();
        const auto load = [&](const char* file, const nicol_measured* given) {
            return nicol_material_load_measured(context, file, given, &material);
        };
        options.sampling = 2;
        REFUSES(load(path.c_str(), &options), "sampling");
        options.sampling = 0;
        options.wavelengths = spectrum({1e9F});
        REFUSES(load(path.c_str(), &options), "wavelength");
        FAILS(load(folder.file("absent.pbsdf").c_str(), nullptr), NICOL_ERROR_FILE_NOT_FOUND, "absent.pbsdf");
        const std::string text = folder.write("text.pbsdf", "no table");
        FAILS(load(text.c_str(), nullptr), NICOL_ERROR_INVALID_FILE, "text.pbsdf");
        CHECK(material == marker<nicol_material>());
    });
}

TEST_CASE("a material by its coefficients") {
    const TemporaryFolder folder;
    const std::string path = folder.file("lambert.npz");
    const nicol::IsotropicMatrix matrix = nicol::project_material(*nicol::diffuse({0.4}), 0, 6);
    nicol::write_psh_matrix(path, std::vector{matrix, matrix});
    on_every_backend([&](nicol_context context) {
        nicol_material material = nullptr;
        OK(nicol_material_load_psh(context, path.c_str(), nullptr, &material));
        const std::vector<float> plain = middle_of(context, Owned(material));
        REQUIRE(plain.size() == 2);
        CHECK(plain[0] == Approx(0.4).epsilon(0.1));  // truncated, so it rings
        const nicol_spectrum scale = spectrum({0.5F, 2});
        OK(nicol_material_load_psh(context, path.c_str(), &scale, &material));
        const std::vector<float> scaled = middle_of(context, Owned(material));
        CHECK(scaled[0] == Approx(0.5 * plain[0]).epsilon(1e-4));
        CHECK(scaled[1] == Approx(2 * plain[1]).epsilon(1e-4));

        material = marker<nicol_material>();
        nicol_spectrum bad = spectrum({-1});
        REFUSES(nicol_material_load_psh(context, path.c_str(), &bad, &material), "scale");
        bad = spectrum({1, 2, 3});
        REFUSES(nicol_material_load_psh(context, path.c_str(), &bad, &material), "scale");
        const std::string text = folder.write("text.npz", "no archive");
        FAILS(nicol_material_load_psh(context, text.c_str(), nullptr, &material), NICOL_ERROR_INVALID_FILE,
              "text.npz");
        CHECK(material == marker<nicol_material>());
    });
}

TEST_CASE("two-sided materials have a back") {
    on_every_backend([](nicol_context context) {
        const nicol_material front = diffuse(context, {0.5F});
        Owned<nicol_material> both;
        OK(nicol_material_create_twosided(context, front, &both));
        CHECK(middle_of(context, front, true)[0] == 0);
        CHECK(middle_of(context, front)[0] == Approx(0.5).epsilon(1e-3));
        OK(nicol_material_release(front));
        CHECK(middle_of(context, both, true)[0] == Approx(0.5).epsilon(1e-3));
        CHECK(middle_of(context, both)[0] == Approx(0.5).epsilon(1e-3));
        nicol_material out = marker<nicol_material>();
        FAILS(nicol_material_create_twosided(context, front, &out), NICOL_ERROR_INVALID_HANDLE, "released");
        const nicol_context other = make_context(NICOL_BACKEND_OSMESA);
        FAILS(nicol_material_create_twosided(other, both, &out), NICOL_ERROR_INVALID_HANDLE, "different");
        OK(nicol_context_release(other));
        CHECK(out == marker<nicol_material>());
    });
}

TEST_CASE("a function of the caller's serves as a material until nothing needs it") {
    on_every_backend([](nicol_context context) {
        Function function;
        nicol_callback_material parameters = described(function);
        parameters.channels = 2;
        nicol_material material = nullptr;
        OK(nicol_material_create_callback(context, &parameters, &material));
        CHECK(function.calls > 0);
        nicol_material both = nullptr;
        OK(nicol_material_create_twosided(context, material, &both));
        const std::vector<float> middle = middle_of(context, material);
        REQUIRE(middle.size() == 2);
        CHECK(middle[0] == Approx(0.5).epsilon(1e-3));
        CHECK(middle[1] == Approx(1.0).epsilon(1e-3));
        OK(nicol_material_release(material));
        CHECK(function.released == 0);
        CHECK(middle_of(context, both, true)[0] == Approx(0.5).epsilon(1e-3));
        CHECK(function.released == 0);
        // A render that needs the function is stopped by it.
        function.stop = true;
        static_cast<void>(middle_of(context, both, false, NICOL_ERROR_CANCELLED));
        CHECK(std::string(nicol_last_error()).find("callback") != std::string::npos);
        OK(nicol_material_release(both));
        CHECK(function.released == 1);
    });
}

TEST_CASE("functions that are no material are refused and given back") {
    on_every_backend([](nicol_context context) {
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
        check_wrong(
            described(function), create,
            {{"mueller", [](P& p) { p.mueller = nullptr; }},
             {"channels", [](P& p) { p.channels = 17; }},
             {"reserved", [](P& p) { p.reserved = 1; }},
             {"lobe_width", [](P& p) { p.lobe_width = NAN; }},
             {"lobe_width", [](P& p) { p.lobe_width = -1; }},
             {"lobe_width", [](P& p) { p.lobe_width = 1.5F; }},
             {"lobe_width", [](P& p) { p.lobe_width = 1e-6F; }},
             {"isotropic",
              [](P& p) {
                  p.mueller = [](void*, std::uint32_t, const double light[3], const double[3], double m[16]) {
                      std::fill_n(m, 16, 0.0);
                      m[0] = 1 + light[0];
                      return std::int32_t{1};
                  };
              }},
             {"finite", [](P& p) {
                  p.mueller = [](void*, std::uint32_t, const double[3], const double[3], double m[16]) {
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
        // Nothing can be said of a struct of no size.
        parameters = described(function);
        parameters.struct_size = 0;
        CHECK(nicol_material_create_callback(context, &parameters, nullptr) == NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(function.released == 2);
    });
}

TEST_CASE("a function must not use its context, and is told so rather than left hanging") {
    on_every_stage([](const Stage& stage) {
        struct Inside {
            const Stage* stage;
            std::atomic<int> refused = 0, other = 0;
        } inside{&stage};
        nicol_callback_material parameters = NICOL_CALLBACK_MATERIAL_INIT;
        parameters.user = &inside;
        parameters.mueller = [](void* user, std::uint32_t, const double[3], const double[3],
                                double m[16]) -> std::int32_t {
            auto& self = *static_cast<Inside*>(user);
            const nicol_result result =
                nicol_render(self.stage->scene, &self.stage->camera, nullptr, self.stage->framebuffer);
            ++(result == NICOL_ERROR_INVALID_ARGUMENT ? self.refused : self.other);
            for (int i = 0; i < 16; ++i) m[i] = 0;
            m[0] = 0.1;
            return 1;
        };
        nicol_material material = nullptr;
        OK(nicol_material_create_callback(stage.context, &parameters, &material));
        static_cast<void>(middle_of(stage.context, Owned(material)));
        CHECK(inside.refused > 0);
        CHECK(inside.other == 0);
        stage.render();  // and the context is as before
    });
}
