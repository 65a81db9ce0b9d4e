// SPDX-License-Identifier: MIT
// Stokes vectors that light can have.
#pragma once

#include <glm/vec4.hpp>
#include <span>

namespace nicol {

/// Moves each vector into the physically realizable range (Eq. 70), sqrt(s1^2 + s2^2 + s3^2) <= s0: a
/// negative s0 becomes 0, a polarized part that is too long keeps its direction. Truncated light leaves that
/// range; true light never does, and the range is convex, so this brings no vector further from the truth
/// than the shortening of s1..s3 does. Returns how many vectors were moved.
///
/// noise: what s0 errs by, 0 and up. Where light is as weak as its error its polarization is that of the
/// error; s1..s3 then become shorter by s0^2 / (s0^2 + noise^2), the factor of the least squared error for
/// light of that strength (Wiener's).
std::size_t make_physical(std::span<glm::vec4> stokes, float noise = 0);

}  // namespace nicol
