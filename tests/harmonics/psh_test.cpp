// SPDX-License-Identifier: MIT
// Tests of coefficient vectors: layout and refused arguments.
#include "harmonics/psh.hpp"

#include "test.hpp"

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
    CHECK_THROWS_AS(v.channel(1), Error);
    CHECK_THROWS_AS(v.channel(-1), Error);
    CHECK_THROWS_AS(v.at(0, 3, 0, 0), Error);
    CHECK_THROWS_AS(v.at(0, 1, 2, 0), Error);
    CHECK_THROWS_AS(v.at(0, 1, 0, 4), Error);
}

TEST_CASE("another order keeps what both have") {
    PshVector v(2, 2);
    for (std::size_t i = 0; i < v.data().size(); ++i) v.data()[i] = static_cast<double>(i + 1);
    for (const int order : {0, 1, 2, 3}) {
        CAPTURE(order);
        const PshVector other = with_order(v, order);
        REQUIRE(other.order() == order);
        REQUIRE(other.channels() == 2);
        for (int c = 0; c < 2; ++c)
            for (int l = 0; l <= order; ++l)
                for (int m = -l; m <= l; ++m)
                    for (int p = 0; p < 4; ++p)
                        CHECK(other.at(c, l, m, p) == (l <= 2 ? v.at(c, l, m, p) : 0));
    }
    CHECK_THROWS_AS(with_order(v, -1), Error);
    CHECK_THROWS_AS(with_order(v, kMaxOrder + 1), Error);
}

TEST_CASE("a gain scales its order in every channel and component") {
    PshVector v(2, 2);
    for (std::size_t i = 0; i < v.data().size(); ++i) v.data()[i] = static_cast<double>(i + 1);
    PshVector scaled = v;
    const double gains[] = {2, -3, 0.5};
    scale_orders(scaled, gains);
    for (int c = 0; c < 2; ++c)
        for (int l = 0; l <= 2; ++l)
            for (int m = -l; m <= l; ++m)
                for (int p = 0; p < 4; ++p) CHECK(scaled.at(c, l, m, p) == gains[l] * v.at(c, l, m, p));
    CHECK_THROWS_AS(scale_orders(scaled, std::span(gains).first(2)), Error);
    CHECK_THROWS_AS(scale_orders(scaled, {}), Error);
}
