// SPDX-License-Identifier: MIT
#include "light/light_pyramid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>

#include "light/environment_texels.hpp"
#include "polarization/moved_axis.hpp"
#include "simd/dispatch.hpp"
#include "simd/work_space.hpp"

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

// Direction at which blobs about the texels of a row look up an image. Relative to a texel, it is the same
// for all columns.
struct BlobTap {
    float turn;  // from the texel's column
    float half_turn;
    float cosine2, sine2;  // of twice the angle from the frame there to the texel's, moved there
};
using BlobTaps = std::array<BlobTap, 6>;

// Returns the taps of a row. along, down: distances in the directions of a parallel and of a meridian.
BlobTaps taps_around(float half_turn, float along, float down) {
    const float angle = std::numbers::pi_v<float> * half_turn;
    const glm::vec3 frame = frame_of(0);
    const glm::vec3 direction(0, std::cos(angle), -std::sin(angle));
    const glm::vec3 other = glm::cross(direction, frame);
    BlobTaps out;
    for (std::size_t k = 0; k < out.size(); ++k) {
        const float around = std::numbers::pi_v<float> / 3 * static_cast<float>(k);
        const glm::vec3 way = along * std::cos(around) * frame + down * std::sin(around) * other;
        const float radius = glm::length(way);
        const glm::vec3 there = std::cos(radius) * direction + std::sin(radius) / radius * way;
        const EquirectPlace<float> place = equirect_place(there.x, there.y, there.z);
        const glm::vec3 from = frame_of(place.turn), to = moved(frame, direction, there);
        const float cosine = glm::dot(from, to), sine = glm::dot(glm::cross(from, there), to);
        out[k] = {.turn = place.turn,
                  .half_turn = place.half_turn,
                  .cosine2 = cosine * cosine - sine * sine,
                  .sine2 = 2 * cosine * sine};
    }
    return out;
}

// first_variance: of level 1.
template <class Number>
[[gnu::always_inline]] inline void find_places(const Lanes& variances, float first_variance,
                                               const LaneVectors& towards, ImageLevels::Places& out) {
    using Bits [[gnu::vector_size(sizeof(Number))]] = std::int32_t;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> direction;
        load_part(towards, first, direction);
        const EquirectPlace<Number> place = equirect_place(direction.x, direction.y, direction.z);
        store_part(place.turn, first, out.turn);
        store_part(place.half_turn, first, out.half_turn);

        // A mixture of two levels has the wanted variance, which doubles from level to level.
        Number relative;
        load_part(variances, first, relative);
        relative *= 1 / first_variance;
        const Bits bits = reinterpret_cast<Bits>(relative);
        const Number octave = __builtin_convertvector((bits >> 23) - 127, Number);
        const auto part = reinterpret_cast<Number>((bits & 0x7FFFFF) | 0x3F800000);  // 1 to 2
        store_part(Number(relative < 1.0F ? relative : octave + part), first, out.level);
    }
}

// Computes the x axes of the frames in the columns of directions.
template <class Number>
[[gnu::always_inline]] inline void find_frames(const LaneVectors& towards, LaneVectors& frames) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> direction;
        load_part(towards, first, direction);
        const Vector3<Number> across{-direction.z, Number{}, direction.x};
        store_part(normalized_or(across, 0.0F, Vector3<float>{1, 0, 0}), first, frames);
    }
}

// Computes from the middle of blobs to the mean direction of their light: of a normal distribution, this is
// the variance times the relative gradient. It is at most a standard deviation.
template <class Number>
[[gnu::always_inline]] inline void find_leans(const Lanes& variances, const LaneVectors& towards,
                                              const ImageLevels::Slopes& slopes, LaneVectors& out) {
    constexpr float pi = std::numbers::pi_v<float>;
    constexpr float least_across = 1e-3F;  // the azimuth of directions closer to the vertical is arbitrary
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> middle;
        Number variance, by_turn, by_half_turn;
        load_part(towards, first, middle);
        load_part(variances, first, variance);
        load_part(slopes.by_turn, first, by_turn);
        load_part(slopes.by_half_turn, first, by_half_turn);
        middle = normalized_or(middle, 0.0F, Vector3<float>{0, 1, 0});
        Number across = middle.x * middle.x + middle.z * middle.z;
        square_root(across);
        const Number inverse = 1.0F / (across > least_across ? across : Number{} + least_across);
        Number east = variance * by_turn * (0.5F / pi) * inverse, south = variance * by_half_turn * (1 / pi);
        Number limit = east * east + south * south;
        const auto too_long = limit > variance;
        limit = too_long ? variance / (too_long ? limit : Number{} + 1.0F) : Number{} + 1.0F;
        square_root(limit);
        east *= limit * inverse;
        south *= limit * inverse;
        store_part(Vector3<Number>{south * middle.x * middle.y - east * middle.z, -south * across * across,
                                   south * middle.z * middle.y + east * middle.x},
                   first, out);
    }
}

}  // namespace

LightPyramid::LightPyramid(const Environment& environment, int most_columns, Kept kept)
    : channels_(static_cast<std::size_t>(environment.channels())),
      components_(kept == Kept::radiance    ? 1
                  : environment.circular()  ? 4
                  : environment.polarized() ? 3
                                            : 1),
      planes_(components_ > 1 ? channels_ : (channels_ + 3) / 4),
      levels_(planes_) {
    const std::unique_ptr<const Environment> tabulated = environment.tabulated();
    EquirectTexels image = texels_of(tabulated ? *tabulated : environment, components_ > 1, channels_);
    levels_.add(image);
    double variance = 0;
    while (image.width > most_columns) {
        image = half_of(image);
        variance = 1.5 * interpolation(image.width);  // averaging adds half of what interpolation does
    }
    const int most = image.width;
    const int fewest = components_ > 1 ? kFewestPolarized : kFewestColumns;
    // The first level's texels are wide for its blobs, because the image's are.
    double next = variance + std::pow(0.75 * texel_of(most), 2);
    first_variance_ = static_cast<float>(next);
    while (true) {
        const auto wanted = static_cast<int>(2 * kPi * kTexels / std::sqrt(next));
        const int width = std::max(std::min(wanted, most), std::min(fewest, most));
        image = blurred(image, width, next - variance);
        levels_.add(image);
        if (next >= kMostVariance) break;
        variance = next;
        next *= 2;
    }
}

// Interpolates at kParts of each texel, first between rows, then between columns.
EquirectTexels LightPyramid::half_of(const EquirectTexels& image) const {
    const auto columns = static_cast<std::size_t>(image.width);
    const int width = image.width / 2;
    const int height = static_cast<int>(image.rows) / 2;
    EquirectTexels out = black_texels(width, height, true, planes_);
    tbb::parallel_for(0, static_cast<int>(planes_) * height, [&](int line) {
        const int row = line % height;
        const auto plane = static_cast<std::size_t>(line / height);
        const glm::vec4* const from =
            image.texels.data() + plane * columns * static_cast<std::size_t>(image.height);
        std::vector<glm::vec4> mean(columns);
        const auto add = [&](int of_image, float weight) {
            const glm::vec4* const texels = from + static_cast<std::size_t>(of_image) * columns;
            for (std::size_t x = 0; x < columns; ++x) mean[x] += weight * texels[x];
        };
        float total = 0;
        for (const float down : kParts) {
            const float half_turn = (static_cast<float>(row) + down) / static_cast<float>(height);
            // Rows near the poles cover less solid angle.
            const float weight = std::sin(std::numbers::pi_v<float> * half_turn);
            total += weight;
            const float y = std::clamp(half_turn * image.rows - image.first_row, 0.0F,
                                       static_cast<float>(image.height - 1));
            const int upper = static_cast<int>(y);
            const float part = y - static_cast<float>(upper);
            add(upper, weight * (1 - part));
            add(std::min(upper + 1, image.height - 1), weight * part);
        }
        glm::vec4* const texels =
            out.texels.data() + static_cast<std::size_t>(line) * static_cast<std::size_t>(width);
        const float step = static_cast<float>(image.width) / static_cast<float>(width);
        for (int x = 0; x < width; ++x) {
            for (const float right : kParts) {
                // Columns are centred and periodic.
                const float place = (static_cast<float>(x) + right) * step + 0.5F;
                const auto after = static_cast<std::size_t>(place);
                const glm::vec4& here = mean[(after + columns - 1) % columns];
                texels[x] += here + (place - static_cast<float>(after)) * (mean[after % columns] - here);
            }
            texels[x] /= total * static_cast<float>(kParts.size());
        }
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
        const BlobTaps taps = taps_around(half_turn, along, down);
        for (int column = 0; column < width; ++column) {
            const float turn = (static_cast<float>(column) + 0.5F) / static_cast<float>(width);
            for (std::size_t plane = 0; plane < planes_; ++plane) {
                glm::vec4 sum = 0.5F * image.at(plane, turn, half_turn);
                for (const BlobTap& tap : taps) {
                    const float there = turn + tap.turn;
                    glm::vec4 light = image.at(plane, there < 1 ? there : there - 1, tap.half_turn);
                    if (components_ > 1) {
                        const glm::vec2 linear(light[1], light[2]);
                        light[1] = tap.cosine2 * linear.x + tap.sine2 * linear.y;
                        light[2] = tap.cosine2 * linear.y - tap.sine2 * linear.x;
                    }
                    sum += 1 / 12.0F * light;
                }
                const std::size_t line =
                    plane * static_cast<std::size_t>(height) + static_cast<std::size_t>(row);
                out.texels[line * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)] = sum;
            }
        }
    });
    return out;
}

ImageLevels::Places LightPyramid::places_of(const Lanes& variances, const LaneVectors& towards) const {
    ImageLevels::Places places;
    dispatch<find_places<FourLanes>, find_places<EightLanes>, find_places<AllLanes>>(
        variances, first_variance_, towards, places);
    return places;
}

void LightPyramid::put_unpolarized(const Lanes* found, LaneLight& out) const {
    out.components = 1;
    out.irradiance.resize(channels_);
    for (std::size_t c = 0; c < channels_; ++c) out.irradiance[c][0] = found[c];
}

void LightPyramid::look_up(const Lanes& variances, LaneLight& out) const {
    const ImageLevels::Places places = places_of(variances, out.towards);
    const std::span<Lanes> found = work_space<LightPyramid, Lanes>(4 * planes_);
    levels_.look_up(places, found.data());
    if (components_ == 1) return put_unpolarized(found.data(), out);
    out.components = components_;
    out.irradiance.resize(channels_);
    for (std::size_t c = 0; c < channels_; ++c)
        std::copy_n(&found[4 * c], components_, out.irradiance[c].begin());
    dispatch<find_frames<FourLanes>, find_frames<EightLanes>, find_frames<AllLanes>>(out.towards, out.x);
}

void LightPyramid::look_up(const Lanes& variances, LaneLight& out, LaneVectors& leans) const {
    const ImageLevels::Places places = places_of(variances, out.towards);
    const std::span<Lanes> found = work_space<LightPyramid, Lanes>(4 * planes_);
    ImageLevels::Slopes slopes;
    levels_.look_up(places, found.data(), slopes);
    put_unpolarized(found.data(), out);
    dispatch<find_leans<FourLanes>, find_leans<EightLanes>, find_leans<AllLanes>>(variances, out.towards,
                                                                                  slopes, leans);
}

}  // namespace nicol
