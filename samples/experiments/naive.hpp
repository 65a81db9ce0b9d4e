// SPDX-License-Identifier: MIT
// The approach that the paper warns of: s1 and s2 in the theta-phi frame as if they were scalars. They take
// the places of s0 and s3, which are expanded in scalar harmonics.
#pragma once

#include "field.hpp"

/// Moves s1, s2 of samples to the places of scalars, and back; the others become 0.
Doubles to_scalars(const Doubles& stokes);
Doubles from_scalars(const Doubles& scalars);

using Expansion = std::function<Doubles(const std::vector<Vec3>&)>;

/// Samples on the grid, s1 and s2 alone, of the field rotated in space: (R f)(w) = R f(R^-1 w), from the
/// Stokes vectors f that `at` gives at directions.
Doubles rotated_samples(const Grid& grid, const Rotation& rotation, const Expansion& at);
