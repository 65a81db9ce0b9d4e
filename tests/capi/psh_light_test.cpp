// SPDX-License-Identifier: MIT
// Images and files of light as coefficients, without a context.
#include "image/stokes_image.hpp"
#include "psh_sky.hpp"

using namespace capi_test;

TEST_CASE("psh: an image of one radiance has one coefficient") {
    const std::vector<float> pixels(16 * 9 * 2, 3.0F);
    const nicol_image image = image_of(pixels, 16, 9, 2, 1);
    Doubles f(2 * vector_size(4), -1);
    OK(nicol_psh_project_image(&image, 4, f.data(), f.size()));
    for (std::size_t i = 0; i < f.size(); ++i)
        CHECK(std::abs(f[i] - (i % vector_size(4) == 0 ? 3 * std::sqrt(4 * pi) : 0)) < 1e-5);
}

TEST_CASE("psh: light from above propagates downwards") {
    std::vector<float> pixels(32 * 17);
    std::fill_n(pixels.begin(), 32 * 3, 1.0F);  // rows around +y
    const nicol_image image = image_of(pixels, 32, 17, 1, 1);
    Doubles f(vector_size(12));
    OK(nicol_psh_project_image(&image, 12, f.data(), f.size()));
    CHECK(value(12, f.data(), {0, -1, 0})[0] > 0.5);
    CHECK(std::abs(value(12, f.data(), {0, 1, 0})[0]) < 0.2);
}

TEST_CASE("psh: an image of a polarized sky is that sky, in every channel") {
    const std::vector<float> pixels = sky_image(512, 257, 3);
    const nicol_image image = image_of(pixels, 512, 257, 3);
    for (const std::uint32_t order : {2U, 6U}) {
        Doubles f(3 * vector_size(order));
        OK(nicol_psh_project_image(&image, order, f.data(), f.size()));
        CHECK(difference_from_sky(order, f.data()) < 2e-4);
        for (std::size_t i = 0; i < vector_size(order); ++i) {
            CHECK(std::abs(f[vector_size(order) + i] - 2 * f[i]) < 1e-5);
            CHECK(std::abs(f[2 * vector_size(order) + i] - 3 * f[i]) < 1e-5);
        }
    }
}

TEST_CASE("psh: an image is released once, on success and on failure") {
    const std::vector<float> pixels(16, 1.0F);
    nicol_image image = image_of(pixels, 4, 4, 1, 1);
    int released = 0;
    image.release = [](void* user) { ++*static_cast<int*>(user); };
    image.release_user = &released;
    Doubles f(vector_size(1));
    OK(nicol_psh_project_image(&image, 1, f.data(), f.size()));
    CHECK(released == 1);
    FAILS(nicol_psh_project_image(&image, 1, f.data(), f.size() - 1), NICOL_ERROR_INVALID_ARGUMENT,
          "coefficients");
    CHECK(released == 2);
    image.channels = 0;
    FAILS(nicol_psh_project_image(&image, 1, f.data(), f.size()), NICOL_ERROR_INVALID_ARGUMENT, "channels");
    CHECK(released == 3);
}

TEST_CASE("psh: a file is the image in it") {
    const Folder folder;
    const std::vector<float> pixels = sky_image(32, 17, 3);
    nicol::StokesImage image(32, 17, 3);
    for (std::size_t i = 0; i < 32 * 17; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(4 * (3 * i + c)), 4,
                        image.data.begin() + static_cast<std::ptrdiff_t>(4 * (c * 32 * 17 + i)));
    const std::string path = folder.file("sky.exr");
    nicol::write_exr(path, image);

    std::uint32_t channels = 0;
    OK(nicol_psh_project_file(path.c_str(), 5, &channels, nullptr, 0));
    CHECK(channels == 3);
    Doubles of_file(3 * vector_size(5)), of_image(of_file.size());
    channels = 0;
    OK(nicol_psh_project_file(path.c_str(), 5, &channels, of_file.data(), of_file.size()));
    CHECK(channels == 3);
    OK(nicol_psh_project_file(path.c_str(), 5, nullptr, of_file.data(), of_file.size()));
    const nicol_image in_memory = image_of(pixels, 32, 17, 3);
    OK(nicol_psh_project_image(&in_memory, 5, of_image.data(), of_image.size()));
    CHECK(of_file == of_image);

    const Doubles before = of_file;
    FAILS(nicol_psh_project_file(path.c_str(), 4, &channels, of_file.data(), of_file.size()),
          NICOL_ERROR_INVALID_ARGUMENT, "coefficients");
    FAILS(nicol_psh_project_file(path.c_str(), 4, &channels, of_file.data(), 0), NICOL_ERROR_INVALID_ARGUMENT,
          "coefficients");
    FAILS(nicol_psh_project_file(path.c_str(), 5, &channels, nullptr, of_file.size()),
          NICOL_ERROR_INVALID_ARGUMENT, "coefficients is NULL");
    FAILS(nicol_psh_project_file(path.c_str(), 4097, &channels, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT,
          "order");
    FAILS(nicol_psh_project_file(nullptr, 5, &channels, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT, "path");
    FAILS(nicol_psh_project_file(folder.file("none.exr").c_str(), 5, &channels, nullptr, 0),
          NICOL_ERROR_FILE_NOT_FOUND, "none.exr");
    FAILS(nicol_psh_project_file(folder.write("bad.exr", "v/1").c_str(), 5, &channels, nullptr, 0),
          NICOL_ERROR_INVALID_FILE, "bad.exr");
    CHECK(of_file == before);
}
