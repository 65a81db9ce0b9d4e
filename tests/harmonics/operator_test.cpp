// SPDX-License-Identifier: MIT
// Tests of operators: coefficient matrices of Mueller fields act as the fields do.
#include "harmonics/operator.hpp"

#include "harmonics/evaluate.hpp"
#include "harmonics/random_operators.hpp"
#include "harmonics/reference.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/transform.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// The Mueller field of a coefficient matrix: the kernel sum over all pairs of harmonics, by evaluation.
class MuellerOfMatrix {
public:
    explicit MuellerOfMatrix(const CoefficientMatrix& matrix) : matrix_(matrix) {}

    Mueller operator()(const glm::dvec3& in, const glm::dvec3& out) const {
        const auto y_in = basis(matrix_.order_in(), in);
        const auto y_out = basis(matrix_.order_out(), out);
        Mueller m;
        for (std::size_t i = 0; i < y_out.size(); ++i)
            for (std::size_t j = 0; j < y_in.size(); ++j)
                for (std::size_t p = 0; p < 4; ++p)
                    for (std::size_t q = 0; q < 4; ++q)
                        m(p, q) +=
                            matrix_(i, j) * y_out[i][static_cast<int>(p)] * y_in[j][static_cast<int>(q)];
        return m;
    }

private:
    /// Returns the basis of Eq. 29 at a direction.
    static std::vector<Stokes> basis(int order, const glm::dvec3& direction) {
        std::vector<double> scalar(psh_count(order));
        std::vector<std::complex<double>> spin2(scalar.size());
        harmonics_at(order, direction, scalar, spin2);
        std::vector<Stokes> out;
        for (std::size_t i = 0; i < scalar.size(); ++i) {
            out.emplace_back(scalar[i], 0, 0, 0);
            out.emplace_back(0, spin2[i].real(), spin2[i].imag(), 0);
            out.emplace_back(0, -spin2[i].imag(), spin2[i].real(), 0);
            out.emplace_back(0, 0, 0, scalar[i]);
        }
        return out;
    }

    const CoefficientMatrix& matrix_;
};

}  // namespace

TEST_CASE("projection inverts the kernel sum: all nine blocks, 16 of 16 elements") {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    CoefficientMatrix want(2, 3);
    for (std::size_t i = 0; i < want.rows(); ++i)
        for (std::size_t j = 0; j < want.columns(); ++j) {
            const bool low_out = (i % 4 == 1 || i % 4 == 2) && i / 4 < 4;
            const bool low_in = (j % 4 == 1 || j % 4 == 2) && j / 4 < 4;
            if (!low_out && !low_in) want(i, j) = normal(random);
        }
    const CoefficientMatrix have =
        project(MuellerOfMatrix(want), 2, {gauss_legendre_rows(3), 5}, 3, {fejer_rows(7), 7});
    CHECK(largest_difference(want.data(), have.data()) < 1e-13);
}

TEST_CASE("the operator in coefficients is the integral over directions (Eq. 39)") {
    std::mt19937_64 random(2);
    // A smooth field without symmetry, in the frames of the directions.
    const MuellerField field = [](const glm::dvec3& in, const glm::dvec3& out) {
        const double a = in.x * out.y + .3 * in.z;
        const double b = in.y * out.z - .2 * out.x;
        Mueller m;
        m(0, 0) = 1 + a;
        m(0, 3) = b;
        m(3, 0) = a * b;
        m(3, 3) = b * b;
        return m;
    };
    const PshVector f = reference::random_field(random, 4);
    const SphereGrid grid{gauss_legendre_rows(8), 15};
    const CoefficientMatrix matrix = project(field, 4, grid, 4, grid);
    PshVector out(4, 1);
    matrix.apply(f.channel(0), out.channel(0));
    const LatitudeRows rows = gauss_legendre_rows(12);
    for (int k = 0; k < 5; ++k) {
        const glm::dvec3 to = reference::random_direction(random);
        Stokes want(0);
        for (std::size_t j = 0; j < rows.theta.size(); ++j)
            for (int c = 0; c < 24; ++c) {
                const glm::dvec3 from = reference::direction(rows.theta[j], 2 * pi * c / 24);
                const Stokes s = evaluate(f, 0, from);
                const Mueller m = field(from, to);
                for (std::size_t p = 0; p < 4; ++p)
                    for (std::size_t q = 0; q < 4; ++q)
                        want[static_cast<int>(p)] +=
                            rows.weight[j] * 2 * pi / 24 * m(p, q) * s[static_cast<int>(q)];
            }
        const Stokes have = evaluate(out, 0, to);
        for (int p = 0; p < 4; ++p) CHECK(have[p] == doctest::Approx(want[p]).epsilon(1e-11));
    }
}

TEST_CASE("isotropic and dense storage are the same operator") {
    std::mt19937_64 random(3);
    const IsotropicMatrix a = reference::random_isotropic(random, 4, 3);
    const IsotropicMatrix b = reference::random_isotropic(random, 3, 5);
    const PshVector f = reference::random_field(random, 5);
    std::vector<double> middle(4 * psh_count(3));
    std::vector<double> out(4 * psh_count(4));
    std::vector<double> other(out.size());
    b.apply(f.channel(0), middle);
    a.apply(middle, out);
    const IsotropicMatrix both = compose(a, b);
    both.apply(f.channel(0), other);
    CHECK(largest_difference(out, other) < 1e-12);
    both.dense().apply(f.channel(0), other);
    CHECK(largest_difference(out, other) < 1e-12);
    compose(a.dense(), b.dense()).apply(f.channel(0), other);
    CHECK(largest_difference(out, other) < 1e-12);
}

TEST_CASE(
    "isotropic operators commute with rotations about z, and their dense form is zero where Eqs. 52 and 53 "
    "say") {
    std::mt19937_64 random(4);
    const IsotropicMatrix a = reference::random_isotropic(random, 4, 4);
    const PshVector f = reference::random_field(random, 4);
    PshVector left(4, 1);
    PshVector right(4, 1);
    const glm::dmat3 rotation = reference::about_z(.7);
    a.apply(rotated(f, rotation).channel(0), left.channel(0));
    a.apply(f.channel(0), right.channel(0));
    CHECK(largest_difference(left.data(), rotated(right, rotation).data()) < 1e-12);
    const CoefficientMatrix d = a.dense();
    for (int l = 0; l <= 4; ++l)
        for (int m = -l; m <= l; ++m)
            for (int k = 0; k <= 4; ++k)
                for (int n = -k; n <= k; ++n) {
                    const std::size_t i = 4 * psh_index(l, m);
                    const std::size_t j = 4 * psh_index(k, n);
                    if (std::abs(m) != std::abs(n))
                        for (std::size_t p = 0; p < 16; ++p) CHECK(d(i + p / 4, j + p % 4) == 0);
                    // The isomorphic part vanishes except for m = n, and the conjugation part except for m =
                    // -n.
                    if (m != n) CHECK(std::abs(d(i + 1, j + 1) + d(i + 2, j + 2)) < 1e-14);
                    if (m != n) CHECK(std::abs(d(i + 2, j + 1) - d(i + 1, j + 2)) < 1e-14);
                    if (m != -n) CHECK(std::abs(d(i + 1, j + 1) - d(i + 2, j + 2)) < 1e-14);
                    if (m != -n) CHECK(std::abs(d(i + 2, j + 1) + d(i + 1, j + 2)) < 1e-14);
                }
}

TEST_CASE("the projection of an isotropic field equals that of the same field taken for a general one") {
    std::mt19937_64 random(5);
    const IsotropicMatrix want = reference::random_isotropic(random, 3, 4);
    const CoefficientMatrix dense = want.dense();
    const MuellerOfMatrix general(dense);
    const IsotropicMuellerField field = [&](double theta_in, double theta_out, double phi) {
        return general(reference::direction(theta_in, phi), reference::direction(theta_out, 0));
    };
    const IsotropicMatrix have =
        project_isotropic(field, 3, gauss_legendre_rows(4), 4, {gauss_legendre_rows(5), 9});
    for (int m = 0; m <= 3; ++m)
        for (int l = m; l <= 3; ++l)
            for (int k = m; k <= 4; ++k)
                for (std::size_t e = 0; e < 16; ++e)
                    CHECK(std::abs(want.block(m, l, k)[e] - have.block(m, l, k)[e]) < 1e-12);
    const CoefficientMatrix by_general =
        project(MuellerField(general), 3, {gauss_legendre_rows(4), 9}, 4, {gauss_legendre_rows(5), 9});
    CHECK(largest_difference(by_general.data(), have.dense().data()) < 1e-12);
}

TEST_CASE("the mirror image (supplement E.6)") {
    std::mt19937_64 random(6);
    const PshVector f = reference::random_field(random, 5);
    const PshVector g = reflected(f);
    PshVector by_matrix(5, 1);
    reflection_matrix(5).apply(f.channel(0), by_matrix.channel(0));
    CHECK(largest_difference(g.data(), by_matrix.data()) < 1e-15);
    CHECK(largest_difference(reflected(g).data(), f.data()) == 0);
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 d = reference::random_direction(random);
        // The mirrored theta-hat is the negative of theta-hat at the mirrored point, so s2 and s3 change
        // sign.
        const Stokes s = evaluate(f, 0, {d.x, d.y, -d.z});
        const Stokes want(s[0], s[1], -s[2], -s[3]);
        const Stokes have = evaluate(g, 0, d);
        for (int p = 0; p < 4; ++p) CHECK(std::abs(have[p] - want[p]) < 1e-13);
    }
}

TEST_CASE("operators refuse bad arguments") {
    CHECK_THROWS_AS(CoefficientMatrix(-1, 2), Error);
    CHECK_THROWS_AS(CoefficientMatrix(2, CoefficientMatrix::kMaxDenseOrder + 1), Error);
    CHECK_THROWS_AS(IsotropicMatrix(2, -1), Error);
    CoefficientMatrix dense(2, 1);
    std::vector<double> in(16);
    std::vector<double> out(36);
    CHECK_THROWS_AS(dense.apply(out, out), Error);
    CHECK_THROWS_AS(dense.apply(in, in), Error);
    CHECK_THROWS_AS(compose(dense, dense), Error);
    CHECK_THROWS_AS(compose(IsotropicMatrix(2, 1), IsotropicMatrix(2, 1)), Error);
    CHECK_THROWS_AS(IsotropicMatrix().apply(in, out), Error);
    CHECK_THROWS_AS(IsotropicMatrix(2, 1).apply(out, out), Error);
    const SphereGrid grid{gauss_legendre_rows(3), 5};
    const SphereGrid coarse{gauss_legendre_rows(3), 4};
    const MuellerField nan = [](const glm::dvec3&, const glm::dvec3&) {
        Mueller m;
        m(2, 1) = NAN;
        return m;
    };
    CHECK_THROWS_AS(project(nan, 2, grid, 2, grid), Error);
    CHECK_THROWS_AS(project(nan, 2, grid, 2, coarse), Error);
    const IsotropicMuellerField fine = [](double, double, double) { return Mueller(); };
    CHECK_THROWS_AS(project_isotropic(fine, 2, grid.rows, 2, coarse), Error);
    CHECK_THROWS_AS(project_isotropic(fine, 2, LatitudeRows{}, 2, grid), Error);
}
