// SPDX-License-Identifier: MIT
// Tests of convolution: the theorem against the integral over the sphere, block by block, and against wrong
// variants.
#include "harmonics/convolution.hpp"

#include "harmonics/evaluate.hpp"
#include "harmonics/random_operators.hpp"
#include "harmonics/reference.hpp"
#include "harmonics/rotation.hpp"
#include "test.hpp"

using namespace nicol;
using reference::random_kernel;

namespace {

/// Evaluates Eq. 63: the integral over all input directions, with the kernel between frames along the great
/// circle.
Stokes angular(const ConvolutionKernel& kernel, const PshVector& field, const glm::dvec3& to) {
    const int order = static_cast<int>(kernel.size()) - 1 + field.order();
    const LatitudeRows rows = gauss_legendre_rows(order / 2 + 2);
    const int columns = order + 3;
    std::complex<double> spin = 0;
    double s0 = 0;
    double s3 = 0;
    for (std::size_t j = 0; j < rows.theta.size(); ++j)
        for (int c = 0; c < columns; ++c) {
            const glm::dvec3 from = reference::direction(rows.theta[j], 2 * pi * c / columns);
            const glm::dvec3 towards = glm::normalize(to - from * glm::dot(to, from));
            const glm::dvec3 onwards = -glm::normalize(from - to * glm::dot(to, from));
            const Frame in(towards, glm::cross(from, towards), from);
            const Frame out(onwards, glm::cross(to, onwards), to);
            const Stokes f = evaluate(field, 0, from);
            const auto rotated =
                std::complex(f[1], f[2]) * reference::frame_change(reference::theta_phi(from), in);
            const double v[4] = {f[0], rotated.real(), rotated.imag(), f[3]};
            const Mueller k =
                kernel_at(kernel, std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to)));
            double r[4] = {};
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t q = 0; q < 4; ++q) r[p] += k(p, q) * v[q];
            const double weight = rows.weight[j] * 2 * pi / columns;
            s0 += weight * r[0];
            s3 += weight * r[3];
            spin +=
                weight * std::complex(r[1], r[2]) * reference::frame_change(out, reference::theta_phi(to));
        }
    return {s0, spin.real(), spin.imag(), s3};
}

double worst_deviation(const ConvolutionKernel& kernel, const PshVector& field, const PshVector& result,
                       std::mt19937_64& random) {
    double worst = 0;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 d = reference::random_direction(random);
        const Stokes want = angular(kernel, field, d);
        const Stokes have = evaluate(result, 0, d);
        for (int p = 0; p < 4; ++p) worst = std::max(worst, std::abs(want[p] - have[p]));
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "the convolution theorem (Eq. 69): frequency domain equals the integral, all 16 degrees of freedom") {
    std::mt19937_64 random(1);
    const ConvolutionKernel kernel = random_kernel(random, 5);
    const PshVector f = reference::random_field(random, 5);
    CHECK(worst_deviation(kernel, f, convolved(kernel, f), random) < 1e-12);
    PshVector low(3, 1);
    for (std::size_t i = 0; i < low.data().size(); ++i) low.data()[i] = f.data()[i];
    CHECK(worst_deviation(kernel, low, convolved(kernel, low), random) < 1e-12);
}

TEST_CASE("kernel functions and coefficients are inverses of each other (Eq. 68)") {
    std::mt19937_64 random(3);
    const ConvolutionKernel kernel = random_kernel(random, 8);
    const ConvolutionKernel back =
        project_kernel([&](double theta) { return kernel_at(kernel, theta); }, 8, gauss_legendre_rows(9));
    CHECK(reference::kernel_difference(kernel, back) < 1e-13);
}

TEST_CASE("convolution commutes with every rotation") {
    std::mt19937_64 random(4);
    const ConvolutionKernel kernel = random_kernel(random, 7);
    const PshVector f = reference::random_field(random, 7, 2);
    const glm::dmat3 r = reference::random_rotation(random);
    CHECK(largest_difference(convolved(kernel, rotated(f, r)).data(),
                             rotated(convolved(kernel, f), r).data()) < 1e-13 * 20);
}

TEST_CASE("as an operator, composed, and extracted again") {
    std::mt19937_64 random(5);
    const ConvolutionKernel a = random_kernel(random, 5);
    const ConvolutionKernel b = random_kernel(random, 5);
    const PshVector f = reference::random_field(random, 5);
    std::vector<double> by_matrix(f.data().size());
    kernel_matrix(a).apply(f.channel(0), by_matrix);
    CHECK(largest_difference(by_matrix, convolved(a, f).data()) < 1e-13);
    CHECK(largest_difference(convolved(compose(a, b), f).data(), convolved(a, convolved(b, f)).data()) <
          1e-12);
    const ConvolutionKernel back = nearest_kernel(kernel_matrix(a).dense());
    CHECK(largest_difference(convolved(back, f).data(), convolved(a, f).data()) < 1e-13);
}

TEST_CASE("the nearest kernel is nearest: what remains is orthogonal to every convolution") {
    std::mt19937_64 random(6);
    std::normal_distribution<double> normal;
    CoefficientMatrix matrix(4, 4);
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j) {
            const auto low = [](std::size_t k) { return (k % 4 == 1 || k % 4 == 2) && k / 4 < 4; };
            if (!low(i) && !low(j)) matrix(i, j) = normal(random);
        }
    const CoefficientMatrix nearest = kernel_matrix(nearest_kernel(matrix)).dense();
    for (int k = 0; k < 10; ++k) {
        const CoefficientMatrix other = kernel_matrix(random_kernel(random, 4)).dense();
        double dot = 0;
        double size = 0;
        for (std::size_t i = 0; i < matrix.data().size(); ++i) {
            dot += (matrix.data()[i] - nearest.data()[i]) * other.data()[i];
            size += std::abs(matrix.data()[i] * other.data()[i]);
        }
        CHECK(std::abs(dot) < 1e-14 * size);
    }
}

TEST_CASE("convolution refuses bad arguments") {
    std::mt19937_64 random(7);
    const ConvolutionKernel kernel = random_kernel(random, 3);
    std::vector<double> f(4 * psh_count(4));
    std::vector<double> g(4 * psh_count(4));
    CHECK_THROWS_AS(convolve(kernel, f, g), Error);
    CHECK_THROWS_AS(convolve(kernel, std::span(f).first(40), std::span(g).first(40)), Error);
    CHECK_THROWS_AS(convolve(kernel, std::span(f).first(64), std::span(g).first(36)), Error);
    CHECK_THROWS_AS(convolve({}, std::span(f).first(4), std::span(g).first(4)), Error);
    CHECK_THROWS_AS(kernel_at(kernel, -1), Error);
    CHECK_THROWS_AS(kernel_at(kernel, NAN), Error);
    CHECK_THROWS_AS(compose(kernel, random_kernel(random, 2)), Error);
    CHECK_THROWS_AS(nearest_kernel(CoefficientMatrix(2, 3)), Error);
    ConvolutionKernel broken = kernel;
    broken[2].iso = NAN;
    CHECK_THROWS_AS(convolve(broken, std::span(f).first(64), std::span(g).first(64)), Error);
    const KernelFunction nan = [](double) {
        Mueller m;
        m(0, 0) = INFINITY;
        return m;
    };
    CHECK_THROWS_AS(project_kernel(nan, 2, gauss_legendre_rows(3)), Error);
    CHECK_THROWS_AS(project_kernel(nan, -2, gauss_legendre_rows(3)), Error);
}
