// SPDX-License-Identifier: MIT
// Convolution against quadrature in the angular domain, and its matrices.
#include "psh.hpp"

using namespace capi_test;

namespace {

/// Bands that a kernel can have: without spin 2 below l = 2.
Doubles random_bands(std::mt19937& random, std::uint32_t order) {
    Doubles bands = random_numbers(random, NICOL_PSH_BAND_SIZE * std::size_t{order + 1});
    for (std::size_t l = 0; l < std::min<std::size_t>(2, order + 1); ++l)
        std::fill_n(bands.begin() + static_cast<std::ptrdiff_t>(16 * l + 4), 12, 0.0);
    return bands;
}

struct Kernel {
    std::uint32_t order;
    Doubles bands;
};

std::int32_t kernel_value(void* user, double theta, double* mueller) {
    const auto& kernel = *static_cast<const Kernel*>(user);
    return nicol_psh_kernel_at(kernel.order, kernel.bands.data(), kernel.bands.size(), &theta, 1, mueller,
                               16) == NICOL_OK;
}

}  // namespace

TEST_CASE("psh: a kernel survives the way to the angular domain and back") {
    std::mt19937 random(1);
    for (const std::uint32_t order : {0U, 1U, 2U, 11U}) {
        Kernel kernel{order, random_bands(random, order)};
        Doubles back(kernel.bands.size());
        OK(nicol_psh_project_kernel(kernel_value, &kernel, order, 0, back.data(), back.size()));
        CHECK(difference(back, kernel.bands) < 1e-13);
    }
}

TEST_CASE("psh: a diffuse kernel has the coefficients of the books") {
    // max(cos, 0) is pi, 2 pi / 3, pi / 4, 0 times the harmonic's norm (Ramamoorthi and Hanrahan).
    const auto clamped = [](void*, double theta, double* m) {
        m[0] = std::max(std::cos(theta), 0.0);
        return std::int32_t{1};
    };
    Doubles bands(4 * 16);
    OK(nicol_psh_project_kernel(clamped, nullptr, 3, 4000, bands.data(), bands.size()));
    const double wanted[] = {pi, 2 * pi / 3, pi / 4, 0};
    for (std::size_t l = 0; l < 4; ++l)
        CHECK(bands[16 * l] * std::sqrt(4 * pi / (2.0 * static_cast<double>(l) + 1)) ==
              doctest::Approx(wanted[l]).epsilon(1e-5));
    for (std::size_t i = 0; i < bands.size(); ++i)
        if (i % 16 != 0) CHECK(bands[i] == 0);
}

TEST_CASE("psh: convolution is the integral over all directions in great-circle frames") {
    std::mt19937 random(2);
    const std::uint32_t order = 5;
    const Doubles bands = random_bands(random, order);
    const Doubles fields = random_fields(random, order, 2);
    Doubles out(fields.size());
    OK(nicol_psh_convolve(order, bands.data(), bands.size(), 2, fields.data(), fields.size(), out.data(),
                          out.size()));

    const std::uint32_t rows = 12, columns = 24;
    const nicol_psh_transform grid = make_transform(NICOL_PSH_GRID_GAUSS_LEGENDRE, order, rows, columns);
    Doubles theta(rows), weight(rows), samples(2 * 4 * rows * columns);
    OK(nicol_psh_transform_get_rows(grid, theta.data(), weight.data(), rows));
    OK(nicol_psh_synthesize(grid, 2, fields.data(), fields.size(), samples.data(), samples.size()));
    OK(nicol_psh_transform_release(grid));
    for (std::size_t v = 0; v < 2; ++v)
        for (int trial = 0; trial < 5; ++trial) {
            const Vec3 w = random_direction(random);
            std::array<double, 4> sum{};
            for (std::size_t j = 0; j < rows; ++j)
                for (std::size_t c = 0; c < columns; ++c) {
                    const Vec3 from = direction(theta[j], 2 * pi * static_cast<double>(c) / columns);
                    const Vec3 y = unit(cross(from, w));
                    const double angle =
                        std::atan2(std::sqrt(dot(cross(from, w), cross(from, w))), dot(from, w));
                    double k[16];
                    OK(nicol_psh_kernel_at(order, bands.data(), bands.size(), &angle, 1, k, 16));
                    const auto s =
                        from_theta_phi(&samples[4 * ((v * rows + j) * columns + c)], cross(y, from), from);
                    double t[4] = {};
                    for (std::size_t a = 0; a < 4; ++a)
                        for (std::size_t b = 0; b < 4; ++b) t[a] += k[4 * a + b] * s[b];
                    const auto rotated = in_theta_phi(t, cross(y, w), w);
                    for (std::size_t p = 0; p < 4; ++p) sum[p] += weight[j] * 2 * pi / columns * rotated[p];
                }
            const auto s = value(order, out.data() + v * vector_size(order), w);
            for (std::size_t p = 0; p < 4; ++p) CHECK(std::abs(sum[p] - s[p]) < 1e-11);
        }

    Doubles replaced = fields;
    OK(nicol_psh_convolve(order, bands.data(), bands.size(), 2, replaced.data(), replaced.size(),
                          replaced.data(), replaced.size()));
    CHECK(replaced == out);
}

TEST_CASE("psh: convolution commutes with rotation") {
    std::mt19937 random(3);
    const std::uint32_t order = 8;
    const Doubles bands = random_bands(random, order);
    const Rotation turn = random_rotation(random);
    Doubles a = random_fields(random, order);
    Doubles b = a;
    OK(nicol_psh_convolve(order, bands.data(), bands.size(), 1, a.data(), a.size(), a.data(), a.size()));
    OK(nicol_psh_rotate(order, 1, a.data(), a.size(), turn.data(), a.data(), a.size()));
    OK(nicol_psh_rotate(order, 1, b.data(), b.size(), turn.data(), b.data(), b.size()));
    OK(nicol_psh_convolve(order, bands.data(), bands.size(), 1, b.data(), b.size(), b.data(), b.size()));
    CHECK(difference(a, b) < 1e-12);
}

TEST_CASE("psh: the matrix of a kernel does what the kernel does") {
    std::mt19937 random(4);
    const std::uint32_t order = 6;
    const Doubles bands = random_bands(random, order);
    const std::size_t n = vector_size(order);
    Doubles matrix(n * n);
    OK(nicol_psh_kernel_matrix(order, bands.data(), bands.size(), matrix.data(), matrix.size()));
    const Doubles fields = random_fields(random, order, 3);
    Doubles a(fields.size()), b(fields.size());
    OK(nicol_psh_convolve(order, bands.data(), bands.size(), 3, fields.data(), fields.size(), a.data(),
                          a.size()));
    OK(nicol_psh_apply_matrix(order, order, matrix.data(), matrix.size(), 3, fields.data(), fields.size(),
                              b.data(), b.size()));
    CHECK(difference(a, b) < 1e-13);
    Doubles back(bands.size());
    OK(nicol_psh_nearest_kernel(order, matrix.data(), matrix.size(), back.data(), back.size()));
    CHECK(difference(back, bands) < 1e-14);
}

TEST_CASE("psh: what the nearest kernel leaves is at right angles to every kernel") {
    std::mt19937 random(5);
    const std::uint32_t order = 4;
    const std::size_t n = vector_size(order);
    Doubles matrix = random_numbers(random, n * n);
    for (std::size_t row = 0; row < n; ++row)  // no spin 2 below l = 2
        for (std::size_t column = 0; column < n; ++column) {
            const auto empty = [](std::size_t i) { return i < 16 && (i % 4 == 1 || i % 4 == 2); };
            if (empty(row) || empty(column)) matrix[row * n + column] = 0;
        }
    Doubles bands(16 * (order + 1)), nearest(n * n), other(n * n);
    OK(nicol_psh_nearest_kernel(order, matrix.data(), matrix.size(), bands.data(), bands.size()));
    OK(nicol_psh_kernel_matrix(order, bands.data(), bands.size(), nearest.data(), nearest.size()));
    for (std::size_t k = 0; k < bands.size(); ++k) {
        if (k < 32 && k % 16 >= 4) continue;
        Doubles one(bands.size());
        one[k] = 1;
        OK(nicol_psh_kernel_matrix(order, one.data(), one.size(), other.data(), other.size()));
        double product = 0, length = 0;
        for (std::size_t i = 0; i < n * n; ++i) {
            product += (matrix[i] - nearest[i]) * other[i];
            length += other[i] * other[i];
        }
        CHECK(length > 0.1);
        CHECK(std::abs(product) < 1e-11);
    }
}
