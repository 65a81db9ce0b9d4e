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

// Sums of rows times light that go with cos m phi and with sin m phi, for each Stokes component.
template <int Rows>
struct Sums {
    LaneVector cosine[Rows] = {};
    LaneVector sine[Rows] = {};
};

// Sign of the sines: that of the run, or 0 where m = 0 and they vanish.
template <int Rows, int Sign>
[[gnu::always_inline]] inline void add_run(const Run& run, std::size_t row_size, const Lanes* table,
                                           const Lanes* light, Sums<Rows>& sums) {
    for (std::size_t i = 0; i < run.count; ++i) {
        const LaneVector even = at(light + run.even + i);
        const LaneVector odd = at(light + run.odd + i);
        for (int p = 0; p < Rows; ++p) {
            const LaneVector row = at(table + static_cast<std::size_t>(p) * row_size + i);
            sums.cosine[p] += row * (p < 2 ? even : odd);
            if constexpr (Sign > 0) sums.sine[p] += row * (p < 2 ? odd : -even);
            if constexpr (Sign < 0) sums.sine[p] += row * (p < 2 ? -odd : even);
        }
    }
}

template <int Rows>
[[gnu::always_inline]] inline void respond_rows(const std::vector<Run>& runs, std::size_t row_size,
                                                const Lanes* table, const Lanes* light, const Lanes* cosine,
                                                const Lanes* sine, Lanes* stokes) {
    Sums<Rows> first;
    auto run = runs.begin();
    for (; run != runs.end() && run->m == 0; table += run++->count) {
        add_run<Rows, 0>(*run, row_size, table, light, first);
    }
    LaneVector s[Rows];
    for (int p = 0; p < Rows; ++p) s[p] = first.cosine[p];
    while (run != runs.end()) {
        const int m = run->m;
        Sums<Rows> sums;
        for (; run != runs.end() && run->m == m; table += run++->count) {
            if (run->sign > 0) {
                add_run<Rows, 1>(*run, row_size, table, light, sums);
            } else {
                add_run<Rows, -1>(*run, row_size, table, light, sums);
            }
        }
        for (int p = 0; p < Rows; ++p) s[p] += sums.cosine[p] * at(cosine + m) + sums.sine[p] * at(sine + m);
    }
    for (int p = 0; p < Rows; ++p) store(stokes + p, s[p]);
}

[[gnu::always_inline]] inline void respond_any(const LightLayout& layout, std::size_t rows,
                                               const Lanes* table, const Lanes* light, const Lanes* cosine,
                                               const Lanes* sine, Lanes* stokes) {
    const std::size_t row_size = layout.row_size();
    if (rows == 1) {
        respond_rows<1>(layout.runs(), row_size, table, light, cosine, sine, stokes);
    } else if (rows == 3) {
        respond_rows<3>(layout.runs(), row_size, table, light, cosine, sine, stokes);
    } else {
        respond_rows<4>(layout.runs(), row_size, table, light, cosine, sine, stokes);
    }
}

}  // namespace

void respond(const LightLayout& layout, std::size_t rows, const Lanes* table, const Lanes* light,
             const Lanes* cosine, const Lanes* sine, Lanes* stokes) {
    dispatch<respond_any>(layout, rows, table, light, cosine, sine, stokes);
}

}  // namespace nicol
