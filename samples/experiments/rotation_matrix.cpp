// SPDX-License-Identifier: MIT
// Figure 10: the matrix of one rotation over scalar harmonics of scalars, over scalar harmonics of s1 and s2,
// and over spin-2 harmonics, all by the same quadrature in the angular domain.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiment.hpp"
#include "image.hpp"
#include "naive.hpp"

namespace {

constexpr std::uint32_t kOrder = 9;
constexpr std::size_t kCount = (kOrder + 1) * (kOrder + 1);

std::size_t level(std::size_t i) {
    return static_cast<std::size_t>(std::sqrt(static_cast<double>(i) + 0.5));
}

struct Summary {
    double off_diagonal;  ///< share of the sum of squares outside the blocks l = l'
    double largest;       ///< largest element outside these blocks
};

Summary summary(const Panel& matrix) {
    double total = 0, off = 0, largest = 0;
    for (std::size_t i = 0; i < kCount; ++i)
        for (std::size_t j = 0; j < kCount; ++j) {
            const double x = matrix.values[i * kCount + j];
            total += x * x;
            if (level(i) == level(j)) continue;
            off += x * x;
            largest = std::max(largest, x);
        }
    return {off / total, largest};
}

/// Returns the magnitudes of components a and b of the coefficients to which `rotate_field` maps unit
/// vectors.
template <class Rotate>
Panel matrix_of(std::size_t first, std::size_t input, std::size_t a, std::size_t b, Rotate rotate_field) {
    Panel panel{kCount, kCount, std::vector<double>(kCount * kCount)};
    for (std::size_t j = first; j < kCount; ++j) {
        Doubles unit_vector(4 * kCount);
        unit_vector[4 * j + input] = 1;
        const Doubles column = rotate_field(unit_vector);
        for (std::size_t i = 0; i < kCount; ++i)
            panel.values[i * kCount + j] = std::hypot(column[4 * i + a], a == b ? 0.0 : column[4 * i + b]);
    }
    return panel;
}

}  // namespace

void figure_10(Experiment& experiment) {
    const Rotation rotation = rotation_about({10, 0.1, 0.2});
    const Grid grid(NICOL_PSH_GRID_GAUSS_LEGENDRE, kOrder, 64, 128);
    const Rotation back = transposed(rotation);
    std::vector<Vec3> sources;
    for (const double theta : grid.theta)
        for (std::size_t c = 0; c < grid.columns; ++c)
            sources.push_back(back * direction(theta, grid.phi(c)));

    const Panel scalar =
        matrix_of(0, 0, 0, 0, [&](const Doubles& f) { return grid.analyze(evaluate(kOrder, f, sources)); });
    const Panel naive = matrix_of(0, 0, 0, 3, [&](const Doubles& f) {
        const auto at = [&](const auto& w) { return from_scalars(evaluate(kOrder, f, w)); };
        return grid.analyze(to_scalars(rotated_samples(grid, rotation, at)));
    });
    double deviation = 0;
    const Panel spin2 = matrix_of(4, 1, 1, 2, [&](const Doubles& f) {
        const Doubles column = grid.analyze(
            rotated_samples(grid, rotation, [&](const auto& w) { return evaluate(kOrder, f, w); }));
        deviation = std::max(deviation, largest_difference(column, rotate(kOrder, f, rotation)));
        return column;
    });

    std::printf("  %-34s %20s %18s\n", "basis, order 9", "energy off the", "largest element");
    std::printf("  %-34s %20s %18s\n", "", "blocks l = l'", "there");
    const auto row = [](const char* name, const Summary& s) {
        std::printf("  %-34s %20.2e %18.2e\n", name, s.off_diagonal, s.largest);
        return s;
    };
    const Summary a = row("(a) scalar SH of a scalar", summary(scalar));
    const Summary b = row("(b) naive: scalar SH of s1, s2", summary(naive));
    const Summary c = row("(c) spin-2 SH of s1, s2", summary(spin2));
    std::printf("  (c) against nicol_psh_rotate: largest difference %.2e\n", deviation);
    experiment.claim(a.largest < 1e-12 && c.largest < 1e-12, "(a) and (c) keep every order to itself");
    experiment.claim(b.off_diagonal > 1e-3, "(b) mixes the orders");
    experiment.claim(deviation < 1e-12, "the Wigner D-functions give the same matrix as the quadrature");
    Image image(3);
    for (const Panel& panel : {scalar, naive, spin2}) image.add(panel, Magnitude{1, 4});
    image.write(experiment.image("fig10_rotation_matrix.png"), 4);
}
