// SPDX-License-Identifier: MIT
#include "texture/texel_gradient.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "texture/image_levels.hpp"

namespace nicol {
namespace {

MipmapShape shape_of(const TextureDescription& image) {
    return {.width = image.levels.front().width,
            .height = image.levels.front().height,
            .last_level = static_cast<int>(image.levels.size()) - 1,
            .to_uv = UvTransform(image.sampling.to_uv)};
}

std::size_t values_of(const TextureImage& level) {
    return static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) *
           static_cast<std::size_t>(level.channels);
}

}  // namespace

TexelGradient::TexelGradient(const Texture& image)
    : sampling_(image.describe().sampling),
      shape_(shape_of(image.describe())),
      channels_(static_cast<std::size_t>(image.channels())) {
    for (const TextureImage& level : image.describe().levels) levels_.emplace_back(values_of(level));
}

void TexelGradient::add(const TexturePoints& points, std::uint32_t chosen,
                        const std::array<Lanes, 4>& values) {
    const tbb::spin_mutex::scoped_lock lock(mutex_);
    if (sampling_.filter != TextureSampling::Filter::mipmap) {
        const std::array<Lanes, 2> uv = wrapped(points.uv, shape_.to_uv, sampling_.wrap);
        LaneTexels texels{};
        if (sampling_.filter == TextureSampling::Filter::nearest)
            find_nearest(uv, shape_.width, shape_.height, texels.upper_left);
        else
            find_texels(uv, shape_.width, shape_.height, {}, sampling_.wrap, texels);
        Lanes one;
        one.value.fill(1);
        add_between(texels, {}, chosen, one, values);
        return;
    }
    LaneFootprintTaps taps;
    footprint_taps(points, shape_, taps);
    LaneIntegers next;
    Lanes fine, coarse;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const auto places = static_cast<float>(taps.rows[i] * taps.count[i]);
        next[i] = std::min(taps.level[i] + 1, shape_.last_level);
        coarse[i] = taps.fraction[i] / places;
        fine[i] = (1 - taps.fraction[i]) / places;
    }
    const int rows = *std::ranges::max_element(taps.rows.value);
    const int most = *std::ranges::max_element(taps.count.value);
    for (int j = 0; j < rows; ++j)
        for (int k = 0; k < most; ++k) {
            const std::array<Lanes, 2> uv = wrapped(taps.first, taps.side, j, taps.step, k, sampling_.wrap);
            std::uint32_t here = 0;
            for (std::size_t i = 0; i < kLanes; ++i)
                if (j < taps.rows[i] && k < taps.count[i]) here |= chosen & 1U << i;
            LaneTexels texels;
            find_texels(uv, shape_.width, shape_.height, taps.level, sampling_.wrap, texels);
            add_between(texels, taps.level, here, fine, values);
            find_texels(uv, shape_.width, shape_.height, next, sampling_.wrap, texels);
            add_between(texels, next, here, coarse, values);
        }
}

void TexelGradient::add_between(const LaneTexels& texels, const LaneIntegers& level, std::uint32_t chosen,
                                const Lanes& factors, const std::array<Lanes, 4>& values) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        if ((chosen >> i & 1U) == 0 || factors[i] == 0) continue;
        double* const to = levels_[static_cast<std::size_t>(level[i])].data();
        const auto right = double{texels.right[i]}, down = double{texels.down[i]};
        const auto add_to = [&](std::int32_t texel, double weight) {
            for (std::size_t c = 0; c < channels_; ++c)
                to[static_cast<std::size_t>(texel) * channels_ + c] +=
                    weight * double{factors[i]} * double{values[c][i]};
        };
        add_to(texels.upper_left[i], (1 - right) * (1 - down));
        add_to(texels.upper_right[i], right * (1 - down));
        add_to(texels.lower_left[i], (1 - right) * down);
        add_to(texels.lower_right[i], right * down);
    }
}

std::vector<double> TexelGradient::take() {
    return gradient_by_image(std::move(levels_), shape_.width, shape_.height);
}

std::uint64_t TexelGradient::bytes(const Texture& image) {
    const std::span levels = image.describe().levels;
    std::uint64_t values = 0;
    for (const TextureImage& level : levels) values += values_of(level);
    // A level grows to the size of the next finer one, first along one side.
    if (levels.size() > 1) values += values_of(levels[0]) + values_of(levels[0]) / 2;
    return values * sizeof(double);
}

}  // namespace nicol
