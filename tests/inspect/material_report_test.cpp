// SPDX-License-Identifier: MIT
// Tests of material reports against closed forms.
#include "inspect/material_report.hpp"

#include "harmonics/random_operators.hpp"
#include "material/material_projection.hpp"
#include "material/psh_matrix_file.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

MaterialPtr surface(const Mueller& mueller) {
    return callback_material(
        {.reflect = [=](int, const glm::dvec3&, const glm::dvec3&) { return mueller; }, .channels = 1});
}

// Returns a Mueller matrix with these elements divided by pi, in s-frames.
Mueller over_pi(double m00, double m10, double m01) {
    Mueller m;
    m(0, 0) = m00 / pi;
    m(1, 0) = m10 / pi;
    m(0, 1) = m01 / pi;
    return m;
}

// Returns the sign of a coefficient under reflection in the plane y = 0, which reverses azimuths, s2 and s3.
double mirror_sign(int m, std::size_t p) {
    if (p == 1 || p == 2) return p == 1 ? 1 : -1;
    return (m >= 0 ? 1.0 : -1.0) * (p == 0 ? 1 : -1);
}

}  // namespace

TEST_CASE("the report of an even surface has its closed form") {
    for (const double reflectance : {0.25, 1.0}) {
        const MatrixReport r = describe(project_material(*diffuse({reflectance}), 0, 16));
        CHECK(r.albedo == doctest::Approx(reflectance).epsilon(1e-3));
        CHECK(r.largest_albedo == doctest::Approx(reflectance).epsilon(0.03));
        CHECK(r.asymmetry < 1e-12);
        // The norm of cos / pi over both hemispheres is the root of (1 / pi^2) (2 pi / 3) (2 pi).
        CHECK(r.norms[0] == doctest::Approx(reflectance * 2 / std::sqrt(3)).epsilon(0.02));
        for (std::size_t i = 1; i < 9; ++i) CHECK(r.norms[i] < 1e-9);
    }
}

TEST_CASE("norms, energies and asymmetry are those of the dense matrix") {
    constexpr int order = 5;
    std::mt19937 random(8);
    const IsotropicMatrix matrix = reference::random_isotropic(random, order, order);
    const MatrixReport r = describe(matrix);
    const CoefficientMatrix dense = matrix.dense();
    std::array<double, 9> norms{};
    std::array<double, order + 1> energy{};
    double wrong = 0, all = 0;
    const auto group = [](std::size_t p) { return p == 0 ? 0U : p == 3 ? 2U : 1U; };
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            for (int k = 0; k <= order; ++k)
                for (int n = -k; n <= k; ++n)
                    for (std::size_t p = 0; p < 4; ++p)
                        for (std::size_t q = 0; q < 4; ++q) {
                            const double square =
                                std::pow(dense(4 * psh_index(l, m) + p, 4 * psh_index(k, n) + q), 2);
                            norms[3 * group(p) + group(q)] += square;
                            energy[static_cast<std::size_t>(std::max(l, k))] += square;
                            all += square;
                            if (mirror_sign(m, p) != mirror_sign(n, q)) wrong += square;
                        }
    for (std::size_t i = 0; i < 9; ++i)
        CHECK(r.norms[i] == doctest::Approx(std::sqrt(norms[i])).epsilon(1e-9));
    REQUIRE(r.energy.size() == energy.size());
    for (std::size_t l = 0; l <= order; ++l) CHECK(r.energy[l] == doctest::Approx(energy[l]).epsilon(1e-9));
    CHECK(r.asymmetry == doctest::Approx(std::sqrt(wrong / all)).epsilon(1e-9));
    CHECK(r.asymmetry > 0.3);
}

TEST_CASE("energy that appears is reported, in the worst polarization") {
    const auto report = [](const Mueller& m, int order) {
        return describe(project_material(*surface(m), 0, order));
    };
    CHECK(report(over_pi(2, 0, 0), 12).largest_albedo == doctest::Approx(2).epsilon(0.05));
    CHECK(report(over_pi(0.5, 0, 0), 12).largest_albedo == doctest::Approx(0.5).epsilon(0.05));
    // In the plane of incidence light with s1 = s0 is fully reflected, and light with s1 = -s0 not at all.
    const MatrixReport polarizer = report(over_pi(0.4, 0, 0.4), 16);
    CHECK(polarizer.albedo == doctest::Approx(0.4).epsilon(1e-3));
    // Light leaves uniformly by cosine. The part of s1 that has one sign in s-frames adds up to 0.4.
    CHECK(polarizer.largest_albedo > 0.45);
    CHECK(polarizer.largest_albedo < 0.81);
}

TEST_CASE("light that polarizes beyond itself is reported") {
    // Reports on matrices, as files hold them.
    const auto report = [](const Mueller& m) {
        return describe(*psh_matrix_material(std::vector{project_material(*surface(m), 0, 12)}), 0);
    };
    CHECK(report(over_pi(0.5, 0, 0)).excess < 0.02);
    // The reflected light has s1 = 1.5 s0.
    const MuellerReport polarized = report(over_pi(0.5, 0.75, 0));
    CHECK(polarized.unphysical > 0.9);
    CHECK(std::abs(polarized.excess - 0.5) < 0.1);
}
