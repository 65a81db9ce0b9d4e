// SPDX-License-Identifier: MIT
// nicol-bench pareto: run time against error.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Writes the plot too if requested. Throws std::runtime_error with Nicol's message where a call fails.
Report bench_pareto(const Options& options);
