// SPDX-License-Identifier: MIT
#include "texture/image_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace nicol {
namespace {

/// Weights of the texels that a texel of the next level covers along one axis: two texels of this level, or
/// parts of three.
struct Taps {
    int first = 0;
    std::array<float, 3> weights{};
};

std::vector<Taps> halving_taps(int size) {
    const int half = std::max(1, size / 2);
    const double step = static_cast<double>(size) / half;
    std::vector<Taps> taps(static_cast<std::size_t>(half));
    for (int i = 0; i < half; ++i) {
        Taps& of_texel = taps[static_cast<std::size_t>(i)];
        const double begin = i * step;
        of_texel.first = static_cast<int>(begin);
        for (int k = 0; k < 3; ++k) {
            const int texel = of_texel.first + k;
            const double covered = std::min(begin + step, texel + 1.0) - std::max(begin, double(texel));
            // Rounding must not select a texel beyond the end.
            if (texel < size && covered > 1e-9)
                of_texel.weights[static_cast<std::size_t>(k)] = static_cast<float>(covered / step);
        }
    }
    return taps;
}

/// Halves one axis of [outer][size][inner].
std::vector<float> halved(const std::vector<float>& values, std::size_t outer, int size, std::size_t inner) {
    const std::vector<Taps> taps = halving_taps(size);
    std::vector<float> out(outer * taps.size() * inner);
    float* to = out.data();
    for (std::size_t o = 0; o < outer; ++o) {
        const float* const line = values.data() + o * static_cast<std::size_t>(size) * inner;
        for (const Taps& of_texel : taps) {
            const float* from = line + static_cast<std::size_t>(of_texel.first) * inner;
            for (std::size_t k = 0; k < of_texel.weights.size(); ++k, from += inner) {
                const float weight = of_texel.weights[k];
                for (std::size_t i = 0; weight > 0 && i < inner; ++i) to[i] += weight * from[i];
            }
            to += inner;
        }
    }
    return out;
}

/// Returns the transpose of halved() of [outer][half of size][inner].
std::vector<double> doubled(const std::vector<double>& values, std::size_t outer, int size,
                            std::size_t inner) {
    const std::vector<Taps> taps = halving_taps(size);
    const std::size_t line = static_cast<std::size_t>(size) * inner;
    std::vector<double> out(outer * line);
    const double* from = values.data();
    for (std::size_t o = 0; o < outer; ++o)
        for (const Taps& of_texel : taps) {
            double* to = out.data() + o * line + static_cast<std::size_t>(of_texel.first) * inner;
            for (std::size_t k = 0; k < of_texel.weights.size(); ++k, to += inner) {
                const auto weight = double{of_texel.weights[k]};
                for (std::size_t i = 0; weight > 0 && i < inner; ++i) to[i] += weight * from[i];
            }
            from += inner;
        }
    return out;
}

/// Halves both sides of an image of even sides, in one pass. Rounds as two calls of halved() do.
template <std::size_t channels>
std::vector<float> quartered(const TextureImage& image) {
    const auto line = static_cast<std::size_t>(image.width) * channels;
    const std::size_t half = line / 2, rows = static_cast<std::size_t>(image.height) / 2;
    std::vector<float> out;
    out.reserve(half * rows + 1);  // image_texture() appends one
    for (std::size_t y = 0; y < rows; ++y) {
        const float* const upper = image.values.data() + 2 * y * line;
        const float* const lower = upper + line;
        for (std::size_t x = 0; x < line; x += 2 * channels)
            for (std::size_t c = 0; c < channels; ++c) {
                const std::size_t left = x + c, right = left + channels;
                out.push_back(0.5F * (0.5F * upper[left] + 0.5F * upper[right]) +
                              0.5F * (0.5F * lower[left] + 0.5F * lower[right]));
            }
    }
    return out;
}

TextureImage next_level(const TextureImage& image) {
    if (image.width % 2 == 0 && image.height % 2 == 0)
        return {.width = image.width / 2,
                .height = image.height / 2,
                .channels = image.channels,
                .values = image.channels == 1   ? quartered<1>(image)
                          : image.channels == 3 ? quartered<3>(image)
                                                : quartered<4>(image)};
    const auto columns = static_cast<std::size_t>(std::max(1, image.width / 2));
    const auto rows = static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    TextureImage next{.width = std::max(1, image.width / 2),
                      .height = std::max(1, image.height / 2),
                      .channels = image.channels,
                      .values = halved(image.values, rows, image.width, channels)};
    next.values = halved(next.values, 1, image.height, columns * channels);
    return next;
}

}  // namespace

std::vector<TextureImage> image_levels(TextureImage image) {
    std::vector<TextureImage> levels;
    levels.push_back(std::move(image));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(next_level(levels.back()));
    return levels;
}

std::vector<double> gradient_by_image(std::vector<std::vector<double>> levels, int width, int height) {
    const auto side = [](int size, std::size_t level) { return std::max(1, size >> level); };
    for (std::size_t level = levels.size() - 1; level > 0; --level) {
        const int columns = side(width, level - 1), rows = side(height, level - 1);
        const auto halved_columns = static_cast<std::size_t>(side(width, level));
        std::vector<double>& finer = levels[level - 1];
        const std::size_t channels =
            finer.size() / static_cast<std::size_t>(columns) / static_cast<std::size_t>(rows);
        const std::vector<double> wider = doubled(doubled(levels[level], 1, rows, halved_columns * channels),
                                                  static_cast<std::size_t>(rows), columns, channels);
        for (std::size_t i = 0; i < finer.size(); ++i) finer[i] += wider[i];
    }
    return std::move(levels.front());
}

}  // namespace nicol
