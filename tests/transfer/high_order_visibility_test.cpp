// SPDX-License-Identifier: MIT
#include "transfer/high_order_visibility.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "material/high_order_gains.hpp"
#include "nicol/error.hpp"
#include "nicol/evaluate.hpp"
#include "nicol/grid.hpp"

using namespace nicol;

namespace {

constexpr double pi = std::numbers::pi;

/// Coefficients over real harmonics of a function of the propagation direction.
template <class Function>
std::vector<float> project(Function function, int order) {
    const LatitudeRows rows = gauss_legendre_rows(128);
    constexpr int columns = 256;
    std::vector<double> sum(psh_count(order));
    std::vector<double> scalar(psh_count(order));
    std::vector<std::complex<double>> spin2(psh_count(order));
    for (std::size_t j = 0; j < rows.theta.size(); ++j) {
        for (int c = 0; c < columns; ++c) {
            const double phi = 2 * pi * (c + 0.5) / columns;
            const glm::dvec3 d(std::sin(rows.theta[j]) * std::cos(phi),
                               std::sin(rows.theta[j]) * std::sin(phi), std::cos(rows.theta[j]));
            harmonics_at(order, d, scalar, spin2);
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += function(d) * rows.weight[j] * 2 * pi / columns * scalar[i];
        }
    }
    return {sum.begin(), sum.end()};
}

}  // namespace

TEST_CASE("what nothing hides is seen whole, and what is hidden is dark") {
    constexpr int order = 8;
    const auto half = project([](const glm::dvec3& d) { return d.z < 0 ? 1.0 : 0.0; }, order);
    const auto all = project([](const glm::dvec3&) { return 1.0; }, order);
    const std::vector<float> none(psh_count(order));
    const HighOrderVisibility dark(order, 0.2, HorizonExtension::dark);
    const HighOrderVisibility mirrored(order, 0.2, HorizonExtension::mirrored);
    for (const double theta : {0.0, 0.4, 1.0, 1.5}) {
        const glm::vec3 d(std::sin(theta) * 0.6, std::sin(theta) * 0.8, -std::cos(theta));
        for (const glm::vec2 open : {dark.at(half, d), mirrored.at(all, d)}) {
            CHECK(open[0] == doctest::Approx(1).epsilon(1e-3));
            CHECK(open[1] == doctest::Approx(1).epsilon(1e-3));
        }
        CHECK(dark.at(none, d) == glm::vec2(0));
        CHECK(mirrored.at(none, d) == glm::vec2(0));
    }
}

TEST_CASE("the fraction is the visibility filtered by the lobe, and by the cosine about the normal") {
    // A wall on the +x side, seen from below: light that travels towards -x is blocked.
    constexpr int order = 12;
    const auto wall = project([](const glm::dvec3& d) { return d.x < 0 ? 0.0 : 1.0; }, order);
    const HighOrderVisibility fraction(order, 0.3, HorizonExtension::mirrored);
    const OrderGains lobe = gaussian_gains(0.3, 0, order);
    std::vector<double> scalar(psh_count(order));
    std::vector<std::complex<double>> spin2(psh_count(order));
    double before = -1;
    for (const double x : {-0.9, -0.4, -0.1, 0.0, 0.1, 0.4, 0.9}) {
        const glm::dvec3 d(x, 0.3 * std::sqrt(1 - x * x), -std::sqrt(0.91 * (1 - x * x)));
        harmonics_at(order, d, scalar, spin2);
        double expected = 0;
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                expected += lobe[static_cast<std::size_t>(l)] * static_cast<double>(wall[psh_index(l, m)]) *
                            scalar[psh_index(l, m)];
        const glm::vec2 found = fraction.at(wall, glm::vec3(d));
        CHECK(found[0] == doctest::Approx(std::clamp(expected, 0.0, 1.0)).epsilon(1e-4));
        CHECK(found[0] >= before - 1e-3);
        CHECK(found[1] == doctest::Approx(0.5).epsilon(1e-3));
        before = found[0];
    }
    CHECK(before > 0.98);
}

TEST_CASE("every vertex is looked at along its mirrored view direction") {
    constexpr int order = 12;
    const auto wall = project([](const glm::dvec3& d) { return d.x < 0 ? 0.0 : 1.0; }, order);
    const HighOrderVisibility fraction(order, 0.2, HorizonExtension::mirrored);
    // All see the same wall in their own frames, whose axes are theta-hat and phi-hat.
    const std::vector<glm::vec3> normals{{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    std::vector<float> visibility;
    for (std::size_t i = 0; i < normals.size(); ++i)
        visibility.insert(visibility.end(), wall.begin(), wall.end());
    const std::vector<glm::vec3> positions(normals.size(), glm::vec3(0));
    const std::vector<std::uint8_t> visible{1, 0, 1, 1};
    std::vector<glm::vec2> out(normals.size(), glm::vec2(7));
    Viewpoint view;
    // theta-hat is -z at the equator: light that comes from below z = 0 travels upwards, against it.
    view.eye = {5, 0, 5};
    fraction.run(view, positions, normals, visible, visibility, 0, 3, out);
    CHECK(out[0][0] < 0.1F);
    CHECK(out[1] == glm::vec2(7));
    CHECK(out[2][0] < 0.1F);
    CHECK(out[3] == glm::vec2(7));
    view.eye = {5, 0, -5};
    fraction.run(view, positions, normals, visible, visibility, 0, 4, out);
    CHECK(out[0][0] > 0.9F);
    CHECK(out[3][0] > 0.9F);
    CHECK(out[0][1] == doctest::Approx(0.5).epsilon(1e-3));
    // Light that is seen travels into the surface.
    const auto half = project([](const glm::dvec3& d) { return d.z < 0 ? 1.0 : 0.0; }, order);
    view.eye = {5, 0, 0.5};
    fraction.run(view, positions, normals, visible, half, 0, 1, out);
    CHECK(out[0][0] > 0.9F);
}

TEST_CASE("orders and widths are checked") {
    CHECK_THROWS_AS(HighOrderVisibility(65, 0.1, HorizonExtension::dark), Error);
    CHECK_THROWS_AS(HighOrderVisibility(-1, 0.1, HorizonExtension::dark), Error);
    CHECK_THROWS_AS(HighOrderVisibility(8, -0.1, HorizonExtension::dark), Error);
    CHECK_NOTHROW(HighOrderVisibility(0, 0, HorizonExtension::dark));
}
