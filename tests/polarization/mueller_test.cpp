// SPDX-License-Identifier: MIT
#include "polarization/mueller.hpp"

#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

Mueller random_mueller(std::mt19937& random) {
    std::uniform_real_distribution<double> value(-1, 1);
    Mueller m;
    for (std::size_t i = 0; i < 16; ++i) m(i / 4, i % 4) = value(random);
    return m;
}

}  // namespace

TEST_CASE("rows and columns are not transposed") {
    Mueller m;
    m(1, 0) = 1;  // a polarizing reflection: unpolarized in, linear out
    CHECK(m * Stokes(1, 0, 0, 0) == Stokes(0, 1, 0, 0));
    CHECK(m * Stokes(0, 1, 0, 0) == Stokes(0, 0, 0, 0));
}

TEST_CASE("the product composes: (a b) s = a (b s)") {
    std::mt19937 random(1);
    const Mueller a = random_mueller(random);
    const Mueller b = random_mueller(random);
    const Stokes s(1, .3, -.2, .1);
    CHECK(glm::distance((a * b) * s, a * (b * s)) < 1e-14);
    CHECK(glm::distance((a + b) * s, a * s + b * s) < 1e-14);
    CHECK(glm::distance((2.0 * a) * s, 2.0 * (a * s)) < 1e-14);
}

TEST_CASE("frame_rotation is rotated() as a matrix") {
    const Stokes s(1, .3, -.2, .1);
    for (const double angle : {0.2, -1.3, 3.0})
        CHECK(glm::distance(frame_rotation(angle) * s, rotated(s, angle)) < 1e-15);
}

TEST_CASE("an element in other frames acts the same on the same light") {
    std::mt19937 random(2);
    const Mueller m = random_mueller(random);
    const Stokes s(1, .3, -.2, .1);
    const double in = .7;
    const double out = -1.9;
    CHECK(glm::distance(in_rotated_frames(m, in, out) * rotated(s, in), rotated(m * s, out)) < 1e-14);
}
