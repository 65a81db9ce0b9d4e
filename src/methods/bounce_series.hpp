// SPDX-License-Identifier: MIT
// Sum of all bounces: a Neumann series.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "methods/bounce.hpp"
#include "stage/workers.hpp"

namespace nicol {

/// Conditions that end a series, and the step that it belongs to.
struct SeriesEnd {
    const char* verb;   ///< name of the step in reports of progress
    int bounces;        ///< largest number of bounces, at least 1
    double negligible;  ///< error that ends the series earlier, relative to the RMS of `all`
    double all;         ///< sum over receivers of the square of the direct light's mean over directions
};

/// Light of all bounces at receivers, in the columns of one channel.
struct BounceSeries {
    LightColumns light;
    int rounds = 0;            ///< bounces that were computed
    std::vector<double> left;  ///< sum over receivers of each column's estimated squared error, as `all`
};

/// Sums the bounces. first: light that arrives by the first bounce; all numbers of the layout.
/// scalar: rows from s0 to s0; all: rows from all numbers to all components. s0 bounces until the end; the
/// polarization of light survives one more bounce, because a surface that reflects twice leaves little of
/// it. In the end, bounces are a geometric series, whose ratio the last two tell: its sum replaces the
/// bounces that are left out.
[[nodiscard]] BounceSeries sum_bounces(const Bounce& bounce, const LinkedSurfaces& surfaces,
                                       const ReflectionRows& scalar, const ReflectionRows& all,
                                       LightColumns first, const SeriesEnd& end, RenderRun& run);

}  // namespace nicol
