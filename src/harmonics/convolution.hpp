// SPDX-License-Identifier: MIT
// Convolution of Stokes vector fields on the sphere with polarized kernels.
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "harmonics/grid.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/psh.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

/// Coefficients of a rotation-equivariant operator in one order: 16 real degrees of freedom (Eq. 68).
struct KernelBand {
    double k00 = 0, k03 = 0, k30 = 0, k33 = 0;  ///< over Y_l0
    std::complex<double> p0, p3;                ///< k10 + i k20, k13 + i k23, over 2Y_l0
    std::complex<double> from_p0, from_p3;      ///< k01 - i k02, k31 - i k32, over Y_l,-2
    std::complex<double> iso;                   ///< isomorphic part of the 2-2 block (Eq. 44), over 2Y_l,-2
    std::complex<double> conj;                  ///< conjugation part, over 2Y_l2
};

/// Convolution kernel: one band per order, 0..order. Bands below l = 2 have no part with spin 2.
using ConvolutionKernel = std::vector<KernelBand>;

/// Kernel as a function of the angle between input and output direction. Both frames have x along the great
/// circle, pointing from input to output (Eq. 62).
using KernelFunction = std::function<Mueller(double theta)>;

/// Returns the coefficients of a kernel by quadrature on the rows (Eq. 68). Throws Error(invalid_argument)
/// for an order out of range or a value that is not finite.
[[nodiscard]] ConvolutionKernel project_kernel(const KernelFunction& kernel, int order,
                                               const LatitudeRows& rows);

/// Returns the kernel function of the coefficients at an angle in [0, pi]. The function is the inverse of
/// project_kernel().
[[nodiscard]] Mueller kernel_at(const ConvolutionKernel& kernel, double theta);

/// Convolves one channel (Eq. 69). `in` and `out` have equal length 4 * psh_count(order), where order is not
/// above the kernel's; they may be the same memory.
void convolve(const ConvolutionKernel& kernel, std::span<const double> in, std::span<double> out);
[[nodiscard]] PshVector convolved(const ConvolutionKernel& kernel, const PshVector& field);

/// Returns the kernel of the convolution by `first` followed by the convolution by `second`.
[[nodiscard]] ConvolutionKernel compose(const ConvolutionKernel& second, const ConvolutionKernel& first);

/// Returns the convolution as an operator (supplement E.9).
[[nodiscard]] IsotropicMatrix kernel_matrix(const ConvolutionKernel& kernel);

/// Returns the kernel nearest to an operator in the Frobenius norm, which is the mean over m of the entries
/// that a convolution has.
[[nodiscard]] ConvolutionKernel nearest_kernel(const CoefficientMatrix& matrix);

}  // namespace nicol
