// SPDX-License-Identifier: MIT
#include "image.hpp"

#include <algorithm>
#include <cmath>

#include "common/handles.hpp"

namespace {

// Tolerance for drawing, whose interpolation has errors relative to a triangle's brightest corner.
constexpr float kRounding = 1e-4F;

}  // namespace

Image read_image(nicol_framebuffer framebuffer) {
    std::uint32_t width = 0, height = 0, channels = 0;
    check(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    Image image{.size = width, .stokes = {}, .object = {}};
    for (std::uint32_t c = 0; c < 3; ++c) {
        std::vector<float>& plane = image.stokes[c];
        plane.resize(4 * image.size * image.size);
        check(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, c, plane.data(), 0,
                                     plane.size() * sizeof(float)));
    }
    return image;
}

Fault fault_at(const Image& image, std::size_t pixel) {
    Fault fault = Fault::none;
    for (const auto& plane : image.stokes) {
        const float* s = &plane[4 * pixel];
        if (s[0] < -kRounding) return Fault::negative;
        if (s[0] * (1 + kRounding) + kRounding < std::hypot(s[1], s[2], s[3])) fault = Fault::overpolarized;
    }
    return fault;
}

RealizableRange realizable_range(const Image& image) {
    const std::vector<std::uint8_t>& mask = image.object;
    double pixels = 0;
    RealizableRange range;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        const Fault fault = fault_at(image, i);
        pixels += 1;
        range.negative += fault == Fault::negative ? 1 : 0;
        range.overpolarized += fault == Fault::overpolarized ? 1 : 0;
    }
    return {.negative = range.negative / pixels, .overpolarized = range.overpolarized / pixels};
}

std::vector<std::uint8_t> eroded(const std::vector<std::uint8_t>& mask, std::size_t size) {
    std::vector<std::uint8_t> out(mask.size(), 0);
    for (std::size_t y = 1; y + 1 < size; ++y) {
        for (std::size_t x = 1; x + 1 < size; ++x) {
            bool inside = true;
            for (std::size_t v = y - 1; v <= y + 1; ++v) {
                for (std::size_t u = x - 1; u <= x + 1; ++u) inside = inside && mask[v * size + u] != 0;
            }
            out[y * size + x] = inside;
        }
    }
    return out;
}

std::array<double, 3> relative_errors(const Image& image, const std::array<Image, 2>& truth,
                                      const std::vector<std::uint8_t>& mask) {
    std::array<double, 3> sums{};
    double power = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (mask[i] == 0) continue;
            const float* a = &truth[0].stokes[c][4 * i];
            const float* b = &truth[1].stokes[c][4 * i];
            for (std::size_t p = 0; p < 3; ++p) {
                const double x = image.stokes[c][4 * i + p];
                sums[p] += (x - double{a[p]}) * (x - double{b[p]});
            }
            power += double{a[0]} * double{b[0]};
        }
    }
    std::array<double, 3> errors{};
    if (!(power > 0)) return errors;
    for (std::size_t p = 0; p < 3; ++p) errors[p] = std::sqrt(std::max(sums[p], 0.0) / power);
    return errors;
}
