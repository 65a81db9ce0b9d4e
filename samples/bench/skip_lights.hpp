// SPDX-License-Identifier: MIT
// Rows of nicol-bench skip for local lights.
#pragma once

#include <nicol.h>

#include <cstdint>

#include "report.hpp"

/// Adds a row for each scene whose local lights need less than all work: frames after the camera moved.
void add_light_rows(nicol_context context, std::uint32_t size, double seconds, Report& report);
