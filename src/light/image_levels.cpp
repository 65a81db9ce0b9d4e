// SPDX-License-Identifier: MIT
#include "light/image_levels.hpp"

#include <array>
#include <cstring>

#include "simd/dispatch.hpp"
#include "simd/lane_parts.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Two rows in each of two images. The column after `left` is next to it.
constexpr std::size_t kRows = 4;

// Texels of sixteen look-ups.
struct Taps {
    alignas(64) std::array<std::array<std::int32_t, kLanes>, kRows> left;
    std::array<Lanes, kRows> left_weights, right_weights;
    // Factors of differences in the second image, for its slopes: of the right texel less the left one in
    // either row, and of the lower texel less the upper one on either side.
    std::array<Lanes, 2> by_turn, by_half_turn;
};

template <class Number>
using Integers [[gnu::vector_size(sizeof(Number))]] = std::int32_t;

// Loads from[indices[i]] into each lane. GCC has an instruction for the loop alone.
template <class Element, class Vector>
[[gnu::always_inline]] inline void gather(const std::vector<Element>& from,
                                          const std::array<std::int32_t, kLanes>& indices, Vector& out) {
    const Element* const values = from.data();
    alignas(64) std::array<Element, kLanes> found;
    for (std::size_t i = 0; i < sizeof(Vector) / sizeof(Element); ++i) found[i] = values[indices[i]];
    std::memcpy(&out, found.data(), sizeof out);
}

// Finds the rows of one image for the lanes from `first` on. row: of the two, the first in `out`.
template <class Number>
[[gnu::always_inline]] inline void find_rows(const ImageLevels::Shapes& shapes,
                                             const ImageLevels::Places& places, std::size_t first,
                                             const Integers<Number>& image, const Number& weight,
                                             std::size_t row, Taps& out) {
    using Integer = Integers<Number>;
    std::array<std::int32_t, kLanes> images;
    std::memcpy(images.data(), &image, sizeof image);
    Number width, last_row, x, y;
    Integer offset;
    gather(shapes.widths, images, width);
    gather(shapes.last_rows, images, last_row);
    gather(shapes.first, images, offset);
    load_part(places.turn, first, x);
    load_part(places.half_turn, first, y);
    // The comparisons replace a NaN by 0, because they are false for it.
    x = x > 0.0F ? x * width : Number{};
    x = 0.5F + (x < width ? x : width);
    y = y > 0.0F ? y * last_row : Number{};
    const Integer columns = __builtin_convertvector(width, Integer);
    const Integer last = __builtin_convertvector(last_row, Integer) - 1;
    const Integer after = __builtin_convertvector(x, Integer);  // the column to the right, plus one
    const Integer left = after > 0 ? after - 1 : columns - 1;
    Integer upper = __builtin_convertvector(y < last_row ? y : last_row, Integer);
    upper = upper < last ? upper : last;
    const Number right_part = x - __builtin_convertvector(after, Number);
    const Number lower_part = y - __builtin_convertvector(upper, Number);
    const Integer texel = offset + upper * (columns + 1) + left;
    const Integer below = texel + columns + 1;
    std::memcpy(out.left[row].data() + first, &texel, sizeof texel);
    std::memcpy(out.left[row + 1].data() + first, &below, sizeof below);
    const Number lower_weight = weight * lower_part, upper_weight = weight - lower_weight;
    store_part(Number(upper_weight * (1.0F - right_part)), first, out.left_weights[row]);
    store_part(Number(upper_weight * right_part), first, out.right_weights[row]);
    store_part(Number(lower_weight * (1.0F - right_part)), first, out.left_weights[row + 1]);
    store_part(Number(lower_weight * right_part), first, out.right_weights[row + 1]);
    if (row == 0) return;
    store_part(Number(width * (1.0F - lower_part)), first, out.by_turn[0]);
    store_part(Number(width * lower_part), first, out.by_turn[1]);
    store_part(Number(last_row * (1.0F - right_part)), first, out.by_half_turn[0]);
    store_part(Number(last_row * right_part), first, out.by_half_turn[1]);
}

template <class Number>
[[gnu::always_inline]] inline void find_taps(const ImageLevels::Shapes& shapes,
                                             const ImageLevels::Places& places, Taps& out) {
    using Integer = Integers<Number>;
    const auto last = static_cast<std::int32_t>(shapes.first.size()) - 1;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number level;
        load_part(places.level, first, level);
        const Number most = Number{} + static_cast<float>(last);
        level = level > 0.0F ? level : Number{};
        level = level < most ? level : most;
        Integer image = __builtin_convertvector(level, Integer);
        image = image < last ? image : Integer{} + (last - 1);
        const Number part = level - __builtin_convertvector(image, Number);
        find_rows<Number>(shapes, places, first, image, 1.0F - part, 0, out);
        find_rows<Number>(shapes, places, first, image + 1, part, 2, out);
    }
}

// Adds a texel and the next one, times their weights, to the two halves of the sums.
[[gnu::always_inline]] inline void add_pair(const glm::vec4* left, float left_weight, float right_weight,
                                            EightLanes& sums) {
    const FourLanes weights{left_weight, right_weight};
    EightLanes texels;
    std::memcpy(&texels, left, sizeof texels);
    sums += texels * __builtin_shufflevector(weights, weights, 0, 0, 0, 0, 1, 1, 1, 1);
}

// Computes the changes of the components of the first plane's texels: by_turn[lane] and by_half_turn[lane].
void add_slopes(const Taps& taps, const glm::vec4* texels, std::size_t planes, glm::vec4* by_turn,
                glm::vec4* by_half_turn) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec4* const upper = texels + static_cast<std::size_t>(taps.left[2][i]) * planes;
        const glm::vec4* const lower = texels + static_cast<std::size_t>(taps.left[3][i]) * planes;
        const FourLanes upper_left = in_register(upper[0]), upper_right = in_register(upper[planes]);
        const FourLanes lower_left = in_register(lower[0]), lower_right = in_register(lower[planes]);
        const FourLanes right = taps.by_turn[0].value[i] * (upper_right - upper_left) +
                                taps.by_turn[1].value[i] * (lower_right - lower_left);
        const FourLanes down = taps.by_half_turn[0].value[i] * (lower_left - upper_left) +
                               taps.by_half_turn[1].value[i] * (lower_right - upper_right);
        std::memcpy(by_turn + i, &right, sizeof right);
        std::memcpy(by_half_turn + i, &down, sizeof down);
    }
}

// Computes out[plane][lane], and, if asked for, the slopes of each component after the planes.
template <class Number>
[[gnu::always_inline]] inline void add_taps(const ImageLevels::Shapes& shapes, const glm::vec4* texels,
                                            std::size_t planes, const ImageLevels::Places& places,
                                            bool slopes, glm::vec4* out) {
    Taps taps;
    find_taps<Number>(shapes, places, taps);
    if (slopes) add_slopes(taps, texels, planes, out + planes * kLanes, out + (planes + 1) * kLanes);
    if (planes == 1) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            EightLanes sums{};
            for (std::size_t row = 0; row < kRows; ++row)
                add_pair(texels + taps.left[row][i], taps.left_weights[row].value[i],
                         taps.right_weights[row].value[i], sums);
            const FourLanes sum = __builtin_shufflevector(sums, sums, 0, 1, 2, 3) +
                                  __builtin_shufflevector(sums, sums, 4, 5, 6, 7);
            std::memcpy(out + i, &sum, sizeof sum);
        }
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t plane = 0; plane < planes; ++plane) {
            FourLanes sum{};
            for (std::size_t row = 0; row < kRows; ++row) {
                const glm::vec4* const left =
                    texels + static_cast<std::size_t>(taps.left[row][i]) * planes + plane;
                sum += taps.left_weights[row].value[i] * in_register(left[0]);
                sum += taps.right_weights[row].value[i] * in_register(left[planes]);
            }
            std::memcpy(out + plane * kLanes + i, &sum, sizeof sum);
        }
    }
}

}  // namespace

void ImageLevels::add(const EquirectTexels& image) {
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    shapes_.first.push_back(static_cast<std::int32_t>(texels_.size() / planes_));
    shapes_.widths.push_back(static_cast<float>(image.width));
    shapes_.last_rows.push_back(static_cast<float>(image.height - 1));
    const std::size_t before = texels_.size(), size = planes_ * (width + 1) * height;
    // Room for later images, which are mostly smaller, spares copies of the former ones.
    if (before + size > texels_.capacity())
        texels_.reserve(before + size + (before == 0 ? 0 : size) + size / 8);
    texels_.resize(before + size);
    glm::vec4* to = &texels_[before];
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t column = 0; column <= width; ++column)
            for (std::size_t plane = 0; plane < planes_; ++plane)
                *to++ = image.texels[(plane * height + row) * width + (column < width ? column : 0)];
}

void ImageLevels::look_up(const Places& places, Lanes* out, Slopes* slopes) const {
    const std::span<glm::vec4> fours = work_space<ImageLevels, glm::vec4>((planes_ + 2) * kLanes);
    dispatch<add_taps<FourLanes>, add_taps<EightLanes>, add_taps<AllLanes>>(
        shapes_, texels_.data(), planes_, places, slopes != nullptr, fours.data());
    for (std::size_t plane = 0; plane < planes_; ++plane)
        take_fours(fours.data() + plane * kLanes, out + 4 * plane);
    if (slopes == nullptr) return;
    std::array<Lanes, 4> by_turn, by_half_turn;
    take_fours(fours.data() + planes_ * kLanes, by_turn.data());
    take_fours(fours.data() + (planes_ + 1) * kLanes, by_half_turn.data());
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float sum = (out[0][i] + out[1][i]) + (out[2][i] + out[3][i]);
        const float inverse = sum > 0 ? 1 / sum : 0;
        slopes->by_turn[i] = inverse * ((by_turn[0][i] + by_turn[1][i]) + (by_turn[2][i] + by_turn[3][i]));
        slopes->by_half_turn[i] =
            inverse * ((by_half_turn[0][i] + by_half_turn[1][i]) + (by_half_turn[2][i] + by_half_turn[3][i]));
    }
}

}  // namespace nicol
