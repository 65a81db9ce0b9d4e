// SPDX-License-Identifier: MIT
// The naive approach that the paper warns of: s1 and s2 in the theta-phi frame treated as scalars, in the
// places of s0 and s3, which are expanded in scalar harmonics.
#pragma once

#include "field.hpp"

/// Moves s1, s2 of samples to the places of scalars; the others become 0. from_scalars() moves them back.
Doubles to_scalars(const Doubles& stokes);
Doubles from_scalars(const Doubles& scalars);

using Expansion = std::function<Doubles(const std::vector<Vec3>&)>;

/// Returns samples on the grid, s1 and s2 only, of the field rotated in space: (R f)(w) = R f(R^-1 w), from
/// the Stokes vectors f that `at` returns at directions.
Doubles rotated_samples(const Grid& grid, const Rotation& rotation, const Expansion& at);
