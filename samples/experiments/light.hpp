// SPDX-License-Identifier: MIT
// The light of the experiments.
#pragma once

#include "experiment.hpp"
#include "field.hpp"

/// Returns coefficients of the first channel of the given file, or else of an image made here: a clear sky
/// with three polarized lamps of increasing sharpness.
Doubles light(const Experiment& experiment, std::uint32_t order);
