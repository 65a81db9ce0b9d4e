// SPDX-License-Identifier: MIT
// Figure 7: light that is smooth at a pole of the coordinates, truncated in both bases.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiment.hpp"
#include "image.hpp"
#include "light.hpp"
#include "naive.hpp"

namespace {

constexpr std::uint32_t kFine = 64;
constexpr std::uint32_t kOrder = 9;

using Field = std::function<Doubles(const std::vector<Vec3>&)>;

/// Returns s1 + i s2 at (theta, phi) in a frame that does not rotate with phi at the pole theta = 0.
std::complex<double> steady(const Doubles& stokes, std::size_t i, double phi) {
    return std::complex(stokes[4 * i + 1], stokes[4 * i + 2]) * std::polar(1.0, 2 * phi);
}

/// Returns the largest difference on a circle about the pole.
double spread(const Field& field, double radius) {
    constexpr std::size_t count = 64;
    std::vector<Vec3> circle;
    for (std::size_t i = 0; i < count; ++i)
        circle.push_back(direction(radius, 2 * pi * static_cast<double>(i) / count));
    const Doubles stokes = field(circle);
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto a = steady(stokes, i, 2 * pi * static_cast<double>(i) / count);
            const auto b = steady(stokes, j, 2 * pi * static_cast<double>(j) / count);
            largest = std::max(largest, std::abs(a - b));
        }
    return largest;
}

/// Adds views of s1 and s2 within 30 degrees of the pole, seen along -z.
void add_views(Image& image, const std::vector<Field>& fields) {
    constexpr std::size_t size = 128;
    std::vector<Vec3> points;
    Doubles azimuth;
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column < size; ++column) {
            const double x = (2 * static_cast<double>(column) + 1) / size - 1;
            const double y = 1 - (2 * static_cast<double>(row) + 1) / size;
            azimuth.push_back(std::atan2(y, x));
            points.push_back(direction(std::min(std::hypot(x, y), 1.0) * pi / 6, azimuth.back()));
        }
    std::vector<Doubles> values;
    for (const Field& field : fields) values.push_back(field(points));
    double scale = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        scale = std::max(scale, std::abs(steady(values[0], i, azimuth[i])));
    for (int component = 0; component < 2; ++component)
        for (const Doubles& stokes : values) {
            Panel panel{size, size, {}};
            for (std::size_t i = 0; i < points.size(); ++i) {
                const auto s = steady(stokes, i, azimuth[i]);
                panel.values.push_back(component == 0 ? s.real() : s.imag());
            }
            image.add(panel, Signed{scale});
        }
}

}  // namespace

void figure_7(Experiment& experiment) {
    const Doubles original = light(experiment, kFine);
    const Grid grid(NICOL_PSH_GRID_GAUSS_LEGENDRE, kFine, 256, 512);
    const Grid coarse(NICOL_PSH_GRID_GAUSS_LEGENDRE, kOrder, 256, 512);  // the same points
    const Doubles samples = grid.synthesize(original);
    const Doubles spin2 = coarse.analyze(samples);
    const Doubles naive = coarse.analyze(to_scalars(samples));

    const auto error = [&](const Doubles& field) {
        Doubles difference = samples;
        for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= field[i];
        return coarse.rms(difference, true) / coarse.rms(samples, true);
    };
    const std::vector<Field> fields = {
        [&](const auto& w) { return evaluate(kFine, original, w); },
        [&](const auto& w) { return evaluate(kOrder, spin2, w); },
        [&](const auto& w) { return from_scalars(evaluate(kOrder, naive, w)); },
    };
    const double errors[] = {0, error(coarse.synthesize(spin2)),
                             error(from_scalars(coarse.synthesize(naive)))};
    const char* const names[] = {"original (order 64)", "spin-2, order 9", "naive, order 9"};
    std::printf("  %-20s %14s   spread of (s1, s2) on a circle about the pole, over their rms, of radius\n",
                "basis", "relative error");
    std::printf("  %-20s %14s %12s %12s %12s\n", "", "(rms)", "1e-1", "1e-3", "1e-6");
    const double rms = coarse.rms(samples, true);
    double limit[3] = {};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        limit[i] = spread(fields[i], 1e-6) / rms;
        std::printf("  %-20s %14.4f %12.2e %12.2e %12.2e\n", names[i], errors[i],
                    spread(fields[i], 1e-1) / rms, spread(fields[i], 1e-3) / rms, limit[i]);
    }
    experiment.claim(limit[1] < 1e-4, "in spin-2 harmonics the truncated light is smooth at the pole");
    experiment.claim(limit[2] > 1e-2, "in the naive basis it is not: it depends on the way to the pole");
    Image image(fields.size());
    add_views(image, fields);
    image.write(experiment.image("fig07_pole.png"), 2);
}
