// SPDX-License-Identifier: MIT
// The loops of every instruction set this processor has do the same, and transforms of any length are right.
#include "harmonics/vector_kernel.hpp"

#include "harmonics/batch_fft.hpp"
#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

std::vector<double> random_values(std::mt19937_64& random, std::size_t count) {
    std::normal_distribution<double> normal;
    std::vector<double> out(count);
    for (double& value : out) value = normal(random);
    return out;
}

/// The recursion of Legendre polynomials, y_{l+1} = ((2l+1) (1 - t) y_l - l y_{l-1}) / (l+1), with random
/// coefficients.
std::vector<LegendreStep> legendre_steps(std::mt19937_64& random, int count) {
    std::normal_distribution<double> normal;
    std::vector<LegendreStep> out(static_cast<std::size_t>(count));
    for (int l = 0; l < count; ++l) {
        LegendreStep& s = out[static_cast<std::size_t>(l)];
        s.p = s.q = (2.0 * l + 1) / (l + 1);
        s.c = l / (l + 1.0);
        for (double& f : s.f) f = normal(random);
    }
    return out;
}

struct Result {
    std::vector<double> synthesis, analysis;
};

Result run(const VectorKernel& kernel, std::vector<LegendreStep> steps, int rings, bool split, double start,
           int exponent, const std::vector<double>& in) {
    const auto n = static_cast<std::size_t>(rings);
    std::vector<double> t;
    for (int r = 0; r < rings; ++r) t.push_back(.001 + 1.0 * r / rings);
    const std::vector<double> value(n, start);
    const std::vector<int> exponents(n, exponent);
    const LegendreRings all{t.data(), value.data(), exponents.data(), rings};
    Result out;
    out.synthesis.resize(8 * n);
    kernel.synthesize(steps.data(), static_cast<int>(steps.size()), all, split, out.synthesis.data(), rings);
    kernel.analyze(steps.data(), static_cast<int>(steps.size()), all, split, in.data(), rings);
    for (const LegendreStep& s : steps) out.analysis.insert(out.analysis.end(), s.f, s.f + 4);
    return out;
}

}  // namespace

TEST_CASE("all instruction sets agree with the plain recursion") {
    std::mt19937_64 random(1);
    for (int k = 0; k < vector_kernel_count(); ++k)
        for (const bool split : {false, true})
            for (const int rings : {8, 16, 24, 40, 72})
                for (const int count : {1, 2, 7, 30}) {
                    const auto steps = legendre_steps(random, count);
                    const auto in = random_values(random, 8 * static_cast<std::size_t>(rings));
                    const Result have = run(vector_kernel(k), steps, rings, split, 1, 0, in);
                    std::vector<double> synthesis(have.synthesis.size());
                    std::vector<double> analysis(have.analysis.size());
                    for (int r = 0; r < rings; ++r) {
                        const double x = 1 - (.001 + 1.0 * r / rings);
                        for (int l = 0; l < count; ++l)
                            for (int f = 0; f < 4; ++f) {
                                const int row = split && l % 2 != 0 ? 4 + f : f;
                                const auto at = static_cast<std::size_t>(row * rings + r);
                                const double y = std::legendre(static_cast<unsigned>(l), x);
                                synthesis[at] += y * steps[static_cast<std::size_t>(l)].f[f];
                                analysis[static_cast<std::size_t>(4 * l + f)] += y * in[at];
                            }
                    }
                    CAPTURE(k);
                    CAPTURE(rings);
                    CAPTURE(count);
                    CHECK(reference::max_difference(synthesis, have.synthesis) < 1e-13);
                    CHECK(reference::max_difference(analysis, have.analysis) < 1e-12);
                }
}

TEST_CASE("a start below the range of double grows back, and joins the sums when it counts") {
    std::mt19937_64 random(2);
    // t beyond 2 makes the recursion grow without end, by about 2^4.6 a step at t = 13.
    for (int k = 0; k < vector_kernel_count(); ++k) {
        const int count = 400;
        std::vector<LegendreStep> steps(count);
        for (auto& s : steps) {
            s = {2, 2, 1, 0, {1, 0, 0, 0}};
        }
        const std::vector<double> t(8, 13.0);
        const std::vector<double> value(8, 0x1p-10);
        const std::vector<int> exponent = {-6, -6, -5, -6, -6, -6, -6, -6};
        std::vector<double> out(64);
        vector_kernel(k).synthesize(steps.data(), count, {t.data(), value.data(), exponent.data(), 8}, false,
                                    out.data(), 8);
        long double y = 0x1p-10L;
        long double before = 0;
        long double sum = 0;
        for (int l = 0; l < count; ++l) {
            sum += y;
            const long double next = (2 - 2 * 13.0L) * y - before;
            before = y;
            y = next;
        }
        CHECK(out[0] == doctest::Approx(static_cast<double>(std::ldexp(sum, -256 * 6))).epsilon(1e-12));
        CHECK(out[2] == doctest::Approx(static_cast<double>(std::ldexp(sum, -256 * 5))).epsilon(1e-12));
    }
}

TEST_CASE("Fourier transforms of every kind of length agree with the sum") {
    std::mt19937_64 random(3);
    for (const int n : {1,  2,  3,  4,  5,  6,  7,   8,   9,   11,  12,  13,  15,  16,  19,  21,
                        30, 49, 61, 64, 66, 67, 101, 122, 127, 134, 202, 210, 256, 257, 360, 602}) {
        CAPTURE(n);
        const auto count = static_cast<std::size_t>(n);
        BatchFft fft(n);
        for (int repeat = 0; repeat < 2; ++repeat) {
            const std::vector<double> in = random_values(random, BatchFft::kElement * count);
            std::vector<double> data = in;
            const double* out = fft.forward(data.data());
            double worst = 0;
            for (std::size_t k = 0; k < count; k += 1 + count / 40)
                for (std::size_t lane = 0; lane < BatchFft::kLanes; ++lane) {
                    std::complex<double> sum = 0;
                    for (std::size_t i = 0; i < count; ++i)
                        sum += std::complex(in[BatchFft::kElement * i + lane],
                                            in[BatchFft::kElement * i + 8 + lane]) *
                               std::polar(1.0, -2 * pi * static_cast<double>(i * k % count) / n);
                    worst =
                        std::max(worst, std::abs(sum - std::complex(out[BatchFft::kElement * k + lane],
                                                                    out[BatchFft::kElement * k + 8 + lane])));
                }
            CHECK(worst < 1e-14 * (3 + n));
        }
    }
}

TEST_CASE("Fourier stages and small products agree between instruction sets") {
    std::mt19937_64 random(4);
    for (const int factor : {2, 3, 4, 5, 7, 11, 13, 61}) {
        const auto p = static_cast<std::size_t>(factor);
        const auto in = random_values(random, BatchFft::kElement * p * 2 * 3);
        const auto twiddles = random_values(random, 2 * 2 * (p - 1));
        std::vector<double> roots;
        for (int j = 0; j < factor; ++j) {
            roots.push_back(std::cos(2 * pi * j / factor));
            roots.push_back(-std::sin(2 * pi * j / factor));
        }
        std::vector<double> first(in.size());
        vector_kernel(0).fft_stage(in.data(), first.data(), factor, 2, 3, twiddles.data(), roots.data());
        for (int k = 1; k < vector_kernel_count(); ++k) {
            std::vector<double> out(in.size());
            vector_kernel(k).fft_stage(in.data(), out.data(), factor, 2, 3, twiddles.data(), roots.data());
            CHECK(reference::max_difference(first, out) < 1e-12);
        }
    }
    for (int k = 0; k < vector_kernel_count(); ++k) {
        const int width = 9;
        const auto d = random_values(random, 81);
        const auto in = random_values(random, 36);
        std::vector<double> out(36);
        std::vector<double> want(36);
        vector_kernel(k).multiply_lanes(width, d.data(), in.data(), out.data());
        for (std::size_t i = 0; i < 9; ++i)
            for (std::size_t j = 0; j < 9; ++j)
                for (std::size_t lane = 0; lane < 4; ++lane)
                    want[4 * i + lane] += d[9 * i + j] * in[4 * j + lane];
        CHECK(reference::max_difference(out, want) < 1e-13);
    }
}
