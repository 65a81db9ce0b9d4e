// SPDX-License-Identifier: MIT
// nicol-bench skip: what is saved by leaving out what a scene does not need.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_skip(const Options& options);
