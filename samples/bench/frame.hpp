// SPDX-License-Identifier: MIT
// nicol-bench frame: what a frame costs beside drawing the triangles.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Throws std::runtime_error with Nicol's message where a call fails.
Report bench_frame(const Options& options);
