// SPDX-License-Identifier: MIT
// Rings of latitude and their recurrences for the Legendre step. Each degree has one recurrence over l for s0
// and s3 and two for s1 + i s2, on all rings at once.
#pragma once

#include "harmonics/legendre_recurrence.hpp"
#include "harmonics/scaled.hpp"
#include "harmonics/transform.hpp"

namespace nicol {

/// Products of square roots from which the steps of every recurrence are made.
struct RootTables {
    explicit RootTables(int order)
        : root(2 * static_cast<std::size_t>(order) + 4), inverse_root(root.size()), inverse_ll(root.size()) {
        for (std::size_t k = 1; k < root.size(); ++k) {
            root[k] = std::sqrt(static_cast<double>(k));
            inverse_root[k] = 1 / root[k];
            inverse_ll[k] = 1 / (static_cast<double>(k) * static_cast<double>(k + 1));
        }
        for (std::size_t s = 0; s < 2; ++s) {
            up[s].resize(static_cast<std::size_t>(order) + 2);
            down[s].resize(up[s].size());
            for (std::size_t l = 2 * s; l < up[s].size(); ++l) {
                const double k = static_cast<double>(l) + 1;
                const double n = 2.0 * static_cast<double>(s);
                up[s][l] = k * std::sqrt((2 * k - 1) * (2 * k + 1) / ((k - n) * (k + n)));
                down[s][l] = 1 / up[s][l];
            }
        }
    }

    std::vector<double> root, inverse_root, inverse_ll;
    std::vector<double> up[2], down[2];  // by |spin| / 2, then l
};

/// Latitude of the northern half, and the indices of the rows at the latitude and at its mirror image; -1 if
/// there is no row. Both rows share their recurrences, because d^l_{mn}(pi - theta) = (-1)^(l+m)
/// d^l_{m,-n}(theta).
struct LatitudeRing {
    HalfAngle half;
    int north = -1;
    int south = -1;
    double north_weight = 0;  ///< 2 pi times the row's weight; 0 if there is no row
    double south_weight = 0;
};

struct LegendreTransform::Plan {
    /// Second indices of d. Each has a chain of first values.
    static constexpr int kSecond[3] = {0, -2, 2};

    Plan(int order_, LatitudeRows rows_);

    /// Computes the first values at degree m of the chains of s0 and s3 (`scalar`) and of s1 + i s2 (`spin`).
    /// Must be called for m = 0, 1, 2 ... in turn.
    void start_degree(int m, bool scalar, bool spin);
    /// Fills steps with the recurrence of chain c at degree m from l = `first` on, for harmonics that include
    /// their norm.
    void fill_steps(std::size_t c, int m, int first);
    /// Runs the recurrence over the steps from l = `first`. synthesize() computes sums from f of the steps;
    /// analyze() computes f from sums.
    void synthesize(std::size_t c, int first, bool split);
    void analyze(std::size_t c, int first, bool split);

    double& sum(std::size_t k, std::size_t ring) { return sums[k * padded + ring]; }

    int order;
    LatitudeRows rows;
    std::vector<LatitudeRing> rings;  // from the pole to the equator
    std::vector<LegendreStep> steps;

private:
    LegendreRings start(std::size_t c, int first);

    RootTables tables;
    std::size_t padded = 0;   // number of rings, rounded up to whole groups of kRingLanes
    std::size_t skipped = 0;  // number of rings too near the pole for this degree
    std::size_t from = 0;     // first ring of the first group that is not skipped
    std::vector<double> t, value;
    std::vector<int> exponent;
    std::vector<Scaled> first_step;  // sin cos of each ring's half angle
    std::vector<Scaled> chains[3];
    std::vector<Scaled> beginnings;  // [m = 0..2][chain][ring]
    std::vector<double> sums;        // [8][padded]
};

}  // namespace nicol
