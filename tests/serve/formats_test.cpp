// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "coding.hpp"
#include "message.hpp"
#include "metrics.hpp"
#include "planes.hpp"
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

TEST_CASE("planes hold every half, and s3 where there is one") {
    const std::uint32_t width = 5, height = 3, pixels = width * height;
    for (const std::size_t channels : {1u, 3u})
        for (const std::uint32_t components : {3u, 4u}) {
            std::vector<std::uint16_t> halves(channels * pixels * 4);
            for (std::size_t i = 0; i < halves.size(); ++i) {
                const std::uint16_t zero = i % 8 == 3 ? 0x8000 : 0;  // a negative zero also counts as zero
                halves[i] = i % 4 < components ? static_cast<std::uint16_t>(i * i * 7919) : zero;
            }
            const Planes planes = planes_of({reinterpret_cast<const char*>(halves.data()), halves.size() * 2},
                                            width, height, 0);
            REQUIRE(planes.components == components);
            REQUIRE(planes.bytes.size() == components * channels * pixels * 2);
            const auto* byte = reinterpret_cast<const unsigned char*>(planes.bytes.data());
            for (std::size_t s = 0; s < components; ++s)
                for (std::size_t c = 0; c < channels; ++c, byte += 2 * pixels)
                    for (std::size_t i = 0, value = 0; i < pixels; ++i) {
                        value = (i % width == 0 ? 0 : value) + byte[i] + 256u * byte[pixels + i];
                        CHECK(value % 65536 == halves[(c * pixels + i) * 4 + s]);
                    }
        }
}

TEST_CASE("rounded planes hold the nearest multiples of a part of s0") {
    const auto number = [](unsigned half) {
        const int exponent = static_cast<int>(half >> 10u & 31u);
        const double magnitude =
            exponent == 0 ? std::ldexp(half & 1023u, -24) : std::ldexp(1024 + (half & 1023u), exponent - 25);
        return (half & 0x8000u) != 0 ? -magnitude : magnitude;
    };
    // All finite halves as s1 to s3, beside s0 values that are as large or larger.
    std::vector<std::uint16_t> halves;
    for (unsigned magnitude = 0; magnitude < 0x7c00; ++magnitude)
        for (const unsigned above : {0u, 1u << 10u, 5u << 10u, 11u << 10u, 12u << 10u})
            for (const unsigned value :
                 {std::min(magnitude + above, 0x7bffu), magnitude, magnitude | 0x8000u, 0u})
                halves.push_back(static_cast<std::uint16_t>(value));
    const std::size_t pixels = halves.size() / 4;
    for (const std::uint32_t bits : {1u, 6u, 10u}) {
        const Planes planes = planes_of({reinterpret_cast<const char*>(halves.data()), halves.size() * 2},
                                        static_cast<std::uint32_t>(pixels), 1, bits);
        const auto* byte = reinterpret_cast<const unsigned char*>(planes.bytes.data());
        std::size_t wrong = 0;
        for (std::size_t s = 0; s < 3; ++s, byte += 2 * pixels)
            for (std::size_t i = 0, value = 0; i < pixels; ++i) {
                value = (value + byte[i] + 256u * byte[pixels + i]) % 65536;
                const double s0 = std::max(number(halves[4 * i]), 0x1p-14), given = number(halves[4 * i + s]);
                const double step = std::ldexp(1.0, std::ilogb(s0) - static_cast<int>(bits));
                // The smallest step of halves is 2^-24, and their largest value is 65504.
                const double least = std::max(step, 0x1p-24), found = number(static_cast<unsigned>(value));
                const bool beyond = std::abs(std::round(given / least) * least) > 65504;
                if (found != (beyond ? given : std::round(given / least) * least)) ++wrong;
            }
        CHECK(wrong == 0);
    }
}

TEST_CASE("a coding is taken where the client says so") {
    for (const char* header : {"deflate", "DEFLATE", "gzip, deflate, br", "gzip;q=1.0,deflate ; q=0.5", "*",
                               "gzip;q=0, *;q=0.1", "*;q=0, deflate"})
        CHECK_MESSAGE(accepts_coding(header, "deflate"), header);
    for (const char* header : {"", "gzip", "identity", "deflate;q=0", "deflate; q=0.000", "*;q=0",
                               "x-deflate", "deflate;q=0, *", ",,", ";"})
        CHECK_MESSAGE(!accepts_coding(header, "deflate"), header);
}

TEST_CASE("a hello arrives as it was said, or not at all") {
    const Hello hello{.renderer = "some OpenGL", .scenes = {"a", ""}};
    const std::string bytes = pack(hello);
    Hello read;
    REQUIRE(unpack(bytes, read));
    CHECK(read == hello);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const bool whole = unpack(std::string_view(bytes).substr(0, length), read);
        CHECK((!whole || read.scenes.size() < 2));
    }
}

TEST_CASE("a loaded scene arrives as it was said, or not at all") {
    const Loaded loaded{.info = {.id = "a",
                                 .digest = "b",
                                 .channels = 3,
                                 .width = 4,
                                 .height = 5,
                                 .up = 2,
                                 .fov = 6,
                                 .orbit = {.azimuth = 7, .elevation = 8, .distance = 9, .target = {1, 2, 3}}},
                        .reason = "c"};
    const std::string bytes = pack(loaded);
    Loaded read;
    REQUIRE(unpack(bytes, read));
    CHECK(read.info == loaded.info);
    CHECK(read.reason == "c");
    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK(!unpack(std::string_view(bytes).substr(0, length), read));
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
