// SPDX-License-Identifier: MIT
#include "harmonics/grid.hpp"

#include <cmath>
#include <numbers>

#include "harmonics/require.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

/// Returns `count` rows of zeros for set_pair(). Throws Error(invalid_argument) unless count is `least` to
/// `most`.
LatitudeRows empty_rows(int count, int least, int most) {
    require(count >= least && count <= most, "row count is " + std::to_string(count) + ", expected " +
                                                 std::to_string(least) + " to " + std::to_string(most));
    const auto n = static_cast<std::size_t>(count);
    LatitudeRows rows;
    rows.theta.resize(n);
    rows.sin_half.resize(n);
    rows.cos_half.resize(n);
    rows.weight.resize(n);
    return rows;
}

void set_pair(LatitudeRows& rows, int north, double theta, double weight) {
    const auto n = static_cast<std::size_t>(north);
    const auto s = rows.theta.size() - 1 - n;
    const double sine = n == s ? std::numbers::sqrt2 / 2 : std::sin(theta / 2);
    const double cosine = n == s ? std::numbers::sqrt2 / 2 : std::cos(theta / 2);
    rows.theta[s] = pi - theta;
    rows.theta[n] = theta;
    rows.sin_half[n] = rows.cos_half[s] = sine;
    rows.cos_half[n] = rows.sin_half[s] = cosine;
    rows.weight[n] = rows.weight[s] = weight;
}

/// Returns cos(i pi / n) for i = 0..2n-1.
std::vector<double> cosines(int n) {
    std::vector<double> out(2 * static_cast<std::size_t>(n));
    for (int i = 0; i < 2 * n; ++i) out[static_cast<std::size_t>(i)] = std::cos(pi * i / n);
    return out;
}

double rotation_cosine(const std::vector<double>& cosine, long long i) {
    return cosine[static_cast<std::size_t>(i) % cosine.size()];
}

}  // namespace

LatitudeRows gauss_legendre_rows(int count) {
    LatitudeRows rows = empty_rows(count, 1, kMaxGaussRows);
    const long double n = count;
    for (int j = 0; j < (count + 1) / 2; ++j) {
        // Newton's method runs in theta, because the roots are almost evenly spaced there and the roots next
        // to the pole keep their relative accuracy.
        long double theta = (j + 0.75L) * std::numbers::pi_v<long double> / (n + 0.5L);
        long double slope = 1;
        bool converged = false;
        for (int iteration = 0; iteration < 8; ++iteration) {
            const long double x = std::cos(theta);
            long double p = 1;
            long double previous = 0;
            for (int k = 0; k < count; ++k) {
                const long double next =
                    ((2 * k + 1) * x * p - k * previous) / static_cast<long double>(k + 1);
                previous = p;
                p = next;
            }
            slope = n * (x * p - previous) / std::sin(theta);
            const long double step = p / slope;
            theta -= step;
            // One more round follows convergence, because the weight needs the slope at the root itself.
            if (converged) break;
            converged = std::abs(step) < 1e-9L / n;
        }
        set_pair(rows, j, static_cast<double>(theta), static_cast<double>(2 / (slope * slope)));
    }
    return rows;
}

LatitudeRows fejer_rows(int count) {
    LatitudeRows rows = empty_rows(count, 1, kMaxRows);
    const std::vector<double> cosine = cosines(count);
    for (int j = 0; j < (count + 1) / 2; ++j) {
        double sum = 0;
        for (int k = (count - 1) / 2; k >= 1; --k)
            sum += rotation_cosine(cosine, static_cast<long long>(k) * (2 * j + 1)) / (4.0 * k * k - 1);
        set_pair(rows, j, (j + 0.5) * pi / count, (1 - 2 * sum) * 2 / count);
    }
    return rows;
}

LatitudeRows clenshaw_curtis_rows(int count) {
    LatitudeRows rows = empty_rows(count, 2, kMaxRows);
    const int n = count - 1;
    const std::vector<double> cosine = cosines(n);
    for (int j = 0; j < (count + 1) / 2; ++j) {
        double sum = 0;
        for (int k = n / 2; k >= 1; --k)
            sum += (2 * k == n ? 1 : 2) * rotation_cosine(cosine, 2LL * k * j) / (4.0 * k * k - 1);
        set_pair(rows, j, j * pi / n, (1 - sum) * (j == 0 ? 1 : 2) / n);
    }
    return rows;
}

}  // namespace nicol
