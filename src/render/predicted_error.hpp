// SPDX-License-Identifier: MIT
// Predicted error of an image.
#pragma once

#include <cmath>

namespace nicol {

/// Error of s0 relative to its RMS. The light of an image comes in parts with an error each: orders that are
/// left out, samples of lights. Errors are independent, so that their squares add. The squares of the parts'
/// s0 add to no more than the square of the whole, so that the prediction is rather too large.
class PredictedError {
public:
    /// Adds a part by the means of its squared error and of its squared s0.
    void add(double squared_error, double power) {
        squared_error_ += squared_error;
        power_ += power;
    }
    [[nodiscard]] double relative() const { return power_ > 0 ? std::sqrt(squared_error_ / power_) : 0; }

private:
    double squared_error_ = 0;
    double power_ = 0;
};

}  // namespace nicol
