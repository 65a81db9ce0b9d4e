// SPDX-License-Identifier: MIT
#include "brute_force.hpp"
#include "chiral_material.hpp"
#include "directions.hpp"
#include "files/npz.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/light_coefficients.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/random_operators.hpp"
#include "material/conductor.hpp"
#include "material/material_projection.hpp"
#include "material/matrix_rows.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/response_table.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

// Returns quadrature nodes for fields that end at the horizon.
LatitudeRows hemisphere_rows(int count, bool upper) {
    LatitudeRows rows = gauss_legendre_rows(count);
    for (std::size_t j = 0; j < rows.theta.size(); ++j) {
        const double theta = std::acos((std::cos(rows.theta[j]) + 1) / 2);
        rows.theta[j] = upper ? theta : pi - theta;
        rows.sin_half[j] = std::sin(rows.theta[j] / 2);
        rows.cos_half[j] = std::cos(rows.theta[j] / 2);
        rows.weight[j] /= 2;
    }
    return rows;
}

double difference(const IsotropicMatrix& a, const IsotropicMatrix& b) {
    double largest = 0;
    for (int m = 0; m <= a.order_in(); ++m)
        for (int l = m; l <= a.order_out(); ++l)
            for (int k = m; k <= a.order_in(); ++k)
                for (std::size_t i = 0; i < 16; ++i)
                    largest = std::max(largest, std::abs(a.block(m, l, k)[i] - b.block(m, l, k)[i]));
    return largest;
}

MaterialPtr rough_gold(double alpha) {
    return rough_conductor({.eta = {metal_index("Au").front()}, .alpha = alpha});
}

}  // namespace

TEST_CASE("the projection of a material is that of its Mueller field") {
    const int order = 5;
    for (const MaterialPtr& material :
         {rough_gold(0.5), pplastic({.alpha = 0.6}), test::chiral(rough_gold(0.5))}) {
        const auto field = [&](double theta_in, double theta_out, double phi) {
            const glm::dvec3 light = -direction(theta_in, phi);
            const glm::dvec3 viewer = direction(theta_out, 0);
            return std::max(0.0, light.z) * evaluate(*material, 0, light, viewer);
        };
        const IsotropicMatrix expected =
            project_isotropic(field, order, hemisphere_rows(48, true), order,
                              {.rows = hemisphere_rows(48, false), .columns = 64});
        const IsotropicMatrix matrix = project_material(*material, 0, order);
        CHECK(difference(matrix, expected) < 3e-4);
        CHECK(std::abs(expected.block(1, 3, 3)[10]) > 5e-3);
        if (material->mirror_symmetric()) {
            CHECK(asymmetry(matrix) < 1e-12);
        } else {
            CHECK(asymmetry(matrix) > 0.2);
        }
    }
}

TEST_CASE("rows of a matrix equal the matrix applied to light, seen from a direction") {
    const int order = 6;
    std::mt19937 random(2);
    const LightLayout layout(order, LightKind::full);
    const PshVector light = test::random_light(order, 1, 4, 3);
    const auto pairs = test::light_pairs(layout, light.channel(0));
    for (const bool symmetric : {true, false}) {
        IsotropicMatrix matrix = reference::random_isotropic(random, order, order);
        if (symmetric) symmetrize(matrix);
        PshVector out(order, 1);
        matrix.apply(light.channel(0), out.channel(0));
        std::vector<double> rows((symmetric ? 4 : 8) * layout.row_size());
        for (const double theta : {0.0, 0.3, 1.2, 1.57, 2.4}) {
            rows_from_matrix(matrix, theta, layout, symmetric ? 1 : 2, rows);
            CHECK(glm::distance(test::rows_times_light(std::span<const double>(rows), pairs),
                                evaluate(out, 0, direction(theta, 0))) < 1e-11);
        }
    }
}

TEST_CASE("a material of a matrix: its table, its directions and its light agree with the matrix") {
    const int order = 7;
    const MaterialPtr gold = rough_gold(0.3);
    const LightLayout layout(order, LightKind::full);
    for (const MaterialPtr& origin : {gold, test::chiral(gold)}) {
        const IsotropicMatrix matrix = project_material(*origin, 0, order);
        const MaterialPtr material = psh_matrix_material({matrix});
        CHECK(material->mirror_symmetric() == origin->mirror_symmetric());
        const PshVector light = test::random_light(order, 1, 4, 5);
        PshVector out(order, 1);
        matrix.apply(light.channel(0), out.channel(0));
        const ResponseTable table(*material, layout, 1);
        for (const int angle : {0, 9, 300, 510}) {
            const double theta = angle * pi / 2 / (ResponseTable::kAngles - 1);
            CHECK(glm::distance(test::respond(table, layout, light, angle),
                                evaluate(out, 0, direction(theta, 0))) < 1e-5);
        }
        // The coefficients of light from a single direction are the harmonics at that direction.
        double largest = 0;
        double error = 0;
        for_all({0.0, 0.4, 1.3}, {0.0, 0.05, 0.77, 1.5}, {0.0, 1.0, 2.8, 4.4},
                [&](double in, double out_zenith, double azimuth) {
                    const glm::dvec3 towards_light = direction(in, azimuth);
                    const glm::dvec3 viewer = direction(out_zenith, 0.9);
                    std::vector<double> scalar(psh_count(order));
                    std::vector<std::complex<double>> spin2(psh_count(order));
                    harmonics_at(order, -towards_light, scalar, spin2);
                    const Mueller m = material->evaluate(0, towards_light, viewer);
                    for (std::size_t q = 0; q < 4; ++q) {
                        PshVector beam(order, 1);
                        for (std::size_t i = 0; i < scalar.size(); ++i) {
                            const auto w = std::conj(spin2[i]) * (q == 2 ? std::complex<double>(0, 1) : 1.0);
                            double* at = &beam.channel(0)[4 * i];
                            if (q == 0 || q == 3) at[q] = scalar[i];
                            if (q == 1 || q == 2) at[1] = w.real(), at[2] = w.imag();
                        }
                        PshVector reflected(order, 1);
                        matrix.apply(beam.channel(0), reflected.channel(0));
                        const Stokes expected = evaluate(reflected, 0, viewer);
                        for (std::size_t p = 0; p < 4; ++p) {
                            const double value = expected[static_cast<int>(p)];
                            largest = std::max(largest, std::abs(value));
                            error = std::max(error, std::abs(m(p, q) * towards_light.z - value));
                        }
                    }
                });
        CHECK(error < 1e-3 * largest);
        CHECK(largest > 0.1);
    }
}

TEST_CASE("symmetrized, a matrix is the mean of itself and its mirror image") {
    const int order = 5;
    std::mt19937 random(7);
    const IsotropicMatrix matrix = reference::random_isotropic(random, order, order);
    const MaterialPtr whole = psh_matrix_material({matrix});
    const MaterialPtr half = psh_matrix_material({matrix}, {1.0}, true);
    CHECK_FALSE(whole->mirror_symmetric());
    CHECK(half->mirror_symmetric());
    CHECK(asymmetry(*half->matrix(0)) == 0);
    CHECK(half->content_key() != whole->content_key());
    double largest = 0;
    double error = 0;
    for_all({0.1, 0.4, 1.3}, {0.05, 0.77, 1.5}, {0.0, 1.0, 2.8, 4.4},
            [&](double in, double out, double azimuth) {
                const glm::dvec3 viewer = direction(out, 0);
                const Mueller m = whole->evaluate(0, direction(in, azimuth), viewer);
                const Mueller mirrored = whole->evaluate(0, direction(in, -azimuth), viewer);
                const Mueller found = half->evaluate(0, direction(in, azimuth), viewer);
                for (std::size_t p = 0; p < 4; ++p)
                    for (std::size_t q = 0; q < 4; ++q) {
                        const double image = (p < 2) == (q < 2) ? mirrored(p, q) : -mirrored(p, q);
                        largest = std::max(largest, std::abs(found(p, q)));
                        error = std::max(error, std::abs(found(p, q) - (m(p, q) + image) / 2));
                    }
            });
    CHECK(error < 1e-5 * largest);
    // Rounding as in single-precision files does not make the table twice as large.
    IsotropicMatrix rounded = *half->matrix(0);
    rounded.block(1, 2, 2)[0] += std::complex<double>(0, 1e-7);
    CHECK(psh_matrix_material({rounded})->mirror_symmetric());
}

TEST_CASE("matrices survive a file, whose entries are those of the dense matrix") {
    const TemporaryFolder folder;
    const auto path = folder / "matrix.npz";
    std::mt19937 random(1);
    const std::vector<IsotropicMatrix> matrices{reference::random_isotropic(random, 4, 4),
                                                reference::random_isotropic(random, 4, 4)};
    write_psh_matrix(path, matrices);
    const auto back = read_psh_matrix(path);
    REQUIRE(back.size() == 2);
    CHECK(difference(back[0], matrices[0]) < 1e-14);
    CHECK(difference(back[1], matrices[1]) < 1e-14);

    const NpyArray coeff = read_npz_member(path, "coeff");
    CHECK(coeff.shape == std::vector<std::size_t>{2, 5 * (4 * 25 - 15 + 2) / 3, 4, 4});
    const CoefficientMatrix dense = matrices[0].dense();
    for (const auto& [li, lo, mi, mo] :
         {std::array{3, 2, 1, 1}, std::array{2, 3, -2, 2}, std::array{4, 4, 3, -3}, std::array{1, 0, 0, 0},
          std::array{4, 3, -1, -1}}) {
        const int a = std::max(li, lo);
        const int b = std::min(li, lo);
        const int index = a * (4 * a * a - 3 * a + 2) / 3 + 2 * b * (2 * b - 1) + 2 * (b + mi) +
                          (mi > mo   ? -1
                           : mi < mo ? 1
                                     : 0) +
                          (li > lo ? 4 * b + 1 : 0);
        for (std::size_t e = 0; e < 16; ++e)
            CHECK(coeff.values[16 * static_cast<std::size_t>(index) + e] ==
                  Approx(dense(4 * psh_index(lo, mo) + e / 4, 4 * psh_index(li, mi) + e % 4)));
    }
}

TEST_CASE("measured gold: check values, isotropy, and light from above leaves upwards") {
    const auto path = test_data("polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz");
    if (path.empty()) return;
    const auto gold = read_psh_matrix(path);
    REQUIRE(gold.size() == 3);
    CHECK(gold[0].order_in() == 19);
    CHECK(gold[0].block(0, 0, 1)[0].real() == Approx(-0.18513477));
    // Gold is yellow, so red exceeds green and green exceeds blue.
    CHECK(gold[0].block(0, 0, 0)[0].real() > gold[1].block(0, 0, 0)[0].real());
    CHECK(gold[1].block(0, 0, 0)[0].real() > 1.4 * gold[2].block(0, 0, 0)[0].real());
    // Reading averages entries, which removes only rounding.
    const NpyArray coeff = read_npz_member(path, "coeff");
    const TemporaryFolder folder;
    write_psh_matrix(folder / "gold.npz", gold);
    const NpyArray again = read_npz_member(folder / "gold.npz", "coeff");
    CHECK(largest_difference(coeff.values, again.values) < 1e-9);

    const MaterialPtr material = psh_matrix_material(gold, {1, 0.5, 1});
    std::vector<double> scalar(psh_count(19));
    std::vector<std::complex<double>> spin2(psh_count(19));
    harmonics_at(19, {0, 0, -1}, scalar, spin2);  // light propagates downwards
    PshVector beam(19, 1);
    for (std::size_t i = 0; i < scalar.size(); ++i) beam.channel(0)[4 * i] = scalar[i];
    PshVector out(19, 1);
    gold[0].apply(beam.channel(0), out.channel(0));
    const double up = evaluate(out, 0, {0, 0, 1})[0];
    CHECK(up > 1);
    CHECK(std::abs(evaluate(out, 0, {0, 0, -1})[0]) < 0.05 * up);
    CHECK(evaluate(*material, 0, {0, 0, 1}, {0, 0, 1})(0, 0) == Approx(up).epsilon(1e-3));

    // An s2 bias that does not rotate with the plane of incidence breaks mirror symmetry. The bias is kept
    // unless the material is symmetrized.
    harmonics_at(19, direction(pi - 0.5, 0), scalar, spin2);
    for (std::size_t i = 0; i < scalar.size(); ++i) beam.channel(0)[4 * i] = scalar[i];
    gold[0].apply(beam.channel(0), out.channel(0));
    const Stokes raw = evaluate(out, 0, direction(0.5, 0));
    CHECK(std::abs(raw[2]) > 0.2 * raw[0]);
    const glm::dvec3 light = direction(0.5, pi);
    const Mueller whole = evaluate(*material, 0, light, direction(0.5, 0));
    const Mueller half = evaluate(*psh_matrix_material(gold, {1.0}, true), 0, light, direction(0.5, 0));
    for (std::size_t p = 0; p < 4; ++p)
        CHECK(std::abs(whole(p, 0) * light.z - raw[static_cast<int>(p)]) < 0.01 * raw[0]);
    CHECK(std::abs(half(2, 0)) < 1e-6 * half(0, 0));
    CHECK(half(1, 0) * light.z == Approx(raw[1]).epsilon(0.01));
}

TEST_CASE("files that are no matrix are refused by name") {
    const TemporaryFolder folder;
    const auto path = folder / "bad.npz";
    const auto refused = [&](std::vector<NpzMember> members, const char* what) {
        write_npz(path, members);
        check_error(ErrorCode::invalid_file, CALL(read_psh_matrix(path)), "bad.npz", what);
    };
    const auto array = [](std::vector<std::size_t> shape, double value = 0) {
        std::size_t count = 1;
        for (const std::size_t n : shape) count *= n;
        return NpyArray{std::move(shape), std::vector<double>(count, value)};
    };
    refused({{"other", array({1})}}, "coeff");
    refused({{"coeff", array({1, 16})}}, "shape");
    refused({{"coeff", array({1, 1, 4, 3})}}, "shape");
    refused({{"coeff", array({0, 1, 4, 4})}}, "channels");
    refused({{"coeff", array({17, 1, 4, 4})}}, "channels");
    refused({{"coeff", array({1, 0, 4, 4})}}, "ISOBI2");
    refused({{"coeff", array({1, 9, 4, 4})}}, "ISOBI2");
    refused({{"coeff", array({1, 1, 4, 4}, std::nan(""))}}, "finite");
    refused({{"coeff", array({1, 1, 4, 4})}, {"cod_type", std::string("POLAR3")}}, "POLAR4");
    refused({{"coeff", array({1, 1, 4, 4})}, {"sh_type", std::string("COMP")}}, "REAL");
    CHECK_THROWS_AS(read_psh_matrix(folder / "absent.npz"), Error);
    CHECK_THROWS_AS(psh_matrix_material({}), Error);
    CHECK_THROWS_AS(psh_matrix_material({IsotropicMatrix(2, 3)}), Error);
    CHECK_THROWS_AS(psh_matrix_material({IsotropicMatrix(2, 2)}, {-1}), Error);
    CHECK_THROWS_AS(project_material(*diffuse({0.5}), 1, 300000), Error);
    CHECK_THROWS_AS(project_material(*diffuse({0.5, 0.5}), 2, 2), Error);
}
