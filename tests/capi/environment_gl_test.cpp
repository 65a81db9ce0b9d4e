// SPDX-License-Identifier: MIT
// Light from files and coefficients, and what is known of it.
#include <cmath>

#include "capi.hpp"
#include "image/stokes_image.hpp"

using namespace capi_test;
using doctest::Approx;

namespace {

nicol_environment_info info_of(nicol_environment environment) {
    nicol_environment_info info = NICOL_ENVIRONMENT_INFO_INIT;
    OK(nicol_environment_get_info(environment, &info));
    return info;
}

std::vector<double> coefficients_of(nicol_environment environment, std::uint32_t order) {
    std::vector<double> out(std::size_t{info_of(environment).channels} * 4 * (order + 1) * (order + 1));
    OK(nicol_psh_project_environment(environment, order, out.data(), out.size()));
    return out;
}

nicol_environment make_sky(nicol_context context, float turbidity = 0, float albedo = 0) {
    nicol_sky sky = NICOL_SKY_INIT;
    sky.sun_direction[0] = 1;
    sky.sun_direction[1] = 0.7F;
    sky.turbidity = turbidity;
    sky.ground_albedo = albedo;
    nicol_environment environment = nullptr;
    OK(nicol_environment_create_sky(context, &sky, &environment));
    return environment;
}

// 8 x 5 pixels whose radiance is the wavelength / 100 nm.
std::string spectral_file(const TemporaryFolder& folder) {
    nicol::StokesImage image(8, 5, 4);
    image.wavelengths = {450, 500, 550, 600};
    for (int c = 0; c < 4; ++c)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 8; ++x)
                image.at(c, y, x)[0] =
                    static_cast<float>(image.wavelengths[static_cast<std::size_t>(c)] / 100);
    const std::string path = folder.file("spectral.exr");
    nicol::write_exr(path, image, {.components = 0});
    return path;
}

}  // namespace

TEST_CASE("what is known of light") {
    on_every_backend([](nicol_context context) {
        nicol_environment environment = make_sky(context);
        nicol_environment_info info = info_of(environment);
        CHECK(info.channels == 3);
        CHECK(info.polarized == 1);
        CHECK(info.circular == 0);
        CHECK(info.wavelength_count == 0);
        OK(nicol_environment_release(environment));
        const nicol_spectrum grey = spectrum({2});
        OK(nicol_environment_create_constant(context, &grey, &environment));
        info = info_of(environment);
        CHECK(info.channels == 1);
        CHECK(info.polarized == 0);
        OK(nicol_environment_release(environment));
    });
}

TEST_CASE("files are loaded at a scale and at wavelengths") {
    const TemporaryFolder folder;
    const std::string path = spectral_file(folder);
    on_every_backend([&](nicol_context context) {
        nicol_environment environment = nullptr;
        OK(nicol_environment_load(context, path.c_str(), nullptr, &environment));
        nicol_environment_info info = info_of(environment);
        CHECK(info.channels == 4);
        REQUIRE(info.wavelength_count == 4);
        CHECK(info.wavelengths[2] == 550);
        const std::vector<double> whole = coefficients_of(environment, 0);
        OK(nicol_environment_release(environment));

        nicol_environment_load_options options = NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT;
        options.scale = 3;
        options.wavelengths = spectrum({598, 460});
        OK(nicol_environment_load(context, path.c_str(), &options, &environment));
        info = info_of(environment);
        REQUIRE(info.wavelength_count == 2);
        CHECK(info.wavelengths[0] == 600);
        CHECK(info.wavelengths[1] == 450);
        const std::vector<double> chosen = coefficients_of(environment, 0);
        CHECK(chosen[0] == Approx(3 * whole[12]));
        CHECK(chosen[4] == Approx(3 * whole[0]));
        OK(nicol_environment_release(environment));

        environment = marker<nicol_environment>();
        const auto load = [&](const char* file) {
            return nicol_environment_load(context, file, &options, &environment);
        };
        options.wavelengths = spectrum({1000});
        FAILS(load(path.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "1000");
        options.wavelengths = spectrum({NAN});
        FAILS(load(path.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "wavelength");
        options.wavelengths.count = 17;
        FAILS(load(path.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "wavelengths.count");
        options.wavelengths.count = 0;
        for (const double bad : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
            options.scale = bad;
            FAILS(load(path.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "scale");
        }
        options.scale = 0;
        options.reserved = 1;
        FAILS(load(path.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "reserved");
        options.reserved = 0;
        options.wavelengths = spectrum({500});
        const std::string plain = folder.file("plain.exr");
        nicol::write_exr(plain, nicol::StokesImage(4, 3, 3));
        FAILS(load(plain.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "wavelength");
        const std::string text = folder.write("text.npz", "no archive");
        FAILS(load(text.c_str()), NICOL_ERROR_INVALID_ARGUMENT, "wavelength");
        options.wavelengths.count = 0;
        FAILS(load(text.c_str()), NICOL_ERROR_INVALID_FILE, "text.npz");
        CHECK(environment == marker<nicol_environment>());
    });
}

TEST_CASE("light goes through its coefficients and back") {
    on_every_backend([](nicol_context context) {
        const Owned sky(make_sky(context));
        // The sky of single scattering has no order above 2.
        std::vector<double> low = coefficients_of(sky, 2);
        for (std::size_t i = 3; i < low.size(); i += 4) {
            CHECK(std::abs(low[i]) < 1e-12);
            low[i] = 0;
        }
        Owned<nicol_environment> light;
        OK(nicol_environment_create_psh(context, 2, 3, low.data(), low.size(), &light));
        const nicol_environment_info info = info_of(light);
        CHECK(info.channels == 3);
        CHECK(info.polarized == 1);
        CHECK(info.circular == 0);
        CHECK(coefficients_of(light, 2) == low);
        const std::vector<double> wanted = coefficients_of(sky, 5), found = coefficients_of(light, 5);
        for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(std::abs(found[i] - wanted[i]) < 1e-9);

        const Stage stage(context);
        OK(nicol_scene_set_environment(stage.scene, sky, nullptr, 0));
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        OK(nicol_scene_set_environment(stage.scene, light, nullptr, 0));
        stage.render();
        const std::vector<float> after = read_all(stage.framebuffer);
        for (std::size_t i = 0; i < before.size(); ++i) CHECK(std::abs(after[i] - before[i]) < 2e-3F);
    });
}

TEST_CASE("coefficients that are no light are refused by name") {
    on_every_backend([](nicol_context context) {
        nicol_environment environment = marker<nicol_environment>();
        std::vector<double> values(2 * 36, 0.0);
        values[0] = values[36] = 1;
        const auto create = [&](std::uint32_t order, std::uint32_t channels, const double* from,
                                std::uint64_t count) {
            return nicol_environment_create_psh(context, order, channels, from, count, &environment);
        };
        FAILS(create(2, 0, values.data(), 0), NICOL_ERROR_INVALID_ARGUMENT, "channels");
        FAILS(create(2, 17, values.data(), 72), NICOL_ERROR_INVALID_ARGUMENT, "channels");
        FAILS(create(4097, 2, values.data(), 72), NICOL_ERROR_INVALID_ARGUMENT, "order");
        FAILS(create(UINT32_MAX, 2, values.data(), 72), NICOL_ERROR_INVALID_ARGUMENT, "order");
        for (const std::uint64_t count : {std::uint64_t{0}, std::uint64_t{71}, UINT64_MAX})
            FAILS(create(2, 2, values.data(), count), NICOL_ERROR_INVALID_ARGUMENT, "coefficients");
        for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
            values[9] = bad;
            FAILS(create(2, 2, values.data(), 72), NICOL_ERROR_INVALID_ARGUMENT, "coefficients");
        }
        values[9] = 0.5;  // p = 1 of l = 1
        FAILS(create(2, 2, values.data(), 72), NICOL_ERROR_INVALID_ARGUMENT, "l = 2");
        values[9] = 0;
        CHECK(environment == marker<nicol_environment>());
        CHECK(nicol_environment_create_psh(context, 2, 2, values.data(), 72, nullptr) ==
              NICOL_ERROR_INVALID_ARGUMENT);
        OK(create(2, 2, values.data(), 72));
        OK(nicol_environment_release(environment));
    });
}

TEST_CASE("a hazy sky is brighter near the horizon, and its ground reflects") {
    on_every_backend([](nicol_context context) {
        // s0 of order 0 is 2 sqrt(pi) times the mean over the sphere.
        const auto mean = [&](float turbidity, float albedo) {
            const nicol_environment sky = make_sky(context, turbidity, albedo);
            const double value = coefficients_of(sky, 0)[4] / (2 * std::sqrt(std::acos(-1.0)));
            OK(nicol_environment_release(sky));
            return value;
        };
        const double black = mean(3, -1);
        CHECK(black == Approx(0.5).epsilon(0.1));  // green, about the luminance, over one half
        CHECK(mean(3, 0) == Approx(mean(3, 0.2F)).epsilon(1e-6));
        CHECK(mean(3, 0.4F) - black == Approx(2 * (mean(3, 0.2F) - black)).epsilon(1e-3));
        CHECK(mean(3, 0.2F) > black);
        CHECK(mean(0, 0.4F) == Approx(mean(0, -1)));

        nicol_environment environment = marker<nicol_environment>();
        const auto refused = [&](float turbidity, float albedo, float y, const char* text) {
            nicol_sky sky = NICOL_SKY_INIT;
            sky.sun_direction[0] = 1;
            sky.sun_direction[1] = y;
            sky.turbidity = turbidity;
            sky.ground_albedo = albedo;
            FAILS(nicol_environment_create_sky(context, &sky, &environment), NICOL_ERROR_INVALID_ARGUMENT,
                  text);
        };
        for (const float bad : {1.0F, 11.0F, -1.0F, NAN}) refused(bad, 0, 1, "turbidity");
        for (const float bad : {1.5F, NAN}) refused(3, bad, 1, "ground_albedo");
        refused(3, 0, -0.5F, "sun_direction");
        CHECK(environment == marker<nicol_environment>());
    });
}
