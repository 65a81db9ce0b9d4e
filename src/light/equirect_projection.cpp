// SPDX-License-Identifier: MIT
// Projection of a bilinear image onto the harmonics by exact integration.
#include "light/equirect_projection.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "harmonics/batch_fft.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/transform.hpp"
#include "light/equirect.hpp"
#include "light/folded_sums.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Upper limit of the Fourier coefficients (in doubles) of the channels that are read together.
constexpr double kRowDoubles = 1 << 24;

/// Fourier coefficients of rows: computed directly for few degrees, by FFT for many.
class RowAnalysis {
public:
    RowAnalysis(const EquirectView& view, int first, int count, int order)
        : view_(view), first_(first), count_(count), order_(order) {
        // A row that is linear between its pixels is the pixels' comb convolved with a hat, whose transform
        // is sinc^2.
        for (int m = 0; m <= order; ++m) {
            const double x = pi * m / view.width;
            const double sinc = m == 0 ? 1 : std::sin(x) / x;
            factor_.push_back(sinc * sinc / view.width);
            // The columns start half a step after phi = -pi.
            rotation_.push_back(std::polar(factor_.back(), m * (pi - pi / view.width)));
        }
    }

    [[nodiscard]] std::vector<FourierRows> run() const {
        std::vector<FourierRows> result(static_cast<std::size_t>(count_), FourierRows(order_, view_.height));
        if (FoldedSums::suits(order_, view_.width))
            run_folded(result);
        else
            run_transformed(result);
        return result;
    }

private:
    /// Returns the image row that is row i of the result.
    [[nodiscard]] const float* row(int channel, int i) const {
        return view_.values + static_cast<std::size_t>(first_ + channel) * view_.channel_stride +
               static_cast<std::size_t>(view_.height - 1 - i) * view_.row_stride;
    }

    void run_folded(std::vector<FourierRows>& results) const {
        const FoldedSums prototype(order_, view_.width);
        tbb::enumerable_thread_specific<FoldedSums> workers(prototype);
        if (view_.components == 4) {
            tbb::parallel_for(0, view_.height, [&](int i) {
                for (int c = 0; c < count_; ++c) {
                    FourierRows& result = results[static_cast<std::size_t>(c)];
                    const float* start = row(c, i);
                    const auto sums =
                        workers.local()({{start, start + 1, start + 2, start + 3}, view_.pixel_stride});
                    store_folded(sums, 0, result.s0, i);
                    store_folded(sums, 3, result.s3, i);
                    store_folded_spin(sums, result, i);
                }
            });
            return;
        }
        tbb::parallel_for(0, (view_.height + 3) / 4, [&](int group) {
            for (int c = 0; c < count_; ++c) {
                std::array<int, 4> rows{};
                std::array<const float*, 4> starts{};
                for (std::size_t k = 0; k < 4; ++k) {
                    rows[k] = std::min(4 * group + static_cast<int>(k), view_.height - 1);
                    starts[k] = row(c, rows[k]);
                }
                const auto sums = workers.local()({starts, view_.pixel_stride});
                for (std::size_t k = 0; k < 4; ++k)
                    store_folded(sums, k, results[static_cast<std::size_t>(c)].s0, rows[k]);
            }
        });
    }

    /// Returns the factor of degree m for folded sums. Because phi = pi - a, exp(-i m phi) = (-1)^m exp(i m
    /// a).
    [[nodiscard]] double folded_factor(std::size_t m) const { return m % 2 == 0 ? factor_[m] : -factor_[m]; }

    void store_folded(std::span<const double> sums, std::size_t k, std::vector<Complex>& to, int i) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(i) * (n + 1) + m] =
                folded_factor(m) * Complex(sums[8 * m + k], sums[8 * m + 4 + k]);
    }

    /// Stores spin coefficients, rotated from the image's frame to the theta-phi frame by 90 degrees, which
    /// negates s1 + i s2.
    void store_folded_spin(std::span<const double> sums, FourierRows& result, int i) const {
        for (int m = 0; m <= order_; ++m) {
            const double* s = &sums[8 * static_cast<std::size_t>(m)];
            const double factor = -folded_factor(static_cast<std::size_t>(m));
            result.spin[result.spin_index(i, m)] = factor * Complex(s[1] - s[6], s[2] + s[5]);
            result.spin[result.spin_index(i, -m)] = factor * Complex(s[1] + s[6], s[2] - s[5]);
        }
    }

    /// Complex sequence of a batch: components p and q of two rows, which may be the same row.
    struct Lane {
        int row_p, row_q;
        std::size_t p, q;
    };
    struct Worker {
        BatchFft fft;
        std::vector<double> data;
    };

    void run_transformed(std::vector<FourierRows>& results) const {
        const auto width = static_cast<std::size_t>(view_.width);
        tbb::enumerable_thread_specific<Worker> workers([&] {
            return Worker{BatchFft(view_.width), std::vector<double>(BatchFft::kElement * width)};
        });
        // A batch holds s0 + i s3 and s1 + i s2 of four rows, or s0 of sixteen rows in pairs.
        const bool polarized = view_.components == 4;
        const int rows = polarized ? 4 : 16;
        tbb::parallel_for(0, (view_.height + rows - 1) / rows, [&](int group) {
            Worker& worker = workers.local();
            for (int c = 0; c < count_; ++c) {
                std::array<Lane, BatchFft::kLanes> lanes{};
                for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
                    const auto at = [&](std::size_t k) {
                        return std::min(rows * group + static_cast<int>(k), view_.height - 1);
                    };
                    if (!polarized)
                        lanes[lane] = {at(2 * lane), at(2 * lane + 1), 0, 0};
                    else if (lane % 2 == 0)
                        lanes[lane] = {at(lane / 2), at(lane / 2), 0, 3};
                    else
                        lanes[lane] = {at(lane / 2), at(lane / 2), 1, 2};
                    load(lanes[lane], c, worker.data.data() + lane);
                }
                const double* out = worker.fft.forward(worker.data.data());
                FourierRows& result = results[static_cast<std::size_t>(c)];
                for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
                    if (lanes[lane].p == 1)
                        store_spin(out + lane, result, lanes[lane].row_p);
                    else
                        store_scalars(out + lane, lanes[lane], result);
                }
            }
        });
    }

    /// Loads a lane from right to left, because phi = pi - 2 pi u falls with the column.
    void load(const Lane& lane, int channel, double* to) const {
        const float* p = row(channel, lane.row_p) + lane.p;
        const float* q = row(channel, lane.row_q) + lane.q;
        const auto width = static_cast<std::size_t>(view_.width);
        for (std::size_t i = 0; i < width; ++i, to += BatchFft::kElement) {
            const std::size_t at = (width - 1 - i) * view_.pixel_stride;
            to[0] = p[at];
            to[BatchFft::kLanes] = q[at];
        }
    }

    /// Returns degree m of a transformed lane. The sums are periodic, so m may be above width / 2.
    [[nodiscard]] Complex degree(const double* out, int m) const {
        const int bin = (m % view_.width + view_.width) % view_.width;
        const double* z = out + BatchFft::kElement * static_cast<std::size_t>(bin);
        const Complex phase = rotation_[static_cast<std::size_t>(std::abs(m))];
        return Complex(z[0], z[BatchFft::kLanes]) * (m < 0 ? std::conj(phase) : phase);
    }

    void store_scalars(const double* out, const Lane& lane, FourierRows& result) const {
        for (int m = 0; m <= order_; ++m) {
            const Complex plus = degree(out, m);
            const Complex minus = std::conj(degree(out, -m));
            const Complex real = 0.5 * (plus + minus);
            const Complex imaginary = Complex(0, -0.5) * (plus - minus);
            result.s0[result.scalar_index(lane.row_p, m)] = real;
            if (lane.q == 3)
                result.s3[result.scalar_index(lane.row_q, m)] = imaginary;
            else
                result.s0[result.scalar_index(lane.row_q, m)] = imaginary;
        }
    }

    void store_spin(const double* out, FourierRows& result, int i) const {
        for (int m = -order_; m <= order_; ++m) result.spin[result.spin_index(i, m)] = -degree(out, m);
    }

    const EquirectView& view_;
    int first_;
    int count_;
    int order_;
    std::vector<double> factor_;     // by degree |m|
    std::vector<Complex> rotation_;  // the factor of m >= 0, rotated to the start of the columns
};

/// Returns Fourier coefficients over the azimuth of the propagation direction about the image's axes, for the
/// rows of `count` channels from `first` on. The rows are linear between pixels. Row i of a result is at
/// theta = i pi / (height - 1), and i = 0 is the nadir of the image (its last row), because theta belongs to
/// the direction of propagation.
std::vector<FourierRows> analyze_rows(const EquirectView& view, int first, int count, int order) {
    return RowAnalysis(view, first, count, order).run();
}

/// Gauss points of one interval between rows: positions in 0..1 and weights of sum 1.
struct IntervalRule {
    std::vector<double> position;
    std::vector<double> weight;
};

/// Returns the Gauss rule of an interval. Between two rows the integrand is a linear function times a
/// trigonometric polynomial of degree order + 1, for which few Gauss points are practically exact. A rule
/// over the whole meridian would suffer from the kinks at the rows.
IntervalRule interval_rule(int order, int intervals) {
    const double log_phase = std::log((order + 1) * pi / intervals);
    // The error of n points for exp(i x t) on 0..1 is x^2n (n!)^4 / ((2n + 1) ((2n)!)^3), built up factor by
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

/// Sum of the coefficients of ranges of intervals between rows.
class MeridianSum {
public:
    /// spin: whether rows may have s1 or s2.
    MeridianSum(const FourierRows& rows, bool spin, const IntervalRule& rule)
        : rows_(rows), spin_(spin), rule_(rule), sum_(4 * psh_count(rows.order), 0.0) {}
    MeridianSum(const MeridianSum& other, tbb::split) : MeridianSum(other.rows_, other.spin_, other.rule_) {}

    /// Adds the intervals first..last, counted from each end of the meridian. The harmonics are mirrored
    /// between north and south, which the Legendre step uses if it gets both.
    void operator()(const tbb::blocked_range<int>& range) {
        const int intervals = rows_.rows - 1;
        LatitudeRows latitudes;
        std::vector<Point> points;
        for (int i = range.begin(); i < range.end(); ++i) {
            // The middle interval of an odd number is its own mirror image.
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
        if (spin_) blend(rows_.spin, fine.spin, 2 * rows_.order + 1);
    }

    const FourierRows& rows_;
    const bool spin_;
    const IntervalRule& rule_;
    std::vector<double> sum_;
};

}  // namespace

PshVector project_equirect(const EquirectView& view, int order) {
    const IntervalRule rule = interval_rule(order, view.height - 1);
    // A grain has enough latitudes to amortize the Legendre step's set-up and few enough to bound the memory.
    const int grain = std::max(1, 256 / static_cast<int>(rule.position.size()));
    // Neighbouring channels are read together, as many as fit.
    const double doubles = 8.0 * (order + 1) * view.height;
    const int together =
        std::max(1, static_cast<int>(std::min<double>(view.channels, kRowDoubles / doubles)));
    PshVector result(order, view.channels);
    for (int first = 0; first < view.channels; first += together) {
        const int count = std::min(together, view.channels - first);
        std::vector<FourierRows> rows = analyze_rows(view, first, count, order);
        // Two channels of unpolarized light are summed as s0 and s3 of one channel, because s3 is a scalar
        // too.
        const int step = view.components == 1 ? 2 : 1;
        for (int c = 0; c < count; c += step) {
            const bool paired = step == 2 && c + 1 < count;
            FourierRows& here = rows[static_cast<std::size_t>(c)];
            if (paired) here.s3 = std::move(rows[static_cast<std::size_t>(c + 1)].s0);
            MeridianSum sum(here, view.components == 4, rule);
            // The reduction is deterministic, so that an image gives equal bits for any number of threads.
            tbb::parallel_deterministic_reduce(
                tbb::blocked_range<int>(0, view.height / 2, static_cast<std::size_t>(grain)), sum);
            const std::span<double> out = result.channel(first + c);
            std::ranges::copy(sum.result(), out.begin());
            if (!paired) continue;
            const std::span<double> other = result.channel(first + c + 1);
            for (std::size_t i = 0; i < out.size(); i += 4) other[i] = std::exchange(out[i + 3], 0.0);
        }
    }
    return rotated(result, equirect_axes());
}

}  // namespace nicol
