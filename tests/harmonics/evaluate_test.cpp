// SPDX-License-Identifier: MIT
// Tests of field values against the definition in high precision, including the poles.
#include "harmonics/evaluate.hpp"

#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("the value is the sum over the basis (Eqs. 29, 30)") {
    std::mt19937_64 random(1);
    const PshVector f = reference::random_field(random, 7, 2);
    for (const double theta : {0.0, 1e-7, .5, pi / 2, 2.8, pi - 1e-7, pi})
        for (const double phi : {0.0, 1.0, -3.0}) {
            const bool pole = theta == 0 || theta == pi;
            if (pole && phi != 0) continue;
            Stokes want(0);
            for (int l = 0; l <= 7; ++l)
                for (int m = -l; m <= l; ++m) {
                    const double y = reference::spin_harmonic(0, l, std::abs(m), theta) *
                                     (m > 0   ? std::sqrt(2) * std::cos(m * phi)
                                      : m < 0 ? std::sqrt(2) * std::sin(-m * phi)
                                              : 1);
                    const auto w = std::complex(f.at(1, l, m, 1), f.at(1, l, m, 2)) *
                                   reference::spin_harmonic(2, l, m, theta) * std::polar(1.0, m * phi);
                    want += Stokes(f.at(1, l, m, 0) * y, w.real(), w.imag(), f.at(1, l, m, 3) * y);
                }
            const glm::dvec3 d = pole ? glm::dvec3(0, 0, 1 - theta) : reference::direction(theta, phi);
            const Stokes have = evaluate(f, 1, 3.5 * d);
            for (int p = 0; p < 4; ++p) CHECK(std::abs(have[p] - want[p]) < 1e-12);
        }
}

TEST_CASE("directions of any length, down to the smallest numbers") {
    std::mt19937_64 random(3);
    const PshVector f = reference::random_field(random, 4);
    const glm::dvec3 d(.3, -.4, .8);
    const Stokes want = evaluate(f, 0, d);
    for (const double scale : {1e-300, 1e300, 1e-320}) {
        const Stokes have = evaluate(f, 0, d * scale);
        for (int p = 0; p < 4; ++p)
            CHECK(have[p] == doctest::Approx(want[p]).epsilon(scale < 1e-310 ? 1e-2 : 1e-12));
    }
}

TEST_CASE("harmonics_at holds what evaluate sums, and batches equal singles") {
    std::mt19937_64 random(4);
    const PshVector f = reference::random_field(random, 8);
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 10; ++i) directions.push_back(reference::random_direction(random));
    std::vector<Stokes> values(directions.size());
    evaluate(f, 0, directions, values);
    std::vector<double> scalar(psh_count(8));
    std::vector<std::complex<double>> spin2(psh_count(8));
    for (std::size_t k = 0; k < directions.size(); ++k) {
        harmonics_at(8, directions[k], scalar, spin2);
        Stokes sum(0);
        for (std::size_t i = 0; i < scalar.size(); ++i) {
            const double* c = f.channel(0).data() + 4 * i;
            const auto w = std::complex(c[1], c[2]) * spin2[i];
            sum += Stokes(c[0] * scalar[i], w.real(), w.imag(), c[3] * scalar[i]);
        }
        CHECK(evaluate(f, 0, directions[k]) == values[k]);
        for (int p = 0; p < 4; ++p) CHECK(sum[p] == doctest::Approx(values[k][p]).epsilon(1e-11));
    }
}

TEST_CASE("projecting samples is the adjoint of evaluating them") {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const PshVector f = reference::random_field(random, 11);
    std::vector<glm::dvec3> directions = {{0, 0, 1}, {0, 0, -1}};
    while (directions.size() < 300) directions.push_back(reference::random_direction(random));
    std::vector<Stokes> samples(directions.size());
    std::vector<double> weights(directions.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = {normal(random), normal(random), normal(random), normal(random)};
        weights[i] = normal(random);
    }
    std::vector<double> projected(f.data().size());
    project_samples(11, directions, samples, weights, projected);
    std::vector<Stokes> values(directions.size());
    evaluate(f, 0, directions, values);
    double left = 0;
    double right = 0;
    for (std::size_t i = 0; i < projected.size(); ++i) left += projected[i] * f.data()[i];
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (int p = 0; p < 4; ++p) right += weights[i] * samples[i][p] * values[i][p];
    CHECK(left == doctest::Approx(right).epsilon(1e-12));
    CHECK_THROWS_AS(project_samples(11, directions, samples, std::span(weights).first(3), projected), Error);
    weights[7] = NAN;
    CHECK_THROWS_AS(project_samples(11, directions, samples, weights, projected), Error);
    weights[7] = 1;
    samples[9][2] = INFINITY;
    CHECK_THROWS_AS(project_samples(11, directions, samples, weights, projected), Error);
}

TEST_CASE("evaluation refuses bad arguments") {
    PshVector f(2, 1);
    CHECK_THROWS_AS(evaluate(f, 0, {0, 0, 0}), Error);
    CHECK_THROWS_AS(evaluate(f, 0, {NAN, 0, 1}), Error);
    CHECK_THROWS_AS(evaluate(f, 0, {INFINITY, 0, 1}), Error);
    CHECK_THROWS_AS(evaluate(f, 1, {0, 0, 1}), Error);
    f.at(0, 0, 0, 0) = INFINITY;
    CHECK_THROWS_AS(evaluate(f, 0, {0, 0, 1}), Error);
    std::vector<double> scalar(4);
    std::vector<std::complex<double>> spin2(9);
    CHECK_THROWS_AS(harmonics_at(2, {0, 0, 1}, scalar, spin2), Error);
}
