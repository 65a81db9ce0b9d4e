// SPDX-License-Identifier: MIT
// Predicted error of an image.
#pragma once

#include <algorithm>
#include <cmath>

namespace nicol {

/// Error of s0 relative to its RMS. The light of an image comes in parts with an error each: orders that are
/// left out, samples of lights. Interpolation between vertices errs by a part of the whole. Errors are
/// independent, so that their squares add.
class PredictedError {
public:
    /// Adds a part whose error is predicted as well as its s0, by the means of their squares. The squares of
    /// the parts' s0 add to no more than the square of the whole, so that the prediction is rather too large.
    void add(double squared_error, double power) {
        squared_error_ += squared_error;
        power_ += power;
    }
    /// Adds a sampled part by the means over the image of its squared noise and of its squared s0.
    void add_noise(double squared_noise, double power) {
        squared_noise_ += squared_noise;
        power_ += power;
    }
    /// Adds an error of all parts, relative to the RMS of the image's s0.
    void add_relative(double error) { squared_relative_ += error * error; }
    /// Sets the mean of the squared s0 of the shaded image, to which noise is relative; 0: unknown.
    void know_power(double power) { known_power_ = power; }
    [[nodiscard]] double relative() const {
        const double shown = known_power_ > 0 ? known_power_ : power_;
        return std::sqrt((power_ > 0 ? squared_error_ / power_ : 0) +
                         (shown > 0 ? squared_noise_ / shown : 0) + squared_relative_);
    }

private:
    double squared_relative_ = 0;
    double squared_error_ = 0;
    double squared_noise_ = 0;
    double power_ = 0;
    double known_power_ = 0;
};

/// Error of omitted orders in an image, over the mean that OrderSelector predicts for all rotations of the
/// light and all views. Measured by tests/peers/random_scenes.py.
inline constexpr double kErrorOfOrders = 0.85;

/// Error of bounced light, relative to its share at receivers: of links chosen as if by chance, of its low
/// order and of the interpolation between receivers. Measured by nicol-bench bounces; pictures err by 0.1 of
/// their bounced light, of which receivers, dense where much light bounces, have twice the share.
inline constexpr double kErrorOfBounces = 0.05;

/// Returns the error of bounced light whose share of all light is `share`. The error comes from differences
/// of bounced light between places and directions, and these come from direct light: where nearly all light
/// has bounced, as in a box with a small opening, it is even.
[[nodiscard]] inline double error_of_bounces(double share) {
    return kErrorOfBounces * share * std::sqrt(std::max(0.0, 1 - share * share));
}

/// Returns the part of a tolerance that is left to the orders by another error, the one of shadows between
/// baked vertices: independent errors add as squares. Half of the tolerance always remains, because finer
/// orders would not mend coarse shadows. The part is rounded down to steps, so that orders stay when objects
/// move.
[[nodiscard]] inline double left_of_tolerance(double tolerance, double error) {
    constexpr double least = 0.5;
    constexpr double steps = 4;  // per octave
    if (!(tolerance > 0)) return tolerance;
    const double used = error / tolerance;
    const double left = std::sqrt(std::max(1 - used * used, least * least));
    return tolerance * std::exp2(std::floor(steps * std::log2(left)) / steps);
}

}  // namespace nicol
