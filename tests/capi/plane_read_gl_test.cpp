// SPDX-License-Identifier: MIT
// Tests of reading planes in every format, with strides, and all channels at once.
#include "planes.hpp"

using namespace capi_test;

namespace {

// Returns the value of half-precision bits by the definition of IEEE 754.
double half_value(std::uint32_t bits) {
    const auto exponent = static_cast<int>(bits >> 10 & 31);
    const double fraction = (bits & 1023) / 1024.0;
    const double size = exponent == 31  ? std::numeric_limits<double>::infinity()
                        : exponent == 0 ? std::ldexp(fraction, -14)
                                        : std::ldexp(1 + fraction, exponent - 15);
    return (bits & 0x8000) != 0 ? -size : size;
}

std::uint16_t nearest_half(float value) {
    const double size = std::abs(static_cast<double>(value));
    std::uint32_t below = 0, above = 0x7c00;  // magnitudes, which grow with their bits
    while (above - below > 1) {
        const std::uint32_t middle = (below + above) / 2;
        (half_value(middle) <= size ? below : above) = middle;
    }
    // Rounding treats infinity as the next power of two.
    const double next = above == 0x7c00 ? 65536 : half_value(above);
    const double down = size - half_value(below), up = next - size;
    const std::uint32_t bits = down < up || (down == up && below % 2 == 0) ? below : above;
    return static_cast<std::uint16_t>(bits | (std::signbit(value) ? 0x8000 : 0));
}

nicol_plane_buffer buffer(nicol_plane plane, nicol_format format, std::uint32_t channel, void* pixels,
                          std::uint64_t bytes) {
    nicol_plane_buffer to = NICOL_PLANE_BUFFER_INIT;
    to.plane = plane;
    to.format = format;
    to.channel = channel;
    to.pixels = pixels;
    to.byte_size = bytes;
    return to;
}

std::size_t components_of(nicol_plane plane) {
    if (plane == NICOL_PLANE_STOKES || plane == NICOL_PLANE_VARIANCE) return 4;
    return plane == NICOL_PLANE_NORMAL || plane == NICOL_PLANE_POSITION ? 3 : 1;
}

// Renders an image of directly visible light with magnitudes that half precision rounds, overflows and
// underflows.
nicol_framebuffer image_of_magnitudes(nicol_context context) {
    std::vector<float> pixels;
    for (int i = 0; i < 64 * 33; ++i)
        for (const double base : {1.0, 65000.0, 6e-8})
            pixels.push_back(static_cast<float>(base * (1 + 0.0173 * (i % 61)) * (1 + 1e-4 * i)));
    const nicol_image image = image_of(pixels, 64, 33, 3, 1);
    const Owned light(make(nicol_environment_create_image, context, &image));
    const Owned scene(empty_scene(context));
    OK(nicol_scene_set_environment(scene, light, nullptr, 1));
    const nicol_framebuffer framebuffer = framebuffer_of(context, 60, 20, 3);
    const nicol_camera camera = front_camera();
    OK(nicol_render(scene, &camera, nullptr, framebuffer));
    return framebuffer;
}

}  // namespace

TEST_CASE("half precision is the nearest number, ties to even, infinite beyond its range") {
    for (const auto& [value, half] : {std::pair(1.0F, 0x3c00),
                                      {-2, 0xc000},
                                      {65504, 0x7bff},
                                      {65519, 0x7bff},
                                      {65520, 0x7c00},
                                      {1 + 1.0F / 2048, 0x3c00},
                                      {1 + 3.0F / 2048, 0x3c02}})
        CHECK(nearest_half(value) == half);
    on_every_backend([](nicol_context context) {
        const Owned framebuffer(image_of_magnitudes(context));
        std::set<bool> infinite, small;
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::vector<float> single = read_plane(framebuffer, NICOL_PLANE_STOKES, c);
            std::vector<std::uint16_t> half(single.size());
            const nicol_plane_buffer to =
                buffer(NICOL_PLANE_STOKES, NICOL_FORMAT_FLOAT16, c, half.data(), 2 * half.size());
            OK(nicol_framebuffer_read_plane(framebuffer, &to));
            for (std::size_t i = 0; i < half.size(); ++i) {
                CHECK(half[i] == nearest_half(single[i]));
                infinite.insert(half[i] == 0x7c00);
                small.insert(half[i] > 0 && half[i] < 0x400);
            }
        }
        std::vector<float> single(std::size_t{60} * 20 * 3 * 4);
        std::vector<std::uint16_t> half(single.size());
        nicol_plane_buffer to = buffer(NICOL_PLANE_STOKES, NICOL_FORMAT_FLOAT32, NICOL_ALL_CHANNELS,
                                       single.data(), 4 * single.size());
        OK(nicol_framebuffer_read_plane(framebuffer, &to));
        to = buffer(NICOL_PLANE_STOKES, NICOL_FORMAT_FLOAT16, NICOL_ALL_CHANNELS, half.data(),
                    2 * half.size());
        OK(nicol_framebuffer_read_plane(framebuffer, &to));
        for (std::size_t i = 0; i < half.size(); ++i) CHECK(half[i] == nearest_half(single[i]));
        CHECK(infinite.size() == 2);
        CHECK(small.size() == 2);
    });
}

STAGE_TEST_CASE("all channels are interleaved, in both formats, with and without a stride") {
    OK(stage.try_render(with_variance()));
    for (const nicol_plane plane :
         {NICOL_PLANE_S0, NICOL_PLANE_S1, NICOL_PLANE_S2, NICOL_PLANE_S3, NICOL_PLANE_STOKES,
          NICOL_PLANE_DOLP, NICOL_PLANE_AOLP, NICOL_PLANE_VARIANCE}) {
        CAPTURE(plane);
        const std::size_t n = components_of(plane), row = 24 * 3 * n;
        std::vector<float> channels[3];
        for (std::uint32_t c = 0; c < 3; ++c) channels[c] = read_plane(stage.framebuffer, plane, c);
        const std::size_t loose_row = 24 * n + 3;
        std::vector<float> loose(loose_row * 16 - 3, -7.5F);  // the last row needs no padding
        OK(nicol_framebuffer_read(stage.framebuffer, plane, 1, loose.data(), 4 * loose_row,
                                  4 * loose.size()));
        for (std::size_t i = 0; i < loose.size(); ++i) {
            const std::size_t y = i / loose_row, x = i % loose_row;
            CHECK(loose[i] == (x < 24 * n ? channels[1][y * 24 * n + x] : -7.5F));
        }
        for (const std::size_t stride : {std::size_t{0}, row, row + 5}) {
            const std::size_t step = stride == 0 ? row : stride;
            std::vector<float> single(step * 15 + row, -7.5F);
            std::vector<std::uint16_t> half(single.size(), 0x1234);
            nicol_plane_buffer to =
                buffer(plane, NICOL_FORMAT_AUTOMATIC, NICOL_ALL_CHANNELS, single.data(), 4 * single.size());
            to.row_stride = 4 * stride;
            OK(nicol_framebuffer_read_plane(stage.framebuffer, &to));
            to = buffer(plane, NICOL_FORMAT_FLOAT16, NICOL_ALL_CHANNELS, half.data(), 2 * half.size());
            to.row_stride = 2 * stride;
            OK(nicol_framebuffer_read_plane(stage.framebuffer, &to));
            for (std::size_t i = 0; i < single.size(); ++i) {
                const std::size_t y = i / step, in_row = i % step;
                if (in_row >= row) {
                    CHECK(single[i] == -7.5F);
                    CHECK(half[i] == 0x1234);
                    continue;
                }
                const std::size_t x = in_row / (3 * n), c = in_row / n % 3, k = in_row % n;
                CHECK(single[i] == channels[c][(y * 24 + x) * n + k]);
                CHECK(half[i] == nearest_half(single[i]));
            }
        }
    }
}

STAGE_TEST_CASE("the plane behind a polarizer is that of an ideal one at its angle") {
    OK(stage.try_render(plain_options()));
    std::vector<float> stokes(std::size_t{24} * 16 * 3 * 4), passed(stokes.size() / 4);
    nicol_plane_buffer to = buffer(NICOL_PLANE_STOKES, NICOL_FORMAT_FLOAT32, NICOL_ALL_CHANNELS,
                                   stokes.data(), 4 * stokes.size());
    OK(nicol_framebuffer_read_plane(stage.framebuffer, &to));
    for (const double angle : {0.0, 45.0, 90.0, 135.0, -30.0, 400.0}) {
        to = buffer(NICOL_PLANE_POLARIZER, NICOL_FORMAT_FLOAT32, NICOL_ALL_CHANNELS, passed.data(),
                    4 * passed.size());
        to.polarizer_angle = angle;
        OK(nicol_framebuffer_read_plane(stage.framebuffer, &to));
        const double twice = angle * std::numbers::pi / 90;
        for (std::size_t i = 0; i < passed.size(); ++i) {
            const float* const s = stokes.data() + 4 * i;
            REQUIRE(double(passed[i]) ==
                    doctest::Approx(0.5 * (double(s[0]) + std::cos(twice) * double(s[1]) +
                                           std::sin(twice) * double(s[2]))));
        }
    }
}

STAGE_TEST_CASE("planes of surfaces come in their formats") {
    nicol_render_options options = plain_options();
    options.aovs = NICOL_AOV_ALL;
    OK(stage.try_render(options));
    for (const nicol_plane plane :
         {NICOL_PLANE_DEPTH, NICOL_PLANE_NORMAL, NICOL_PLANE_POSITION, NICOL_PLANE_ALPHA}) {
        const std::size_t n = components_of(plane);
        const std::vector<float> single = read_surface<float>(stage.framebuffer, plane, n);
        std::vector<float> old(single.size());
        OK(nicol_framebuffer_read(stage.framebuffer, plane, 0, old.data(), 0, 4 * old.size()));
        CHECK(old == single);
        std::vector<std::uint16_t> half(single.size());
        const nicol_plane_buffer to = buffer(plane, NICOL_FORMAT_FLOAT16, 0, half.data(), 2 * half.size());
        OK(nicol_framebuffer_read_plane(stage.framebuffer, &to));
        for (std::size_t i = 0; i < half.size(); ++i) CHECK(half[i] == nearest_half(single[i]));
    }
    const std::vector<std::uint32_t> ids =
        read_surface<std::uint32_t>(stage.framebuffer, NICOL_PLANE_INSTANCE, 1);
    std::vector<std::uint32_t> named(27 * 16, 5);
    nicol_plane_buffer to =
        buffer(NICOL_PLANE_INSTANCE, NICOL_FORMAT_UINT32, 0, named.data(), 4 * named.size());
    to.row_stride = 4 * 27;
    OK(nicol_framebuffer_read_plane(stage.framebuffer, &to));
    for (std::size_t i = 0; i < named.size(); ++i)
        CHECK(named[i] == (i % 27 < 24 ? ids[i / 27 * 24 + i % 27] : 5));
}
