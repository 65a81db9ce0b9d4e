// SPDX-License-Identifier: MIT
// Tests of sensors as JSON and of mosaics as PNG files.
#include "sensor/sensor_file.hpp"

#include "image/observer.hpp"
#include "scenes.hpp"
#include "sensor/angle_pictures.hpp"
#include "sensor/mosaic_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

Sensor parsed(std::string_view text) {
    return parse_sensor("sensor.json", text, {});
}

}  // namespace

TEST_CASE("JSON sets the members that it names, after those of a preset, and elements in the light's order") {
    const Sensor sensor = parsed(R"({"seed": 18446744073709551615, "bits": 10, "preset": "imx250myr",
        "quantum_efficiency": [0.5, 0.6, 0.4], "shot_noise": false, "extinction_ratio": 300,
        "elements": [{"kind": "polarizer", "angle": 30, "extinction_ratio": 1000},
                     {"kind": "retarder", "angle": 45, "retardance": 90, "transmittance": 0.9}]})");
    CHECK(sensor.mosaic == Mosaic::polarized_bayer);
    CHECK(sensor.seed == UINT64_MAX);
    CHECK(sensor.bits == 10);
    CHECK(sensor.full_well == 10715);
    CHECK(sensor.quantum_efficiency == std::vector<double>{0.5, 0.6, 0.4});
    CHECK(!sensor.shot_noise);
    CHECK(sensor.extinction_ratio == 300);
    PolarizationElement polarizer, plate;
    polarizer.angle = pi / 6;
    plate.kind = PolarizationElement::Kind::retarder;
    plate.angle = pi / 4;
    plate.transmittance = 0.9;
    const Mueller expected = in_front(plate, 0) * in_front(polarizer, 1000);
    for (std::size_t i = 0; i < 16; ++i) CHECK(sensor.optics(i / 4, i % 4) == expected(i / 4, i % 4));
    CHECK(sensor_json(parsed(sensor_json(sensor))) == sensor_json(sensor));
}

TEST_CASE("wrong JSON is refused with the file, the key and what would be right") {
    const auto refused = [](std::string_view text, const char* part) {
        check_error(ErrorCode::invalid_file, CALL(parsed(text)), "sensor.json: ", part);
    };
    refused("{", "is not JSON");
    refused("[]", "is not a sensor: a JSON object");
    refused(R"({"full_wel": 3})", "\"full_wel\" must be one of: preset, mosaic,");
    refused(R"({"full_well": "3"})", "\"full_well\" must be a number");
    refused(R"({"full_well": 0})", "full_well of the sensor is 0");
    refused(R"({"bits": 9})", "bits of the sensor is 9");
    refused(R"({"bits": 1e400})", "is not JSON");
    refused(R"({"seed": -1})", "\"seed\" must be a whole number");
    refused(R"({"preset": "imx"})", "\"preset\" must be one of: imx250mzr, imx250myr");
    refused(R"({"mosaic": 1})", "\"mosaic\" must be one of: plain, polarized, polarized_bayer");
    refused(R"({"shot_noise": 1})", "\"shot_noise\" must be true or false");
    refused(R"({"elements": [{"kind": "lens"}]})", "\"elements.kind\" must be one of: polarizer");
    refused(R"({"elements": [{"turn": 1}]})", "\"elements.turn\" must be one of: kind");
    refused(R"({"elements": [{"transmittance": 2}]})", "transmittance of an element is 2");
    refused(R"({"elements": [3]})", "\"elements\" must be a list of objects");
    refused(R"({"optics": [1, 2]})", "\"optics\" must be 16 numbers");
    refused(R"({"quantum_efficiency": []})", "quantum_efficiency of the sensor has 0 values");
    refused(R"({"quantum_efficiency": [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1]})",
            "has 17 values; it must have 1");
}

TEST_CASE("a mosaic's file gives back its numbers and its sensor, in 8 and 16 bits") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "raw.png";
    for (const int bits : {8, 10, 12, 16}) {
        Sensor sensor = with_preset({}, SensorPreset::imx250mzr);
        sensor.bits = bits;
        sensor.seed = 9;
        const RawImage raw = expose(sensor, even_light(64, 32, 1, {0.7F, 0.2F, 0.1F, 0}), 3);
        write_mosaic(file, sensor, raw);
        const Sensor same = read_sensor(file, {});
        CHECK(sensor_json(same) == sensor_json(sensor));
        const RawImage back = read_mosaic(file, same);
        CHECK(back.width == 64);
        CHECK(back.values == raw.values);
        std::ifstream in(file, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        CHECK(bytes[24] == (bits == 8 ? 8 : 16));
        CHECK(png_text(bytes, "Nicol:Bits") == std::to_string(bits));
        CHECK(png_text(bytes, "Nicol:Mosaic").starts_with("polarized 90 45 / 135 0"));
        CHECK(png_text(bytes, "Nicol:Bit").empty());
        for (std::size_t cut = 0; cut < bytes.size(); cut += 7) (void)png_text(bytes.substr(0, cut), "None");
    }
}

TEST_CASE("numbers beyond the bits, colours and files without a sensor are refused") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "raw.png";
    Sensor sensor;
    RawImage raw{2, 2, {0, 1, 2, 4095}};
    write_mosaic(file, sensor, raw);
    sensor.bits = 10;
    check_error(ErrorCode::invalid_file, CALL(read_mosaic(file, sensor)), "number 4095",
                "10 bits gives at most 1023");
    check_error(ErrorCode::invalid_argument, CALL(write_mosaic(file, sensor, raw)), "number 4095");
    raw = {3, 1, {0, 0, 0}};
    check_error(ErrorCode::invalid_argument, CALL(write_mosaic(file, sensor, raw)), "3 x 1 pixels");
    const std::filesystem::path colours = folder / "colours.png";
    write_png(colours, png_of(tone_mapped(even_light(2, 2, 3, {1, 0, 0, 0}))));
    check_error(ErrorCode::invalid_file, CALL(read_mosaic(colours, sensor)), "3 channels; a mosaic is grey");
    check_error(ErrorCode::invalid_file, CALL(read_sensor(colours, {})), "has no text Nicol:Sensor");
    check_error(ErrorCode::file_not_found, CALL(read_sensor(folder / "none.json", {})), "none.json");
}

TEST_CASE("pictures behind a polarizer at four angles give the light in front of it") {
    const TemporaryFolder folder;
    const std::array<float, 4> stokes{0.8F, 0.3F, -0.2F, 0};
    std::array<std::filesystem::path, 4> files;
    for (std::size_t a = 0; a < 4; ++a) {
        files[a] = folder / ("angle" + std::to_string(a) + ".exr");
        const double angle = pi / 4 * static_cast<double>(a);
        write_exr(files[a], through_polarizer(even_light(3, 2, 3, stokes), angle));
    }
    const StokesImage light = read_angle_pictures(files);
    CHECK(light.channels == 3);
    for (std::size_t i = 0; i < light.data.size(); ++i)
        CHECK(light.data[i] == doctest::Approx(stokes[i % 4]).epsilon(1e-6));
    // Numbers of PNG files are linear.
    const std::filesystem::path grey = folder / "grey.png";
    Sensor plain;
    plain.mosaic = Mosaic::plain;
    plain.bits = 8;
    write_mosaic(grey, plain, {1, 1, {51}});
    CHECK(read_angle_pictures({grey, grey, grey, grey}).data[0] == doctest::Approx(0.4));
    files[2] = grey;
    check_error(ErrorCode::invalid_file, CALL(read_angle_pictures(files)), "grey.png",
                "1 x 1 pixels with 1 channels; the first picture has 3 x 2");
}
