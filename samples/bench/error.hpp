// SPDX-License-Identifier: MIT
// nicol-bench error: distance from the reference method, by order.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_error(const Options& options);
