// SPDX-License-Identifier: MIT
#include "methods/bounce_series.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nicol {
namespace {

// Largest ratio of a bounce to the one before. A closed surface that absorbs nothing has 1.
constexpr double kLargestRatio = 0.99;
// Bounces after which the geometric series is taken as it is. What is left is known; more bounces would take
// more time than they are worth.
constexpr int kMostRounds = 24;

/// Estimates for a column after a bounce.
struct Tail {
    double ratio = 0;  // of a bounce to the one before, as far as they are alike
    double apart = 0;  // squared norm of the rest of the bounce, which is not like the one before
    double error = 0;  // squared norm of the error if all later bounces are taken to be alike
};

// Adds the light of one bounce to the numbers of s0.
void add_scalars(const LightColumns& from, LightColumns& to) {
    for (std::size_t r = 0; r < from.points(); ++r)
        for (std::size_t j = 0; j < from.numbers() * from.lanes(); ++j)
            for (std::size_t i = 0; i < kLanes; ++i) to.at(r)[j][i] += from.at(r)[j][i];
}

// Sum of `count` terms of a geometric series that begins with its ratio.
double geometric(double ratio, int count) {
    return ratio * (1 - std::pow(ratio, count)) / (1 - ratio);
}

// Writes the later bounces b = (I - K)^-1 K y of y = ratio x before + d as ratio / (1 - ratio) y + K d /
// ((1 - ratio) (I - K)), whose second term is the error.
Tail tail_of(const LightColumns& before, const LightColumns& after, std::size_t column, double apart_before) {
    double old = 0, both = 0, now = 0;
    for (std::size_t r = 0; r < after.points(); ++r) {
        const auto x = double{before.value(r, 0, column)}, y = double{after.value(r, 0, column)};
        old += x * x;
        both += x * y;
        now += y * y;
    }
    Tail out;
    if (!(old > 0)) return out;
    out.ratio = std::clamp(both / old, 0.0, kLargestRatio);
    out.apart = std::max(0.0, now - 2 * out.ratio * both + out.ratio * out.ratio * old);
    double decay = std::max(out.ratio, 0.5);
    if (apart_before > 0) decay = std::min(std::sqrt(out.apart / apart_before), kLargestRatio);
    const double factor = decay / ((1 - out.ratio) * (1 - decay));
    out.error = factor * factor * out.apart;
    return out;
}

}  // namespace

BounceSeries sum_bounces(const Bounce& bounce, const LinkedSurfaces& surfaces, const ReflectionRows& scalar,
                         const ReflectionRows& all, LightColumns first, const SeriesEnd& end,
                         RenderRun& run) {
    const std::size_t columns = first.columns(), scalars = scalar.light().size();
    BounceSeries out;
    out.rounds = 1;
    out.left.assign(columns, 0.0);
    out.light = std::move(first);
    if (end.bounces == 1) return out;

    const auto for_blocks = [&](const auto& body) {
        run.workers.for_blocks(surfaces.blocks(), end.verb, run.progress,
                               [&](std::size_t begin, std::size_t last) {
                                   for (std::size_t b = begin; b < last; ++b) body(b);
                               });
    };
    LightColumns sum = out.light;
    LightColumns before(surfaces.receivers(), scalars, columns), after = before;
    for (std::size_t r = 0; r < surfaces.receivers(); ++r)
        std::copy_n(out.light.at(r), scalars * before.lanes(), before.at(r));
    std::vector<Tail> tails(columns);
    // The last bounce is that of all components below.
    while (++out.rounds < end.bounces) {
        for_blocks([&](std::size_t b) { bounce.reflect_receivers(b, scalar, before, after); });
        add_scalars(after, sum);
        double most = 0, power = end.all;
        for (std::size_t c = 0; c < columns; ++c) {
            tails[c] = tail_of(before, after, c, tails[c].apart);
            most = std::max(most, tails[c].error);
            double own = 0;
            for (std::size_t r = 0; r < surfaces.receivers(); ++r) {
                const auto value = double{sum.value(r, 0, c)};
                own += value * value;
            }
            power = std::max(power, own);
        }
        std::swap(before, after);
        if (most > end.negligible * end.negligible * power && out.rounds < kMostRounds) continue;
        const int later = end.bounces - 1 - out.rounds;
        for (std::size_t c = 0; c < columns; ++c) {
            const auto factor = static_cast<float>(geometric(tails[c].ratio, later));
            out.left[c] = tails[c].error;
            for (std::size_t r = 0; r < surfaces.receivers(); ++r)
                for (std::size_t j = 0; j < scalars; ++j) {
                    const std::size_t at = j * sum.lanes() + c / kLanes;
                    sum.at(r)[at][c % kLanes] += factor * before.at(r)[at][c % kLanes];
                }
        }
        ++out.rounds;
        break;
    }
    LightColumns last(surfaces.receivers(), sum.numbers(), columns);
    for_blocks([&](std::size_t b) { bounce.reflect_receivers(b, all, sum, last); });
    for (std::size_t r = 0; r < surfaces.receivers(); ++r)
        for (std::size_t j = 0; j < sum.numbers() * sum.lanes(); ++j)
            for (std::size_t i = 0; i < kLanes; ++i) out.light.at(r)[j][i] += last.at(r)[j][i];
    return out;
}

}  // namespace nicol
