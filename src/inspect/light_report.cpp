// SPDX-License-Identifier: MIT
#include "inspect/light_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "harmonics/energy.hpp"
#include "light/equirect.hpp"

namespace nicol {
namespace {

void describe_pixels(const EquirectImage& image, int channel, LightChannelReport& report) {
    constexpr double rounding = 1e-5;
    double area = 0;
    double polarized = 0;
    double positive = 0;
    double excess = 0;
    report.smallest = std::numeric_limits<double>::infinity();
    report.largest = -report.smallest;
    for (int y = 0; y < image.height; ++y) {
        // Rows are vertex-centred, so the first and the last row are caps of half a step about the poles.
        const double step = std::numbers::pi / (image.height - 1);
        const bool pole = y == 0 || y == image.height - 1;
        const double weight =
            pole ? 2 * std::pow(std::sin(step / 4), 2) : 2 * std::sin(y * step) * std::sin(step / 2);
        for (int x = 0; x < image.width; ++x) {
            const Stokes s = image.stokes(channel, y, x);
            const double linear = std::hypot(s[1], s[2]);
            const double degree = std::hypot(linear, s[3]);
            area += weight;
            report.mean += weight * s[0];
            report.smallest = std::min(report.smallest, s[0]);
            report.largest = std::max(report.largest, s[0]);
            excess = std::max(excess, degree - s[0]);
            if (s[0] < 0) report.negative += weight;
            if (s[0] < 0 || degree > (1 + rounding) * s[0]) report.unphysical += weight;
            if (s[0] <= 0) continue;
            report.direction +=
                weight * s[0] * equirect_direction((x + 0.5) / image.width, y / (image.height - 1.0));
            positive += weight * s[0];
            polarized += weight * linear;
            report.largest_dolp = std::max(report.largest_dolp, linear / s[0]);
            report.circular = std::max(report.circular, std::abs(s[3]) / s[0]);
        }
    }
    report.mean /= area;
    report.negative /= area;
    report.unphysical /= area;
    if (positive > 0) {
        report.mean_dolp = polarized / positive;
        report.direction /= positive;
    }
    if (excess > 0 && report.unphysical > 0 && report.mean > 0) report.largest_excess = excess / report.mean;
}

}  // namespace

LightReport describe(const Environment& light, const PshVector& coefficients) {
    const EquirectImage image = light.image();
    LightReport report;
    report.width = image.width;
    report.height = image.height;
    report.polarized = light.polarized();
    report.circular = light.circular();
    report.wavelengths = light.wavelengths();
    for (int c = 0; c < light.channels(); ++c) {
        LightChannelReport& channel = report.channels.emplace_back();
        if (c < coefficients.channels()) channel.energy = energy_per_order(coefficients, c);
        describe_pixels(image, c, channel);
    }
    return report;
}

}  // namespace nicol
