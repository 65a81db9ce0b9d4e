// SPDX-License-Identifier: MIT
// nicol-bench textures
#pragma once

#include "options.hpp"
#include "report.hpp"

Report bench_textures(const Options& given);
