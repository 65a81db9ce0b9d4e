// SPDX-License-Identifier: MIT
#include "image/reconstruction_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "arguments.hpp"

namespace nicol {
namespace {

using Kind = ReconstructionFilter::Kind;

// Radius of a Gaussian filter over its standard deviation.
constexpr double kDeviations = 4;

double size_of(const ReconstructionFilter& filter) {
    if (filter.size != 0) return filter.size;
    switch (filter.kind) {
        case Kind::gaussian:
            return 0.5;
        case Kind::lanczos:
            return 3;
        default:
            return 1;
    }
}

// Cubic of Mitchell and Netravali, "Reconstruction filters in computer graphics", 1988, Eq. 8.
double cubic(double x, double b, double c) {
    if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
    return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) /
           6;
}

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-8 ? 1 : std::sin(angle) / angle;
}

}  // namespace

double ReconstructionFilter::radius() const {
    switch (kind) {
        case Kind::box:
            return 0.5;
        case Kind::gaussian:
            return kDeviations * size_of(*this);
        case Kind::mitchell:
        case Kind::catmullrom:
            return 2;
        case Kind::tent:
        case Kind::lanczos:
            break;
    }
    return size_of(*this);
}

double ReconstructionFilter::operator()(double distance) const {
    if (kind == Kind::box) return distance >= -0.5 && distance < 0.5 ? 1 : 0;
    const double x = std::abs(distance);
    if (!(x < radius())) return 0;
    switch (kind) {
        case Kind::gaussian: {
            // The value at the radius is subtracted, so that the filter is continuous.
            const double deviations = x / size_of(*this);
            return std::exp(-deviations * deviations / 2) - std::exp(-kDeviations * kDeviations / 2);
        }
        case Kind::mitchell:
            return cubic(x, b, c);
        case Kind::catmullrom:
            return cubic(x, 0, 0.5);
        case Kind::lanczos:
            return sinc(x) * sinc(x / radius());
        case Kind::tent:
        case Kind::box:
            break;
    }
    return 1 - x / radius();
}

void check(const ReconstructionFilter& filter, const char* name) {
    const std::string prefix = name;
    const double scale = filter.kind == Kind::gaussian ? kDeviations : 1;
    const double least = filter.kind == Kind::lanczos ? 1 : ReconstructionFilter::kLeastRadius / scale;
    const double most = ReconstructionFilter::kMostRadius / scale;
    if (filter.size != 0 && !(filter.size >= least && filter.size <= most)) {
        refuse(prefix + "size is " + std::to_string(filter.size) + "; it must lie in " +
               std::to_string(least) + " to " + std::to_string(most) + ", or be 0, the filter's default");
    }
    for (const auto& [value, member] : {std::pair{filter.b, "b"}, std::pair{filter.c, "c"}}) {
        if (!(value >= 0 && value <= 1))
            refuse(prefix + member + " is " + std::to_string(value) + "; it must lie in 0 to 1");
    }
}

}  // namespace nicol
