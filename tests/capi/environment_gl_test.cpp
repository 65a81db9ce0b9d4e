// SPDX-License-Identifier: MIT
// Tests of environments from memory, files and coefficients, and of the information about them.
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

// A 4 x 3 image of three channels whose rows lie `stride` floats apart.
struct Pixels {
    std::vector<float> values;
    nicol_image image;
    int released = 0;

    explicit Pixels(std::uint32_t components = 1, std::size_t stride = 0) {
        const std::size_t row = std::size_t{4} * 3 * components;
        if (stride == 0) stride = row;
        // The gaps between the rows hold NaN, because they must not be read.
        values.assign(stride * 2 + row, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t y = 0; y < 3; ++y)
            for (std::size_t i = 0; i < row; ++i)
                values[y * stride + i] =
                    i % components == 0 ? 1 + 0.1F * static_cast<float>(y * row + i) : 0.2F;
        image = image_of(values, 4, 3, 3, components);
        image.row_stride = stride == row ? 0 : stride * sizeof(float);
        image.release = [](void* user) { ++*static_cast<int*>(user); };
        image.release_user = &released;
    }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;
};

}  // namespace

CONTEXT_TEST_CASE("rows of an image may lie apart, and what lies between them is not read") {
    for (const std::uint32_t components : {1U, 4U}) {
        Pixels tight(components), loose(components, std::size_t{4} * 3 * components + 5);
        const Owned a(make(nicol_environment_create_image, context, &tight.image)),
            b(make(nicol_environment_create_image, context, &loose.image));
        CHECK((tight.released == 1 && loose.released == 1));
        // Overwrites the pixels, because the environments no longer need them.
        for (Pixels* pixels : {&tight, &loose}) pixels->values.assign(pixels->values.size(), 0);
        const std::vector<double> light = coefficients_of(a, 2);
        CHECK(light == coefficients_of(b, 2));
        CHECK(light[0] > 0);
        CHECK(info_of(a).polarized == (components == 4 ? 1 : 0));
    }
    Pixels quiet;
    quiet.image.release = nullptr;
    const Owned environment(make(nicol_environment_create_image, context, &quiet.image));
}

CONTEXT_TEST_CASE("an image that cannot be taken is given back") {
    Pixels pixels;
    nicol_environment environment = marker<nicol_environment>();
    const auto create = [&](const nicol_image& image) {
        pixels.released = 0;
        const nicol_result result = nicol_environment_create_image(context, &image, &environment);
        CHECK(environment == marker<nicol_environment>());
        CHECK(pixels.released == 1);
        return result;
    };
    using I = nicol_image;
    check_wrong(pixels.image, create,
                {{"byte_size", [](I& i) { i.byte_size -= 1; }},
                 {"byte_size", [](I& i) { i.byte_size = 0; }},
                 {"row_stride", [](I& i) { i.row_stride = 44; }},
                 {"row_stride", [](I& i) { i.row_stride = 50; }},
                 {"byte_size", [](I& i) { i.row_stride = 96; }},
                 {"row_stride", [](I& i) { i.row_stride = UINT64_MAX - 3; }},
                 {"row_stride", [](I& i) { i.row_stride = std::uint64_t{1} << 63; }},
                 {"width", [](I& i) { i.width = 0; }},
                 {"1 x 3 pixels; width and height must lie in 2 to", [](I& i) { i.width = 1; }},
                 {"width", [](I& i) { i.width = NICOL_MAX_SIZE + 1; }},
                 {"height", [](I& i) { i.height = 1; }},
                 {"height", [](I& i) { i.height = UINT32_MAX; }},
                 {"channels", [](I& i) { i.channels = 0; }},
                 {"channels", [](I& i) { i.channels = NICOL_MAX_CHANNELS + 1; }},
                 {"components", [](I& i) { i.components = 0; }},
                 {"components", [](I& i) { i.components = 3; }},
                 {"pixels", [](I& i) { i.pixels = nullptr; }},
                 // The image exceeds every limit, and the caller claims to have the memory.
                 {"16384", [](I& i) {
                      i.width = i.height = NICOL_MAX_SIZE;
                      i.channels = NICOL_MAX_CHANNELS;
                      i.components = 4;
                      i.byte_size = UINT64_MAX;
                  }}});
    for (const float bad : {NAN, INFINITY, -300.0F}) {
        const float before = std::exchange(pixels.values[19], bad);  // a pixel with non-zero weight
        REFUSES(create(pixels.image), "");
        pixels.values[19] = before;
    }
    FAILS(nicol_environment_create_image(nullptr, &pixels.image, &environment), NICOL_ERROR_INVALID_HANDLE,
          "nicol_context");
    REFUSES(nicol_environment_create_image(context, &pixels.image, nullptr), "environment");
    CHECK(pixels.released == 3);
    pixels.image.struct_size = 0;  // such a struct may not be read at all
    REFUSES(nicol_environment_create_image(context, &pixels.image, nullptr), "");
    CHECK(pixels.released == 3);
}

CONTEXT_TEST_CASE("a sky has the defaults that its fields name, and 0 is none") {
    nicol_sky sky = NICOL_SKY_INIT;
    const auto light = [&] {
        return coefficients_of(Owned(make(nicol_environment_create_sky, context, &sky)), 2);
    };
    const std::vector<double> standard = light();
    sky.dop_max = 0.8F;
    sky.sun_direction[1] = 2;
    sky.radiance = spectrum({1, 1, 1});
    CHECK(largest_difference(standard, light()) < 1e-5);
    sky.dop_max = 0;
    std::vector<double> s0 = standard;
    for (std::size_t i = 0; i < s0.size(); ++i) s0[i] *= i % 4 == 0 ? 1 : 0;
    CHECK(largest_difference(light(), s0) < 1e-5);
    CHECK(largest_difference(standard, s0) > 0.1);

    // Tests the ground of a hazy sky. s0 of order 0 is 2 sqrt(pi) times the mean over the sphere.
    const auto mean = [&](float turbidity, float albedo) {
        sky.turbidity = turbidity;
        sky.ground_albedo = albedo;
        return light()[36] / (2 * std::sqrt(pi));  // the green channel
    };
    CHECK(nicol_sky NICOL_SKY_INIT.ground_albedo == 0.2F);
    CHECK(mean(3, 0.2F) > mean(3, 0));
    CHECK(mean(0, 0.4F) == Approx(mean(0, 0)));
}

TEST_CASE("files are loaded at a scale and at wavelengths") {
    const TemporaryFolder folder;
    nicol::StokesImage image(8, 5, 4);  // radiance in each channel is its wavelength / 100 nm
    image.wavelengths = {450, 500, 550, 600};
    for (std::size_t i = 0; i < image.data.size(); i += 4)
        image.data[i] = static_cast<float>(image.wavelengths[i / 160]) / 100;
    const std::string path = folder.file("spectral.exr"), plain = folder.file("plain.exr");
    const std::string text = folder.write("text.npz", "no archive");
    nicol::write_exr(path, image, {.components = 0});
    nicol::write_exr(plain, nicol::StokesImage(4, 3, 3));
    on_every_backend([&](nicol_context context) {
        Owned environment(make(nicol_environment_load, context, path.c_str(), nullptr));
        nicol_environment_info info = info_of(environment);
        CHECK((info.channels == 4 && info.polarized == 0 && info.circular == 0));
        REQUIRE(info.wavelength_count == 4);
        CHECK(info.wavelengths[2] == 550);
        const std::vector<double> whole = coefficients_of(environment, 0);

        nicol_environment_load_options options = NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT;
        options.scale = 3;
        options.wavelengths = spectrum({598, 460});
        OK(nicol_environment_load(context, path.c_str(), &options, &environment));
        info = info_of(environment);
        REQUIRE(info.wavelength_count == 2);
        CHECK((info.wavelengths[0] == 600 && info.wavelengths[1] == 450));
        const std::vector<double> chosen = coefficients_of(environment, 0);
        CHECK(chosen[0] == Approx(3 * whole[12]));
        CHECK(chosen[4] == Approx(3 * whole[0]));

        nicol_environment none = marker<nicol_environment>();
        const auto load = [&](const std::string& file) {
            return
                [&, file](const auto& o) { return nicol_environment_load(context, file.c_str(), &o, &none); };
        };
        check_wrong(options, load(path),
                    {{"1000", [](auto& o) { o.wavelengths = spectrum({1000}); }},
                     {"wavelength", [](auto& o) { o.wavelengths = spectrum({NAN}); }},
                     {"wavelengths.count", [](auto& o) { o.wavelengths.count = 17; }},
                     {"scale", [](auto& o) { o.scale = -1; }},
                     {"scale", [](auto& o) { o.scale = HUGE_VAL; }},
                     {"reserved", [](auto& o) { o.reserved = 1; }}});
        for (const std::string& file : {plain, text}) REFUSES(load(file)(options), "wavelength");
        options.wavelengths.count = 0;
        FAILS(load(text)(options), NICOL_ERROR_INVALID_FILE, "text.npz");
        CHECK(none == marker<nicol_environment>());
    });
}

CONTEXT_TEST_CASE("light goes through its coefficients and back") {
    const Owned sky(clear_sky(context, {1, 0.7F, 0}));
    // A sky of single scattering has no order above 2 and no circular polarization.
    std::vector<double> low = coefficients_of(sky, 2);
    for (std::size_t i = 3; i < low.size(); i += 4) CHECK(std::abs(std::exchange(low[i], 0)) < 1e-12);
    const Owned light(make(nicol_environment_create_psh, context, 2U, 3U, low.data(), low.size()));
    for (const nicol_environment_info& info : {info_of(sky), info_of(light)}) {
        CHECK((info.channels == 3 && info.polarized == 1 && info.circular == 0));
        CHECK(info.wavelength_count == 0);
    }
    CHECK(coefficients_of(light, 2) == low);
}
