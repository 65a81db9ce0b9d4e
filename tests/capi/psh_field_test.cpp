// SPDX-License-Identifier: MIT
// Evaluation, rotation, reflection and products against closed forms and against the angular domain.
#include "psh.hpp"

using namespace capi_test;

TEST_CASE("psh: single coefficients are the harmonics of the books") {
    std::mt19937 random(1);
    const double a = std::sqrt(3 / (4 * pi)), b = std::sqrt(5 / (4 * pi));
    for (int trial = 0; trial < 20; ++trial) {
        const Vec3 w = random_direction(random);
        const double phi = std::atan2(w[1], w[0]);
        const double sin_half = std::sqrt((1 - w[2]) / 2), cos_half = std::sqrt((1 + w[2]) / 2);
        const auto at = [&](int l, int m, int p) {
            Doubles f(vector_size(2));
            f[position(l, m, p)] = 1;
            return value(2, f.data(), w);
        };
        for (const int p : {0, 3}) {
            const auto i = static_cast<std::size_t>(p);
            CHECK(at(0, 0, p)[i] == doctest::Approx(std::sqrt(1 / (4 * pi))));
            CHECK(at(1, 0, p)[i] == doctest::Approx(a * w[2]));
            CHECK(at(1, 1, p)[i] == doctest::Approx(-a * w[0]));
            CHECK(at(1, -1, p)[i] == doctest::Approx(-a * w[1]));
            CHECK(at(2, -2, p)[i] == doctest::Approx(std::sqrt(15 / (4 * pi)) * w[0] * w[1]));
            CHECK(at(2, 2, p)[1] == 0);
        }
        const auto spin2 = [&](int m) { return std::complex(at(2, m, 1)[1], at(2, m, 1)[2]); };
        CHECK(std::abs(spin2(0) - std::sqrt(15 / (32 * pi)) * (1 - w[2] * w[2])) < 1e-14);
        CHECK(std::abs(spin2(2) - std::polar(b * std::pow(sin_half, 4), 2 * phi)) < 1e-14);
        CHECK(std::abs(spin2(-2) - std::polar(b * std::pow(cos_half, 4), -2 * phi)) < 1e-14);
        const auto imaginary = at(2, 2, 2);  // the coefficient i
        CHECK(std::abs(std::complex(-imaginary[2], imaginary[1]) + spin2(2)) < 1e-14);
    }
}

TEST_CASE("psh: many vectors and directions at once are the single ones") {
    std::mt19937 random(2);
    const std::uint32_t order = 7;
    const Doubles fields = random_fields(random, order, 3);
    Doubles directions;
    for (int i = 0; i < 5; ++i)
        for (const double x : random_direction(random)) directions.push_back(3e5 * x);
    directions.insert(directions.end(), {0, 0, 1, 0, 0, -2});
    Doubles stokes(3 * 7 * 4);
    OK(nicol_psh_evaluate(order, 3, fields.data(), fields.size(), directions.data(), directions.size(),
                          stokes.data(), stokes.size()));
    for (std::size_t v = 0; v < 3; ++v)
        for (std::size_t i = 0; i < 7; ++i) {
            const auto single = value(order, fields.data() + v * vector_size(order),
                                      {directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]});
            for (std::size_t p = 0; p < 4; ++p)
                CHECK(stokes[4 * (7 * v + i) + p] == doctest::Approx(single[p]).epsilon(1e-12));
        }
}

TEST_CASE("psh: a rotated field is the field rotated in space, frames included") {
    std::mt19937 random(3);
    const std::uint32_t order = 12;
    const Doubles fields = random_fields(random, order, 2);
    const Rotation turn = random_rotation(random);
    Doubles rotated(fields.size());
    OK(nicol_psh_rotate(order, 2, fields.data(), fields.size(), turn.data(), rotated.data(), rotated.size()));
    for (std::size_t v = 0; v < 2; ++v)
        for (int trial = 0; trial < 20; ++trial) {
            const Vec3 w = random_direction(random);
            const auto before = value(order, fields.data() + v * vector_size(order), w);
            const auto wanted = in_theta_phi(before.data(), turn * theta_phi(w)[0], turn * w);
            const auto now = value(order, rotated.data() + v * vector_size(order), turn * w);
            for (std::size_t p = 0; p < 4; ++p) CHECK(std::abs(now[p] - wanted[p]) < 1e-11);
        }
}

TEST_CASE("psh: rotations form their group") {
    std::mt19937 random(4);
    const std::uint32_t order = 9;
    const Doubles fields = random_fields(random, order, 3);
    const auto rotate = [&](const Rotation& r, Doubles f) {
        OK(nicol_psh_rotate(order, 3, f.data(), f.size(), r.data(), f.data(), f.size()));  // in place
        return f;
    };
    CHECK(difference(rotate({1, 0, 0, 0, 1, 0, 0, 0, 1}, fields), fields) < 1e-15);
    CHECK(difference(rotate({-1, 0, 0, 0, -1, 0, 0, 0, 1}, rotate({-1, 0, 0, 0, -1, 0, 0, 0, 1}, fields)),
                     fields) < 1e-15);
    for (int trial = 0; trial < 10; ++trial) {
        const Rotation a = random_rotation(random), b = random_rotation(random);
        CHECK(difference(rotate(b, rotate(a, fields)), rotate(after(b, a), fields)) < 1e-13);
        CHECK(difference(rotate(transposed(a), rotate(a, fields)), fields) < 1e-13);
    }
}

TEST_CASE("psh: reflection is the mirror image in the plane z = 0") {
    std::mt19937 random(5);
    const std::uint32_t order = 6;
    const Doubles fields = random_fields(random, order, 2);
    Doubles mirrored(fields.size());
    OK(nicol_psh_reflect(order, 2, fields.data(), fields.size(), mirrored.data(), mirrored.size()));
    for (std::size_t v = 0; v < 2; ++v)
        for (int trial = 0; trial < 20; ++trial) {
            const Vec3 w = random_direction(random);
            const auto s = value(order, fields.data() + v * vector_size(order), w);
            const auto t = value(order, mirrored.data() + v * vector_size(order), {w[0], w[1], -w[2]});
            // A mirror keeps the lengths along both axes and turns every sense of rotation.
            CHECK(std::abs(t[0] - s[0]) < 1e-12);
            CHECK(std::abs(t[1] - s[1]) < 1e-12);
            CHECK(std::abs(t[2] + s[2]) < 1e-12);
            CHECK(std::abs(t[3] + s[3]) < 1e-12);
        }
    OK(nicol_psh_reflect(order, 2, mirrored.data(), fields.size(), mirrored.data(), mirrored.size()));
    CHECK(mirrored == fields);
}

TEST_CASE("psh: a product is the product at every direction") {
    std::mt19937 random(6);
    const std::uint32_t scalar_order = 5, order = 8, order_out = scalar_order + order;
    const Doubles scalar = random_numbers(random, 36);
    const Doubles fields = random_fields(random, order, 2);
    Doubles product(2 * vector_size(order_out));
    OK(nicol_psh_multiply(scalar_order, scalar.data(), scalar.size(), order, 2, fields.data(), fields.size(),
                          order_out, product.data(), product.size()));
    Doubles scalar_field(vector_size(scalar_order));
    for (std::size_t i = 0; i < scalar.size(); ++i) scalar_field[4 * i] = scalar[i];
    for (std::size_t v = 0; v < 2; ++v)
        for (int trial = 0; trial < 20; ++trial) {
            const Vec3 w = random_direction(random);
            const double factor = value(scalar_order, scalar_field.data(), w)[0];
            const auto s = value(order, fields.data() + v * vector_size(order), w);
            const auto t = value(order_out, product.data() + v * vector_size(order_out), w);
            for (std::size_t p = 0; p < 4; ++p) CHECK(std::abs(t[p] - factor * s[p]) < 1e-11);
        }

    // A lower order is the same, cut; and the product may replace its factor.
    Doubles cut = fields;
    OK(nicol_psh_multiply(scalar_order, scalar.data(), scalar.size(), order, 2, cut.data(), cut.size(), order,
                          cut.data(), cut.size()));
    for (std::size_t v = 0; v < 2; ++v)
        for (std::size_t i = 0; i < vector_size(order); ++i)
            CHECK(std::abs(cut[v * vector_size(order) + i] - product[v * vector_size(order_out) + i]) <
                  1e-12);
}
