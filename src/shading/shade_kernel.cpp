// SPDX-License-Identifier: MIT
#include "shading/shade_kernel.hpp"

#include <numbers>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

constexpr float half_root2 = std::numbers::sqrt2_v<float> / 2;

// Sums of rows times light that go with cos m phi and with sin m phi, for each Stokes component.
template <int Rows>
struct Sums {
    LaneVector cosine[Rows] = {};
    LaneVector sine[Rows] = {};
};

[[gnu::always_inline]] inline const LaneVector& at(const Lanes* from) {
    return *reinterpret_cast<const LaneVector*>(from);
}

// a and b: a coefficient and that of -m, of which one is the real and one the imaginary part of z. s0 turns
// by -m phi: Re z = a cos + b sin and Im z = b cos - a sin. For s3, exchange a and b: z turns by m phi, with
// Re z = b cos - a sin and Im z = a cos + b sin.
template <int Rows, bool Circular>
[[gnu::always_inline]] inline void add_scalars(const ShadeTerms& terms, ShadeTerms::Run run,
                                               std::size_t row_size, const Lanes* table, const Lanes* light,
                                               Sums<Rows>& sums) {
    constexpr bool flip = Circular;
    for (std::size_t k = run.first; k < run.last; ++k) {
        const MirrorBasis::ScalarPair& pair = terms.basis.scalar_pairs()[k];
        const LaneVector a = at(light + pair.cosine);
        const LaneVector b = pair.m > 0 ? at(light + pair.sine) : LaneVector{};
        for (int p = 0; p < Rows; ++p) {
            const LaneVector row = at(table + static_cast<std::size_t>(p) * row_size + pair.entry);
            if ((p < 2) != flip) {
                sums.cosine[p] += row * a;
                sums.sine[p] += row * b;
            } else {
                sums.cosine[p] += row * b;
                sums.sine[p] -= row * a;
            }
        }
    }
}

// With E and O of prepare_rows(): Re E cos - ... for rows 0 and 1, Im for the others.
template <int Rows>
[[gnu::always_inline]] inline void add_spins(const ShadeTerms& terms, ShadeTerms::Run run,
                                             std::size_t row_size, const Lanes* table, const Lanes* light,
                                             Sums<Rows>& sums) {
    const std::size_t odd = terms.basis.spin().size();
    for (std::size_t k = run.first; k < run.last; ++k) {
        const MirrorBasis::SpinPair& pair = terms.basis.spin_pairs()[k];
        const LaneVector ec = at(light + pair.cosine);
        const LaneVector oc = at(light + pair.cosine + odd);
        if (pair.m == 0) {
            for (int p = 0; p < Rows; ++p) {
                const LaneVector row = at(table + static_cast<std::size_t>(p) * row_size + pair.plus);
                if (pair.l % 2 == 0) {
                    sums.cosine[p] += row * (p < 2 ? ec : oc);
                } else if (p < 2) {
                    sums.cosine[p] -= row * oc;
                } else {
                    sums.cosine[p] += row * ec;
                }
            }
            continue;
        }
        const LaneVector es = at(light + pair.sine);
        const LaneVector os = at(light + pair.sine + odd);
        for (int p = 0; p < Rows; ++p) {
            const Lanes* rows = table + static_cast<std::size_t>(p) * row_size;
            const LaneVector first = at(rows + pair.plus);
            const LaneVector second = at(rows + pair.minus);
            if (p < 2) {
                sums.cosine[p] += first * ec + second * os;
                sums.sine[p] += second * oc - first * es;
            } else {
                sums.cosine[p] += first * oc - second * es;
                sums.sine[p] -= second * ec + first * os;
            }
        }
    }
}

template <int Rows>
[[gnu::always_inline]] inline void respond_rows(const ShadeTerms& terms, std::size_t row_size,
                                                const Lanes* table, const Lanes* light, const Lanes* cosine,
                                                const Lanes* sine, Lanes* stokes) {
    LaneVector s[Rows] = {};
    for (std::size_t m = 0; m < terms.scalars.size(); ++m) {
        Sums<Rows> sums;
        add_scalars<Rows, false>(terms, terms.scalars[m], row_size, table, light, sums);
        add_spins<Rows>(terms, terms.spins[m], row_size, table, light, sums);
        if (terms.circular) {
            add_scalars<Rows, true>(terms, terms.scalars[m], row_size, table + terms.basis.s3_entry(),
                                    light + terms.basis.s3_begin(), sums);
        }
        for (int p = 0; p < Rows; ++p) s[p] += sums.cosine[p] * at(cosine + m) + sums.sine[p] * at(sine + m);
    }
    for (int p = 0; p < Rows; ++p) store(stokes + p, s[p]);
}

template <class Pair>
std::vector<ShadeTerms::Run> runs(const std::vector<Pair>& pairs, int order) {
    std::vector<ShadeTerms::Run> out(static_cast<std::size_t>(order) + 1);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        ShadeTerms::Run& run = out[static_cast<std::size_t>(pairs[k].m)];
        if (run.last == 0) run.first = k;
        run.last = k + 1;
    }
    return out;
}

// In place of the rows r of z = E + i O at m and of z' at -m, sign z' = conj E + i conj O, those of E and O:
// r Re z + r' Re z' = (r + sign r') Re E + (sign r' - r) Im O, and likewise for Im. join() halves E and O.
[[gnu::always_inline]] inline void prepare_all(const ShadeTerms& terms, std::size_t row_size,
                                               std::size_t rows, Lanes* table) {
    for (const MirrorBasis::SpinPair& pair : terms.basis.spin_pairs()) {
        const float sign = pair.l % 2 == 0 ? 0.5F : -0.5F;
        for (std::size_t p = 0; p < rows; ++p) {
            Lanes* plus = table + p * row_size + pair.plus;
            Lanes* minus = table + p * row_size + pair.minus;
            const LaneVector r = at(plus);
            if (pair.m == 0) {
                store(plus, half_root2 * r);
                continue;
            }
            const LaneVector other = sign * at(minus);
            store(plus, other + 0.5F * r);
            store(minus, other - 0.5F * r);
        }
    }
}

[[gnu::always_inline]] inline void respond_all(const ShadeTerms& terms, std::size_t row_size,
                                               std::size_t rows, const Lanes* table, const Lanes* light,
                                               const Lanes* cosine, const Lanes* sine, Lanes* stokes) {
    if (rows == 1) {
        respond_rows<1>(terms, row_size, table, light, cosine, sine, stokes);
    } else if (rows == 3) {
        respond_rows<3>(terms, row_size, table, light, cosine, sine, stokes);
    } else {
        respond_rows<4>(terms, row_size, table, light, cosine, sine, stokes);
    }
}

}  // namespace

ShadeTerms::ShadeTerms(const LightLayout& layout)
    : basis(layout),
      scalars(runs(basis.scalar_pairs(), layout.order())),
      spins(runs(basis.spin_pairs(), layout.order())),
      circular(layout.kind() == LightKind::full) {}

void prepare_rows(const ShadeTerms& terms, std::size_t row_size, std::size_t rows, Lanes* table) {
    dispatch<prepare_all>(terms, row_size, rows, table);
}

void respond(const ShadeTerms& terms, std::size_t row_size, std::size_t rows, const Lanes* table,
             const Lanes* light, const Lanes* cosine, const Lanes* sine, Lanes* stokes) {
    dispatch<respond_all>(terms, row_size, rows, table, light, cosine, sine, stokes);
}

}  // namespace nicol
