// SPDX-License-Identifier: MIT
#include "sensor/mosaic_file.hpp"

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "files/file_error.hpp"
#include "files/read_bytes.hpp"
#include "image/bitmap.hpp"
#include "image/png.hpp"
#include "sensor/sensor_file.hpp"

namespace nicol {
namespace {

std::size_t big_endian(std::string_view bytes) {
    std::size_t value = 0;
    for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
}

const char* layout_text(Mosaic mosaic) {
    switch (mosaic) {
        case Mosaic::plain:
            return "plain";
        case Mosaic::polarized:
            return "polarized 90 45 / 135 0, degrees counter-clockwise from image right";
        default:
            return "polarized_bayer 90 45 / 135 0, degrees counter-clockwise from image right, each 2 x 2 "
                   "under "
                   "one of R G / G B";
    }
}

}  // namespace

bool is_png(std::string_view bytes) {
    return bytes.starts_with(kPngSignature);
}

std::string png_text(std::string_view bytes, std::string_view keyword) {
    // A chunk: length of the data, type, data, checksum.
    constexpr std::size_t frame = 12;
    for (bytes.remove_prefix(std::min(bytes.size(), kPngSignature.size())); bytes.size() >= frame;) {
        const std::size_t length = big_endian(bytes);
        if (length > bytes.size() - frame) break;
        const std::string_view data = bytes.substr(8, length);
        if (bytes.substr(4, 4) == "tEXt" && data.size() > keyword.size() && data.starts_with(keyword) &&
            data[keyword.size()] == '\0')
            return std::string(data.substr(keyword.size() + 1));
        bytes.remove_prefix(frame + length);
    }
    return {};
}

void write_mosaic(const std::filesystem::path& file, const Sensor& sensor, const RawImage& raw) {
    check(sensor, raw.width, raw.height, sensor.mosaic == Mosaic::polarized_bayer ? 3 : 1);
    const auto largest = std::ranges::max_element(raw.values);
    if (largest != raw.values.end() && *largest > largest_number(sensor))
        refuse("the mosaic has the number " + std::to_string(*largest) + "; a sensor of " +
               std::to_string(sensor.bits) + " bits gives at most " +
               std::to_string(static_cast<int>(largest_number(sensor))));
    const bool deep = sensor.bits > 8;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(raw.values.size() * (deep ? 2 : 1));
    for (const std::uint16_t number : raw.values) {
        if (deep) bytes.push_back(static_cast<std::uint8_t>(number >> 8));
        bytes.push_back(static_cast<std::uint8_t>(number & 0xff));
    }
    const std::array<std::pair<std::string, std::string>, 3> text{
        {{"Nicol:Mosaic", layout_text(sensor.mosaic)},
         {"Nicol:Bits", std::to_string(sensor.bits)},
         {kSensorKeyword, sensor_json(sensor)}}};
    write_png(file, PngImage{.width = raw.width,
                             .height = raw.height,
                             .grey = true,
                             .deep = deep,
                             .bytes = bytes,
                             .text = text,
                             .noisy = true});
}

RawImage read_mosaic(const std::filesystem::path& file, const Sensor& sensor) {
    const std::string bytes = read_bytes(file);
    const Bitmap bitmap = read_bitmap(file, bytes);
    if (bitmap.channels != 1)
        invalid_file(file, "has " + std::to_string(bitmap.channels) +
                               " channels; a mosaic is grey, one number per pixel");
    // The header is the first chunk, with the bits of a number in its ninth byte.
    constexpr std::size_t bits_at = 8 + 8 + 8;
    const float largest = is_png(bytes) && bytes[bits_at] == 16 ? 65535.0F : 255.0F;
    RawImage raw{bitmap.width, bitmap.height, {}};
    for (const float value : bitmap.values) {
        const auto number = static_cast<std::uint16_t>(std::lround(value * largest));
        if (number > largest_number(sensor))
            invalid_file(file, "has the number " + std::to_string(number) + "; a sensor of " +
                                   std::to_string(sensor.bits) + " bits gives at most " +
                                   std::to_string(static_cast<int>(largest_number(sensor))));
        raw.values.push_back(number);
    }
    return raw;
}

}  // namespace nicol
