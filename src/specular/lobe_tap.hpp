// SPDX-License-Identifier: MIT
// Taps into filtered light, and the contribution of light from other directions to them.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

#include "polarization/stokes.hpp"
#include "polarization/view_geometry.hpp"
#include "simd/lane_parts.hpp"

namespace nicol {

/// Kernels of spin 0 and spin 2 at an angle.
struct ZonalValue {
    double spin0;
    double spin2;
};

/// Returns the exact kernels with these gains, from order 0 on, at the cosine of an angle.
[[nodiscard]] ZonalValue zonal_sum(const std::vector<double>& gain, double cosine);

/// Function of the angle between two directions, given by its coefficients: the convolution kernels with
/// gain[l] of s0 and s3, and of s1 + i s2 (frames with x along the great circle). A table in single
/// precision.
class ZonalKernel {
public:
    /// Takes gain[l] for l = 0..order.
    explicit ZonalKernel(const std::vector<double>& gain);

    /// Computes the kernels at directions with the squared distances 2 - 2 cos(angle), within 0..4. Number: a
    /// vector of floats.
    template <class Number>
    [[gnu::always_inline]] void at(const Number& distance2, Number& spin0, Number& spin2) const {
        Number x = distance2 < 4.0F ? distance2 : Number{} + 4.0F;
        square_root(x);
        x *= static_cast<float>(table_.size() - 1) / 2;
        for (std::size_t i = 0; i < kPart<Number>; ++i) {
            const std::size_t below = std::min(static_cast<std::size_t>(x[i]), table_.size() - 2);
            const float f = x[i] - static_cast<float>(below);
            const Value* const value = table_.data() + below;
            spin0[i] = value[0].spin0 + f * (value[1].spin0 - value[0].spin0);
            spin2[i] = value[0].spin2 + f * (value[1].spin2 - value[0].spin2);
        }
    }

private:
    struct Value {
        float spin0;
        float spin2;
    };
    std::vector<Value> table_;  // by distance
};

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
[[nodiscard]] TapResponse tap_response(const Tap& tap, const ZonalValue& kernel, const Frame& from);

}  // namespace nicol
