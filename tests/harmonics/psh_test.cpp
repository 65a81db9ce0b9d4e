// SPDX-License-Identifier: MIT
// Coefficient vectors: layout and refused arguments.
#include "nicol/psh.hpp"

#include <doctest/doctest.h>

#include "nicol/error.hpp"

using namespace nicol;

TEST_CASE("coefficients lie at [channel][l*l + l + m][p]") {
    PshVector v(3, 2);
    CHECK(v.data().size() == 2 * 16 * 4);
    v.at(1, 2, -1, 3) = 7;
    CHECK(v.data()[(16 + 5) * 4 + 3] == 7);
    CHECK(v.channel(1)[5 * 4 + 3] == 7);
    CHECK(psh_index(0, 0) == 0);
    CHECK(psh_index(2, 2) == 8);
    CHECK(psh_count(9) == 100);
}

TEST_CASE("coefficient vectors refuse what they cannot hold") {
    CHECK_THROWS_AS(PshVector(-1, 1), Error);
    CHECK_THROWS_AS(PshVector(kMaxOrder + 1, 1), Error);
    CHECK_THROWS_AS(PshVector(2, 0), Error);
    PshVector v(2, 1);
    CHECK_THROWS_AS((void)v.channel(1), Error);
    CHECK_THROWS_AS((void)v.channel(-1), Error);
    CHECK_THROWS_AS((void)v.at(0, 3, 0, 0), Error);
    CHECK_THROWS_AS((void)v.at(0, 1, 2, 0), Error);
    CHECK_THROWS_AS((void)v.at(0, 1, 0, 4), Error);
}
