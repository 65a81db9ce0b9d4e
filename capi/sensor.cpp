// SPDX-License-Identifier: MIT
// Image sensors: raw mosaics of Stokes images, and Stokes images of raw mosaics.
#include "sensor/sensor.hpp"

#include <algorithm>
#include <cstring>
#include <numbers>

#include "element.hpp"
#include "initialiser.hpp"
#include "input_file.hpp"
#include "nicol_files.h"
#include "planes.hpp"
#include "progress.hpp"
#include "rows.hpp"
#include "sensor/angle_pictures.hpp"
#include "sensor/demosaic.hpp"
#include "sensor/mosaic_file.hpp"
#include "sensor/sensor_file.hpp"
#include "stokes_rows.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

static_assert(static_cast<int>(Mosaic::plain) == NICOL_MOSAIC_PLAIN &&
              static_cast<int>(Mosaic::polarized) == NICOL_MOSAIC_POLARIZED &&
              static_cast<int>(Mosaic::polarized_bayer) == NICOL_MOSAIC_POLARIZED_BAYER);
static_assert(static_cast<int>(Demosaic::bilinear) == NICOL_DEMOSAIC_BILINEAR &&
              static_cast<int>(Demosaic::blocks) == NICOL_DEMOSAIC_BLOCKS &&
              static_cast<int>(Demosaic::gradient) == NICOL_DEMOSAIC_GRADIENT);
static_assert(static_cast<int>(SensorPreset::imx250mzr) == NICOL_SENSOR_PRESET_IMX250MZR &&
              static_cast<int>(SensorPreset::imx250myr) == NICOL_SENSOR_PRESET_IMX250MYR);

/// Fields of nicol_sensor that are numbers with the same name and unit as members of Sensor.
struct NumberField {
    double nicol_sensor::*field;
    double Sensor::*member;
};
constexpr std::array kNumbers{NumberField{&nicol_sensor::exposure, &Sensor::exposure},
                              NumberField{&nicol_sensor::exposure_time, &Sensor::exposure_time},
                              NumberField{&nicol_sensor::full_well, &Sensor::full_well},
                              NumberField{&nicol_sensor::gain, &Sensor::gain},
                              NumberField{&nicol_sensor::black_level, &Sensor::black_level},
                              NumberField{&nicol_sensor::read_noise, &Sensor::read_noise},
                              NumberField{&nicol_sensor::dark_current, &Sensor::dark_current},
                              NumberField{&nicol_sensor::dsnu, &Sensor::dsnu},
                              NumberField{&nicol_sensor::prnu, &Sensor::prnu},
                              NumberField{&nicol_sensor::extinction_ratio, &Sensor::extinction_ratio},
                              NumberField{&nicol_sensor::extinction_spread, &Sensor::extinction_spread},
                              NumberField{&nicol_sensor::misalignment, &Sensor::misalignment},
                              NumberField{&nicol_sensor::crosstalk, &Sensor::crosstalk},
                              NumberField{&nicol_sensor::crosstalk_spread, &Sensor::crosstalk_spread},
                              NumberField{&nicol_sensor::blur, &Sensor::blur},
                              NumberField{&nicol_sensor::vignetting, &Sensor::vignetting}};

nicol_sensor read_sensor_struct(const nicol_sensor* sensor) {
    return read_struct(sensor, nicol_sensor NICOL_SENSOR_INIT, "sensor");
}

Sensor sensor_from(const nicol_sensor& given) {
    require_constant(given.mosaic, NICOL_MOSAIC_POLARIZED_BAYER, "sensor->mosaic", "NICOL_MOSAIC_...");
    if (given.reserved != 0) refuse("sensor->reserved must be 0");
    Sensor sensor;
    sensor.mosaic = static_cast<Mosaic>(given.mosaic);
    sensor.bits = static_cast<int>(std::min(given.bits, 99U));
    sensor.shot_noise = switch_from(given.shot_noise, "sensor->shot_noise");
    sensor.seed = given.seed;
    for (std::size_t i = 0; i < 16; ++i) sensor.optics(i / 4, i % 4) = given.optics[i];
    for (const auto& [field, member] : kNumbers) sensor.*member = given.*field;
    sensor.quantum_efficiency =
        spectrum(given.quantum_efficiency, sensor.quantum_efficiency[0], 1, "sensor->quantum_efficiency");
    check(sensor);
    return sensor;
}

Sensor sensor_from(const nicol_sensor* sensor) {
    return sensor_from(read_sensor_struct(sensor));
}

void write_sensor(nicol_sensor* to, const Sensor& sensor) {
    nicol_sensor out = NICOL_SENSOR_INIT;
    out.mosaic = static_cast<nicol_mosaic>(sensor.mosaic);
    out.bits = static_cast<std::uint32_t>(sensor.bits);
    out.shot_noise = sensor.shot_noise ? 1 : 0;
    out.seed = sensor.seed;
    for (std::size_t i = 0; i < 16; ++i) out.optics[i] = sensor.optics(i / 4, i % 4);
    for (const auto& [field, member] : kNumbers) out.*field = sensor.*member;
    out.quantum_efficiency.count = static_cast<std::uint32_t>(sensor.quantum_efficiency.size());
    std::ranges::transform(sensor.quantum_efficiency, out.quantum_efficiency.values,
                           [](double value) { return static_cast<float>(value); });
    write_struct(to, out, "sensor");
}

/// Numbers of pixels in the caller's memory.
class RawRows {
public:
    RawRows(const nicol_raw_image* given, const char* name)
        : image_(read_struct(given, nicol_raw_image NICOL_RAW_IMAGE_INIT, name)) {
        require_size(name, image_.width, image_.height);
        if (image_.reserved != 0) refuse(std::string(name) + "->reserved must be 0");
        rows_.emplace(image_.pixels, image_.row_stride, image_.byte_size, sizeof(std::uint16_t),
                      std::size_t{image_.width}, static_cast<int>(image_.height));
    }

    [[nodiscard]] RawImage read() const {
        RawImage raw{static_cast<int>(image_.width), static_cast<int>(image_.height), {}};
        for (int y = 0; y < raw.height; ++y) {
            const auto* row = reinterpret_cast<const std::uint16_t*>(rows_->row(y));
            raw.values.insert(raw.values.end(), row, row + raw.width);
        }
        return raw;
    }
    void require_size_of(int width, int height) const {
        if (std::cmp_not_equal(image_.width, width) || std::cmp_not_equal(image_.height, height))
            refuse("to has " + std::to_string(image_.width) + " x " + std::to_string(image_.height) +
                   " pixels; the light has " + std::to_string(width) + " x " + std::to_string(height));
    }
    void write(const RawImage& raw) const {
        const auto width = static_cast<std::size_t>(raw.width);
        for (int y = 0; y < raw.height; ++y)
            std::memcpy(rows_->row(y), raw.values.data() + static_cast<std::size_t>(y) * width,
                        width * sizeof(std::uint16_t));
    }

private:
    nicol_raw_image image_;
    std::optional<Rows> rows_;
};

}  // namespace

nicol_result nicol_sensor_set_preset(nicol_sensor* sensor, nicol_sensor_preset preset) {
    return guarded([&] {
        const Sensor former = sensor_from(sensor);
        require_constant(preset, NICOL_SENSOR_PRESET_IMX250MYR, "preset", "NICOL_SENSOR_PRESET_...");
        write_sensor(sensor, with_preset(former, static_cast<SensorPreset>(preset)));
    });
}

nicol_result nicol_sensor_load(nicol_sensor* sensor, const char* path) {
    return guarded([&] {
        const Sensor former = sensor_from(sensor);
        write_sensor(sensor, read_sensor(read_path(path, "path"), former));
    });
}

nicol_result nicol_sensor_load_memory(nicol_sensor* sensor, const nicol_memory_file* file) {
    return guarded([&] {
        const Sensor former = sensor_from(sensor);
        const InputFile input = input_file(file, {});
        write_sensor(sensor, read_sensor(input.name, former, input.budget));
    });
}

nicol_result nicol_sensor_add_element(nicol_sensor* sensor, const nicol_polarization_element* element,
                                      double extinction_ratio) {
    return guarded([&] {
        Sensor out = sensor_from(sensor);
        const nicol_polarization_element given = read_element(element);
        if (given.angle_texture != nullptr || given.retardance_texture != nullptr)
            refuse("a sensor's element has a texture; it must have none");
        const PolarizationElement added = element_from(given);
        if (added.to_world != glm::dmat4(1.0))
            refuse("element->to_world must be the identity: the element faces the camera");
        out.optics = in_front(added, extinction_ratio) * out.optics;
        write_sensor(sensor, out);
    });
}

nicol_result nicol_sensor_expose(const nicol_sensor* sensor, const nicol_stokes_image* light, uint64_t frame,
                                 const nicol_raw_image* to) {
    return guarded([&] {
        const Sensor own = sensor_from(sensor);
        const StokesImage image = StokesRows(light, "light").read();
        const RawRows rows(to, "to");
        rows.require_size_of(image.width, image.height);
        rows.write(expose(own, image, frame));
    });
}

nicol_result nicol_framebuffer_expose(nicol_framebuffer framebuffer, const nicol_sensor* sensor,
                                      uint64_t frame, const nicol_raw_image* to) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const Sensor own = sensor_from(sensor);
        const RawRows rows(to, "to");
        const Access access(self);
        rows.require_size_of(self.content->width(), self.content->height());
        const StokesImage& image = self.content->image();
        const Stopwatch watch;
        rows.write(self.session->on_workers([&] { return expose(own, image, frame); }));
        self.content->statistics().observe_ms += watch.milliseconds();
    });
}

nicol_result nicol_sensor_write_png(const nicol_sensor* sensor, const nicol_raw_image* raw,
                                    const char* path) {
    return guarded([&] {
        const Sensor own = sensor_from(sensor);
        const RawImage image = RawRows(raw, "raw").read();
        const std::filesystem::path file = read_path(path, "path");
        require_suffix(path, ".png");
        write_mosaic(file, own, image);
    });
}

nicol_result nicol_sensor_demosaic(const nicol_sensor* sensor, const nicol_raw_image* raw,
                                   nicol_demosaic method, const nicol_stokes_image* to) {
    return guarded([&] {
        const Sensor own = sensor_from(sensor);
        const RawImage image = RawRows(raw, "raw").read();
        require_constant(method, NICOL_DEMOSAIC_GRADIENT, "method", "NICOL_DEMOSAIC_...");
        const StokesRows rows(to, "to");
        StokesImage stokes = demosaic(own, image, static_cast<Demosaic>(method));
        rows.write(stokes);
    });
}

nicol_result nicol_file_demosaic(const char* in, const nicol_sensor* sensor, nicol_demosaic method,
                                 const char* out) {
    return guarded([&] {
        const std::filesystem::path from = read_path(in, "in");
        const Sensor own = sensor_from(sensor);
        require_constant(method, NICOL_DEMOSAIC_GRADIENT, "method", "NICOL_DEMOSAIC_...");
        const std::filesystem::path to = read_path(out, "out");
        require_suffix(out, ".exr");
        write_exr(to, demosaic(own, read_mosaic(from, own), static_cast<Demosaic>(method)));
    });
}

nicol_result nicol_file_combine_angles(const char* at_0, const char* at_45, const char* at_90,
                                       const char* at_135, const char* out) {
    return guarded([&] {
        const std::array<std::filesystem::path, 4> files{read_path(at_0, "at_0"), read_path(at_45, "at_45"),
                                                         read_path(at_90, "at_90"),
                                                         read_path(at_135, "at_135")};
        const std::filesystem::path to = read_path(out, "out");
        require_suffix(out, ".exr");
        write_exr(to, read_angle_pictures(files));
    });
}

NICOL_INITIALISER(nicol_sensor, NICOL_SENSOR_INIT)
NICOL_INITIALISER(nicol_stokes_image, NICOL_STOKES_IMAGE_INIT)
NICOL_INITIALISER(nicol_raw_image, NICOL_RAW_IMAGE_INIT)
