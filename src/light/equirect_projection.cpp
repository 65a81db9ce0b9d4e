// SPDX-License-Identifier: MIT
// Exact integration of a bilinear picture against the harmonics.
#include "light/equirect_projection.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "light/degree_sums.hpp"
#include "light/equirect.hpp"
#include "light/folded_sums.hpp"
#include "nicol/grid.hpp"
#include "nicol/rotation.hpp"
#include "nicol/transform.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Fourier coefficients, over the azimuth of the propagation direction about the picture's axes, of rows that
/// are linear between pixels. Row i of the result lies at theta = i pi / (height - 1), where i = 0 is the
/// nadir of the picture (its last row), for theta belongs to where the light goes.
class RowAnalysis {
public:
    RowAnalysis(const EquirectPixels& pixels, int order)
        : pixels_(pixels), order_(order), factor_(static_cast<std::size_t>(2 * order) + 1) {
        // A row linear between its pixels is their comb convolved with a hat, whose transform is sinc^2.
        for (int m = -order; m <= order; ++m) {
            const double x = pi * m / pixels.width;
            const double sinc = m == 0 ? 1 : std::sin(x) / x;
            factor_[static_cast<std::size_t>(m + order)] = sinc * sinc / pixels.width;
        }
    }

    [[nodiscard]] FourierRows run(int channel) const {
        FourierRows result(order_, pixels_.height);
        if (FoldedSums::suits(order_, pixels_.width))
            run_folded(channel, result);
        else
            run_transformed(channel, result);
        return result;
    }

private:
    void run_folded(int channel, FourierRows& result) const {
        const FoldedSums prototype(order_, pixels_.width);
        tbb::enumerable_thread_specific<FoldedSums> workers(prototype);
        if (pixels_.components == 4) {
            tbb::parallel_for(0, pixels_.height, [&](int row) {
                const float* start = first(channel, {row, 0});
                const auto sums = workers.local()({{start, start + 1, start + 2, start + 3}, 4});
                store_folded(sums, 0, result.s0, row);
                store_folded(sums, 3, result.s3, row);
                store_folded_spin(sums, result, row);
            });
            return;
        }
        tbb::parallel_for(0, (pixels_.height + 3) / 4, [&](int group) {
            std::array<int, 4> rows{};
            std::array<const float*, 4> starts{};
            for (std::size_t k = 0; k < 4; ++k) {
                rows[k] = std::min(4 * group + static_cast<int>(k), pixels_.height - 1);
                starts[k] = first(channel, {rows[k], 0});
            }
            const auto sums = workers.local()({starts, 1});
            for (std::size_t k = 0; k < 4; ++k) store_folded(sums, k, result.s0, rows[k]);
        });
    }

    /// phi = pi - a, so exp(-i m phi) = (-1)^m exp(i m a).
    [[nodiscard]] double folded_factor(std::size_t m) const {
        const double factor = factor_[static_cast<std::size_t>(order_) + m];
        return m % 2 == 0 ? factor : -factor;
    }

    void store_folded(std::span<const double> sums, std::size_t k, std::vector<Complex>& to, int row) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(row) * (n + 1) + m] =
                folded_factor(m) * Complex(sums[8 * m + k], sums[8 * m + 4 + k]);
    }

    /// From the picture's frame to the theta-phi frame: a quarter turn, the sign of s1 + i s2.
    void store_folded_spin(std::span<const double> sums, FourierRows& result, int row) const {
        for (int m = 0; m <= order_; ++m) {
            const double* s = &sums[8 * static_cast<std::size_t>(m)];
            const double factor = -folded_factor(static_cast<std::size_t>(m));
            result.spin[result.spin_index(row, m)] = factor * Complex(s[1] - s[6], s[2] + s[5]);
            result.spin[result.spin_index(row, -m)] = factor * Complex(s[1] + s[6], s[2] - s[5]);
        }
    }

    void run_transformed(int channel, FourierRows& result) const {
        // phi = pi - 2 pi u falls with the column, so the pixels are taken from the right.
        tbb::enumerable_thread_specific<Worker> workers([&] {
            return Worker{DegreeSums(order_, pixels_.width, pi / pixels_.width - pi),
                          std::vector<Complex>(static_cast<std::size_t>(pixels_.width)),
                          std::vector<Complex>(factor_.size())};
        });
        if (pixels_.components == 4) {
            tbb::parallel_for(0, pixels_.height, [&](int row) {
                Worker& worker = workers.local();
                load(worker, channel, {row, 0}, {row, 3}, 1);
                store_real(worker, result.s0, row);
                store_imaginary(worker, result.s3, row);
                load(worker, channel, {row, 1}, {row, 2}, -1);
                std::ranges::copy(worker.sums, result.spin.begin() + static_cast<std::ptrdiff_t>(
                                                                         result.spin_index(row, -order_)));
            });
            return;
        }
        // Two real rows are one complex row.
        tbb::parallel_for(0, (pixels_.height + 1) / 2, [&](int pair) {
            Worker& worker = workers.local();
            const int second = std::min(2 * pair + 1, pixels_.height - 1);
            load(worker, channel, {2 * pair, 0}, {second, 0}, 1);
            store_real(worker, result.s0, 2 * pair);
            store_imaginary(worker, result.s0, second);
        });
    }

    struct Worker {
        DegreeSums transform;
        std::vector<Complex> samples;
        std::vector<Complex> sums;
    };
    struct Source {
        int row;
        std::size_t component;
    };

    [[nodiscard]] const float* first(int channel, Source source) const {
        const int row = channel * pixels_.height + (pixels_.height - 1 - source.row);
        return pixels_.values.data() +
               static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels_.width) *
                   static_cast<std::size_t>(pixels_.components) +
               source.component;
    }

    /// The Fourier coefficients of sign * (real + i imaginary).
    void load(Worker& worker, int channel, Source real, Source imaginary, double sign) const {
        const auto components = static_cast<std::size_t>(pixels_.components);
        const float* a = first(channel, real);
        const float* b = first(channel, imaginary);
        const std::size_t width = worker.samples.size();
        for (std::size_t i = 0; i < width; ++i) {
            const std::size_t at = (width - 1 - i) * components;
            worker.samples[i] = sign * Complex(a[at], b[at]);
        }
        worker.transform(worker.samples, worker.sums);
        for (std::size_t i = 0; i < factor_.size(); ++i) worker.sums[i] *= factor_[i];
    }

    /// The coefficients m >= 0 of the real part of what was loaded.
    void store_real(const Worker& worker, std::vector<Complex>& to, int row) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(row) * (n + 1) + m] =
                0.5 * (worker.sums[n + m] + std::conj(worker.sums[n - m]));
    }

    void store_imaginary(const Worker& worker, std::vector<Complex>& to, int row) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(row) * (n + 1) + m] =
                Complex(0, -0.5) * (worker.sums[n + m] - std::conj(worker.sums[n - m]));
    }

    const EquirectPixels& pixels_;
    int order_;
    std::vector<double> factor_;
};

/// Gauss points of one interval between rows: where (0..1) and how much (sum 1).
struct IntervalRule {
    std::vector<double> position;
    std::vector<double> weight;
};

/// Between two rows the integrand is a straight line times a trigonometric polynomial of degree order + 1, on
/// which few Gauss points are as good as exact; a rule over the whole meridian would suffer from the kinks.
IntervalRule interval_rule(int order, int intervals) {
    const double log_phase = std::log((order + 1) * pi / intervals);
    // Error of n points for exp(i x t) on 0..1: x^2n (n!)^4 / ((2n + 1) ((2n)!)^3), built up factor by
    // factor.
    double log_error = 0;
    int points = 0;
    do {
        ++points;
        const double n = points;
        log_error += 2 * log_phase + 4 * std::log(n) - 3 * std::log(2 * n * (2 * n - 1)) +
                     std::log((2 * n - 1) / (2 * n + 1));
    } while (log_error > std::log(1e-13) && (points + 1) * intervals <= kMaxRows);
    const LatitudeRows gauss = gauss_legendre_rows(points);
    IntervalRule rule;
    for (std::size_t i = 0; i < gauss.theta.size(); ++i) {
        rule.position.push_back(gauss.sin_half[i] * gauss.sin_half[i]);
        rule.weight.push_back(gauss.weight[i] / 2);
    }
    return rule;
}

/// Sums the coefficients of ranges of intervals between rows.
class MeridianSum {
public:
    MeridianSum(const FourierRows& rows, const IntervalRule& rule)
        : rows_(rows), rule_(rule), sum_(4 * psh_count(rows.order), 0.0) {}
    MeridianSum(const MeridianSum& other, tbb::split) : MeridianSum(other.rows_, other.rule_) {}

    /// Intervals first..last counted from each end of the meridian: the harmonics are mirrored between north
    /// and south, which the Legendre step uses when it gets both.
    void operator()(const tbb::blocked_range<int>& range) {
        const int intervals = rows_.rows - 1;
        LatitudeRows latitudes;
        std::vector<Point> points;
        for (int i = range.begin(); i < range.end(); ++i) {
            // The middle one of an odd number of intervals is its own mirror image.
            const bool middle = 2 * i + 1 == intervals;
            const std::size_t count = middle ? (rule_.position.size() + 1) / 2 : rule_.position.size();
            for (std::size_t k = 0; k < count; ++k) add(latitudes, points, i, k);
        }
        const std::size_t north = points.size();
        for (std::size_t j = north; j-- > 0;) {
            const bool equator =
                2 * points[j].interval + 1 == intervals && 2 * points[j].node + 1 == rule_.position.size();
            if (equator) continue;
            latitudes.theta.push_back(pi - latitudes.theta[j]);
            latitudes.sin_half.push_back(latitudes.cos_half[j]);
            latitudes.cos_half.push_back(latitudes.sin_half[j]);
            latitudes.weight.push_back(latitudes.weight[j]);
            points.push_back(
                {intervals - 1 - points[j].interval, rule_.position.size() - 1 - points[j].node});
        }

        FourierRows fine(rows_.order, latitudes.count());
        for (std::size_t j = 0; j < points.size(); ++j) interpolate(points[j], fine, static_cast<int>(j));
        std::vector<double> part(sum_.size());
        LegendreTransform(rows_.order, std::move(latitudes)).analyze(fine, part);
        for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += part[i];
    }

    void join(const MeridianSum& other) {
        for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += other.sum_[i];
    }

    [[nodiscard]] const std::vector<double>& result() const { return sum_; }

private:
    struct Point {
        int interval;
        std::size_t node;
    };

    void add(LatitudeRows& latitudes, std::vector<Point>& points, int interval, std::size_t node) const {
        const double step = pi / (rows_.rows - 1);
        const double theta = (interval + rule_.position[node]) * step;
        latitudes.theta.push_back(theta);
        latitudes.sin_half.push_back(std::sin(theta / 2));
        latitudes.cos_half.push_back(std::cos(theta / 2));
        latitudes.weight.push_back(step * rule_.weight[node] * std::sin(theta));
        points.push_back({interval, node});
    }

    void interpolate(const Point& point, FourierRows& fine, int row) const {
        const double t = rule_.position[point.node];
        const auto blend = [&](const std::vector<Complex>& from, std::vector<Complex>& to, int length) {
            const auto n = static_cast<std::size_t>(length);
            const Complex* a = from.data() + static_cast<std::size_t>(point.interval) * n;
            Complex* out = to.data() + static_cast<std::size_t>(row) * n;
            for (std::size_t m = 0; m < n; ++m) out[m] = (1 - t) * a[m] + t * a[m + n];
        };
        blend(rows_.s0, fine.s0, rows_.order + 1);
        blend(rows_.s3, fine.s3, rows_.order + 1);
        blend(rows_.spin, fine.spin, 2 * rows_.order + 1);
    }

    const FourierRows& rows_;
    const IntervalRule& rule_;
    std::vector<double> sum_;
};

}  // namespace

PshVector project_equirect(const EquirectPixels& pixels, int order) {
    const RowAnalysis analysis(pixels, order);
    const IntervalRule rule = interval_rule(order, pixels.height - 1);
    // Enough latitudes at once to make the Legendre step's set-up cheap, few enough to bound the memory.
    const int grain = std::max(1, 256 / static_cast<int>(rule.position.size()));
    PshVector result(order, pixels.channels);
    for (int c = 0; c < pixels.channels; ++c) {
        const FourierRows rows = analysis.run(c);
        MeridianSum sum(rows, rule);
        // Deterministic: the same picture gives the same bits whatever the number of threads.
        tbb::parallel_deterministic_reduce(
            tbb::blocked_range<int>(0, pixels.height / 2, static_cast<std::size_t>(grain)), sum);
        std::ranges::copy(sum.result(), result.channel(c).begin());
    }
    return rotated(result, equirect_axes());
}

}  // namespace nicol
