// SPDX-License-Identifier: MIT
// Tests of Stokes images from mosaics.
#include "sensor/demosaic.hpp"

#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

constexpr std::array kMethods{Demosaic::bilinear, Demosaic::blocks, Demosaic::gradient};

/// Returns light that is linear in x and y.
StokesImage slope(int width, int height, int channels) {
    StokesImage light(width, height, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float s0 =
                    0.2F + 0.02F * static_cast<float>(x) + 0.01F * static_cast<float>(y * (c + 1));
                const std::array<float, 4> stokes{s0, 0.4F * s0, -0.3F * s0, 0};
                std::copy(stokes.begin(), stokes.end(), light.at(c, y, x).begin());
            }
    return light;
}

}  // namespace

TEST_CASE("an even picture comes back exactly") {
    const std::array<float, 4> stokes{0.75F, 0.25F, -0.5F, 0};
    for (const Mosaic mosaic : {Mosaic::polarized, Mosaic::polarized_bayer})
        for (const Demosaic method : kMethods) {
            const int channels = mosaic == Mosaic::polarized ? 1 : 3;
            const Sensor sensor = quiet_sensor(mosaic);
            const StokesImage back =
                demosaic(sensor, expose(sensor, even_light(16, 8, channels, stokes), 0), method);
            const int cell = method == Demosaic::blocks ? cell_side(mosaic) : 1;
            CHECK(back.width == 16 / cell);
            CHECK(back.height == 8 / cell);
            CHECK(back.data == even_light(back.width, back.height, channels, stokes).data);
        }
    Sensor plain = quiet_sensor(Mosaic::plain);
    const StokesImage back = demosaic(plain, expose(plain, even_light(3, 5, 1, stokes), 0), kMethods[0]);
    CHECK(back.data == even_light(3, 5, 1, {0.75F, 0, 0, 0}).data);
}

TEST_CASE(
    "gradients keep slanted edges that bilinear interpolation smears, and straight ones as well as it does") {
    const Sensor sensor = quiet_sensor();
    constexpr int size = 32;
    for (const auto& [a, b] : {std::array{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}, {2.0, 1.0}}) {
        CAPTURE(a);
        CAPTURE(b);
        StokesImage light(size, size, 1);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool bright = a * (x - 15.5) + b * (y - 15.5) > 0;
                const std::array<float, 4> stokes =
                    bright ? std::array{0.9F, 0.3F, -0.2F, 0.0F} : std::array{0.1F, -0.05F, 0.0F, 0.0F};
                std::ranges::copy(stokes, light.at(0, y, x).begin());
            }
        const RawImage raw = expose(sensor, light, 0);
        const auto error = [&](Demosaic method) {
            const StokesImage back = demosaic(sensor, raw, method);
            double sum = 0;
            for (std::size_t i = 0; i < back.data.size(); ++i)
                sum += std::abs(static_cast<double>(back.data[i] - light.data[i]));
            return sum;
        };
        // Beside a straight edge two of the angles are known on its other side alone.
        const double most = a * b == 0 ? 1.0001 : 0.8;
        CHECK(error(Demosaic::gradient) < most * error(Demosaic::bilinear));
    }
}

TEST_CASE("exposure, gain, levels, efficiencies and extinction are undone") {
    Sensor sensor;
    sensor.mosaic = Mosaic::polarized_bayer;
    sensor.bits = 16;
    sensor.read_noise = 0;
    sensor.shot_noise = false;
    sensor.black_level = 500;
    sensor.dark_current = 20000;
    sensor.full_well = 20000;
    sensor.exposure = 15000;
    sensor.quantum_efficiency = {0.3, 0.6, 0.4};
    sensor.extinction_ratio = 20;
    const std::array<float, 4> stokes{0.9F, -0.3F, 0.4F, 0};
    const StokesImage back =
        demosaic(sensor, expose(sensor, even_light(4, 4, 3, stokes), 0), Demosaic::blocks);
    for (std::size_t i = 0; i < back.data.size(); ++i) CHECK(std::abs(back.data[i] - stokes[i % 4]) < 2e-4F);
}

TEST_CASE(
    "light that varies evenly comes back by interpolation, up to the numbers' steps, away from borders") {
    for (const Mosaic mosaic : {Mosaic::polarized, Mosaic::polarized_bayer}) {
        const int channels = mosaic == Mosaic::polarized ? 1 : 3;
        const StokesImage light = slope(24, 16, channels);
        const Sensor sensor = quiet_sensor(mosaic);
        const StokesImage back = demosaic(sensor, expose(sensor, light, 0), Demosaic::bilinear);
        REQUIRE(back.data.size() == light.data.size());
        for (int c = 0; c < channels; ++c)
            for (int y = 4; y < 12; ++y)
                for (int x = 4; x < 20; ++x)
                    for (std::size_t p = 0; p < 4; ++p)
                        CHECK(std::abs(back.at(c, y, x)[p] - light.at(c, y, x)[p]) < 5e-5F);
    }
}

TEST_CASE("at borders the nearest pixels count, none beyond") {
    for (const Mosaic mosaic : {Mosaic::polarized, Mosaic::polarized_bayer}) {
        const int cell = cell_side(mosaic);
        const int channels = mosaic == Mosaic::polarized ? 1 : 3;
        StokesImage light(4 * cell, 4 * cell, channels);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < 4 * cell; ++y)
                for (int x = 0; x < 4 * cell; ++x)
                    light.at(c, y, x)[0] = std::min(x, y) < cell       ? 0.5F
                                           : std::max(x, y) < 3 * cell ? 0.25F
                                                                       : 1;
        const Sensor sensor = quiet_sensor(mosaic);
        const StokesImage back = demosaic(sensor, expose(sensor, light, 0), Demosaic::bilinear);
        const int last = 4 * cell - 1;
        for (int c = 0; c < channels; ++c) {
            CHECK(back.at(c, 0, 0)[0] == 0.5F);
            CHECK(back.at(c, last, 0)[0] == 0.5F);
            CHECK(back.at(c, last, last)[0] == 1);
        }
    }
}

TEST_CASE("mosaics that are no whole cells, and polarizers that polarize nothing, are refused") {
    Sensor sensor;
    const RawImage odd{3, 2, std::vector<std::uint16_t>(6)};
    check_error(ErrorCode::invalid_argument, CALL(demosaic(sensor, odd, Demosaic::blocks)), "3 x 2 pixels");
    sensor.extinction_ratio = 1;
    const RawImage even{2, 2, std::vector<std::uint16_t>(4)};
    check_error(ErrorCode::invalid_argument, CALL(demosaic(sensor, even, Demosaic::blocks)),
                "extinction_ratio of the sensor is 1");
}
