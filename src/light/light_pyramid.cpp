// SPDX-License-Identifier: MIT
#include "light/light_pyramid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

constexpr double kPi = std::numbers::pi;

// Fewest columns of levels of unpolarized and of polarized light. The Stokes frames of neighbouring columns
// turn by the angle between the columns at the poles, which interpolation ignores.
constexpr int kFewestColumns = 24;
constexpr int kFewestPolarized = 64;
// Variance of the last level, at least.
constexpr double kMostVariance = 0.25;
// Texels of an image per standard deviation of its blobs.
constexpr double kTexels = 1.5;

// Places within a texel, in texels, at which a wide image is averaged.
constexpr std::array<float, 4> kParts{0.125F, 0.375F, 0.625F, 0.875F};

double texel_of(int width) {
    return 2 * kPi / width;
}

// Variance that bilinear interpolation adds.
double interpolation(int width) {
    return texel_of(width) * texel_of(width) / 6;
}

// Returns the x axis of the frames in a column.
glm::vec3 frame_of(float turn) {
    const float angle = 2 * std::numbers::pi_v<float> * turn;
    return {std::cos(angle), 0, std::sin(angle)};
}

// Returns a direction's frame, moved to another direction along the shortest way.
glm::vec3 moved(const glm::vec3& frame, const glm::vec3& from, const glm::vec3& to) {
    return frame - glm::dot(frame, to) / (1 + glm::dot(from, to)) * (from + to);
}

// Returns Stokes vectors of light from a unit direction in frames with the x axis `to` instead of `from`.
glm::vec4 turned(const glm::vec4& stokes, const glm::vec3& direction, const glm::vec3& from,
                 const glm::vec3& to) {
    const float cosine = glm::dot(from, to), sine = glm::dot(glm::cross(from, direction), to);
    const float cosine2 = cosine * cosine - sine * sine, sine2 = 2 * cosine * sine;
    return {stokes[0], cosine2 * stokes[1] + sine2 * stokes[2], cosine2 * stokes[2] - sine2 * stokes[1],
            stokes[3]};
}

// Where sixteen look-ups lie: in the images, and between levels.
struct Places {
    Lanes turn, half_turn;
    std::array<std::uint32_t, kLanes> lower;
    Lanes part;  // of the level after `lower`
};

[[gnu::always_inline]] inline void find_places(const Lanes& variances, float first_variance,
                                               const LaneVectors& towards, LaneVectors& frames, Places& out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = towards.x.value[i], y = towards.y.value[i], z = towards.z.value[i];
        const EquirectPlace place = equirect_place(x, y, z);
        out.turn.value[i] = place.turn;
        out.half_turn.value[i] = place.half_turn;
        const bool pole = !(place.across > 0);
        const float inverse = 1 / (pole ? 1.0F : place.across);
        frames.x.value[i] = pole ? 1.0F : -z * inverse;
        frames.y.value[i] = 0;
        frames.z.value[i] = x * inverse;

        // A mixture of two levels has the wanted variance, which doubles from level to level.
        const float relative = variances.value[i] / first_variance;
        const auto bits = std::bit_cast<std::uint32_t>(relative);
        const bool sharp = relative < 1;
        out.lower[i] = sharp ? 0 : 1 + (bits >> 23) - 127;
        out.part.value[i] = sharp ? relative : std::bit_cast<float>((bits & 0x7FFFFF) | 0x3F800000) - 1;
    }
}

}  // namespace

LightPyramid::LightPyramid(const Environment& environment, int most_columns)
    : channels_(static_cast<std::size_t>(environment.channels())),
      components_(environment.circular()    ? 4
                  : environment.polarized() ? 3
                                            : 1),
      planes_(components_ > 1 ? channels_ : (channels_ + 3) / 4) {
    const std::unique_ptr<const Environment> tabulated = environment.tabulated();
    levels_.push_back(texels_of((tabulated ? *tabulated : environment).image(), components_ > 1, channels_));
    EquirectTexels narrow;
    double variance = 0;
    const EquirectTexels* image = &levels_.front();
    while (image->width > most_columns) {
        narrow = half_of(*image);
        image = &narrow;
        variance = 1.5 * interpolation(narrow.width);  // averaging adds half of what interpolation does
    }
    const int most = image->width;
    const int fewest = components_ > 1 ? kFewestPolarized : kFewestColumns;
    // The first level's texels are wide for its blobs, because the image's are.
    double next = variance + std::pow(0.75 * texel_of(most), 2);
    first_variance_ = static_cast<float>(next);
    while (true) {
        const auto wanted = static_cast<int>(2 * kPi * kTexels / std::sqrt(next));
        const int width = std::max(std::min(wanted, most), std::min(fewest, most));
        EquirectTexels level = blurred(*image, width, next - variance);
        levels_.push_back(std::move(level));
        if (next >= kMostVariance) break;
        image = &levels_.back();
        variance = next;
        next *= 2;
    }
}

EquirectTexels LightPyramid::half_of(const EquirectTexels& image) const {
    const int width = image.width / 2;
    const int height = static_cast<int>(image.rows) / 2;
    EquirectTexels out = black_texels(width, height, true, planes_);
    tbb::parallel_for(0, static_cast<int>(planes_) * height, [&](int line) {
        const int row = line % height;
        const auto plane = static_cast<std::size_t>(line / height);
        glm::vec4* const texels =
            out.texels.data() + static_cast<std::size_t>(line) * static_cast<std::size_t>(width);
        float total = 0;
        for (const float down : kParts) {
            const float half_turn = (static_cast<float>(row) + down) / static_cast<float>(height);
            // Rows near the poles cover less solid angle.
            const float weight = std::sin(std::numbers::pi_v<float> * half_turn);
            total += weight;
            for (int x = 0; x < width; ++x)
                for (const float right : kParts)
                    texels[x] +=
                        weight * image.at(plane, (static_cast<float>(x) + right) / static_cast<float>(width),
                                          half_turn);
        }
        for (int x = 0; x < width; ++x) texels[x] /= total * static_cast<float>(kParts.size());
    });
    return out;
}

// Averages over seven directions, which as nodes of a normal distribution are exact up to the fifth degree.
// `variance` includes that of the result's interpolation, which averages over less of a parallel of latitude
// than of a meridian.
EquirectTexels LightPyramid::blurred(const EquirectTexels& image, int width, double variance) const {
    const int height = (width + 1) / 2 + 1;
    EquirectTexels out = black_texels(width, height, false, planes_);
    tbb::parallel_for(0, height, [&](int row) {
        const float half_turn = static_cast<float>(row) / out.rows;
        const float angle = std::numbers::pi_v<float> * half_turn;
        const double own = interpolation(width), narrowing = std::sin(static_cast<double>(angle));
        const auto along = static_cast<float>(2 * std::sqrt(variance - own * narrowing * narrowing));
        const auto down = static_cast<float>(2 * std::sqrt(variance - own));
        for (int column = 0; column < width; ++column) {
            const float turn = (static_cast<float>(column) + 0.5F) / static_cast<float>(width);
            const glm::vec3 frame = frame_of(turn);
            const glm::vec3 direction(std::sin(angle) * frame.z, std::cos(angle), -std::sin(angle) * frame.x);
            const glm::vec3 other = glm::cross(direction, frame);
            for (std::size_t plane = 0; plane < planes_; ++plane) {
                glm::vec4 sum = 0.5F * image.at(plane, turn, half_turn);
                for (int k = 0; k < 6; ++k) {
                    const float around = std::numbers::pi_v<float> / 3 * static_cast<float>(k);
                    const glm::vec3 way = along * std::cos(around) * frame + down * std::sin(around) * other;
                    const float radius = glm::length(way);
                    const glm::vec3 there = std::cos(radius) * direction + std::sin(radius) / radius * way;
                    const EquirectPlace place = equirect_place(there.x, there.y, there.z);
                    const glm::vec4 light = image.at(plane, place.turn, place.half_turn);
                    sum += 1 / 12.0F *
                           (components_ == 1
                                ? light
                                : turned(light, there, frame_of(place.turn), moved(frame, direction, there)));
                }
                const std::size_t line =
                    plane * static_cast<std::size_t>(height) + static_cast<std::size_t>(row);
                out.texels[line * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)] = sum;
            }
        }
    });
    return out;
}

void LightPyramid::look_up(const Lanes& variances, LaneLight& out) const {
    out.components = components_;
    out.irradiance.resize(channels_);
    Places places;
    dispatch<find_places>(variances, first_variance_, out.towards, out.x, places);
    const std::size_t last = levels_.size() - 1;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t lower = std::min<std::size_t>(places.lower[i], last);
        const float part = lower < last ? places.part[i] : 0.0F;
        const float turn = places.turn[i], half_turn = places.half_turn[i];
        for (std::size_t plane = 0; plane < planes_; ++plane) {
            glm::vec4 value = levels_[lower].at(plane, turn, half_turn);
            if (part > 0) value += part * (levels_[lower + 1].at(plane, turn, half_turn) - value);
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
