// SPDX-License-Identifier: MIT
// Exact integration of a bilinear image against the harmonics.
#include "light/equirect_projection.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "harmonics/grid.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/transform.hpp"
#include "light/equirect.hpp"
#include "light/row_analysis.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Upper limit of the Fourier coefficients (in doubles) of channels that are read together.
constexpr double kRowDoubles = 1 << 24;

/// Gauss points of one interval between rows: positions in 0..1 and weights of sum 1.
struct IntervalRule {
    std::vector<double> position;
    std::vector<double> weight;
};

/// Between two rows the integrand is a linear function times a trigonometric polynomial of degree order + 1,
/// for which few Gauss points are practically exact; a rule over the whole meridian would suffer from the
/// kinks at the rows.
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

PshVector project_equirect(const EquirectView& view, int order) {
    const IntervalRule rule = interval_rule(order, view.height - 1);
    // Enough latitudes at once to amortize the Legendre step's set-up, few enough to bound the memory.
    const int grain = std::max(1, 256 / static_cast<int>(rule.position.size()));
    // Neighbouring channels are read together, as many as fit.
    const double doubles = 8.0 * (order + 1) * view.height;
    const int together =
        std::max(1, static_cast<int>(std::min<double>(view.channels, kRowDoubles / doubles)));
    PshVector result(order, view.channels);
    for (int first = 0; first < view.channels; first += together) {
        const int count = std::min(together, view.channels - first);
        const std::vector<FourierRows> rows = analyze_rows(view, first, count, order);
        for (int c = 0; c < count; ++c) {
            MeridianSum sum(rows[static_cast<std::size_t>(c)], rule);
            // Deterministic: the same image gives the same bits whatever the number of threads.
            tbb::parallel_deterministic_reduce(
                tbb::blocked_range<int>(0, view.height / 2, static_cast<std::size_t>(grain)), sum);
            std::ranges::copy(sum.result(), result.channel(first + c).begin());
        }
    }
    return rotated(result, equirect_axes());
}

}  // namespace nicol
