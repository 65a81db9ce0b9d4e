// SPDX-License-Identifier: MIT
// nicol-bench harmonics: transforms, rotation and projection.
#pragma once

#include "report.hpp"

/// `seconds` of measurement for each line. Throws std::runtime_error with Nicol's message where a call fails.
Report bench_harmonics(double seconds);
