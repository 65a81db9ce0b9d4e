// SPDX-License-Identifier: MIT
// Conversions between blocks and rows. A block of an isotropic matrix acts on the lanes (s0_lm, s3_lm, w_lm,
// conj w_l-m). Rows are first made over complex numbers, which equal the lanes up to factors: sqrt2
// conj(s0_lm), i sqrt2 s3_lm, w_lm. Their real parts give s0 and s1, their imaginary parts s2 and s3. For a
// mirror-symmetric material, each entry is one real number: the first pairing. A matrix that every mirror
// negates is, for m > 0, i times a mirror-symmetric matrix. The factor i rotates light about the normal by a
// quarter of its wave, which turns even numbers into odd numbers: the second pairing.
#include "material/matrix_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "harmonics/spin_harmonics.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;
using Block = IsotropicMatrix::Block;
constexpr double kRoot2 = std::numbers::sqrt2;
using std::numbers::pi;

// Entries of the four rows for s0_lm, w_lm, w_l-m and s3_lm at one l and m.
struct RowEntries {
    std::array<std::array<double, 4>, 4> at{};  // [p][s0, w m, w -m, s3]
};

RowEntries entries_of(const Block& g, int m) {
    RowEntries e;
    auto& r = e.at;
    if (m == 0) {
        r[0] = {g[0].real(), g[2].real() + g[3].real(), 0, 0};
        r[1] = {g[8].real(), g[10].real() + g[11].real(), 0, 0};
        r[2] = {0, g[10].real() - g[11].real(), 0, g[9].imag()};
        r[3] = {0, g[7].imag() - g[6].imag(), 0, g[5].real()};
        return e;
    }
    r[0] = {kRoot2 * g[0].real(), 2 * g[2].real(), 2 * g[3].real(), kRoot2 * g[1].imag()};
    r[1] = {(g[8].real() + g[12].real()) / kRoot2, g[10].real() + g[14].real(), g[11].real() + g[15].real(),
            (g[9].imag() + g[13].imag()) / kRoot2};
    r[2] = {(g[12].real() - g[8].real()) / kRoot2, g[10].real() - g[14].real(), g[15].real() - g[11].real(),
            (g[9].imag() - g[13].imag()) / kRoot2};
    r[3] = {kRoot2 * g[4].imag(), -2 * g[6].imag(), 2 * g[7].imag(), kRoot2 * g[5].real()};
    return e;
}

// Returns the entries of the second pairing.
RowEntries second_entries_of(const Block& g, int m) {
    if (m > 0) {
        Block symmetric;
        for (std::size_t e = 0; e < 16; ++e) symmetric[e] = Complex(0, -1) * g[e];
        return entries_of(symmetric, m);
    }
    RowEntries e;
    e.at[0] = {0, g[3].imag() - g[2].imag(), 0, g[1].real()};
    e.at[1] = {0, g[11].imag() - g[10].imag(), 0, g[9].real()};
    e.at[2] = {g[8].imag(), g[10].imag() + g[11].imag(), 0, 0};
    e.at[3] = {g[4].real(), g[6].real() + g[7].real(), 0, 0};
    return e;
}

Block block_of(const RowEntries& e, int m) {
    const auto& r = e.at;
    const Complex i(0, 1);
    if (m == 0) {
        const double same = (r[1][1] + r[2][1]) / 2;
        const double other = (r[1][1] - r[2][1]) / 2;
        return {r[0][0],
                0.0,
                r[0][1] / 2,
                r[0][1] / 2,
                0.0,
                r[3][3],
                -i * r[3][1] / 2.0,
                i * r[3][1] / 2.0,
                r[1][0],
                i * r[2][3],
                same,
                other,
                r[1][0],
                -i * r[2][3],
                other,
                same};
    }
    return {r[0][0] / kRoot2,
            i * r[0][3] / kRoot2,
            r[0][1] / 2,
            r[0][2] / 2,
            i * r[3][0] / kRoot2,
            r[3][3] / kRoot2,
            -i * r[3][1] / 2.0,
            i * r[3][2] / 2.0,
            (r[1][0] - r[2][0]) / kRoot2,
            i * (r[1][3] + r[2][3]) / kRoot2,
            (r[1][1] + r[2][1]) / 2,
            (r[1][2] - r[2][2]) / 2,
            (r[1][0] + r[2][0]) / kRoot2,
            i * (r[1][3] - r[2][3]) / kRoot2,
            (r[1][1] - r[2][1]) / 2,
            (r[1][2] + r[2][2]) / 2};
}

Block second_block_of(const RowEntries& e, int m) {
    const Complex i(0, 1);
    if (m > 0) {
        Block block = block_of(e, m);
        for (Complex& value : block) value *= i;
        return block;
    }
    const auto& r = e.at;
    const double same = (r[2][1] - r[1][1]) / 2;
    const double other = (r[2][1] + r[1][1]) / 2;
    return {0.0,          r[0][3],     -i * r[0][1] / 2.0, i * r[0][1] / 2.0, r[3][0],  0.0,
            r[3][1] / 2,  r[3][1] / 2, i * r[2][0],        r[1][3],           i * same, i * other,
            -i * r[2][0], r[1][3],     -i * other,         -i * same};
}

// Applies, or takes back, the signs that a quarter of a wave gives to pairs of the second pairing; m > 0.
void rotate_pairs(RowEntries& entries) {
    for (std::size_t p = 0; p < 4; ++p) {
        auto& [s0, e, o, s3] = entries.at[p];
        if (p < 2) {
            o = -o;
            s3 = -s3;
        } else {
            s0 = -s0;
            e = -e;
        }
    }
}

// Conversions between entries for w_lm and w_l-m and entries for the pairs of e and o (LightLayout). m = 0
// has only w_l0 and one pair, whose odd number takes the sign of the harmonic's mirror image.
void to_pairs(RowEntries& entries, int l, int m, std::size_t pairing) {
    const double image = l % 2 == 0 ? 1 : -1;
    for (std::size_t p = 0; p < 4; ++p) {
        auto& [s0, plus, minus, s3] = entries.at[p];
        if (m == 0) {
            if ((p >= 2) == (pairing == 0)) plus *= image;
            continue;
        }
        const double sum = (plus + image * minus) / kRoot2;
        const double difference = (plus - image * minus) / kRoot2;
        plus = p < 2 ? sum : -difference;
        minus = p < 2 ? difference : sum;
    }
    if (m > 0 && pairing == 1) rotate_pairs(entries);
}
void from_pairs(RowEntries& entries, int l, int m, std::size_t pairing) {
    if (m > 0 && pairing == 1) rotate_pairs(entries);
    const double image = l % 2 == 0 ? 1 : -1;
    for (std::size_t p = 0; p < 4; ++p) {
        auto& [s0, e, o, s3] = entries.at[p];
        if (m == 0) {
            if ((p >= 2) == (pairing == 0)) e *= image;
            continue;
        }
        const double sum = (p < 2 ? e + o : o - e) / kRoot2;
        const double difference = (p < 2 ? e - o : o + e) / kRoot2;
        e = sum;
        o = image * difference;
    }
}

// Returns the places of the pairs of s0, e, o and s3 in a row by psh_index(l, m), m >= 0; absent: row_size().
std::vector<std::array<std::size_t, 4>> positions(const LightLayout& layout) {
    std::array<std::size_t, 4> none{};
    none.fill(layout.row_size());
    std::vector<std::array<std::size_t, 4>> at(psh_count(layout.order()), none);
    std::size_t j = 0;
    for (const LightLayout::Run& run : layout.runs()) {
        const std::size_t slot = run.part == LightKind::unpolarized ? 0
                                 : run.part == LightKind::full      ? 3
                                 : run.m == 0 || run.sign > 0       ? 1
                                                                    : 2;
        for (std::size_t i = 0; i < run.count; ++i) {
            at[psh_index(run.l + static_cast<int>(i) * run.step, run.m)][slot] = j++;
        }
    }
    return at;
}

/// Values of the lanes' harmonics at a latitude: Y_lm for two lanes, 2Y_lm and 2Y_l-m.
struct OutgoingHarmonics {
    OutgoingHarmonics(int order, double theta) : scalar(psh_count(order)), spin2(psh_count(order)) {
        spin_harmonics(0, order, theta, scalar);
        spin_harmonics(2, order, theta, spin2);
    }
    [[nodiscard]] std::array<double, 4> lanes(int l, int m) const {
        const double y = scalar[psh_index(l, m)];
        return {y, y, spin2[psh_index(l, m)], spin2[psh_index(l, -m)]};
    }
    std::vector<double> scalar, spin2;
};

}  // namespace

void rows_from_matrix(const IsotropicMatrix& matrix, double theta_out, const LightLayout& layout,
                      std::size_t pairings, std::span<double> rows) {
    std::ranges::fill(rows, 0.0);
    const auto at = positions(layout);
    const OutgoingHarmonics y(matrix.order_out(), theta_out);
    const int order_in = std::min(layout.order(), matrix.order_in());
    std::vector<Block> sums(static_cast<std::size_t>(order_in) + 1);
    for (int m = 0; m <= std::min(order_in, matrix.order_out()); ++m) {
        std::ranges::fill(sums, Block{});
        for (int l = m; l <= matrix.order_out(); ++l) {
            const std::array<double, 4> lane = y.lanes(l, m);
            for (int k = m; k <= order_in; ++k) {
                const Block& block = matrix.block(m, l, k);
                for (std::size_t e = 0; e < 16; ++e)
                    sums[static_cast<std::size_t>(k)][e] += lane[e / 4] * block[e];
            }
        }
        for (int k = m; k <= order_in; ++k) {
            const Block& sum = sums[static_cast<std::size_t>(k)];
            const auto& slots = at[psh_index(k, m)];
            for (std::size_t pairing = 0; pairing < pairings; ++pairing) {
                RowEntries entries = pairing == 0 ? entries_of(sum, m) : second_entries_of(sum, m);
                to_pairs(entries, k, m, pairing);
                for (std::size_t p = 0; p < 4; ++p) {
                    const std::size_t row = (p * pairings + pairing) * layout.row_size();
                    for (std::size_t s = 0; s < 4; ++s)
                        if (slots[s] < layout.row_size()) rows[row + slots[s]] = entries.at[p][s];
                }
            }
        }
    }
}

void add_circle(IsotropicMatrix& matrix, double theta_out, double weight, const LightLayout& layout,
                std::size_t pairings, std::span<const double> rows) {
    const auto at = positions(layout);
    const OutgoingHarmonics y(matrix.order_out(), theta_out);
    for (int m = 0; m <= std::min(matrix.order_in(), matrix.order_out()); ++m) {
        for (int k = m; k <= matrix.order_in(); ++k) {
            Block g{};
            const auto& slots = at[psh_index(k, m)];
            for (std::size_t pairing = 0; pairing < pairings; ++pairing) {
                RowEntries entries;
                for (std::size_t p = 0; p < 4; ++p) {
                    const std::size_t row = (p * pairings + pairing) * layout.row_size();
                    for (std::size_t s = 0; s < 4; ++s)
                        if (slots[s] < layout.row_size()) entries.at[p][s] = rows[row + slots[s]];
                }
                from_pairs(entries, k, m, pairing);
                const Block part = pairing == 0 ? block_of(entries, m) : second_block_of(entries, m);
                for (std::size_t e = 0; e < 16; ++e) g[e] += part[e];
            }
            for (int l = m; l <= matrix.order_out(); ++l) {
                const std::array<double, 4> lane = y.lanes(l, m);
                Block& block = matrix.block(m, l, k);
                for (std::size_t e = 0; e < 16; ++e) block[e] += 2 * pi * weight * lane[e / 4] * g[e];
            }
        }
    }
}

}  // namespace nicol
