// SPDX-License-Identifier: MIT
// References independent of the library: explicit sums in thousands of bits, and helpers for random fields.
#pragma once

#include <complex>
#include <random>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "directions.hpp"
#include "harmonics/psh.hpp"
#include "polarization/stokes.hpp"

namespace reference {

/// Returns d^l_{mn}(theta) for the exact value of the double theta, by Wigner's sum. All digits are right up
/// to l = 4096.
double wigner_d(int l, int m, int n, double theta);

/// Returns sY_lm(theta, 0), computed from wigner_d().
double spin_harmonic(int spin, int l, int m, double theta);

/// Returns (l1 l2 l3; m1 m2 m3) by Racah's sum. All digits are right up to l = 200.
double wigner_3j(int l1, int l2, int l3, int m1, int m2, int m3);

/// Returns standard normal coefficients. p = 1, 2 stay zero below l = 2.
nicol::PshVector random_field(std::mt19937_64& random, int order, int channels = 1);

/// Returns a uniformly distributed random rotation.
glm::dmat3 random_rotation(std::mt19937_64& random);
glm::dmat3 about_z(double angle);
glm::dmat3 about_y(double angle);

using ::direction;
using ::random_direction;

/// Returns the theta-phi frame by its definition.
nicol::Frame theta_phi(const glm::dvec3& direction);

/// Returns exp(-2 i psi) with to = from Rz(psi): the factor of s1 + i s2 (Eq. 14).
std::complex<double> frame_change(const nicol::Frame& from, const nicol::Frame& to);

}  // namespace reference
