// SPDX-License-Identifier: MIT
#include "sensor/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "arguments.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

struct Range {
    const char* name;
    double value;
    double least;
    double most;
    const char* meaning;
};

std::string text_of(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

void check(const Range& range) {
    if (range.value >= range.least && range.value <= range.most) return;
    refuse(std::string(range.name) + " of the sensor is " + text_of(range.value) + "; it must lie in " +
           text_of(range.least) + " to " + text_of(range.most) + ": " + range.meaning);
}

void check_extinction(double ratio, const std::string& name) {
    if (ratio != 0 && !(ratio >= 1 && std::isfinite(ratio)))
        refuse(name + " is " + text_of(ratio) + "; it must be at least 1, or 0 for an ideal polarizer");
}

}  // namespace

void check(const Sensor& sensor) {
    if (sensor.mosaic > Mosaic::polarized_bayer)
        refuse("mosaic of the sensor must be plain, polarized or polarized_bayer");
    constexpr std::array depths{8, 10, 12, 16};
    if (std::ranges::find(depths, sensor.bits) == depths.end())
        refuse("bits of the sensor is " + std::to_string(sensor.bits) + "; it must be 8, 10, 12 or 16");
    const double largest = largest_number(sensor);
    const std::array ranges{
        Range{"exposure", sensor.exposure, 0, 1e12, "photons for s0 = 1, 0: automatic"},
        Range{"exposure_time", sensor.exposure_time, 0, 1e6, "seconds"},
        Range{"full_well", sensor.full_well, 1, 1e9, "electrons"},
        Range{"gain", sensor.gain, 0, 1e6, "numbers per electron, 0: automatic"},
        Range{"black_level", sensor.black_level, 0, largest - 1, "number without electrons"},
        Range{"read_noise", sensor.read_noise, 0, 1e6, "electrons"},
        Range{"dark_current", sensor.dark_current, 0, 1e9, "electrons per second"},
        Range{"dsnu", sensor.dsnu, 0, 1e6, "electrons"},
        Range{"prnu", sensor.prnu, 0, 1, "relative"},
        Range{"extinction_spread", sensor.extinction_spread, 0, 1, "relative"},
        Range{"misalignment", sensor.misalignment, 0, 5, "degrees"},
        Range{"crosstalk", sensor.crosstalk, 0, 0.8, "fraction of a pixel's electrons"},
        Range{"crosstalk_spread", sensor.crosstalk_spread, 0, 1, "relative"},
        Range{"blur", sensor.blur, 0, 16, "pixels"},
        Range{"vignetting", sensor.vignetting, 0, 0.99, "part of the light"}};
    for (const Range& range : ranges) check(range);
    check_extinction(sensor.extinction_ratio, "extinction_ratio of the sensor");
    const std::size_t efficiencies = sensor.quantum_efficiency.size();
    if (efficiencies < 1 || efficiencies > kMaxFileChannels)
        refuse("quantum_efficiency of the sensor has " + std::to_string(efficiencies) +
               " values; it must have 1, or one per channel, at most " + std::to_string(kMaxFileChannels));
    for (const double efficiency : sensor.quantum_efficiency)
        if (!(efficiency > 0 && efficiency <= 1))
            refuse("quantum_efficiency of the sensor is " + text_of(efficiency) +
                   "; it must be above 0 and at most 1");
    for (std::size_t i = 0; i < 16; ++i)
        if (!std::isfinite(sensor.optics(i / 4, i % 4)))
            refuse("optics[" + std::to_string(i) + "] of the sensor is not finite");
}

void check(const Sensor& sensor, int width, int height, int channels) {
    check(sensor);
    const int cell = cell_side(sensor.mosaic);
    if (width % cell != 0 || height % cell != 0)
        refuse("the image has " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels; both sides must be multiples of " + std::to_string(cell) + ", the mosaic's cell");
    if (sensor.mosaic == Mosaic::polarized_bayer && channels != 3)
        refuse("the image has " + std::to_string(channels) +
               " channels; a mosaic with colour filters needs 3");
    const std::size_t efficiencies = sensor.quantum_efficiency.size();
    if (efficiencies != 1 && efficiencies != static_cast<std::size_t>(channels))
        refuse("quantum_efficiency of the sensor has " + std::to_string(efficiencies) +
               " values; the image has " + std::to_string(channels) + " channels");
}

int cell_side(Mosaic mosaic) {
    constexpr std::array sides{1, 2, 4};
    return sides[static_cast<std::size_t>(mosaic)];
}

double largest_number(const Sensor& sensor) {
    return static_cast<double>((1 << sensor.bits) - 1);
}

double gain_of(const Sensor& sensor) {
    if (sensor.gain > 0) return sensor.gain;
    return (largest_number(sensor) - sensor.black_level) / sensor.full_well;
}

double electrons_of(const Sensor& sensor, std::size_t channel) {
    const std::vector<double>& efficiency = sensor.quantum_efficiency;
    const double own = efficiency[std::min(channel, efficiency.size() - 1)];
    if (sensor.exposure > 0) return own * sensor.exposure;
    const double passed = sensor.mosaic == Mosaic::plain ? 1 : 0.5;
    return own / *std::ranges::max_element(efficiency) * sensor.full_well / passed;
}

// A polarizer that transmits t along its axis and e t across is t (sqrt(e) + (1 - sqrt(e)) P - sqrt(e) (1 -
// sqrt(e)) Q), where P is the ideal polarizer and Q the one across it.
Mueller in_front(const PolarizationElement& element, double extinction_ratio) {
    check(element);
    check_extinction(extinction_ratio, "extinction_ratio");
    const auto ideal = [&](double angle) {
        PolarizationElement placed = element;
        placed.to_world = glm::dmat4(1.0);
        placed.angle = angle;
        return PlacedElement(placed).mueller(Frame(1.0));
    };
    Mueller matrix = ideal(element.angle);
    if (element.kind == PolarizationElement::Kind::polarizer && extinction_ratio > 0) {
        const double root = 1 / std::sqrt(extinction_ratio);
        matrix = root * element.transmittance * Sensor::unchanged() + (1 - root) * matrix +
                 -root * (1 - root) * ideal(element.angle + std::numbers::pi / 2);
    }
    // Machines differ in the last bits of sines and cosines. Rounded, they expose a sensor to the same light.
    for (std::size_t i = 0; i < 16; ++i)
        matrix(i / 4, i % 4) = std::nearbyint(matrix(i / 4, i % 4) * 0x1p40) * 0x1p-40;
    return matrix;
}

Sensor with_preset(Sensor sensor, SensorPreset preset) {
    if (preset > SensorPreset::imx250myr) refuse("preset must be one of the sensors");
    sensor.mosaic = preset == SensorPreset::imx250mzr ? Mosaic::polarized : Mosaic::polarized_bayer;
    sensor.bits = 12;
    // MATRIX VISION mvBlueFOX3 Technical Documentation, mvBlueFOX3-2051 (IMX250, measured by EMVA 1288 with
    // the grey version): SNRmax 40.3 dB, dynamic range 71.2 dB, 12 bits. The full well is the square of
    // SNRmax, and the read noise the full well over the dynamic range. Teledyne DALSA's Genie Nano
    // M2450-Polarized (IMX250MZR) states at most 11,000 electrons.
    sensor.full_well = 10715;
    sensor.read_noise = 2.95;
    return sensor;
}

}  // namespace nicol
