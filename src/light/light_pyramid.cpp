// SPDX-License-Identifier: MIT
#include "light/light_pyramid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nicol {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Columns of the last level, of unpolarized and of polarized light. The Stokes frames of neighbouring columns
// turn by the angle between the columns at the poles, so polarized light must not be averaged over wide
// columns.
constexpr int kLeastColumns = 8;
constexpr int kLeastPolarized = 32;

// Most texels side by side that are averaged near the poles.
constexpr float kMostColumns = 8;

// Places within a texel, in texels, at which the level before is averaged.
constexpr std::array<float, 4> kParts{0.125F, 0.375F, 0.625F, 0.875F};

}  // namespace

LightPyramid::LightPyramid(const Environment& environment)
    : channels_(static_cast<std::size_t>(environment.channels())),
      components_(environment.circular()    ? 4
                  : environment.polarized() ? 3
                                            : 1),
      planes_(components_ > 1 ? channels_ : (channels_ + 3) / 4) {
    const std::unique_ptr<const Environment> tabulated = environment.tabulated();
    levels_.push_back(texels_of((tabulated ? *tabulated : environment).image(), components_ > 1, channels_));
    const int least = components_ > 1 ? kLeastPolarized : kLeastColumns;
    while (levels_.back().width >= 2 * least && levels_.back().height >= least)
        levels_.push_back(half_of(levels_.back(), planes_));
}

EquirectTexels LightPyramid::half_of(const EquirectTexels& level, std::size_t planes) {
    const int width = level.width / 2;
    const int height = static_cast<int>(level.rows) / 2;
    EquirectTexels out{.width = width,
                       .height = height,
                       .rows = static_cast<float>(height),
                       .first_row = 0.5F,
                       .texels = std::vector<glm::vec4>(planes * static_cast<std::size_t>(width) *
                                                        static_cast<std::size_t>(height))};
    tbb::parallel_for(0, static_cast<int>(planes) * height, [&](int line) {
        const int row = line % height;
        const auto plane = static_cast<std::size_t>(line / height);
        glm::vec4* const texels =
            out.texels.data() + static_cast<std::size_t>(line) * static_cast<std::size_t>(width);
        float total = 0;
        for (const float down : kParts) {
            const float half_turn = (static_cast<float>(row) + down) / static_cast<float>(height);
            // Rows near the poles cover less solid angle.
            const float weight = std::sin(kPi * half_turn);
            total += weight;
            for (int x = 0; x < width; ++x)
                for (const float right : kParts)
                    texels[x] +=
                        weight * level.at(plane, (static_cast<float>(x) + right) / static_cast<float>(width),
                                          half_turn);
        }
        for (int x = 0; x < width; ++x) texels[x] /= total * static_cast<float>(kParts.size());
    });
    return out;
}

// Returns the mean over `columns` texels side by side.
glm::vec4 LightPyramid::across_columns(const EquirectTexels& level, std::size_t plane, float turn,
                                       float half_turn, float columns) {
    const int taps = static_cast<int>(columns);
    const float step = std::min(columns / static_cast<float>(level.width), 1.0F) / static_cast<float>(taps);
    glm::vec4 sum(0);
    for (int k = 0; k < taps; ++k) {
        const float there = turn + (static_cast<float>(k) - 0.5F * static_cast<float>(taps - 1)) * step;
        sum += level.at(plane, there - std::floor(there), half_turn);
    }
    return sum / static_cast<float>(taps);
}

void LightPyramid::look_up(const Lanes& solid_angles, LaneLight& out) const {
    out.components = components_;
    out.irradiance.resize(channels_);
    const EquirectTexels& first = levels_.front();
    // Solid angle of a texel of the first level at the horizon.
    const float texel = 2 * kPi / static_cast<float>(first.width) * kPi / first.rows;
    const auto last = static_cast<float>(levels_.size() - 1);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = out.towards.x[i], y = out.towards.y[i], z = out.towards.z[i];
        const auto [turn, half_turn, across] = equirect_place(x, y, z);
        put(out.x, i, across > 0 ? glm::vec3(-z, 0, x) / across : glm::vec3(1, 0, 0));

        const float texels = solid_angles[i] / texel;
        const float level = texels > 1 ? std::min(0.5F * std::log2(texels), last) : 0.0F;
        // Texels near the poles are narrow: several side by side are as wide as one is high. Polarized light
        // is not averaged over them, because their frames differ.
        const float wide = std::sqrt(texels) * std::exp2(-level) / std::max(across, 1e-3F);
        const float columns = components_ > 1 ? 1.0F : std::clamp(wide, 1.0F, kMostColumns);
        const auto lower = static_cast<std::size_t>(level);
        const float part = level - static_cast<float>(lower);
        for (std::size_t plane = 0; plane < planes_; ++plane) {
            glm::vec4 value = across_columns(levels_[lower], plane, turn, half_turn, columns);
            if (part > 0)
                value += part * (across_columns(levels_[lower + 1], plane, turn, half_turn, columns) - value);
            if (components_ > 1) {
                for (std::size_t p = 0; p < components_; ++p)
                    out.irradiance[plane][p][i] = value[static_cast<glm::length_t>(p)];
                continue;
            }
            for (std::size_t c = 4 * plane; c < std::min(channels_, 4 * plane + 4); ++c)
                out.irradiance[c][0][i] = value[static_cast<glm::length_t>(c % 4)];
        }
    }
}

std::size_t LightPyramid::bytes() const noexcept {
    std::size_t out = 0;
    for (const EquirectTexels& level : levels_) out += level.texels.size() * sizeof(glm::vec4);
    return out;
}

}  // namespace nicol
