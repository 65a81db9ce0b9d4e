// SPDX-License-Identifier: MIT
// Reconstruction filters of images, with the shapes and defaults of Mitsuba 3.
#pragma once

namespace nicol {

/// Weight of a sample in a pixel: the product of operator() of its distances along x and y from the pixel's
/// centre, in pixels.
struct ReconstructionFilter {
    enum class Kind { box, gaussian, tent, mitchell, catmullrom, lanczos };
    static constexpr double kLeastRadius = 0.5;  ///< every pixel holds a sample of its own then
    static constexpr double kMostRadius = 16;

    Kind kind = Kind::box;
    /// Gaussian: standard deviation, pixels; tent: radius, pixels; lanczos: number of lobes on each side; 0:
    /// the kind's default, 0.5, 1 and 3. Other kinds have no size.
    double size = 0;
    double b = 1.0 / 3;  ///< mitchell: parameters of Mitchell and Netravali, 0..1
    double c = 1.0 / 3;

    /// Returns the distance, in pixels, from which on weights are 0.
    [[nodiscard]] double radius() const;
    /// Returns the weight at a distance along one axis, which is negative in lobes of some kinds.
    [[nodiscard]] double operator()(double distance) const;

    bool operator==(const ReconstructionFilter&) const = default;
};

/// Throws Error(invalid_argument) that names the member that is out of range, with `name` before it.
void check(const ReconstructionFilter& filter, const char* name);

}  // namespace nicol
