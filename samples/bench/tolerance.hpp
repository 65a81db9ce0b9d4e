// SPDX-License-Identifier: MIT
// nicol-bench tolerance: requested, predicted and measured errors.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_tolerance(const Options& options);
