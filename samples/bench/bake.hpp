// SPDX-License-Identifier: MIT
// nicol-bench bake: visibility at the vertices.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_bake(const Options& options);
