// SPDX-License-Identifier: MIT
// Mosaics as PNG files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sensor/expose.hpp"

namespace nicol {

/// Writes the numbers as grey of 8 bits, or of 16 bits if the sensor has more than 8. Text chunks:
/// Nicol:Mosaic, the layout and its angles; Nicol:Bits; Nicol:Sensor, the sensor as JSON. Throws
/// Error(invalid_argument) for a number above the sensor's largest one, and Error(write_failed).
void write_mosaic(const std::filesystem::path& file, const Sensor& sensor, const RawImage& raw);

/// Reads the numbers of a grey image. Throws what read_bitmap() throws, and Error(invalid_file) for colours
/// and for a number above the sensor's largest one.
[[nodiscard]] RawImage read_mosaic(const std::filesystem::path& file, const Sensor& sensor);

/// Returns whether the bytes are those of a PNG file.
[[nodiscard]] bool is_png(std::string_view bytes);
/// Returns the text of a PNG's tEXt chunk with this keyword; empty if there is none.
[[nodiscard]] std::string png_text(std::string_view bytes, std::string_view keyword);

/// Keyword of the chunk with the sensor as JSON.
inline constexpr const char* kSensorKeyword = "Nicol:Sensor";

}  // namespace nicol
