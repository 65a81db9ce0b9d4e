// SPDX-License-Identifier: MIT
#include "exr.hpp"

#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little, "OpenEXR files are little-endian");

namespace {

template <typename T>
void put(std::string& to, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    to.append(bytes, sizeof value);
}

void attribute(std::string& to, const char* name, const char* type, const std::string& value) {
    to.append(name).append(1, '\0').append(type).append(1, '\0');
    put(to, static_cast<std::int32_t>(value.size()));
    to += value;
}

std::string header(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& names) {
    std::string channels, window, centre, one;
    for (const std::string& name : names) {
        channels.append(name).append(1, '\0');
        put<std::int32_t>(channels, 2);  // pixel type: 32-bit float
        put<std::int32_t>(channels, 0);
        put<std::int32_t>(channels, 1);
        put<std::int32_t>(channels, 1);
    }
    channels.append(1, '\0');
    put<std::int32_t>(window, 0);
    put<std::int32_t>(window, 0);
    put(window, static_cast<std::int32_t>(width - 1));
    put(window, static_cast<std::int32_t>(height - 1));
    put(centre, 0.0f);
    put(centre, 0.0f);
    put(one, 1.0f);

    std::string text;
    put<std::int32_t>(text, 20000630);  // the format's magic number
    put<std::int32_t>(text, 2);         // version 2, scan lines
    attribute(text, "channels", "chlist", channels);
    attribute(text, "compression", "compression", std::string(1, '\0'));
    attribute(text, "dataWindow", "box2i", window);
    attribute(text, "displayWindow", "box2i", window);
    attribute(text, "lineOrder", "lineOrder", std::string(1, '\0'));
    attribute(text, "pixelAspectRatio", "float", one);
    attribute(text, "screenWindowCenter", "v2f", centre);
    attribute(text, "screenWindowWidth", "float", one);
    return text.append(1, '\0');
}

}  // namespace

std::string encode_exr(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& names,
                       const std::vector<float>& data) {
    const std::size_t count = names.size(), line = std::size_t{width} * count * sizeof(float);
    std::string file = header(width, height, names);
    const std::size_t first = file.size() + std::size_t{height} * 8;
    file.reserve(first + height * (line + 8));
    for (std::uint32_t y = 0; y < height; ++y) put<std::uint64_t>(file, first + y * (line + 8));
    for (std::uint32_t y = 0; y < height; ++y) {
        put(file, y);
        put(file, static_cast<std::uint32_t>(line));
        const float* row = data.data() + std::size_t{y} * width * count;
        for (std::size_t c = 0; c < count; ++c)
            for (std::uint32_t x = 0; x < width; ++x) put(file, row[x * count + c]);
    }
    return file;
}
