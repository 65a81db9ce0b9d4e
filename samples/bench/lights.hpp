// SPDX-License-Identifier: MIT
// nicol-bench lights
#pragma once

#include "options.hpp"
#include "report.hpp"

Report bench_lights(const Options& given);
