// SPDX-License-Identifier: MIT
#include "specular/lane_reflection.hpp"

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"
#include "specular/high_order_factors.hpp"

namespace nicol {
namespace {

[[gnu::always_inline]] inline const LaneVector& at(const Lanes* from) {
    return *reinterpret_cast<const LaneVector*>(from);
}

constexpr std::size_t kRest = HighOrderFactors::kUnpolarized;

// Adds the blocks (0,0) (1,0) (0,1) (1,1) and (2,2) (3,2) (2,3) (3,3) of a mirror-symmetric factor.
template <bool Polarized>
[[gnu::always_inline]] inline void add_even(const Lanes* first, const Lanes* others, const LaneVector* s,
                                            LaneVector* sum) {
    sum[0] += at(first) * s[0];
    sum[1] += at(first + 1) * s[0];
    if constexpr (Polarized) {
        sum[0] += at(others) * s[1];
        sum[1] += at(others + 1) * s[1];
        sum[2] += at(others + 2) * s[2] + at(others + 4) * s[3];
        sum[3] += at(others + 3) * s[2] + at(others + 5) * s[3];
    }
}

// Adds the blocks that change sign between right and left.
template <bool Polarized>
[[gnu::always_inline]] inline void add_odd(const Lanes* first, const Lanes* others, const LaneVector* s,
                                           LaneVector* sum) {
    sum[2] += at(first) * s[0];
    sum[3] += at(first + 1) * s[0];
    if constexpr (Polarized) {
        sum[0] += at(others) * s[2] + at(others + 4) * s[3];
        sum[1] += at(others + 1) * s[2] + at(others + 5) * s[3];
        sum[2] += at(others + 2) * s[1];
        sum[3] += at(others + 3) * s[1];
    }
}

// Adds the reflection of the light at the taps by mirror-symmetric factors, in the s-frame.
template <bool Polarized>
[[gnu::always_inline]] inline void add_taps(const ChannelTaps& taps, const Lanes* f, const Lanes& lobe,
                                            const Lanes& hemisphere, LaneVector* sum) {
    constexpr int components = Polarized ? 4 : 1;
    LaneVector s[4];
    LaneVector difference[4];
    const auto take = [&](const Lanes* from) {
        for (int p = 0; p < components; ++p) s[p] = at(from + p);
    };
    take(taps.central);
    add_even<Polarized>(f, f + kRest, s, sum);
    if (taps.up != nullptr) {
        take(taps.up);
        add_even<Polarized>(f + 2, f + kRest + 6, s, sum);
        take(taps.down);
        add_even<Polarized>(f + 4, f + kRest + 12, s, sum);
        for (int p = 0; p < components; ++p) {
            s[p] = at(taps.right + p) + at(taps.left + p);
            difference[p] = at(taps.right + p) - at(taps.left + p);
        }
        add_even<Polarized>(f + 6, f + kRest + 18, s, sum);
        add_odd<Polarized>(f + 8, f + kRest + 24, difference, sum);
    }
    for (int p = 0; p < 4; ++p) sum[p] *= at(&lobe);
    if (taps.base != nullptr) {
        const LaneVector base = at(&hemisphere) * at(taps.base);
        sum[0] += base * at(f + 10);
        sum[1] += base * at(f + 11);
    }
}

template <bool Polarized>
[[gnu::always_inline]] inline void reflect(const ChannelTaps& taps, const Lanes* f, std::size_t pairings,
                                           const LaneMirror& mirror, const Lanes& lobe,
                                           const Lanes& hemisphere, Lanes* stokes) {
    LaneVector sum[4] = {};
    add_taps<Polarized>(taps, f, lobe, hemisphere, sum);
    if (pairings > 1) {
        LaneVector second[4] = {};
        add_taps<Polarized>(taps, f + HighOrderFactors::kElements, lobe, hemisphere, second);
        for (int p = 0; p < 4; ++p) sum[p] += second[p ^ 2];
    }
    const LaneVector c = at(&mirror.frame_cosine);
    const LaneVector sine = at(&mirror.frame_sine);
    store(stokes, sum[0]);
    store(stokes + 1, c * sum[1] + sine * sum[2]);
    store(stokes + 2, c * sum[2] - sine * sum[1]);
    store(stokes + 3, sum[3]);
}

}  // namespace

void reflect_taps(const ChannelTaps& taps, bool polarized, const Lanes* factors, std::size_t pairings,
                  const LaneMirror& mirror, const Lanes& lobe, const Lanes& hemisphere, Lanes* stokes) {
    if (polarized) {
        dispatch<reflect<true>>(taps, factors, pairings, mirror, lobe, hemisphere, stokes);
    } else {
        dispatch<reflect<false>>(taps, factors, pairings, mirror, lobe, hemisphere, stokes);
    }
}

}  // namespace nicol
