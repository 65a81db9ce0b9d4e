// SPDX-License-Identifier: MIT
#include "render/predicted_error.hpp"

#include "test.hpp"

using namespace nicol;

TEST_CASE("parts of a prediction add as squares, over the RMS of the whole") {
    PredictedError error;
    CHECK(error.relative() == 0);
    error.add_relative(0.03);
    CHECK(error.relative() == doctest::Approx(0.03));
    error.add_noise(0.01 * 0.01, 0.25);
    CHECK(error.relative() == doctest::Approx(std::hypot(0.03, 0.01 / 0.5)));
    error.add(0.02 * 0.02, 0.75);
    CHECK(error.relative() == doctest::Approx(std::sqrt(0.0009 + 0.0001 + 0.0004)));
}

TEST_CASE("noise is relative to the shaded image, once that is known, and errors of orders to their light") {
    PredictedError error;
    error.add_noise(0.01 * 0.01, 0.25);
    error.know_power(0);  // a black image says nothing
    CHECK(error.relative() == doctest::Approx(0.02));
    error.know_power(0.01);
    CHECK(error.relative() == doctest::Approx(0.1));
    error.add(0.02 * 0.02, 0.75);
    CHECK(error.relative() == doctest::Approx(std::hypot(0.1, 0.02)));
}
