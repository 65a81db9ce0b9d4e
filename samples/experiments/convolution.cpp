// SPDX-License-Identifier: MIT
// Figure 16: convolution with diag(pi - theta) by the integral over all directions and by coefficients.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiment.hpp"
#include "image.hpp"
#include "light.hpp"

namespace {

std::int32_t kernel(void*, double theta, double mueller[16]) {
    for (int p = 0; p < 4; ++p) mueller[5 * p] = pi - theta;
    return 1;
}

struct Point {
    Vec3 w, x, y;  ///< direction, theta-hat, phi-hat
};

std::vector<Point> points_of(const Grid& grid) {
    std::vector<Point> out;
    for (const double theta : grid.theta)
        for (std::size_t c = 0; c < grid.columns; ++c) {
            const double phi = grid.phi(c);
            out.push_back({direction(theta, phi), theta_hat(theta, phi), phi_hat(phi)});
        }
    return out;
}

/// Returns the integral of k(angle) f over the grid, with frames rotated along the great circle between the
/// two points.
std::array<double, 4> convolve_at(const Grid& grid, const std::vector<Point>& from, const Doubles& f,
                                  const Point& to) {
    std::array<double, 4> sum{};
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Point& p = from[i];
        const double k =
            (pi - std::acos(std::clamp(dot(p.w, to.w), -1.0, 1.0))) * grid.solid_angle(i / grid.columns);
        // The great circle leaves the input along a and reaches the output along b.
        const std::complex<double> a(dot(to.w, p.x), dot(to.w, p.y));
        const std::complex<double> b(-dot(p.w, to.x), -dot(p.w, to.y));
        const double length = std::norm(a) * std::norm(b);
        const std::complex<double> e = length > 0 ? std::conj(a) * b : 1.0;
        const std::complex<double> rotated =
            std::complex(f[4 * i + 1], f[4 * i + 2]) * (e * e / (length > 0 ? length : 1.0));
        sum[0] += k * f[4 * i];
        sum[1] += k * rotated.real();
        sum[2] += k * rotated.imag();
        sum[3] += k * f[4 * i + 3];
    }
    return sum;
}

}  // namespace

void figure_16(Experiment& experiment) {
    const std::uint32_t order = experiment.quick ? 19 : 99;
    const std::uint32_t rows = order + 1, columns = 2 * order + 1;
    const Doubles f = light(experiment, order);
    const Grid grid(NICOL_PSH_GRID_GAUSS_LEGENDRE, order, rows, columns);

    Doubles bands(NICOL_PSH_BAND_SIZE * std::size_t{rows});
    const double kernel_s = seconds(
        [&] { check(nicol_psh_project_kernel(kernel, nullptr, order, 4096, bands.data(), bands.size())); });
    Doubles result(f.size());
    const auto convolve = [&] {
        check(nicol_psh_convolve(order, bands.data(), bands.size(), 1, f.data(), f.size(), result.data(),
                                 result.size()));
    };
    const double convolve_s = least_seconds(convolve);
    Doubles frequency;
    const double synthesize_s = least_seconds([&] { frequency = grid.synthesize(result); });

    // The output pixels are every second column, (order + 1)^2 in all.
    const std::vector<Point> points = points_of(grid);
    std::vector<std::size_t> pixels;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t c = 0; c < rows; ++c) pixels.push_back(row * columns + 2 * c % columns);
    Doubles angular, wanted;
    const double angular_s = seconds([&] {
        const Doubles samples = grid.synthesize(f);
        for (const std::size_t i : pixels)
            for (const double s : convolve_at(grid, points, samples, points[i])) angular.push_back(s);
    });
    double scale = 0;
    for (const std::size_t i : pixels)
        for (std::size_t p = 0; p < 4; ++p) {
            wanted.push_back(frequency[4 * i + p]);
            scale = std::max(scale, std::abs(wanted.back()));
        }
    const double difference = largest_difference(angular, wanted) / scale;
    std::printf(
        "  kernel diag(pi - theta), l < %u, %zu pixels, one thread; angular: sum over %zu directions\n", rows,
        pixels.size(), points.size());
    std::printf("  angular domain                       %12.4e s\n", angular_s);
    std::printf("  frequency domain: convolve           %12.4e s\n", convolve_s);
    std::printf("  frequency domain: and to the grid    %12.4e s\n", convolve_s + synthesize_s);
    std::printf("  (once a kernel: its coefficients     %12.4e s)\n", kernel_s);
    std::printf("  ratio                                %12.0f    (the authors: 253 s / 0.0105 s = 24095)\n",
                angular_s / (convolve_s + synthesize_s));
    std::printf("  largest difference over the largest value: %.2e\n", difference);

    // The kernel has a kink at 0 and pi, so the error is in the sum, not in the coefficients. A finer sum
    // shows the cause.
    std::printf("  %-34s %s\n", "sum over rows x columns", "difference at 100 pixels");
    double last = 0, first = 0;
    for (const std::uint32_t finer : {1U, 2U, 4U}) {
        const Grid input(NICOL_PSH_GRID_GAUSS_LEGENDRE, order, finer * rows, finer * columns);
        const Doubles samples = input.synthesize(f);
        const std::vector<Point> from = points_of(input);
        last = 0;
        for (std::size_t i = 0; i < pixels.size(); i += pixels.size() / 100) {
            const auto s = convolve_at(input, from, samples, points[pixels[i]]);
            for (std::size_t p = 0; p < 4; ++p)
                last = std::max(last, std::abs(s[p] - wanted[4 * i + p]) / scale);
        }
        if (finer == 1) first = last;
        std::printf("  %5u x %-26u %.2e\n", finer * rows, finer * columns, last);
    }
    experiment.claim(difference < (experiment.quick ? 1e-3 : 1e-4), "both domains give the same light");
    experiment.claim(last < first / 8, "what differs is the error of the sum, of third order in its step");

    Image image(3);
    for (std::size_t p = 0; p < 3; ++p) {
        Panel panels[3];
        double largest = 0;
        for (Panel& panel : panels) panel = {rows, rows, {}};
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            panels[0].values.push_back(angular[4 * i + p]);
            panels[1].values.push_back(wanted[4 * i + p]);
            panels[2].values.push_back(1e4 * (angular[4 * i + p] - wanted[4 * i + p]));
            largest = std::max(largest, std::abs(wanted[4 * i + p]));
        }
        for (const Panel& panel : panels) image.add(panel, Signed{largest});
    }
    image.write(experiment.image("fig16_convolution.png"), experiment.quick ? 8 : 2);
}
