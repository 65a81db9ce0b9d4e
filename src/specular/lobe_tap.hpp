// SPDX-License-Identifier: MIT
// Taps into filtered light, and how light from elsewhere contributes to them.
#pragma once

#include <complex>
#include <vector>

#include "polarization/stokes.hpp"

namespace nicol {

/// A function of the angle between two directions given by its coefficients: the kernels of the convolutions
/// with gain[l] of s0 and s3, and of s1 + i s2 (frames with x along the great circle).
class ZonalKernel {
public:
    /// gain[l] for l = 0..order.
    explicit ZonalKernel(const std::vector<double>& gain);

    struct Value {
        double spin0;
        double spin2;
    };
    /// At directions with the squared distance 2 - 2 cos(angle), within 0..4.
    [[nodiscard]] Value at(double distance2) const;

private:
    std::vector<Value> table_;  // by distance
};

/// Exactly, at the cosine of an angle.
[[nodiscard]] ZonalKernel::Value zonal_sum(const std::vector<double>& gain, double cosine);

/// Where light filtered by a lobe is looked up: in the direction of its frame's z.
struct Tap {
    Frame frame;
    int lobe;  ///< position in kLobeWidths; that many: cosine_gains(), of which only s0 counts
};

/// What light in some frame contributes to a tap: (s0, s3) = scalar (s0, s3) and s1 + i s2 = spin2 (s1 + i
/// s2) there.
struct TapResponse {
    double scalar;
    std::complex<double> spin2;
};

/// For light in the frame `from`, by the value of the tap's kernel at the angle between them.
[[nodiscard]] TapResponse tap_response(const Tap& tap, const ZonalKernel::Value& kernel, const Frame& from);

}  // namespace nicol
