// SPDX-License-Identifier: MIT
#include "planes.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace {

constexpr std::size_t kStokes = 4;
constexpr unsigned kMagnitude = 0x7fff;
constexpr int kFraction = 10;  // bits of a half below its exponent
constexpr unsigned kInfinity = 0x7c00;

/// Returns the exponent. Subnormal numbers have that of the smallest normal numbers.
int exponent_of(unsigned magnitude) {
    return std::max(static_cast<int>(magnitude >> kFraction), 1);
}

/// Returns the nearest multiple of 2^unit, with `unit` biased like the exponent of a half.
std::uint16_t rounded(std::uint16_t half, int unit) {
    const unsigned magnitude = half & kMagnitude;
    const int exponent = exponent_of(magnitude), dropped = unit + kFraction - exponent;
    if (dropped <= 0 || magnitude >= kInfinity) return half;
    unsigned result = 0;
    if (dropped <= kFraction) {
        const unsigned last = 1u << static_cast<unsigned>(dropped);
        result = (magnitude + last / 2) & ~(last - 1);  // may carry into the exponent
    } else if (dropped == kFraction + 1 && magnitude >> kFraction != 0) {
        result = static_cast<unsigned>(exponent + 1) << kFraction;
    }
    if (result == 0) return 0;
    return result >= kInfinity ? half : static_cast<std::uint16_t>(result | (half & ~kMagnitude));
}

void round_all(std::vector<std::uint16_t>& values, std::uint32_t bits) {
    for (std::size_t i = 0; i < values.size(); i += kStokes) {
        const int unit = exponent_of(values[i] & kMagnitude) - static_cast<int>(bits);
        for (std::size_t s = 0; s < kStokes; ++s) values[i + s] = rounded(values[i + s], unit);
    }
}

}  // namespace

Planes planes_of(std::string_view halves, std::uint32_t width, std::uint32_t height, std::uint32_t bits) {
    // Halves have the machine's byte order, which is little-endian on all supported machines.
    std::vector<std::uint16_t> values(halves.size() / sizeof(std::uint16_t));
    std::memcpy(values.data(), halves.data(), values.size() * sizeof(std::uint16_t));
    if (bits > 0) round_all(values, bits);
    std::uint32_t s3 = 0;
    for (std::size_t i = kStokes - 1; i < values.size(); i += kStokes) s3 |= values[i];
    Planes planes{.components = (s3 & kMagnitude) == 0 ? 3u : 4u, .bytes = {}};
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
