// SPDX-License-Identifier: MIT
// Figure 21 for many materials: what each form of the high orders leaves.
#pragma once

#include "options.hpp"
#include "report.hpp"

Report bench_materials(const Options& options);
