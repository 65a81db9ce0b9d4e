// SPDX-License-Identifier: MIT
// Taps into filtered light, and the contribution of light from other directions to them.
#pragma once

#include <complex>
#include <vector>

#include "polarization/stokes.hpp"

namespace nicol {

/// Function of the angle between two directions, given by its coefficients: the convolution kernels with
/// gain[l] of s0 and s3, and of s1 + i s2 (frames with x along the great circle).
class ZonalKernel {
public:
    /// Takes gain[l] for l = 0..order.
    explicit ZonalKernel(const std::vector<double>& gain);

    struct Value {
        double spin0;
        double spin2;
    };
    /// Returns the kernels at directions with the squared distance 2 - 2 cos(angle), within 0..4.
    [[nodiscard]] Value at(double distance2) const;

private:
    std::vector<Value> table_;  // by distance
};

/// Returns the exact kernels at the cosine of an angle.
[[nodiscard]] ZonalKernel::Value zonal_sum(const std::vector<double>& gain, double cosine);

/// Evaluation point in light filtered by a lobe: the direction of its frame's z.
struct Tap {
    Frame frame;
    int lobe;  ///< index in kLobeWidths; kLobeWidths.size() means cosine_gains(), which applies to s0 only
};

/// Contribution of light in some frame to a tap: (s0, s3) = scalar (s0, s3) and s1 + i s2 = spin2 (s1 + i s2)
/// at the tap.
struct TapResponse {
    double scalar;
    std::complex<double> spin2;
};

/// Returns the contribution of light in the frame `from`; `kernel` is the tap's kernel at the angle between
/// them.
[[nodiscard]] TapResponse tap_response(const Tap& tap, const ZonalKernel::Value& kernel, const Frame& from);

}  // namespace nicol
