// SPDX-License-Identifier: MIT
// nicol-bench coarse
#pragma once

#include "options.hpp"
#include "report.hpp"

Report bench_coarse(const Options& given);
