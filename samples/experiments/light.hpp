// SPDX-License-Identifier: MIT
// The light of the experiments.
#pragma once

#include "experiment.hpp"
#include "field.hpp"

/// Coefficients of the first channel: of the file that was given, else of an image made here, a clear sky
/// with three polarized lamps, each sharper than the one before.
Doubles light(const Experiment& experiment, std::uint32_t order);
