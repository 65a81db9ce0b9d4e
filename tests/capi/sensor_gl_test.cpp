// SPDX-License-Identifier: MIT
// Tests of sensors through the C interface.
#include <fstream>
#include <iterator>

#include "image/stokes_image.hpp"
#include "planes.hpp"

using namespace capi_test;

namespace {

struct Raw {
    std::vector<std::uint16_t> numbers;
    nicol_raw_image image = NICOL_RAW_IMAGE_INIT;

    Raw(std::uint32_t width, std::uint32_t height) : numbers(std::size_t{width} * height) {
        image.width = width;
        image.height = height;
        image.pixels = numbers.data();
        image.byte_size = numbers.size() * sizeof(std::uint16_t);
    }
};

struct Light {
    std::vector<float> pixels;
    nicol_stokes_image image = NICOL_STOKES_IMAGE_INIT;

    Light(std::uint32_t width, std::uint32_t height, std::uint32_t channels)
        : pixels(std::size_t{4} * width * height * channels) {
        image.width = width;
        image.height = height;
        image.channels = channels;
        image.pixels = pixels.data();
        image.byte_size = pixels.size() * sizeof(float);
    }
};

}  // namespace

STAGE_TEST_CASE("a framebuffer's raw image is that of its Stokes planes, in each layout") {
    stage.render();
    std::uint32_t width = 0, height = 0, channels = 0;
    OK(nicol_framebuffer_get_size(stage.framebuffer, &width, &height, &channels));
    Light light(width, height, channels);
    nicol_plane_buffer buffer = NICOL_PLANE_BUFFER_INIT;
    buffer.plane = NICOL_PLANE_STOKES;
    buffer.channel = NICOL_ALL_CHANNELS;
    buffer.pixels = light.pixels.data();
    buffer.byte_size = light.image.byte_size;
    OK(nicol_framebuffer_read_plane(stage.framebuffer, &buffer));
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    sensor.seed = 4;
    for (const nicol_mosaic mosaic :
         {NICOL_MOSAIC_PLAIN, NICOL_MOSAIC_POLARIZED, NICOL_MOSAIC_POLARIZED_BAYER}) {
        sensor.mosaic = mosaic;
        Raw direct(width, height), of_planes(width, height);
        OK(nicol_framebuffer_expose(stage.framebuffer, &sensor, 7, &direct.image));
        OK(nicol_sensor_expose(&sensor, &light.image, 7, &of_planes.image));
        CHECK(direct.numbers == of_planes.numbers);
        CHECK(*std::ranges::max_element(direct.numbers) > 0);
    }
    Raw small(2, 2);
    REFUSES(nicol_framebuffer_expose(stage.framebuffer, &sensor, 7, &small.image),
            "to has 2 x 2 pixels; the light has");
}

TEST_CASE("a light goes through optics and sensor into a file and comes back as an image") {
    const TemporaryFolder folder;
    const std::string png = folder.file("raw.png"), exr = folder.file("back.exr");
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    OK(nicol_sensor_set_preset(&sensor, NICOL_SENSOR_PRESET_IMX250MYR));
    CHECK(sensor.mosaic == NICOL_MOSAIC_POLARIZED_BAYER);
    sensor.bits = 16;
    sensor.shot_noise = 0;
    sensor.read_noise = 0;
    nicol_polarization_element half_wave = NICOL_POLARIZATION_ELEMENT_INIT;
    half_wave.kind = NICOL_POLARIZATION_ELEMENT_RETARDER;
    half_wave.retardance = 180;
    half_wave.angle = 45;
    OK(nicol_sensor_add_element(&sensor, &half_wave, 0));
    Light light(8, 4, 3), back(8, 4, 3);
    for (std::size_t i = 0; i < light.pixels.size(); i += 4) {
        light.pixels[i] = 0.5F;
        light.pixels[i + 1] = 0.25F;
    }
    Raw raw(8, 4);
    OK(nicol_sensor_expose(&sensor, &light.image, 0, &raw.image));
    OK(nicol_sensor_write_png(&sensor, &raw.image, png.c_str()));
    nicol_sensor read = NICOL_SENSOR_INIT;
    OK(nicol_sensor_load(&read, png.c_str()));
    CHECK(std::memcmp(&read, &sensor, sizeof sensor) == 0);
    std::ifstream file(png, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    nicol_memory_file in_memory = NICOL_MEMORY_FILE_INIT;
    in_memory.bytes = bytes.data();
    in_memory.byte_size = bytes.size();
    nicol_sensor from_bytes = NICOL_SENSOR_INIT;
    OK(nicol_sensor_load_memory(&from_bytes, &in_memory));
    CHECK(std::memcmp(&from_bytes, &sensor, sizeof sensor) == 0);
    OK(nicol_file_demosaic(png.c_str(), &read, NICOL_DEMOSAIC_BILINEAR, exr.c_str()));
    OK(nicol_sensor_demosaic(&read, &raw.image, NICOL_DEMOSAIC_BILINEAR, &back.image));
    const nicol::StokesImage image = nicol::read_exr(exr);
    for (std::size_t i = 0; i < back.pixels.size(); ++i) {
        constexpr float flipped[] = {0.5F, -0.25F, 0, 0};
        CHECK(back.pixels[i] == doctest::Approx(flipped[i % 4]).epsilon(1e-3));
        const std::size_t pixel = i / 12, channel = i / 4 % 3;
        CHECK(image.data[4 * (32 * channel + pixel) + i % 4] == back.pixels[i]);
    }
    const std::string combined = folder.file("combined.exr");
    OK(nicol_file_combine_angles(exr.c_str(), exr.c_str(), exr.c_str(), exr.c_str(), combined.c_str()));
    CHECK(nicol::read_exr(combined).data[0] == doctest::Approx(2 * image.data[0]));
}

TEST_CASE("bad sensors, images and files are refused by the field's name") {
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    Light light(4, 4, 1);
    Raw raw(4, 4);
    const auto exposed = [&] { return nicol_sensor_expose(&sensor, &light.image, 0, &raw.image); };
    const auto refuses = [&](auto& field, auto value, const char* text) {
        const auto former = std::exchange(field, value);
        REFUSES(exposed(), text);
        field = former;
    };
    OK(exposed());
    refuses(sensor.bits, 14U, "bits of the sensor is 14; it must be 8, 10, 12 or 16");
    refuses(sensor.full_well, 0.0, "full_well of the sensor is 0");
    refuses(sensor.mosaic, 3U, "sensor->mosaic is 3");
    refuses(sensor.shot_noise, 2U, "sensor->shot_noise is 2; it must be 0 or 1");
    refuses(sensor.optics[5], HUGE_VAL, "optics[5] of the sensor is not finite");
    refuses(sensor.quantum_efficiency.count, 17U, "sensor->quantum_efficiency");
    refuses(sensor.reserved, 1U, "sensor->reserved must be 0");
    refuses(light.pixels[5], std::nanf(""), "column 1, row 0 is not finite");
    refuses(light.image.width, 0U, "light of 0 x 4 pixels");
    refuses(light.image.channels, 0U, "light->channels is 0");
    refuses(light.image.byte_size, std::uint64_t{255}, "byte_size is 255");
    refuses(raw.image.row_stride, std::uint64_t{9}, "row_stride is 9");
    light.image.width = light.image.height = raw.image.width = raw.image.height = 3;
    REFUSES(exposed(), "3 x 3 pixels; both sides must be multiples of 2");
    light = Light(4, 4, 3);
    raw = Raw(4, 4);
    REFUSES(nicol_sensor_demosaic(&sensor, &raw.image, NICOL_DEMOSAIC_BILINEAR, &light.image),
            "to has 4 x 4 pixels with 3 channels; the result has 4 x 4 with 1");
    REFUSES(nicol_sensor_demosaic(&sensor, &raw.image, 3, &light.image), "method is 3");
    REFUSES(nicol_sensor_set_preset(&sensor, 2), "preset is 2");
    nicol_polarization_element element = NICOL_POLARIZATION_ELEMENT_INIT;
    REFUSES(nicol_sensor_add_element(&sensor, &element, 0.5), "extinction_ratio is 0.5");
    element.to_world[3] = 1;
    REFUSES(nicol_sensor_add_element(&sensor, &element, 0), "element->to_world must be the identity");
    REFUSES(nicol_sensor_write_png(&sensor, &raw.image, "raw.jpg"), "raw.jpg ends in .jpg");
    FAILS(nicol_sensor_load(&sensor, "none.json"), NICOL_ERROR_FILE_NOT_FOUND, "none.json");
    nicol_memory_file json = NICOL_MEMORY_FILE_INIT;
    json.name = "camera.json";
    json.bytes = R"({"bits": 14})";
    json.byte_size = 12;
    FAILS(nicol_sensor_load_memory(&sensor, &json), NICOL_ERROR_INVALID_FILE, "camera.json: bits");
    REFUSES(nicol_sensor_load_memory(&sensor, nullptr), "file is NULL");
}
