// SPDX-License-Identifier: MIT
#include "harmonics/legendre_recurrence.hpp"

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

/// The recurrence of Legendre polynomials, y_{l+1} = ((2l+1) (1 - t) y_l - l y_{l-1}) / (l+1), with random
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

Result run(std::vector<LegendreStep> steps, int rings, bool split, double start, int exponent,
           const std::vector<double>& in) {
    const auto n = static_cast<std::size_t>(rings);
    std::vector<double> t;
    for (int r = 0; r < rings; ++r) t.push_back(.001 + 1.0 * r / rings);
    const std::vector<double> value(n, start);
    const std::vector<int> exponents(n, exponent);
    const LegendreRings all{t.data(), value.data(), exponents.data(), rings};
    Result out;
    out.synthesis.resize(8 * n);
    synthesize(steps.data(), static_cast<int>(steps.size()), all, split, out.synthesis.data(), rings);
    analyze(steps.data(), static_cast<int>(steps.size()), all, split, in.data(), rings);
    for (const LegendreStep& s : steps) out.analysis.insert(out.analysis.end(), s.f, s.f + 4);
    return out;
}

}  // namespace

TEST_CASE("sums over rings agree with the plain recurrence") {
    std::mt19937_64 random(1);
    for (const bool split : {false, true})
        for (const int rings : {8, 16, 24, 40, 72})
            for (const int count : {1, 2, 7, 30}) {
                const auto steps = legendre_steps(random, count);
                const auto in = random_values(random, 8 * static_cast<std::size_t>(rings));
                const Result have = run(steps, rings, split, 1, 0, in);
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
                CAPTURES(rings, count);
                CHECK(largest_difference(synthesis, have.synthesis) < 1e-13);
                CHECK(largest_difference(analysis, have.analysis) < 1e-12);
            }
}

TEST_CASE("a start below the range of double grows back, and joins the sums when it counts") {
    // t beyond 2 makes the recurrence grow without end, by about 2^4.6 a step at t = 13.
    const int count = 400;
    std::vector<LegendreStep> steps(count);
    for (auto& s : steps) {
        s = {2, 2, 1, 0, {1, 0, 0, 0}};
    }
    const std::vector<double> t(8, 13.0);
    const std::vector<double> value(8, 0x1p-10);
    const std::vector<int> exponent = {-6, -6, -5, -6, -6, -6, -6, -6};
    std::vector<double> out(64);
    synthesize(steps.data(), count, {t.data(), value.data(), exponent.data(), 8}, false, out.data(), 8);
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
