// SPDX-License-Identifier: MIT
// Test of sequences of optics: two rotating quarter-wave plates give the Mueller matrix of what stands
// between.
#include "scenes.hpp"
#include "sensor/expose.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

PolarizationElement plate(double angle, double retardance = pi / 2) {
    PolarizationElement element;
    element.kind = PolarizationElement::Kind::retarder;
    element.angle = angle;
    element.retardance = retardance;
    return element;
}

/// Solves rows^T rows x = rows^T values by elimination.
std::array<double, 16> least_squares(const std::vector<std::array<double, 16>>& rows,
                                     const std::vector<double>& values) {
    std::array<std::array<double, 17>, 16> a{};
    for (std::size_t n = 0; n < rows.size(); ++n)
        for (std::size_t i = 0; i < 16; ++i) {
            for (std::size_t j = 0; j < 16; ++j) a[i][j] += rows[n][i] * rows[n][j];
            a[i][16] += rows[n][i] * values[n];
        }
    for (std::size_t k = 0; k < 16; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < 16; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        for (std::size_t i = 0; i < 16; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < 17; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    std::array<double, 16> x{};
    for (std::size_t i = 0; i < 16; ++i) x[i] = a[i][16] / a[i][i];
    return x;
}

}  // namespace

TEST_CASE("plates that rotate 1 : 5 in front of and behind a sample give its Mueller matrix to 1e-5") {
    PolarizationElement dichroic;
    dichroic.angle = 0.4;
    dichroic.transmittance = 0.9;
    const Mueller sample = in_front(plate(0.7, 1.1), 0) * in_front(dichroic, 8);
    Sensor sensor = quiet_sensor(Mosaic::plain);
    sensor.exposure = 100000;
    const int side = 256;  // pixels that the steps of the numbers are averaged over
    sensor.read_noise = 2;
    const StokesImage light = even_light(side, side, 1, {1, 0, 0, 0});
    std::vector<std::array<double, 16>> rows;
    std::vector<double> values;
    for (int n = 0; n < 36; ++n) {
        const double angle = n * pi / 36;
        const Mueller generator = in_front(plate(angle), 0) * in_front({}, 0);
        const Mueller analyser = in_front({}, 0) * in_front(plate(5 * angle), 0);
        const Stokes sent = generator * Stokes(1, 0, 0, 0);
        std::array<double, 16> row{};
        for (std::size_t i = 0; i < 16; ++i) row[i] = analyser(0, i / 4) * sent[static_cast<int>(i % 4)];
        rows.push_back(row);
        sensor.optics = analyser * sample * generator;
        double sum = 0;
        for (const double v : expose(sensor, light, static_cast<std::uint64_t>(n)).values) sum += v;
        values.push_back(sum / side / side / 50000);
    }
    const std::array<double, 16> found = least_squares(rows, values);
    for (std::size_t i = 0; i < 16; ++i) CHECK(std::abs(found[i] - sample(i / 4, i % 4)) < 1e-5);
}
