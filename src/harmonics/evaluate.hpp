// SPDX-License-Identifier: MIT
// The value of a Stokes vector field at directions.
#pragma once

#include <complex>
#include <span>

#include "harmonics/psh.hpp"
#include "polarization/stokes.hpp"

namespace nicol {

/// Stokes components of the field at a direction (normalised here), in the theta-phi frame of that direction;
/// on the z axis phi is taken as 0 (Eq. 30). Throws Error(invalid_argument) for a direction that is zero or
/// not finite or a channel the field does not have.
[[nodiscard]] Stokes evaluate(const PshVector& field, int channel, const glm::dvec3& direction);

/// The same at many directions; cheaper than one by one. The spans must have the same length.
void evaluate(const PshVector& field, int channel, std::span<const glm::dvec3> directions,
              std::span<Stokes> out);

/// The adjoint: coefficients[psh_index(l, m)][p] = sum over i of weights[i] <Y_lmp, samples[i]> of one
/// channel. With solid angles for weights this is the projection (Eq. 32) by whatever quadrature they make.
/// The first three spans must have the same length, coefficients 4 * psh_count(order) values. Throws
/// Error(invalid_argument) as evaluate.
void project_samples(int order, std::span<const glm::dvec3> directions, std::span<const Stokes> samples,
                     std::span<const double> weights, std::span<double> coefficients);

/// The values of all harmonics at a direction, so that a field there is their dot product with its
/// coefficients: scalar[psh_index(l, m)] is the real harmonic (for p = 0 and 3), spin2 the complex 2Y_lm.
/// Both spans hold psh_count(order) values. Throws Error(invalid_argument) as evaluate.
void harmonics_at(int order, const glm::dvec3& direction, std::span<double> scalar,
                  std::span<std::complex<double>> spin2);

}  // namespace nicol
