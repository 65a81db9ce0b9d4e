// SPDX-License-Identifier: MIT
// Tests of raw images: layout and signs, noise by EMVA 1288, errors of pixels, and bytes that stay.
#include "sensor/expose.hpp"

#include <tbb/global_control.h>

#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

struct Moments {
    double mean = 0;
    double variance = 0;
};

Moments moments(const std::vector<std::uint16_t>& values) {
    Moments out;
    for (const double v : values) out.mean += v / static_cast<double>(values.size());
    for (const double v : values)
        out.variance += (v - out.mean) * (v - out.mean) / static_cast<double>(values.size() - 1);
    return out;
}

std::uint64_t fnv(const std::vector<std::uint16_t>& values) {
    std::uint64_t hash = 14695981039346656037U;
    for (const std::uint16_t v : values) hash = (hash ^ v) * 1099511628211U;
    return hash;
}

/// A sensor that uses every source of noise and of errors.
Sensor noisy_sensor() {
    Sensor sensor = with_preset({}, SensorPreset::imx250mzr);
    sensor.seed = 20;
    sensor.black_level = 60;
    sensor.dark_current = 500;
    sensor.dsnu = 3;
    sensor.prnu = 0.01;
    sensor.extinction_ratio = 300;
    sensor.extinction_spread = 0.2;
    sensor.misalignment = 0.5;
    sensor.crosstalk = 0.02;
    return sensor;
}

}  // namespace

TEST_CASE("pixels have the order 90 45 / 135 0 with angles counter-clockwise from image right") {
    const Sensor sensor = quiet_sensor();
    const auto cell = [&](const std::array<float, 4>& stokes) {
        return expose(sensor, even_light(2, 2, 1, stokes), 0).values;
    };
    using Numbers = std::vector<std::uint16_t>;
    CHECK(cell({1, 1, 0, 0}) == Numbers{0, 20000, 20000, 40000});                   // horizontal
    CHECK(cell({1, 0, 1, 0}) == Numbers{20000, 40000, 0, 20000});                   // +45 degrees
    CHECK(cell({1, -1, 0, 0}) == Numbers{40000, 20000, 20000, 0});                  // vertical
    CHECK(cell({1, 0.25F, 0.4330127F, 0}) == Numbers{15000, 28660, 11340, 25000});  // +30 degrees, DoLP 0.5
    CHECK(cell({1, 0, 0, 1}) == Numbers{20000, 20000, 20000, 20000});
}

TEST_CASE("colour filters are R G / G B over blocks of four polarizers, and other sensors take the mean") {
    StokesImage light(4, 4, 3);
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 16; ++i) light.at(c, i / 4, i % 4)[0] = 0.25F * static_cast<float>(c + 1);
    const RawImage bayer = expose(quiet_sensor(Mosaic::polarized_bayer), light, 0);
    CHECK(bayer.values == std::vector<std::uint16_t>{5000, 5000, 10000, 10000, 5000, 5000, 10000, 10000,  //
                                                     10000, 10000, 15000, 15000, 10000, 10000, 15000, 15000});
    CHECK(expose(quiet_sensor(), light, 0).values == std::vector<std::uint16_t>(16, 10000));
    CHECK(expose(quiet_sensor(Mosaic::plain), light, 0).values == std::vector<std::uint16_t>(16, 20000));
    Sensor red = quiet_sensor(Mosaic::polarized_bayer);
    red.quantum_efficiency = {0.5, 0.25, 0.125};
    CHECK(expose(red, light, 0).values[15] == 3750);
}

TEST_CASE("a photon-transfer curve gives back gain, read noise and quantum efficiency within 2 %") {
    Sensor sensor = with_preset({}, SensorPreset::imx250mzr);
    sensor.mosaic = Mosaic::plain;
    sensor.exposure = 10000;
    sensor.gain = 0.4;
    sensor.black_level = 100;
    const auto pixels = [&](float s0, std::uint64_t frame) {
        return moments(expose(sensor, even_light(512, 512, 1, {s0, 0, 0, 0}), frame).values);
    };
    const Moments dark = pixels(0, 0);
    CHECK(dark.mean == doctest::Approx(100).epsilon(1e-3));
    CHECK(std::sqrt(dark.variance - 1.0 / 12) / sensor.gain ==
          doctest::Approx(sensor.read_noise).epsilon(0.02));
    std::uint64_t frame = 1;
    for (const float s0 : {0.002F, 0.02F, 0.1F, 0.5F, 1.0F}) {
        CAPTURE(s0);
        const Moments lit = pixels(s0, frame++);
        const double signal = lit.mean - dark.mean;
        CHECK(signal / (sensor.gain * 10000 * static_cast<double>(s0)) == doctest::Approx(0.6).epsilon(0.02));
        const double tolerance = s0 > 0.05F ? 0.02 : 0.2;  // read noise covers the noise of few photons
        CHECK((lit.variance - dark.variance) / signal == doctest::Approx(sensor.gain).epsilon(tolerance));
    }
}

TEST_CASE("the full well and the bits limit numbers, and an automatic exposure fills the well at s0 = 1") {
    for (const int bits : {8, 10, 12, 16}) {
        Sensor sensor;
        sensor.bits = bits;
        sensor.shot_noise = false;
        sensor.read_noise = 0;
        const auto number = [&](float s0) {
            return expose(sensor, even_light(2, 2, 1, {s0, 0, 0, 0}), 0).values[0];
        };
        const int largest = (1 << bits) - 1;
        CHECK(number(1) == largest);
        CHECK(number(1e30F) == largest);
        CHECK(number(-1) == 0);
        CHECK(std::abs(number(0.5F) - largest / 2) <= 1);
        sensor.gain = largest / 20000.0;  // a well that is full at half of the numbers
        CHECK(std::abs(number(9) - largest / 2) <= 1);
    }
}

TEST_CASE("dark current, offsets and sensitivities have the deviations that are asked for") {
    Sensor sensor = quiet_sensor(Mosaic::plain);
    const auto seen = [&](float s0) {
        return moments(expose(sensor, even_light(256, 256, 1, {s0, 0, 0, 0}), 0).values);
    };
    sensor.dark_current = 5000;
    sensor.exposure_time = 0.5;
    CHECK(seen(0).mean == 2500);
    sensor.dsnu = 20;
    CHECK(std::sqrt(seen(0).variance) == doctest::Approx(20).epsilon(0.02));
    sensor.dsnu = 0;
    sensor.prnu = 0.03;
    CHECK(seen(0).variance == 0);
    CHECK(std::sqrt(seen(0.5F).variance) == doctest::Approx(0.03 * 20000).epsilon(0.02));
}

TEST_CASE("polarizers leak by their extinction ratio and turn by their misalignment") {
    Sensor sensor = quiet_sensor();
    sensor.extinction_ratio = 40;
    const auto crossed = [&] {
        const RawImage raw = expose(sensor, even_light(256, 256, 1, {1, 1, 0, 0}), 0);
        std::vector<std::uint16_t> at_90;
        for (std::size_t y = 0; y < 256; y += 2)
            for (std::size_t x = 0; x < 256; x += 2) at_90.push_back(raw.values[256 * y + x]);
        return moments(at_90);
    };
    CHECK(crossed().mean == 1000);
    CHECK(crossed().variance == 0);
    sensor.extinction_spread = 0.1;
    CHECK(crossed().mean == doctest::Approx(1000).epsilon(0.01));
    CHECK(std::sqrt(crossed().variance) == doctest::Approx(100).epsilon(0.03));
    sensor.extinction_ratio = sensor.extinction_spread = 0;
    sensor.misalignment = 2;
    // The mean of sin^2 of a normal angle.
    const double angle = 2 * pi / 180;
    CHECK(crossed().mean == doctest::Approx(20000 * (1 - std::exp(-2 * angle * angle))).epsilon(0.03));
}

TEST_CASE("crosstalk gives a part of each pixel to its neighbours and loses nothing") {
    Sensor sensor = quiet_sensor(Mosaic::plain);
    sensor.crosstalk = 0.2;
    StokesImage light(5, 5, 1);
    light.at(0, 2, 2)[0] = 1;
    light.at(0, 0, 0)[0] = 0.5F;
    const RawImage raw = expose(sensor, light, 0);
    CHECK(raw.values[12] == 32000);
    for (const std::size_t neighbour : {7U, 11U, 13U, 17U}) CHECK(raw.values[neighbour] == 2000);
    CHECK(raw.values[0] == 18000);
    int sum = 0;
    for (const int v : raw.values) sum += v;
    CHECK(sum == 60000);
}

TEST_CASE("crosstalk by pixel has the deviation that is asked for, and loses nothing") {
    Sensor sensor = quiet_sensor(Mosaic::plain);
    sensor.crosstalk = 0.2;
    sensor.crosstalk_spread = 0.25;
    // Pixels alone in the dark keep what they do not give away.
    StokesImage light(384, 384, 1);
    std::vector<std::uint16_t> kept;
    for (int y = 1; y < light.height; y += 3)
        for (int x = 1; x < light.width; x += 3) light.at(0, y, x)[0] = 1;
    const RawImage raw = expose(sensor, light, 0);
    double sum = 0;
    for (const double v : raw.values) sum += v;
    for (std::size_t y = 1; y < 384; y += 3)
        for (std::size_t x = 1; x < 384; x += 3) kept.push_back(raw.values[384 * y + x]);
    CHECK(sum / static_cast<double>(kept.size()) == doctest::Approx(40000).epsilon(1e-4));
    CHECK(moments(kept).mean == doctest::Approx(32000).epsilon(0.002));
    CHECK(std::sqrt(moments(kept).variance) == doctest::Approx(0.05 * 40000).epsilon(0.02));
    CHECK(expose(sensor, light, 1).values == raw.values);  // it belongs to the pixel, not to the frame
}

TEST_CASE("a lens blurs light by the deviation that is asked for, and darkens corners as cosines do") {
    Sensor sensor = quiet_sensor(Mosaic::plain);
    sensor.blur = 1.5;
    StokesImage light(41, 41, 1);
    light.at(0, 20, 20)[0] = 1.5F;
    const RawImage spot = expose(sensor, light, 0);
    double sum = 0, spread = 0;
    for (int i = 0; i < 41 * 41; ++i) {
        const double value = spot.values[static_cast<std::size_t>(i)];
        sum += value;
        spread += value * (i % 41 - 20) * (i % 41 - 20);
    }
    CHECK(sum == doctest::Approx(60000).epsilon(1e-3));
    CHECK(std::sqrt(spread / sum) == doctest::Approx(1.5).epsilon(0.01));
    CHECK(spot.values[20 * 41 + 22] == spot.values[22 * 41 + 20]);
    CHECK(expose(sensor, even_light(6, 4, 1, {0.5F, 0, 0, 0}), 0).values ==
          std::vector<std::uint16_t>(24, 20000));

    sensor.blur = 0;
    sensor.vignetting = 0.36;
    const RawImage dark = expose(sensor, even_light(41, 41, 1, {1, 0, 0, 0}), 0);
    CHECK(dark.values[20 * 41 + 20] == 40000);
    CHECK(dark.values[0] == 40000 * 64 / 100);
    // The corner's tangent squared is 1 / 0.8 - 1 = 0.25; half way to the corner it is a quarter of that.
    CHECK(dark.values[10 * 41 + 10] == doctest::Approx(40000 / (1.0625 * 1.0625)).epsilon(1e-4));
}

TEST_CASE("elements in front of the sensor act as their Mueller matrices, in the order of the light") {
    Sensor sensor = quiet_sensor();
    PolarizationElement polarizer, plate;
    plate.kind = PolarizationElement::Kind::retarder;
    plate.angle = pi / 4;
    // Horizontal light through a quarter-wave plate at 45 degrees is circular: all angles measure one half.
    sensor.optics = in_front(plate, 0) * in_front(polarizer, 0);
    const RawImage raw = expose(sensor, even_light(2, 2, 1, {1, 1, 0, 0}), 0);
    CHECK(raw.values == std::vector<std::uint16_t>(4, 20000));
    // The other way round, half of it is horizontal.
    sensor.optics = in_front(polarizer, 0) * in_front(plate, 0);
    CHECK(expose(sensor, even_light(2, 2, 1, {1, 1, 0, 0}), 0).values[3] == 20000);
    CHECK(expose(sensor, even_light(2, 2, 1, {1, 1, 0, 0}), 0).values[0] == 0);

    polarizer.transmittance = 0.8;
    const Mueller real = in_front(polarizer, 100);
    CHECK((real * Stokes(1, 1, 0, 0))[0] == doctest::Approx(0.8));
    CHECK((real * Stokes(1, -1, 0, 0))[0] == doctest::Approx(0.008));
    CHECK((real * Stokes(1, 0, 1, 0))[2] == doctest::Approx(0.08));  // sqrt(k1 k2)
    CHECK((real * Stokes(1, 0, 0, 1))[3] == doctest::Approx(0.08));
}

TEST_CASE("the same seed and frame give the same bytes for any number of threads, on every machine") {
    StokesImage light(96, 64, 3);
    for (std::size_t i = 0; i < light.data.size(); i += 4) {
        light.data[i] = static_cast<float>(i % 977) / 977;
        light.data[i + 1] = light.data[i] * (static_cast<float>(i % 31) - 15) / 32;
        light.data[i + 2] = light.data[i] * (static_cast<float>(i % 37) - 18) / 40;
    }
    Sensor sensor = noisy_sensor();
    PolarizationElement plate;
    plate.kind = PolarizationElement::Kind::retarder;
    plate.angle = 0.3;
    sensor.optics = in_front(plate, 0);
    std::vector<std::uint16_t> single;
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        single = expose(sensor, light, 5).values;
    }
    {
        const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
        CHECK(expose(sensor, light, 5).values == single);
    }
    CHECK(expose(sensor, light, 6).values != single);
    sensor.seed = 21;
    CHECK(expose(sensor, light, 5).values != single);
    CHECK(fnv(single) == 8184805965854610899U);
}

TEST_CASE("bad sensors, sizes and light are refused by name") {
    const auto refused = [](auto change, const char* text) {
        Sensor sensor;
        change(sensor);
        check_error(ErrorCode::invalid_argument, CALL(expose(sensor, even_light(4, 4, 1, {1, 0, 0, 0}), 0)),
                    text);
    };
    refused([](Sensor& s) { s.bits = 11; }, "bits of the sensor is 11; it must be 8, 10, 12 or 16");
    refused([](Sensor& s) { s.full_well = 0; }, "full_well of the sensor is 0; it must lie in 1 to");
    refused([](Sensor& s) { s.read_noise = std::nan(""); }, "read_noise");
    refused([](Sensor& s) { s.black_level = 4095; }, "black_level");
    refused([](Sensor& s) { s.extinction_ratio = 0.5; }, "extinction_ratio of the sensor is 0.5");
    refused([](Sensor& s) { s.misalignment = 90; }, "misalignment");
    refused([](Sensor& s) { s.crosstalk_spread = 2; }, "crosstalk_spread of the sensor is 2");
    refused([](Sensor& s) { s.blur = 17; }, "blur of the sensor is 17; it must lie in 0 to 16: pixels");
    refused([](Sensor& s) { s.vignetting = 1; }, "vignetting of the sensor is 1");
    refused([](Sensor& s) { s.quantum_efficiency = {0}; }, "quantum_efficiency of the sensor is 0");
    refused([](Sensor& s) { s.quantum_efficiency = {0.5, 0.5}; }, "2 values; the image has 1 channels");
    refused([](Sensor& s) { s.optics(1, 2) = HUGE_VAL; }, "optics[6]");
    refused([](Sensor& s) { s.mosaic = Mosaic::polarized_bayer; }, "needs 3");
    const Sensor sensor;
    check_error(ErrorCode::invalid_argument, CALL(expose(sensor, even_light(5, 4, 1, {1, 0, 0, 0}), 0)),
                "5 x 4 pixels; both sides must be multiples of 2");
    StokesImage light = even_light(4, 2, 3, {1, 0, 0, 0});
    light.at(2, 1, 3)[1] = std::numeric_limits<float>::quiet_NaN();
    Sensor behind_lens;
    behind_lens.blur = 1;
    for (const Sensor& with : {sensor, behind_lens})
        check_error(ErrorCode::invalid_argument, CALL(expose(with, light, 0)),
                    "channel 2 at column 3, row 1 is not finite");
}
