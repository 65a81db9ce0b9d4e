// SPDX-License-Identifier: MIT
#include "texture/lane_texels.hpp"

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using Wrap = TextureSampling::Wrap;
// Vectors in the compiler's own types, because the compiler does not vectorise loops over lanes that contain
// selections.
using Number [[gnu::vector_size(64)]] = float;
using Integer [[gnu::vector_size(64)]] = std::int32_t;

[[gnu::always_inline]] inline void load(const LaneIntegers& from, Integer& to) {
    to = *reinterpret_cast<const IntVector*>(&from);
}
[[gnu::always_inline]] inline void store(LaneIntegers& to, const Integer& from) {
    *reinterpret_cast<IntVector*>(&to) = from;
}

// Computes floor_to_int() of each lane.
[[gnu::always_inline]] inline void floor_lanes(const Number& x, Integer& out) {
    out = __builtin_convertvector(x, Integer);
    out += x < __builtin_convertvector(out, Number);  // true is -1
}

[[gnu::always_inline]] inline void wrap_lanes(Number& t, Wrap wrap) {
    if (wrap == Wrap::clamp) {
        t = t > 0 ? t : Number{};
        t = t < 1 ? t : Number{} + 1.0F;
        return;
    }
    constexpr float most = 1 << 30;  // the limit of within_int()
    t = t > -most ? t : Number{} - most;
    t = t < most ? t : Number{} + most;
    Integer whole;
    if (wrap == Wrap::repeat) {
        floor_lanes(t, whole);
        t -= __builtin_convertvector(whole, Number);
        return;
    }
    floor_lanes(t * 0.5F, whole);
    t -= 2.0F * __builtin_convertvector(whole, Number);
    t = t < 2.0F - t ? t : 2.0F - t;
}

[[gnu::always_inline]] inline void wrap_all(const std::array<Lanes, 2>& uv, const UvTransform& transform,
                                            Wrap wrap, std::array<Lanes, 2>& out) {
    LaneVector u, v;
    load(uv.data(), u);
    load(&uv[1], v);
    for (glm::length_t k = 0; k < 2; ++k) {
        Number t = transform.linear[0][k] * u + transform.linear[1][k] * v + transform.offset[k];
        wrap_lanes(t, wrap);
        store(&out[static_cast<std::size_t>(k)], t);
    }
}

[[gnu::always_inline]] inline void wrap_place(const std::array<Lanes, 2>& first,
                                              const std::array<Lanes, 2>& side, int j,
                                              const std::array<Lanes, 2>& step, int k, Wrap wrap,
                                              std::array<Lanes, 2>& out) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        LaneVector from, across, along;
        load(&first[axis], from);
        load(&side[axis], across);
        load(&step[axis], along);
        Number t = from + static_cast<float>(j) * across + static_cast<float>(k) * along;
        wrap_lanes(t, wrap);
        store(&out[axis], t);
    }
}

// Finds the wrapped indices of texel i and the next texel, for -1 <= i < size.
[[gnu::always_inline]] inline void find_neighbours(const Integer& i, const Integer& size, Wrap wrap,
                                                   Integer& first, Integer& second) {
    const Integer before = wrap == Wrap::repeat ? size - 1 : Integer{};
    const Integer after = wrap == Wrap::repeat ? Integer{} : size - 1;
    first = i < 0 ? before : i;
    second = i + 1 == size ? after : i + 1;
}

[[gnu::always_inline]] inline void find_cells(const std::array<Lanes, 2>& uv, int width, int height,
                                              const LaneIntegers& level, Wrap wrap, LaneTexels& out) {
    Integer halvings;
    load(level, halvings);
    Integer columns = (Integer{} + width) >> halvings, rows = (Integer{} + height) >> halvings;
    columns = columns > 1 ? columns : Integer{} + 1;
    rows = rows > 1 ? rows : Integer{} + 1;
    LaneVector u, v;
    load(uv.data(), u);
    load(&uv[1], v);
    const Number x = u * __builtin_convertvector(columns, Number) - 0.5F;
    const Number y = v * __builtin_convertvector(rows, Number) - 0.5F;
    Integer column, row, left, right, upper, lower;
    floor_lanes(x, column);
    floor_lanes(y, row);
    store(&out.right, x - __builtin_convertvector(column, Number));
    store(&out.down, y - __builtin_convertvector(row, Number));
    find_neighbours(column, columns, wrap, left, right);
    find_neighbours(row, rows, wrap, upper, lower);
    store(out.upper_left, upper * columns + left);
    store(out.upper_right, upper * columns + right);
    store(out.lower_left, lower * columns + left);
    store(out.lower_right, lower * columns + right);
}

[[gnu::always_inline]] inline void find_one(const std::array<Lanes, 2>& uv, int width, int height,
                                            LaneIntegers& out) {
    LaneVector u, v;
    load(uv.data(), u);
    load(&uv[1], v);
    Integer column = __builtin_convertvector(u * static_cast<float>(width), Integer);
    Integer row = __builtin_convertvector(v * static_cast<float>(height), Integer);
    column = column < width - 1 ? column : Integer{} + (width - 1);
    row = row < height - 1 ? row : Integer{} + (height - 1);
    store(out, row * width + column);
}

}  // namespace

std::array<Lanes, 2> wrapped(const std::array<Lanes, 2>& uv, const UvTransform& transform, Wrap wrap) {
    std::array<Lanes, 2> out;
    dispatch<wrap_all>(uv, transform, wrap, out);
    return out;
}

std::array<Lanes, 2> wrapped(const std::array<Lanes, 2>& first, const std::array<Lanes, 2>& side, int j,
                             const std::array<Lanes, 2>& step, int k, Wrap wrap) {
    std::array<Lanes, 2> out;
    dispatch<wrap_place>(first, side, j, step, k, wrap, out);
    return out;
}

void find_texels(const std::array<Lanes, 2>& uv, int width, int height, const LaneIntegers& level, Wrap wrap,
                 LaneTexels& out) {
    dispatch<find_cells>(uv, width, height, level, wrap, out);
}

void find_nearest(const std::array<Lanes, 2>& uv, int width, int height, LaneIntegers& out) {
    dispatch<find_one>(uv, width, height, out);
}

}  // namespace nicol
