// SPDX-License-Identifier: MIT
#include "planes.hpp"

#include <cstring>
#include <vector>

namespace {

constexpr std::size_t kStokes = 4;

}  // namespace

Planes planes_of(std::string_view halves, std::uint32_t width, std::uint32_t height) {
    // The library's numbers are the machine's, which is little-endian wherever it is built.
    std::vector<std::uint16_t> values(halves.size() / sizeof(std::uint16_t));
    std::memcpy(values.data(), halves.data(), values.size() * sizeof(std::uint16_t));
    std::uint32_t s3 = 0;
    for (std::size_t i = kStokes - 1; i < values.size(); i += kStokes) s3 |= values[i];
    constexpr std::uint32_t magnitude = 0x7fff;
    Planes planes{.components = (s3 & magnitude) == 0 ? 3u : 4u, .bytes = {}};
    const std::size_t pixels = std::size_t{width} * height, channels = values.size() / kStokes / pixels;
    planes.bytes.resize(planes.components * channels * pixels * 2);
    char* low = planes.bytes.data();
    for (std::size_t component = 0; component < planes.components; ++component)
        for (std::size_t channel = 0; channel < channels; ++channel, low += 2 * pixels) {
            const std::uint16_t* from = values.data() + channel * pixels * kStokes + component;
            char* const high = low + pixels;
            for (std::size_t y = 0, i = 0; y < height; ++y) {
                unsigned left = 0;
                for (std::size_t x = 0; x < width; ++x, ++i) {
                    const unsigned value = from[i * kStokes], difference = value - left;
                    low[i] = static_cast<char>(difference & 0xffu);
                    high[i] = static_cast<char>(difference >> 8u & 0xffu);
                    left = value;
                }
            }
        }
    return planes;
}
