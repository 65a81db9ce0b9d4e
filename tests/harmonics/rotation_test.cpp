// SPDX-License-Identifier: MIT
// Tests of field rotation: against evaluation, as a group, and at the angles where Euler angles degenerate.
#include "harmonics/rotation.hpp"

#include "harmonics/evaluate.hpp"
#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;
using reference::about_y;
using reference::about_z;

namespace {

/// Returns the largest deviation of g(w) from R_S f(R^-1 w) at random directions (Eq. 25).
double deviation(const PshVector& f, const PshVector& g, const glm::dmat3& rotation,
                 std::mt19937_64& random) {
    double worst = 0;
    for (int i = 0; i < 30; ++i) {
        const glm::dvec3 to = reference::random_direction(random);
        const glm::dvec3 from = glm::transpose(rotation) * to;
        const Stokes in = evaluate(f, 0, from);
        const Stokes out = evaluate(g, 0, to);
        const auto phase =
            reference::frame_change(rotation * reference::theta_phi(from), reference::theta_phi(to));
        worst = std::max({worst, std::abs(in[0] - out[0]), std::abs(in[3] - out[3]),
                          std::abs(std::complex(in[1], in[2]) * phase - std::complex(out[1], out[2]))});
    }
    return worst;
}

}  // namespace

TEST_CASE("the rotated field has the rotated values") {
    std::mt19937_64 random(1);
    for (const int order : {0, 1, 2, 5, 9, 70}) {
        CAPTURE(order);
        const PshVector f = reference::random_field(random, order);
        for (const glm::dmat3& r :
             {reference::random_rotation(random), glm::dmat3(1), about_y(pi), about_z(pi), about_y(1e-9),
              about_z(.3) * about_y(pi - 1e-9) * about_z(1.0), glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1),
              glm::dmat3(0, 0, 1, 1, 0, 0, 0, 1, 0)})
            CHECK(deviation(f, rotated(f, r), r, random) < 2e-14 * (1 + order) * (1 + order));
    }
}

TEST_CASE("a rotation and its inverse leave the field as it was, and so does the identity") {
    std::mt19937_64 random(3);
    for (const auto& [order, bound] : {std::pair(9, 1e-14), {100, 2e-13}, {300, 1e-12}}) {
        const PshVector f = reference::random_field(random, order);
        const glm::dmat3 r = reference::random_rotation(random);
        CHECK(largest_difference(rotated(rotated(f, r), glm::transpose(r)), f) <= bound);
        if (order == 9) CHECK(largest_difference(rotated(f, glm::dmat3(1)), f) < 3e-15);
    }
}

TEST_CASE("high orders about y by 90 degrees, where whole degrees m start below the range of double") {
    std::mt19937_64 random(9);
    const int order = 450;
    const PshVector f = reference::random_field(random, order);
    const glm::dmat3 r = about_y(pi / 2);
    const PshVector g = rotated(f, r);
    CHECK(largest_difference(rotated(g, glm::transpose(r)).data(), f.data()) <= 2e-12);
    CHECK(deviation(f, g, r, random) < 1e-9);
    const glm::dmat3 beyond = about_y(2.9);
    CHECK(largest_difference(rotated(rotated(f, beyond), glm::transpose(beyond)).data(), f.data()) <= 2e-12);
}

TEST_CASE("D(R1) D(R2) = D(R1 R2)") {
    std::mt19937_64 random(5);
    const PshVector f = reference::random_field(random, 30);
    const glm::dmat3 a = reference::random_rotation(random);
    const glm::dmat3 b = reference::random_rotation(random);
    const PshVector two = rotated(rotated(f, b), a);
    CHECK(largest_difference(two.data(), rotated(f, a * b).data()) < 3e-13);
    CHECK(largest_difference(two.data(), rotated(f, b * a).data()) > .1);
}

TEST_CASE("ten thousand small rotations drift less than 1e-10") {
    std::mt19937_64 random(6);
    const PshVector f = reference::random_field(random, 9);
    const double step = 2 * pi / 10000;
    const glm::dmat3 tilt = about_z(.4) * about_y(.9);
    const PshRotation rotation(9, tilt * about_z(step) * glm::transpose(tilt));
    PshVector g = f;
    for (int i = 0; i < 10000; ++i) rotation.apply(g.data(), g.data());
    CHECK(largest_difference(f.data(), g.data()) < 1e-10);
}

TEST_CASE("a rotation by 1e-9 is not lost") {
    std::mt19937_64 random(7);
    const PshVector f = reference::random_field(random, 9);
    const PshVector g = rotated(f, about_y(1e-9));
    const PshVector h = rotated(f, about_y(1e-3));
    double size = 0;
    for (std::size_t i = 0; i < f.data().size(); ++i)
        size =
            std::max(size, std::abs((g.data()[i] - f.data()[i]) / 1e-9 - (h.data()[i] - f.data()[i]) / 1e-3));
    CHECK(size < .1);
    const EulerZyz euler = euler_zyz(about_z(1.2) * about_y(1e-9) * about_z(-.3));
    CHECK(euler.sin_half_beta == doctest::Approx(.5e-9).epsilon(1e-6));
    CHECK(std::arg(euler.alpha) == doctest::Approx(1.2).epsilon(1e-6));
    CHECK(std::arg(euler.gamma) == doctest::Approx(-.3).epsilon(1e-6));
}

TEST_CASE("orders above kStoredOrder take the same path as below, and batches equal singles") {
    std::mt19937_64 random(8);
    const int high = PshRotation::kStoredOrder + 1;
    const PshVector f = reference::random_field(random, high, 2);
    PshVector low(high - 1, 2);
    for (int c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < low.channel(c).size(); ++i) low.channel(c)[i] = f.channel(c)[i];
    const glm::dmat3 r = reference::random_rotation(random);
    const PshVector g = rotated(f, r);
    const PshVector h = rotated(low, r);
    std::vector<double> single(low.channel(1).size());
    PshRotation(high - 1, r).apply(low.channel(1), single);
    for (int c = 0; c < 2; ++c)
        CHECK(largest_difference(h.channel(c), g.channel(c).first(h.channel(c).size())) < 1e-15);
    CHECK(largest_difference(h.channel(1), single) == 0);
}

TEST_CASE("rotation refuses what is none") {
    PshVector f(2, 1);
    CHECK_THROWS_AS(rotated(f, glm::dmat3(2)), Error);
    CHECK_THROWS_AS(rotated(f, glm::dmat3(-1)), Error);
    CHECK_THROWS_AS(rotated(f, glm::dmat3(0)), Error);
    CHECK_THROWS_AS(rotated(f, glm::dmat3(NAN)), Error);
    CHECK_THROWS_AS(rotated(f, glm::dmat3(1, 0, 0, 1e-3, 1, 0, 0, 0, 1)), Error);
    CHECK_THROWS_AS(rotated(PshVector(), glm::dmat3(1)), Error);
    CHECK_THROWS_AS(PshRotation(-1, glm::dmat3(1)), Error);
    f.at(0, 2, 0, 1) = NAN;
    CHECK_THROWS_AS(rotated(f, glm::dmat3(1)), Error);
    std::vector<double> out(35);
    CHECK_THROWS_AS(PshRotation(2, glm::dmat3(1)).apply(f.data(), out), Error);
    CHECK_THROWS_AS(PshRotation(2, glm::dmat3(1)).apply(out, out), Error);
}
