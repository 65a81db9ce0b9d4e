// SPDX-License-Identifier: MIT
// Values of Stokes vector fields at directions, and the adjoint.
#pragma once

#include <complex>
#include <span>

#include "harmonics/psh.hpp"
#include "polarization/stokes.hpp"

namespace nicol {

/// Returns the Stokes components of the field at a direction (which the function normalises), in the
/// theta-phi frame of that direction; on the z axis phi is taken as 0 (Eq. 30). Throws
/// Error(invalid_argument) for a direction that is zero or not finite or a channel that the field does not
/// have.
[[nodiscard]] Stokes evaluate(const PshVector& field, int channel, const glm::dvec3& direction);

/// Evaluates the field at many directions, which is cheaper than one by one. The spans must have equal
/// lengths.
void evaluate(const PshVector& field, int channel, std::span<const glm::dvec3> directions,
              std::span<Stokes> out);

/// Computes the adjoint of evaluate(): coefficients[psh_index(l, m)][p] = sum over i of weights[i] <Y_lmp,
/// samples[i]> of one channel. With solid angles for weights, the adjoint is the projection (Eq. 32) by the
/// quadrature that directions and weights define. The first three spans must have equal lengths, and
/// coefficients must have 4 * psh_count(order) values. Throws what evaluate() throws.
void project_samples(int order, std::span<const glm::dvec3> directions, std::span<const Stokes> samples,
                     std::span<const double> weights, std::span<double> coefficients);

/// Computes the values of all harmonics at a direction, so that a field's value there is their dot product
/// with the field's coefficients: scalar[psh_index(l, m)] is the real harmonic (for p = 0 and 3), spin2 the
/// complex 2Y_lm. Both spans hold psh_count(order) values. Throws what evaluate() throws.
void harmonics_at(int order, const glm::dvec3& direction, std::span<double> scalar,
                  std::span<std::complex<double>> spin2);

}  // namespace nicol
