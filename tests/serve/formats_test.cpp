// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <png.h>

#include "message.hpp"
#include "metrics.hpp"
#include "png.hpp"

TEST_CASE("PNG reads back as it was") {
    const std::uint32_t width = 37, height = 11;
    std::vector<std::uint8_t> rgb(width * height * 3);
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>(i * i / 7);
    for (const bool srgb : {false, true}) {
        const std::string file = encode_png(width, height, rgb, srgb);
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
        CHECK(image.width == width);
        CHECK(image.height == height);
        image.format = PNG_FORMAT_RGB;
        std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
        REQUIRE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr) != 0);
        CHECK(read == rgb);
        CHECK((file.find("sRGB") != std::string::npos) == srgb);
    }
}

TEST_CASE("a hello arrives as it was said, or not at all") {
    Hello hello;
    hello.renderer = "some OpenGL";
    hello.scenes.resize(2);
    hello.scenes[1] = {.id = "a",
                       .digest = "b",
                       .channels = 3,
                       .width = 4,
                       .height = 5,
                       .up = 2,
                       .fov = 6,
                       .orbit = {.azimuth = 7, .elevation = 8, .distance = 9, .target = {1, 2, 3}}};
    const std::string bytes = pack(hello);
    Hello read;
    REQUIRE(unpack(bytes, read));
    CHECK(read == hello);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const bool whole = unpack(std::string_view(bytes).substr(0, length), read);
        CHECK((!whole || read.scenes.size() < 2));
    }
}

TEST_CASE("a histogram counts up to each bound") {
    Histogram histogram;
    CHECK(histogram.mean() == 0);
    for (const double seconds : {0.0004, 0.001, 0.003, 100.0}) histogram.add(seconds);
    const std::string text = histogram.text("x", "a=\"b\"");
    CHECK(text.find("nicol_serve_x_bucket{a=\"b\",le=\"0.0005\"} 1\n") != std::string::npos);
    CHECK(text.find("nicol_serve_x_bucket{a=\"b\",le=\"0.001\"} 2\n") != std::string::npos);
    CHECK(text.find("nicol_serve_x_bucket{a=\"b\",le=\"10\"} 3\n") != std::string::npos);
    CHECK(text.find("nicol_serve_x_bucket{a=\"b\",le=\"+Inf\"} 4\n") != std::string::npos);
    CHECK(text.find("nicol_serve_x_count{a=\"b\"} 4\n") != std::string::npos);
    CHECK(histogram.mean() == doctest::Approx(25.0011));
}
