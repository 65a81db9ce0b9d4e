// SPDX-License-Identifier: MIT
#include "shading/lane_response.hpp"

#include <vector>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using Run = LightLayout::Run;

[[gnu::always_inline]] inline const LaneVector& at(const Lanes* from) {
    return *reinterpret_cast<const LaneVector*>(from);
}

// Sums of rows times light that are multiplied by cos m phi and by sin m phi, for each Stokes component.
template <int Rows>
struct Sums {
    LaneVector cosine[Rows] = {};
    LaneVector sine[Rows] = {};
};

// Adds one run. Sign: the run's sign of the sines, or 0 for m = 0, because sines vanish there.
template <int Rows, int Pairings, int Sign>
[[gnu::always_inline]] inline void add_run(const Run& run, std::size_t row_size, const Lanes* table,
                                           const Lanes* light, Sums<Rows>& sums) {
    for (std::size_t i = 0; i < run.count; ++i) {
        const LaneVector even = at(light + run.even + i);
        const LaneVector odd = at(light + run.odd + i);
        for (int r = 0; r < Rows * Pairings; ++r) {
            const int p = r / Pairings;
            const bool of_even = (p < 2) == (r % Pairings == 0);
            const LaneVector row = at(table + static_cast<std::size_t>(r) * row_size + i);
            sums.cosine[p] += row * (of_even ? even : odd);
            if constexpr (Sign > 0) sums.sine[p] += row * (of_even ? odd : -even);
            if constexpr (Sign < 0) sums.sine[p] += row * (of_even ? -odd : even);
        }
    }
}

template <int Rows, int Pairings>
[[gnu::always_inline]] inline void respond_rows(const std::vector<Run>& runs, std::size_t row_size,
                                                const Lanes* table, const Lanes* light, const Lanes* cosine,
                                                const Lanes* sine, Lanes* stokes) {
    Sums<Rows> first;
    auto run = runs.begin();
    for (; run != runs.end() && run->m == 0; table += run++->count) {
        add_run<Rows, Pairings, 0>(*run, row_size, table, light, first);
    }
    LaneVector s[Rows];
    for (int p = 0; p < Rows; ++p) s[p] = first.cosine[p];
    while (run != runs.end()) {
        const int m = run->m;
        Sums<Rows> sums;
        for (; run != runs.end() && run->m == m; table += run++->count) {
            if (run->sign > 0) {
                add_run<Rows, Pairings, 1>(*run, row_size, table, light, sums);
            } else {
                add_run<Rows, Pairings, -1>(*run, row_size, table, light, sums);
            }
        }
        for (int p = 0; p < Rows; ++p) s[p] += sums.cosine[p] * at(cosine + m) + sums.sine[p] * at(sine + m);
    }
    for (int p = 0; p < Rows; ++p) store(stokes + p, s[p]);
}

template <int Pairings>
[[gnu::always_inline]] inline void respond_pairings(const LightLayout& layout, std::size_t rows,
                                                    const Lanes* table, const Lanes* light,
                                                    const Lanes* cosine, const Lanes* sine, Lanes* stokes) {
    const std::size_t row_size = layout.row_size();
    if (rows == 1) {
        respond_rows<1, Pairings>(layout.runs(), row_size, table, light, cosine, sine, stokes);
    } else if (rows == 3) {
        respond_rows<3, Pairings>(layout.runs(), row_size, table, light, cosine, sine, stokes);
    } else {
        respond_rows<4, Pairings>(layout.runs(), row_size, table, light, cosine, sine, stokes);
    }
}

[[gnu::always_inline]] inline void respond_any(const LightLayout& layout, std::size_t rows,
                                               std::size_t pairings, const Lanes* table, const Lanes* light,
                                               const Lanes* cosine, const Lanes* sine, Lanes* stokes) {
    if (pairings == 1) {
        respond_pairings<1>(layout, rows, table, light, cosine, sine, stokes);
    } else {
        respond_pairings<2>(layout, rows, table, light, cosine, sine, stokes);
    }
}

}  // namespace

void respond(const LightLayout& layout, std::size_t rows, std::size_t pairings, const Lanes* table,
             const Lanes* light, const Lanes* cosine, const Lanes* sine, Lanes* stokes) {
    dispatch<respond_any>(layout, rows, pairings, table, light, cosine, sine, stokes);
}

}  // namespace nicol
