// SPDX-License-Identifier: MIT
#include "simd/lane_phases.hpp"

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// DoubleLanes promises less alignment than a vector of its size does.
using DoubleVector
    [[gnu::vector_size(sizeof(DoubleLanes)), gnu::may_alias, gnu::aligned(alignof(DoubleLanes))]] = double;

[[gnu::always_inline]] inline void raise_all(const DoubleLanes& cosine, const DoubleLanes& sine,
                                             std::size_t count, Lanes* cosines, Lanes* sines) {
    const DoubleVector c = *reinterpret_cast<const DoubleVector*>(&cosine);
    const DoubleVector s = *reinterpret_cast<const DoubleVector*>(&sine);
    DoubleVector re = DoubleVector{} + 1.0;
    DoubleVector im{};
    for (std::size_t m = 0; m < count; ++m) {
        store(cosines + m, __builtin_convertvector(re, LaneVector));
        store(sines + m, __builtin_convertvector(im, LaneVector));
        const DoubleVector next = re * c - im * s;
        im = im * c + re * s;
        re = next;
    }
}

}  // namespace

void raise_phases(const DoubleLanes& cosine, const DoubleLanes& sine, std::size_t count, Lanes* cosines,
                  Lanes* sines) {
    dispatch<raise_all>(cosine, sine, count, cosines, sines);
}

}  // namespace nicol
