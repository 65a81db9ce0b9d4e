// SPDX-License-Identifier: MIT
// Figure 11: truncated light, rotated by its coefficients and rotated back in space, should stay unchanged.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiment.hpp"
#include "image.hpp"
#include "light.hpp"
#include "naive.hpp"

namespace {

Panel component(const Grid& grid, const Doubles& stokes, std::size_t p) {
    Panel panel{grid.columns, grid.theta.size(), {}};
    for (std::size_t i = 0; i < stokes.size(); i += 4) panel.values.push_back(stokes[i + p]);
    return panel;
}

Doubles minus(Doubles a, const Doubles& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

struct Loop {
    Doubles before, after;
};

/// Rotates coefficients, and samples of these back in space, in spin-2 harmonics.
Loop spin2_loop(const Grid& grid, std::uint32_t order, const Doubles& f, const Rotation& rotation) {
    const Doubles rotated = rotate(order, f, rotation);
    return {from_scalars(to_scalars(grid.synthesize(f))),
            rotated_samples(grid, transposed(rotation),
                            [&](const auto& w) { return evaluate(order, rotated, w); })};
}

/// Runs the loop in the naive basis, where the rotated coefficients are those of the rotated field.
Loop naive_loop(const Grid& grid, std::uint32_t order, const Doubles& f, const Rotation& rotation) {
    const Doubles rotated = grid.analyze(to_scalars(
        rotated_samples(grid, rotation, [&](const auto& w) { return from_scalars(evaluate(order, f, w)); })));
    return {from_scalars(grid.synthesize(f)), rotated_samples(grid, transposed(rotation), [&](const auto& w) {
                return from_scalars(evaluate(order, rotated, w));
            })};
}

}  // namespace

void figure_11(Experiment& experiment) {
    const Rotation rotation = rotation_about({10, 0.1, 0.2});
    std::printf("  %-8s %34s %34s\n", "", "spin-2: difference over rms", "naive: difference over rms");
    std::printf("  %-8s %17s %16s %17s %16s\n", "order", "rms", "largest", "rms", "largest");
    double worst_spin2 = 0, best_naive = 1;
    Image image(3);
    for (const std::uint32_t order : {4U, 9U, 19U}) {
        const Doubles f = light(experiment, order);
        const Grid grid(NICOL_PSH_GRID_GAUSS_LEGENDRE, order, 96, 192);
        const Doubles naive = grid.analyze(to_scalars(grid.synthesize(f)));
        const Loop a = spin2_loop(grid, order, f, rotation);
        const Loop b = naive_loop(grid, order, naive, rotation);
        const double rms_a = grid.rms(a.before, true), rms_b = grid.rms(b.before, true);
        const double spin2_error = largest_difference(a.before, a.after) / rms_a;
        const double naive_error = grid.rms(minus(b.after, b.before), true) / rms_b;
        std::printf("  %-8u %17.2e %16.2e %17.2e %16.2e\n", order,
                    grid.rms(minus(a.after, a.before), true) / rms_a, spin2_error, naive_error,
                    largest_difference(b.before, b.after) / rms_b);
        worst_spin2 = std::max(worst_spin2, spin2_error);
        best_naive = std::min(best_naive, naive_error);
        if (order != 9) continue;
        const double scale = 3 * rms_a;
        for (const Loop& loop : {a, b})
            for (const Doubles& stokes : {loop.before, loop.after, minus(loop.after, loop.before)})
                image.add(component(grid, stokes, 1), Signed{scale});
    }
    experiment.claim(worst_spin2 < 1e-11, "spin-2 harmonics are invariant under rotation");
    experiment.claim(best_naive > 1e-3, "the naive basis is not");
    image.write(experiment.image("fig11_rotation_invariance.png"), 2);
}
