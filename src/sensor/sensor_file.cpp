// SPDX-License-Identifier: MIT
#include "sensor/sensor_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "error.hpp"
#include "files/file_error.hpp"
#include "files/json.hpp"
#include "files/read_bytes.hpp"
#include "sensor/mosaic_file.hpp"
#include "shortest_text.hpp"

namespace nicol {
namespace {

struct NumberKey {
    const char* name;
    double Sensor::*member;
};
constexpr std::array kNumbers{NumberKey{"exposure", &Sensor::exposure},
                              NumberKey{"exposure_time", &Sensor::exposure_time},
                              NumberKey{"full_well", &Sensor::full_well},
                              NumberKey{"gain", &Sensor::gain},
                              NumberKey{"black_level", &Sensor::black_level},
                              NumberKey{"read_noise", &Sensor::read_noise},
                              NumberKey{"dark_current", &Sensor::dark_current},
                              NumberKey{"dsnu", &Sensor::dsnu},
                              NumberKey{"prnu", &Sensor::prnu},
                              NumberKey{"extinction_ratio", &Sensor::extinction_ratio},
                              NumberKey{"extinction_spread", &Sensor::extinction_spread},
                              NumberKey{"misalignment", &Sensor::misalignment},
                              NumberKey{"crosstalk", &Sensor::crosstalk},
                              NumberKey{"crosstalk_spread", &Sensor::crosstalk_spread},
                              NumberKey{"blur", &Sensor::blur},
                              NumberKey{"vignetting", &Sensor::vignetting}};
constexpr std::array kMosaics{"plain", "polarized", "polarized_bayer"};
constexpr std::array kPresets{"imx250mzr", "imx250myr"};
constexpr std::array kKinds{"polarizer", "retarder", "right_circular", "left_circular"};

/// Reader of one file's values, whose errors name the file and the key.
class Values {
public:
    explicit Values(const std::filesystem::path& file) : file_(file) {}

    [[noreturn]] void wrong(const std::string& key, const std::string& wanted) const {
        invalid_file(file_, "\"" + key + "\" must be " + wanted);
    }
    [[nodiscard]] double number(const std::string& key, const Json& value) const {
        if (!value.is_number()) wrong(key, "a number");
        return value.get<double>();
    }
    template <std::size_t n>
    [[nodiscard]] std::size_t name(const std::string& key, const Json& value,
                                   const std::array<const char*, n>& names) const {
        std::string all;
        for (std::size_t i = 0; i < n; ++i) {
            if (value.is_string() && value.get_ref<const std::string&>() == names[i]) return i;
            all += (i == 0 ? "" : ", ") + std::string(names[i]);
        }
        wrong(key, "one of: " + all);
    }
    [[nodiscard]] std::vector<double> numbers(const std::string& key, const Json& value) const {
        if (!value.is_array()) return {number(key, value)};
        std::vector<double> all;
        for (const Json& item : value) all.push_back(number(key, item));
        return all;
    }
    [[nodiscard]] Mueller matrix(const std::string& key, const Json& value) const {
        const std::vector<double> rows = numbers(key, value);
        if (rows.size() != 16) wrong(key, "16 numbers, row by row");
        Mueller matrix;
        for (std::size_t i = 0; i < 16; ++i) matrix(i / 4, i % 4) = rows[i];
        return matrix;
    }
    [[nodiscard]] Mueller element(const Json& value) const {
        if (!value.is_object()) wrong("elements", "a list of objects");
        PolarizationElement element;
        double extinction_ratio = 0;
        for (const auto& [key, member] : value.items()) {
            const std::string full = "elements." + key;
            if (key == "kind")
                element.kind = static_cast<PolarizationElement::Kind>(name(full, member, kKinds));
            else if (key == "angle")
                element.angle = number(full, member) * std::numbers::pi / 180;
            else if (key == "retardance")
                element.retardance = number(full, member) * std::numbers::pi / 180;
            else if (key == "transmittance")
                element.transmittance = number(full, member);
            else if (key == "extinction_ratio")
                extinction_ratio = number(full, member);
            else
                wrong(full, "one of: kind, angle, retardance, transmittance, extinction_ratio");
        }
        return in_front(element, extinction_ratio);
    }

private:
    const std::filesystem::path& file_;
};

void set(Sensor& sensor, const std::string& key, const Json& value, const Values& values) {
    for (const auto& [name, member] : kNumbers)
        if (key == name) {
            sensor.*member = values.number(key, value);
            return;
        }
    if (key == "preset") return;  // was read first
    if (key == "mosaic") {
        sensor.mosaic = static_cast<Mosaic>(values.name(key, value, kMosaics));
    } else if (key == "bits") {
        if (!value.is_number_integer()) values.wrong(key, "8, 10, 12 or 16");
        sensor.bits =
            static_cast<int>(std::clamp(value.get<std::int64_t>(), std::int64_t{0}, std::int64_t{99}));
    } else if (key == "seed") {
        if (!value.is_number_unsigned()) values.wrong(key, "a whole number of at least 0");
        sensor.seed = value.get<std::uint64_t>();
    } else if (key == "shot_noise") {
        if (!value.is_boolean()) values.wrong(key, "true or false");
        sensor.shot_noise = value.get<bool>();
    } else if (key == "quantum_efficiency") {
        sensor.quantum_efficiency = values.numbers(key, value);
    } else if (key == "optics") {
        sensor.optics = values.matrix(key, value);
    } else if (key == "elements") {
        if (!value.is_array()) values.wrong(key, "a list of objects");
        for (const Json& item : value) sensor.optics = values.element(item) * sensor.optics;
    } else {
        std::string all = "preset, mosaic, bits, seed, shot_noise, quantum_efficiency, optics, elements";
        for (const auto& [name, member] : kNumbers) all += std::string(", ") + name;
        values.wrong(key, "one of: " + all);
    }
}

Sensor sensor_of(const std::filesystem::path& file, const Json& root, Sensor sensor) {
    const Values values(file);
    if (!root.is_object()) invalid_file(file, "is not a sensor: a JSON object");
    if (const auto preset = root.find("preset"); preset != root.end())
        sensor = with_preset(sensor, static_cast<SensorPreset>(values.name("preset", *preset, kPresets)));
    for (const auto& [key, value] : root.items()) set(sensor, key, value, values);
    check(sensor);
    return sensor;
}

}  // namespace

std::string sensor_json(const Sensor& sensor) {
    const auto list = [](std::size_t count, const auto& item) {
        std::string out;
        for (std::size_t i = 0; i < count; ++i) out += (i == 0 ? "" : ", ") + shortest_text(item(i));
        return "[" + out + "]";
    };
    std::string out =
        R"({"mosaic": ")" + std::string(kMosaics[static_cast<std::size_t>(sensor.mosaic)]) +
        R"(", "bits": )" + std::to_string(sensor.bits) + R"(, "seed": )" + std::to_string(sensor.seed) +
        R"(, "shot_noise": )" + (sensor.shot_noise ? "true" : "false") + R"(, "quantum_efficiency": )" +
        list(sensor.quantum_efficiency.size(), [&](std::size_t i) { return sensor.quantum_efficiency[i]; }) +
        R"(, "optics": )" + list(16, [&](std::size_t i) { return sensor.optics(i / 4, i % 4); });
    for (const auto& [name, member] : kNumbers)
        out += R"(, ")" + std::string(name) + R"(": )" + shortest_text(sensor.*member);
    return out + "}";
}

Sensor parse_sensor(const std::filesystem::path& file, std::string_view text, Sensor base) {
    constexpr std::size_t most = std::size_t{1} << 20;
    if (text.size() > most) invalid_file(file, "is larger than a sensor can be, 1 MiB");
    const JsonRoom room(text);
    try {
        const Json root = Json::parse(text);
        return sensor_of(file, root, std::move(base));
    } catch (const Json::exception& error) {
        invalid_file(file, std::string("is not JSON: ") + error.what());
    } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_argument) throw;
        invalid_file(file, error.what());
    }
}

Sensor read_sensor(const std::filesystem::path& file, const Sensor& base, const LoadBudget& budget) {
    const std::string bytes = read_bytes(file, budget);
    if (!is_png(bytes)) return parse_sensor(file, bytes, base);
    const std::string text = png_text(bytes, kSensorKeyword);
    if (text.empty())
        invalid_file(file, std::string("has no text ") + kSensorKeyword +
                               "; give the sensor as a JSON file of its own");
    return parse_sensor(file, text, base);
}

}  // namespace nicol
