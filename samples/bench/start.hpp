// SPDX-License-Identifier: MIT
// nicol-bench start: from nothing to the first image.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_start(const Options& options);
