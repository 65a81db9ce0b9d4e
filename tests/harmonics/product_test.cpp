// SPDX-License-Identifier: MIT
// Tests of visibility times light: the matrix of triple products equals the grid product, and both equal the
// product by direction.
#include "harmonics/product.hpp"

#include "files/npz.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

std::vector<double> random_scalar(std::mt19937_64& random, int order) {
    std::normal_distribution<double> normal;
    std::vector<double> out(psh_count(order));
    for (double& value : out) value = normal(random);
    return out;
}

PshVector as_field(const std::vector<double>& scalar, int order) {
    PshVector out(order, 1);
    for (std::size_t i = 0; i < scalar.size(); ++i) out.data()[4 * i] = scalar[i];
    return out;
}

/// Returns the last array of a data file of the paper's authors, or nothing if the file is absent.
std::vector<double> npz_values(const std::string& name) {
    const auto file = test_data("polarsh/" + name);
    return file.empty() ? std::vector<double>() : read_npz_member(file, npz_members(file).back()).values;
}

}  // namespace

TEST_CASE("the grid product is the product, direction by direction") {
    std::mt19937_64 random(1);
    const auto v = random_scalar(random, 4);
    const PshVector f = reference::random_field(random, 6);
    PshVector out(10, 1);
    PshProduct(4, 6, 10).multiply(v, f.channel(0), out.channel(0));
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 d = reference::random_direction(random);
        const Stokes want = evaluate(as_field(v, 4), 0, d)[0] * evaluate(f, 0, d);
        const Stokes have = evaluate(out, 0, d);
        for (int p = 0; p < 4; ++p) CHECK(std::abs(want[p] - have[p]) < 1e-12);
    }
}

TEST_CASE("the shadow matrix gives the same coefficients as the grid") {
    std::mt19937_64 random(2);
    for (const auto& [lv, lo, li] : {std::array{8, 4, 4}, std::array{5, 3, 6}, std::array{0, 2, 2},
                                     std::array{3, 9, 1}, std::array{14, 3, 2}, std::array{18, 9, 9}}) {
        const auto v = random_scalar(random, lv);
        const PshVector f = reference::random_field(random, li);
        std::vector<double> by_grid(4 * psh_count(lo));
        std::vector<double> by_matrix(by_grid.size());
        PshProduct(lv, li, lo).multiply(v, f.channel(0), by_grid);
        ShadowMatrix(lv, lo, li).expand(v).apply(f.channel(0), by_matrix);
        CHECK(largest_difference(by_grid, by_matrix) < 2e-13);
    }
}

TEST_CASE("the shadow matrix is symmetric, keeps spins apart, and is the identity for no shadow") {
    std::mt19937_64 random(3);
    const ShadowMatrix shadow(6, 3, 3);
    const CoefficientMatrix m = shadow.expand(random_scalar(random, 6));
    for (std::size_t i = 0; i < m.rows(); ++i)
        for (std::size_t j = 0; j < m.columns(); ++j) {
            CHECK(m(i, j) == doctest::Approx(m(j, i)).epsilon(1e-12));
            const auto part = [](std::size_t k) { return k % 4 == 0 ? 0 : k % 4 == 3 ? 2 : 1; };
            if (part(i) != part(j)) CHECK(m(i, j) == 0);
        }
    std::vector<double> open(psh_count(6));
    open[0] = std::sqrt(4 * 3.14159265358979323846);
    const CoefficientMatrix identity = shadow.expand(open);
    for (std::size_t i = 0; i < m.rows(); ++i)
        for (std::size_t j = 0; j < m.columns(); ++j) {
            const bool spin2_low = (i % 4 == 1 || i % 4 == 2) && i / 4 < 4;
            CHECK(std::abs(identity(i, j) - (i == j && !spin2_low)) < 1e-14);
        }
}

TEST_CASE("the shadow matrix of a vertex of the authors' data (Fig. 13) equals theirs") {
    const std::vector<double> visibility = npz_values("vis_SHVec_buddha_v17650_256_L9.npz");
    const std::vector<double> published = npz_values("vis_TPmat_buddha_v17650_256_L5.npz");
    if (visibility.empty() || published.empty()) return;
    REQUIRE(visibility.size() == psh_count(8));
    REQUIRE(published.size() == 25 * 25 * 9);
    const CoefficientMatrix matrix = ShadowMatrix(8, 4, 4).expand(visibility);
    double worst = 0;
    double largest = 0;
    for (std::size_t i = 0; i < 25; ++i)
        for (std::size_t j = 0; j < 25; ++j)
            for (std::size_t p = 0; p < 3; ++p)
                for (std::size_t q = 0; q < 3; ++q) {
                    const double want = published[(i * 25 + j) * 9 + p * 3 + q];
                    worst = std::max(worst, std::abs(matrix(4 * i + p, 4 * j + q) - want));
                    largest = std::max(largest, std::abs(want));
                }
    CHECK(largest > .1);
    CHECK(worst < 1e-6);
}

TEST_CASE("products refuse bad arguments") {
    CHECK_THROWS_AS(ShadowMatrix(-1, 2, 2), Error);
    CHECK_THROWS_AS(ShadowMatrix(2, 200, 2), Error);
    CHECK_THROWS_AS(PshProduct(2, -2, 2), Error);
    const ShadowMatrix shadow(2, 1, 1);
    std::vector<double> v(9);
    CHECK_THROWS_AS(shadow.expand(std::span(v).first(4)), Error);
    v[3] = NAN;
    CHECK_THROWS_AS(shadow.expand(v), Error);
    PshProduct product(2, 1, 1);
    std::vector<double> f(16);
    CHECK_THROWS_AS(product.multiply(std::span(v).first(8), f, f), Error);
    CHECK_THROWS_AS(product.multiply(v, std::span(f).first(8), f), Error);
}
