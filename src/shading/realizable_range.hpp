// SPDX-License-Identifier: MIT
// Physically realizable range of Stokes vectors.
#pragma once

#include <glm/vec4.hpp>
#include <span>

namespace nicol {

/// Moves each vector into the physically realizable range (Eq. 70), sqrt(s1^2 + s2^2 + s3^2) <= s0: a
/// negative s0 becomes 0, and a polarized part that is too long is shortened to s0 and keeps its direction.
/// This is a clamp and not the projection of Section 8.2, which raises s0 as well. Truncated light can leave
/// the range; true light never does. Returns the number of moved vectors.
///
/// noise: error of s0, at least 0. The polarization of light that is as weak as its error is mostly error.
/// Therefore s1..s3 are multiplied by s0^2 / (s0^2 + noise^2), the factor of least squared error for light of
/// this strength (Wiener's).
std::size_t make_physical(std::span<glm::vec4> stokes, float noise = 0);

}  // namespace nicol
