// SPDX-License-Identifier: MIT
// nicol-bench scale: cost against the number of vertices and against the order.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_scale(const Options& options);
