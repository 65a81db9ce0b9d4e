// SPDX-License-Identifier: MIT
// Sensors as JSON: an object whose keys are the members of Sensor.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "files/load_budget.hpp"
#include "sensor/sensor.hpp"

namespace nicol {

/// Returns the sensor as one line of JSON, from which parse_sensor() makes the same sensor.
[[nodiscard]] std::string sensor_json(const Sensor& sensor);

/// Returns `base` with the members that the text names. Other keys: "preset", the name of a preset, which
/// comes first, and "elements", a list of elements in front of the sensor in the order of the light, each
/// with "kind" (polarizer, retarder, right_circular, left_circular), "angle" and "retardance" (degrees),
/// "transmittance" and "extinction_ratio". Throws Error(invalid_file) that names `file` and the key.
[[nodiscard]] Sensor parse_sensor(const std::filesystem::path& file, std::string_view text, Sensor base);

/// Reads a JSON file, or the sensor in a mosaic that write_mosaic() wrote. Throws Error(file_not_found) and
/// what parse_sensor() throws. `budget` has the source of the file.
[[nodiscard]] Sensor read_sensor(const std::filesystem::path& file, const Sensor& base,
                                 const LoadBudget& budget = {});

}  // namespace nicol
