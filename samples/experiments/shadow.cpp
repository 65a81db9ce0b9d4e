// SPDX-License-Identifier: MIT
// Figure 13: from visibility over spherical harmonics to the matrix that multiplies by it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiment.hpp"
#include "field.hpp"
#include "image.hpp"
#include "published.hpp"

namespace {

constexpr std::uint32_t kOrder = 4;
constexpr std::uint32_t kScalarOrder = 2 * kOrder;  // all orders that matter between two such fields

/// Returns an example of visibility: a vertex beside a wall, on the ground, with a ball overhead.
double visible(const Vec3& w) {
    const bool ground = w[2] < -0.1;
    const bool wall = w[0] > 0.75;
    const bool ball = dot(w, unit({-0.4, 0.5, 0.6})) > std::cos(0.45);
    return ground || wall || ball ? 0 : 1;
}

Doubles shadow_matrix(const Doubles& visibility) {
    const std::size_t n = vector_size(kOrder);
    Doubles matrix(n * n);
    check(nicol_psh_shadow_matrix(kScalarOrder, visibility.data(), visibility.size(), kOrder, kOrder,
                                  matrix.data(), matrix.size()));
    return matrix;
}

/// Returns the largest difference to the authors' matrix of their visibility: [index out][index in][p out][p
/// in] of s0, s1, s2, without s3.
double difference_to_published(const std::string& folder) {
    constexpr std::size_t count = (kOrder + 1) * (kOrder + 1), n = 4 * count;
    const Doubles matrix = shadow_matrix(
        published(folder + "/vis_SHVec_buddha_v17650_256_L9.npz", (kScalarOrder + 1) * (kScalarOrder + 1)));
    const Doubles theirs = published(folder + "/vis_TPmat_buddha_v17650_256_L5.npz", 9 * count * count);
    double most = 0;
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        const std::size_t row = 4 * (k / 9 / count) + k % 9 / 3, column = 4 * (k / 9 % count) + k % 3;
        most = std::max(most, std::abs(matrix[row * n + column] - theirs[k]));
    }
    return most;
}

}  // namespace

void figure_13(Experiment& experiment) {
    // The projected step function needs many points; all later steps are exact.
    const Grid fine(NICOL_PSH_GRID_GAUSS_LEGENDRE, kScalarOrder, 512, 1024);
    Doubles samples(4 * fine.points());
    for (std::size_t i = 0; i < fine.points(); ++i)
        samples[4 * i] = visible(direction(fine.theta[i / fine.columns], fine.phi(i % fine.columns)));
    const Doubles as_field = fine.analyze(samples);
    Doubles visibility;
    for (std::size_t i = 0; i < as_field.size(); i += 4) visibility.push_back(as_field[i]);

    const std::size_t n = vector_size(kOrder);
    Doubles matrix;
    const double expand_s = seconds([&] { matrix = shadow_matrix(visibility); });

    // Quadrature computes the matrix without triple products: each basis function times the visibility, point
    // by point.
    const Grid grid(NICOL_PSH_GRID_GAUSS_LEGENDRE, kOrder, 16, 32);
    const Grid scalar_grid(NICOL_PSH_GRID_GAUSS_LEGENDRE, kScalarOrder, 16, 32);
    const Doubles factor = scalar_grid.synthesize(as_field);
    Doubles by_quadrature(n * n);
    for (std::size_t j = 0; j < n; ++j) {
        Doubles basis(n);
        basis[j] = 1;
        Doubles product = grid.synthesize(basis);
        for (std::size_t i = 0; i < product.size(); ++i) product[i] *= factor[i - i % 4];
        const Doubles column = grid.analyze(product);
        for (std::size_t i = 0; i < n; ++i) by_quadrature[i * n + j] = column[i];
    }

    const auto norm = [&](auto in_block) {
        double sum = 0;
        for (std::size_t i = 0; i < n * n; ++i)
            if (in_block(i / n % 4, i % n % 4)) sum += matrix[i] * matrix[i];
        return std::sqrt(sum);
    };
    const auto spin2 = [](std::size_t p) { return p == 1 || p == 2; };
    const double other =
        norm([&](std::size_t a, std::size_t b) { return spin2(a) != spin2(b) || (!spin2(a) && a != b); });
    std::printf("  visible share of the sphere            %.4f\n", visibility[0] / std::sqrt(4 * pi));
    std::printf("  Frobenius norm, s0 to s0               %.4f\n",
                norm([](std::size_t a, std::size_t b) { return a == 0 && b == 0; }));
    std::printf("  Frobenius norm, spin 2 to 2            %.4f\n",
                norm([&](std::size_t a, std::size_t b) { return spin2(a) && spin2(b); }));
    std::printf("  Frobenius norm, all that must vanish   %.2e\n", other);
    const double deviation = largest_difference(matrix, by_quadrature);
    std::printf("  against products at points, largest    %.2e\n", deviation);
    std::printf("  time to expand, its 3j symbols too     %.2e s\n", expand_s);
    const double published_deviation =
        experiment.polarsh.empty() ? 0 : difference_to_published(experiment.polarsh);
    if (experiment.polarsh.empty())
        std::printf("  against the authors' own matrix        not compared, see --polarsh\n");
    else
        std::printf("  against the authors' own matrix        %.2e\n", published_deviation);
    experiment.claim(other == 0, "visibility keeps s0, s3 and (s1, s2) apart");
    experiment.claim(deviation < 1e-13, "triple products (Eqs. 215, 216) are products at every point");
    if (!experiment.polarsh.empty())
        experiment.claim(published_deviation < 1e-6, "the authors' matrix of their visibility is ours");

    Panel matrix_panel{n, n, {}};
    for (const double x : matrix) matrix_panel.values.push_back(x);
    Image image(1);
    image.add(matrix_panel, Magnitude{1, 4});
    image.write(experiment.image("fig13_shadow_matrix.png"), 4);
    const Doubles smooth = fine.synthesize(as_field);
    Image maps(2);
    for (const Doubles& map : {samples, smooth}) {
        Panel panel{fine.columns / 4, fine.theta.size() / 4, {}};
        for (std::size_t row = 0; row < panel.height; ++row)
            for (std::size_t column = 0; column < panel.width; ++column)
                panel.values.push_back(map[4 * (4 * row * fine.columns + 4 * column)]);
        maps.add(panel, Signed{1});
    }
    maps.write(experiment.image("fig13_visibility.png"), 2);
}
