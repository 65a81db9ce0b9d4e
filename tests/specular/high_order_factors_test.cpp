// SPDX-License-Identifier: MIT
// Tests of the filters, kernels and factors of high orders.
#include "specular/high_order_factors.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/order_gains.hpp"
#include "harmonics/random_operators.hpp"
#include "material/chiral_material.hpp"
#include "material/conductor.hpp"
#include "material/counting_material.hpp"
#include "material/material_projection.hpp"
#include "material/psh_matrix_file.hpp"
#include "specular/convolution_kernel.hpp"
#include "specular/split_fit.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using Elements = std::array<float, HighOrderFactors::kElements>;

// Returns an ideal blurring mirror: light filtered by `gains`, attenuated per component and mirrored.
MaterialPtr blurring_mirror(const OrderGains& gains) {
    ConvolutionKernel kernel(gains.size());
    for (std::size_t l = 0; l < gains.size(); ++l) {
        const double unit = gains[l] / std::sqrt(4 * pi / (2 * static_cast<double>(l) + 1));
        kernel[l].k00 = unit;
        kernel[l].k33 = 0.5 * unit;
        if (l >= 2) kernel[l].iso = 0.8 * unit;
    }
    const int order = static_cast<int>(gains.size()) - 1;
    return psh_matrix_material({compose(reflection_matrix(order), kernel_matrix(kernel))});
}

// Interpolates the elements between the two table angles around a cosine.
Elements elements_at(const HighOrderFactors& factors, float cosine, std::size_t channel,
                     std::size_t pairing = 0) {
    const HighOrderFactors::Position at = HighOrderFactors::position(cosine);
    const std::size_t first = pairing * HighOrderFactors::kElements;
    const float* low = factors.row(at.angle, channel) + first;
    const float* high = factors.row(at.angle + 1, channel) + first;
    Elements out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = low[i] + at.fraction * (high[i] - low[i]);
    return out;
}

}  // namespace

TEST_CASE("gains are the Legendre coefficients of their lobes") {
    const OrderGains cosine = cosine_gains(0, 12);
    const LatitudeRows rows = gauss_legendre_rows(400);
    for (int l = 0; l <= 12; ++l) {
        double sum = 0;
        for (std::size_t j = 0; j < rows.theta.size(); ++j) {
            const double x = std::cos(rows.theta[j]);
            if (x > 0) sum += 2 * rows.weight[j] * x * std::legendre(static_cast<unsigned>(l), x);
        }
        CHECK(cosine[static_cast<std::size_t>(l)] == doctest::Approx(sum).epsilon(1e-4).scale(0.01));
    }
    const OrderGains lobe = gaussian_gains(0.3, 2, 6);
    REQUIRE(lobe.size() == 7);
    CHECK(lobe[1] == 0);
    CHECK(lobe[6] == doctest::Approx(std::exp(-21 * 0.09)));
    CHECK(gaussian_gains(0, 5, 5)[5] == 1);
    CHECK(cosine_gains(5, 9)[4] == 0);
    for (const auto& [width, first] : {std::pair(0.1, 6), {0.1, -1}, {-0.1, 0}, {std::nan(""), 0}})
        CHECK_THROWS_AS(gaussian_gains(width, first, 5), Error);
    CHECK_THROWS_AS(cosine_gains(0, kMaxOrder + 1), Error);
}

TEST_CASE("the kernel without a dense matrix is the kernel") {
    const MaterialPtr material = rough_conductor({.eta = metal_index("Cu"), .alpha = 0.4});
    const IsotropicMatrix matrix = project_material(*material, 1, 7);
    const ConvolutionKernel expected = nearest_kernel(compose(reflection_matrix(7), matrix).dense());
    const std::vector<ConvolutionKernel> found = mirrored_kernels(*material, 7, 3);
    REQUIRE(found.size() == 3);
    REQUIRE(found[1].size() == expected.size());
    double most = 0;
    for (const KernelBand& band : expected) most = std::max(most, std::abs(band.k00));
    CHECK(reference::kernel_difference(expected, found[1]) < 1e-12 * most);
    CHECK_THROWS_AS(mirrored_kernel(IsotropicMatrix(3, 4)), Error);
    CHECK_THROWS_AS(mirrored_kernels(*material, 7, 2), Error);
}

TEST_CASE("the factors of a mirror that blurs by one of the lobes are the mirror's") {
    const MaterialPtr material = blurring_mirror(gaussian_gains(kLobeWidths[3], 0, 24));
    const HighOrderFactors factors(*material, SplitBasis(4, 24), 1);
    CHECK(factors.central_lobe() == 3);
    const double expected[4] = {1, 0.8, -0.8, -0.5};
    Elements f{};
    for (const float cosine : {1.0F, 0.77F, 0.3F}) {
        f = elements_at(factors, cosine, 0);
        // A tap beside the centre counts by the part of its light that it shares with the centre.
        const auto sum = [&](std::size_t first, std::size_t stride) {
            return f[first] + f[first + stride] + f[first + 2 * stride] + 2 * f[first + 3 * stride];
        };
        constexpr auto rest = static_cast<std::size_t>(HighOrderFactors::kUnpolarized);
        CHECK(sum(0, 2) == doctest::Approx(expected[0]).epsilon(2e-3));
        CHECK(sum(rest + 1, 6) == doctest::Approx(expected[1]).epsilon(2e-3));
        CHECK(sum(rest + 2, 6) == doctest::Approx(expected[2]).epsilon(2e-3));
        CHECK(sum(rest + 5, 6) == doctest::Approx(expected[3]).epsilon(2e-3));
        for (const std::size_t zero : {std::size_t{1}, rest, rest + 3, rest + 4})
            CHECK(std::abs(f[zero]) < 2e-3F);
    }
    f = elements_at(factors, 0.3F, 0);
    CHECK(std::abs(f[8]) < 2e-3F);
}

TEST_CASE("factors from samples of a material and from its rows agree") {
    // The matrix is truncated at the same order on the outgoing side, which hardly affects a smooth material.
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.3}, .alpha = 0.5});
    for (const MaterialPtr& sampled : {plastic, test::chiral(plastic)}) {
        const MaterialPtr by_rows = psh_matrix_material({project_material(*sampled, 0, 24)});
        const HighOrderFactors a(*sampled, SplitBasis(2, 9), 1);
        const HighOrderFactors b(*by_rows, SplitBasis(2, 9), 1);
        REQUIRE(a.central_lobe() == b.central_lobe());
        REQUIRE(a.outer_lobe() == b.outer_lobe());
        REQUIRE(a.pairings() == sampled->pairings());
        for (const float cosine : {0.98F, 0.8F, 0.5F}) {
            for (std::size_t pairing = 0; pairing < a.pairings(); ++pairing) {
                const Elements x = elements_at(a, cosine, 0, pairing);
                const Elements y = elements_at(b, cosine, 0, pairing);
                CHECK(largest_difference(x, y) < 0.02 * largest(elements_at(a, cosine, 0)));
                CHECK(largest(x) > 0.1 * largest(elements_at(a, cosine, 0)));
            }
        }
    }
}

TEST_CASE("a mirror has one tap, of the whole light, and no base") {
    const Elements mirror = elements_at(HighOrderFactors::mirror(), 0.4F, 0);
    CHECK(HighOrderFactors::mirror().spread() == 0);
    CHECK_FALSE(HighOrderFactors::mirror().has_base());
    CHECK(mirror[0] == 1);
    CHECK(mirror[14] == -1);
}

TEST_CASE("lobes follow the roughness, and the base has a tap where there is one") {
    const HighOrderFactors sharp(*rough_conductor({.alpha = 0.05}), SplitBasis(4, 32), 1);
    const HighOrderFactors blunt(*rough_conductor({.alpha = 0.25}), SplitBasis(4, 32), 1);
    CHECK(sharp.outer_lobe() < blunt.outer_lobe());
    CHECK(sharp.spread() == kLobeWidths[static_cast<std::size_t>(sharp.outer_lobe())]);
    CHECK_FALSE(sharp.has_base());
    CHECK(HighOrderFactors(*pplastic({.alpha = 0.1}), SplitBasis(4, 9), 1).has_base());
}

TEST_CASE("few orders, which some taps do not contain, leave factors finite") {
    const MaterialPtr material = pplastic({.alpha = 0.2});
    for (const auto& [low, high] : {std::array{4, 5}, std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
        const HighOrderFactors factors(*material, SplitBasis(low, high), 1);
        CAPTURE(high);
        CHECK(largest(factors.data()) > 0);
        CHECK(largest(factors.data()) < 100);
    }
}

TEST_CASE("a grey material has one set of factors, orders and channels are checked") {
    const MaterialPtr grey = pplastic({.diffuse_reflectance = {0.4}, .alpha = 0.3});
    CHECK(HighOrderFactors(*grey, SplitBasis(4, 9), 3).channels() == 1);
    for (const auto& [low, high] : {std::pair(9, 9), {-1, 9}, {4, kMaxOrder + 1}})
        CHECK_THROWS_AS(HighOrderFactors(*grey, SplitBasis(low, high), 1), Error);
    const MaterialPtr two = pplastic({.diffuse_reflectance = {0.4, 0.1}, .alpha = 0.3});
    CHECK_THROWS_AS(HighOrderFactors(*two, SplitBasis(4, 9), 3), Error);
}

TEST_CASE("fits of materials that differ by weights alone share moments") {
    const auto plastic = [](const std::vector<double>& color) {
        return pplastic({.diffuse_reflectance = color, .alpha = 0.2});
    };
    const SplitBasis basis(4, 16);
    KnownMoments known;
    for (const std::vector<double>& color : {std::vector<double>{0.9, 0.1, 0.2}, {0.05, 0.8, 0.3}}) {
        const HighOrderFactors alone(*plastic(color), basis, 3);
        const HighOrderFactors shared(*plastic(color), basis, 3, &known);
        CHECK(alone.central_lobe() == shared.central_lobe());
        CHECK(std::ranges::equal(alone.data(), shared.data()));
    }
    // A material that is not evaluated again has the fit of the first one.
    const test::Counting counting;
    KnownMoments counted;
    const HighOrderFactors first(counting, basis, 1, &counted);
    const int calls = counting.calls;
    CHECK(calls > 0);
    const HighOrderFactors second(counting, basis, 1, &counted);
    CHECK(counting.calls == calls);
    CHECK(std::ranges::equal(first.data(), second.data()));
}

TEST_CASE("a fit for unpolarized light has the factors of s0 of a fit for all light") {
    const SplitBasis basis(4, 16);
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.4}, .alpha = 0.2});
    const std::array stencils{SplitStencil{0, 1, 0.05}, SplitStencil{1, 2, 0.1}};
    for (const MaterialPtr& material : {plastic, diffuse({0.5}), test::chiral(plastic)}) {
        KnownMoments of_all, of_s0;
        const auto all = SplitFit(*material, basis, 1, of_all).at(0.7, stencils);
        const auto s0 = SplitFit(*material, basis, 1, of_s0, 1).at(0.7, stencils);
        for (std::size_t s = 0; s < stencils.size(); ++s)
            for (std::size_t p = 0; p < 4; ++p) {
                CHECK(s0[s][0].energy[p][0] == doctest::Approx(all[s][0].energy[p][0]).epsilon(1e-6));
                for (std::size_t tap = 0; tap < kSplitUnknowns; tap += 4)
                    CHECK(s0[s][0].of[p][tap] == doctest::Approx(all[s][0].of[p][tap]).epsilon(1e-6));
            }
        CHECK(s0[0][0].energy[0][0] > 0);
    }
}
