// SPDX-License-Identifier: MIT
// Tests of transforms: exact on every grid for band-limited fields, and equal to evaluation at each point.
#include "harmonics/transform.hpp"

#include "harmonics/evaluate.hpp"
#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

double round_trip(std::mt19937_64& random, int order, LatitudeRows rows, int columns) {
    const PshVector f = reference::random_field(random, order);
    PshTransform transform(order, std::move(rows), columns, .3);
    std::vector<double> samples(4 * static_cast<std::size_t>(transform.rows().count() * columns));
    std::vector<double> back(f.data().size());
    transform.synthesize(f.channel(0), samples);
    transform.analyze(samples, back);
    return largest_difference(f, back) / largest(f);
}

}  // namespace

TEST_CASE("round trips are exact on every grid") {
    std::mt19937_64 random(1);
    const auto check = [&](int order, LatitudeRows rows, int columns, double bound) {
        CAPTURES(order, columns);
        CHECK(round_trip(random, order, std::move(rows), columns) <= bound);
    };
    for (const auto& [order, bound] :
         {std::pair(0, 1e-15), {1, 2e-15}, {2, 3e-15}, {9, 1e-14}, {32, 4e-14}, {100, 2e-13}}) {
        check(order, gauss_legendre_rows(order + 1), 2 * order + 1, bound);
        check(order, gauss_legendre_rows(order + 4), 2 * order + 6, bound);
        check(order, fejer_rows(2 * order + 1), 2 * order + 1, bound);
        check(order, clenshaw_curtis_rows(2 * order + 2), 2 * order + 2, bound);
    }
    check(1000, gauss_legendre_rows(1001), 2016, 5e-12);
    // These rows are far longer than the order needs.
    for (const auto& [order, columns] :
         {std::pair(9, 64), {9, 516}, {0, 1024}, {4, 66}, {3, 4096}, {40, 400}, {8, 68}})
        check(order, gauss_legendre_rows(order + 1), columns, 1e-13);
}

TEST_CASE("synthesis equals evaluation at the grid points") {
    std::mt19937_64 random(3);
    const int order = 40;
    const PshVector f = reference::random_field(random, order);
    for (const bool odd : {false, true}) {
        const int columns = 90;
        PshTransform transform(order, fejer_rows(odd ? 83 : 84), columns, -.7);
        const int rows = transform.rows().count();
        std::vector<double> samples(4 * static_cast<std::size_t>(rows * columns));
        transform.synthesize(f.channel(0), samples);
        for (int row = 0; row < rows; row += 3)
            for (int c = 0; c < columns; c += 11) {
                const double theta = transform.rows().theta[static_cast<std::size_t>(row)];
                const Stokes want = evaluate(f, 0, reference::direction(theta, -.7 + 2 * pi * c / columns));
                for (int p = 0; p < 4; ++p)
                    CHECK(std::abs(samples[4 * static_cast<std::size_t>(row * columns + c) +
                                           static_cast<std::size_t>(p)] -
                                   want[p]) < 2e-11);
            }
    }
}

TEST_CASE("rows that are not mirrored between north and south work, too") {
    std::mt19937_64 random(4);
    const int order = 6;
    const PshVector f = reference::random_field(random, order);
    LatitudeRows all = gauss_legendre_rows(20);
    LatitudeRows some;
    for (const std::size_t j : {0UL, 3UL, 4UL, 9UL, 12UL, 16UL, 18UL}) {
        some.theta.push_back(all.theta[j]);
        some.sin_half.push_back(all.sin_half[j]);
        some.cos_half.push_back(all.cos_half[j]);
        some.weight.push_back(all.weight[j]);
    }
    LegendreTransform whole(order, all);
    LegendreTransform part(order, some);
    FourierRows a(order, 20);
    FourierRows b(order, 7);
    whole.synthesize(f.channel(0), a);
    part.synthesize(f.channel(0), b);
    int row = 0;
    for (const int j : {0, 3, 4, 9, 12, 16, 18}) {
        for (int m = 0; m <= order; ++m) {
            CHECK(std::abs(a.s0[a.scalar_index(j, m)] - b.s0[b.scalar_index(row, m)]) < 1e-13);
            CHECK(std::abs(a.s3[a.scalar_index(j, m)] - b.s3[b.scalar_index(row, m)]) < 1e-13);
            CHECK(std::abs(a.spin[a.spin_index(j, m)] - b.spin[b.spin_index(row, m)]) < 1e-13);
            CHECK(std::abs(a.spin[a.spin_index(j, -m)] - b.spin[b.spin_index(row, -m)]) < 1e-13);
        }
        ++row;
    }
    // Analysis is the adjoint of synthesis under the weights for any rows.
    std::vector<double> back(f.data().size());
    part.analyze(b, back);
    double left = 0;
    for (std::size_t i = 0; i < back.size(); ++i) left += back[i] * f.data()[i];
    double right = 0;
    for (int j = 0; j < 7; ++j)
        for (int m = -order; m <= order; ++m) {
            const std::size_t g = b.scalar_index(j, std::abs(m));
            right += 2 * pi * some.weight[static_cast<std::size_t>(j)] *
                     (std::norm(b.s0[g]) + std::norm(b.s3[g]) + std::norm(b.spin[b.spin_index(j, m)]));
        }
    CHECK(left == doctest::Approx(right).epsilon(1e-12));
}

TEST_CASE("weights integrate polynomials") {
    const auto moment = [](const LatitudeRows& rows, int power) {
        double sum = 0;
        for (std::size_t j = 0; j < rows.theta.size(); ++j) {
            CHECK(std::abs(rows.sin_half[j] - std::sin(rows.theta[j] / 2)) < 1e-15);
            CHECK(std::abs(rows.cos_half[j] - std::cos(rows.theta[j] / 2)) < 1e-15);
            sum += rows.weight[j] * std::pow(std::cos(rows.theta[j]), power);
        }
        return sum;
    };
    for_all({1, 2, 3, 8, 21, 500}, {0, 1, 2, 6, 20, 30}, [&](int n, int power) {
        const double want = power % 2 == 0 ? 2.0 / (power + 1) : 0;
        if (power < 2 * n) CHECK(std::abs(moment(gauss_legendre_rows(n), power) - want) < 3e-15);
        if (power < n) CHECK(std::abs(moment(fejer_rows(n), power) - want) < 3e-15);
        if (n > 1 && power < n) CHECK(std::abs(moment(clenshaw_curtis_rows(n), power) - want) < 3e-15);
    });
    CHECK(gauss_legendre_rows(3).weight[1] == doctest::Approx(8.0 / 9));
    CHECK(gauss_legendre_rows(2).theta[0] == doctest::Approx(std::acos(1 / std::sqrt(3))));
}

TEST_CASE("transforms refuse bad arguments") {
    for (const int rows : {0, kMaxGaussRows + 1}) CHECK_THROWS_AS(gauss_legendre_rows(rows), Error);
    CHECK_THROWS_AS(fejer_rows(-3), Error);
    CHECK_THROWS_AS(clenshaw_curtis_rows(1), Error);
    for (const auto& [order, columns, first] : {std::tuple(-1, 3, 0.0), {2, 4, 0.0}, {2, 5, double{NAN}}})
        CHECK_THROWS_AS(PshTransform(order, fejer_rows(5), columns, first), Error);
    CHECK_THROWS_AS(PshTransform(2, LatitudeRows{}, 5), Error);
    LatitudeRows torn = fejer_rows(5);
    torn.weight.pop_back();
    CHECK_THROWS_AS(PshTransform(2, torn, 5), Error);
    LatitudeRows bent = fejer_rows(5);
    bent.sin_half[2] = 2;
    CHECK_THROWS_AS(PshTransform(2, bent, 5), Error);
    PshTransform good(2, fejer_rows(5), 5);
    std::vector<double> samples(100);
    std::vector<double> coefficients(36);
    CHECK_THROWS_AS(good.analyze(std::span(samples).first(99), coefficients), Error);
    CHECK_THROWS_AS(good.analyze(samples, std::span(coefficients).first(35)), Error);
    CHECK_THROWS_AS(good.synthesize(std::span(coefficients).first(35), samples), Error);
    CHECK_THROWS_AS(good.synthesize(coefficients, std::span(samples).first(99)), Error);
    for (const double value : {double{NAN}, double{INFINITY}}) {
        samples[17] = value;
        CHECK_THROWS_AS(good.analyze(samples, coefficients), Error);
    }
    coefficients.assign(36, 0.0);
    coefficients[20] = NAN;
    CHECK_THROWS_AS(good.synthesize(coefficients, samples), Error);
    FourierRows other(3, 5);
    LegendreTransform legendre(2, fejer_rows(5));
    CHECK_THROWS_AS(legendre.synthesize(coefficients, other), Error);
    CHECK_THROWS_AS(legendre.analyze(other, coefficients), Error);
    FourierTransform fourier(2, 5);
    FourierRows two(2, 2);
    CHECK_THROWS_AS(fourier.analyze(std::span(samples).first(20), two, 2), Error);
    CHECK_THROWS_AS(fourier.analyze(std::span(samples).first(21), two, 1), Error);
    CHECK_THROWS_AS(fourier.synthesize(other, 0, std::span(samples).first(20)), Error);
}
