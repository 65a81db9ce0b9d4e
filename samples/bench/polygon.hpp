// SPDX-License-Identifier: MIT
// A square light by places, beside its closed form.
#pragma once

#include "options.hpp"
#include "report.hpp"
#include "temporary_folder.hpp"

/// Adds to the columns of bench_lights(): of a matt floor under the light, without shadows, what some numbers
/// of places err, and how long they take beside Lambert's formula for the same pixels.
void add_polygon(Report& report, const Options& given, const TemporaryFolder& folder);
