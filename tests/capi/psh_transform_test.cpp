// SPDX-License-Identifier: MIT
// Transforms: round trips on every grid, samples against evaluation, one handle on several threads.
#include <algorithm>
#include <thread>

#include "psh.hpp"

using namespace capi_test;

namespace {

constexpr nicol_psh_grid grids[] = {NICOL_PSH_GRID_FEJER, NICOL_PSH_GRID_CLENSHAW_CURTIS,
                                    NICOL_PSH_GRID_GAUSS_LEGENDRE};

struct Size {
    std::uint32_t rows = 0, columns = 0;
    [[nodiscard]] std::size_t samples() const { return std::size_t{4} * rows * columns; }
};

Size size_of(nicol_psh_transform transform) {
    Size size;
    OK(nicol_psh_transform_get_size(transform, &size.rows, &size.columns));
    return size;
}

}  // namespace

TEST_CASE("psh: coefficients survive the way to every grid and back") {
    std::mt19937 random(1);
    for (const nicol_psh_grid grid : grids)
        for (const std::uint32_t order : {0U, 1U, 2U, 9U, 30U}) {
            CAPTURE(grid);
            CAPTURE(order);
            const nicol_psh_transform transform = make_transform(grid, order, 0, 0, 0.3);
            const Size size = size_of(transform);
            CHECK(size.columns == 2 * order + 1);
            if (grid == NICOL_PSH_GRID_GAUSS_LEGENDRE)
                CHECK(size.rows == order + 1);
            else
                CHECK(size.rows == std::max(2 * order + 1, grid == NICOL_PSH_GRID_FEJER ? 1U : 2U));
            const Doubles fields = random_fields(random, order, 3);
            Doubles samples(3 * size.samples());
            Doubles back(fields.size());
            OK(nicol_psh_synthesize(transform, 3, fields.data(), fields.size(), samples.data(),
                                    samples.size()));
            OK(nicol_psh_analyze(transform, 3, samples.data(), samples.size(), back.data(), back.size()));
            CHECK(difference(fields, back) < 1e-13);
            OK(nicol_psh_transform_release(transform));
        }
}

TEST_CASE("psh: samples are the field at the rows and columns that the handle tells") {
    std::mt19937 random(2);
    for (const nicol_psh_grid grid : grids) {
        const std::uint32_t order = 6, rows = 17, columns = 20;
        const double phi0 = 0.7;
        const nicol_psh_transform transform = make_transform(grid, order, rows, columns, phi0);
        Doubles theta(rows), weight(rows);
        OK(nicol_psh_transform_get_rows(transform, theta.data(), weight.data(), rows));
        CHECK(std::ranges::is_sorted(theta));
        double sum = 0, fourth = 0;
        for (std::size_t j = 0; j < rows; ++j) {
            sum += weight[j];
            fourth += weight[j] * std::pow(std::cos(theta[j]), 4);
        }
        CHECK(sum == doctest::Approx(2).epsilon(1e-14));
        CHECK(fourth == doctest::Approx(0.4).epsilon(1e-14));
        if (grid == NICOL_PSH_GRID_FEJER) CHECK(theta[0] == doctest::Approx(pi / 34));
        if (grid == NICOL_PSH_GRID_CLENSHAW_CURTIS) CHECK(theta[0] == 0);

        const Doubles field = random_fields(random, order);
        Doubles samples(4 * rows * columns);
        OK(nicol_psh_synthesize(transform, 1, field.data(), field.size(), samples.data(), samples.size()));
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t c = 0; c < columns; ++c) {
                if (std::sin(theta[j]) < 1e-6) continue;  // there phi is that of the column
                const auto s = value(order, field.data(),
                                     direction(theta[j], phi0 + 2 * pi * static_cast<double>(c) / columns));
                for (std::size_t p = 0; p < 4; ++p)
                    CHECK(std::abs(samples[4 * (j * columns + c) + p] - s[p]) < 1e-12);
            }
        OK(nicol_psh_transform_release(transform));
    }
}

TEST_CASE("psh: a handle lives as long as its last reference and is not another's") {
    const nicol_psh_transform transform = make_transform(NICOL_PSH_GRID_FEJER, 3);
    OK(nicol_psh_transform_retain(transform));
    OK(nicol_psh_transform_release(transform));
    CHECK(size_of(transform).rows == 7);
    FAILS(nicol_mesh_release(reinterpret_cast<nicol_mesh>(transform)), NICOL_ERROR_INVALID_HANDLE,
          "a nicol_psh_transform was passed for a nicol_mesh");
    OK(nicol_psh_transform_release(transform));
    std::uint32_t rows = 0, columns = 0;
    FAILS(nicol_psh_transform_get_size(transform, &rows, &columns), NICOL_ERROR_INVALID_HANDLE,
          "nicol_psh_transform");
    FAILS(nicol_psh_transform_retain(nullptr), NICOL_ERROR_INVALID_HANDLE, "nicol_psh_transform");
    OK(nicol_psh_transform_release(nullptr));
}

TEST_CASE("psh: calls of many threads on one transform take turns") {
    std::mt19937 random(3);
    const std::uint32_t order = 16;
    const nicol_psh_transform transform = make_transform(NICOL_PSH_GRID_GAUSS_LEGENDRE, order);
    const Size size = size_of(transform);
    const Doubles fields = random_fields(random, order, 4);
    Doubles errors(4, 1);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            const double* field = fields.data() + t * vector_size(order);
            Doubles samples(size.samples()), back(vector_size(order));
            double largest = 0;
            for (int i = 0; i < 50; ++i) {
                const bool ok = nicol_psh_synthesize(transform, 1, field, back.size(), samples.data(),
                                                     samples.size()) == NICOL_OK &&
                                nicol_psh_analyze(transform, 1, samples.data(), samples.size(), back.data(),
                                                  back.size()) == NICOL_OK;
                for (std::size_t k = 0; k < back.size(); ++k)
                    largest = std::max(largest, ok ? std::abs(back[k] - field[k]) : 1);
            }
            errors[t] = largest;
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const double error : errors) CHECK(error < 1e-13);
    OK(nicol_psh_transform_release(transform));
}
