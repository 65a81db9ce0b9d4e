// SPDX-License-Identifier: MIT
// Operators as matrices: products, Mueller fields, composition, and the matrix of the paper's authors.
#include <algorithm>
#include <cstdlib>

#include "files/npz.hpp"
#include "psh.hpp"

using namespace capi_test;

namespace {

Doubles shadow_matrix(std::uint32_t scalar_order, const Doubles& scalar, std::uint32_t out,
                      std::uint32_t in) {
    Doubles matrix(vector_size(out) * vector_size(in));
    OK(nicol_psh_shadow_matrix(scalar_order, scalar.data(), scalar.size(), out, in, matrix.data(),
                               matrix.size()));
    return matrix;
}

Doubles apply(const Doubles& matrix, std::uint32_t out, std::uint32_t in, const Doubles& fields) {
    const std::size_t vectors = fields.size() / vector_size(in);
    Doubles result(vectors * vector_size(out));
    OK(nicol_psh_apply_matrix(out, in, matrix.data(), matrix.size(), vectors, fields.data(), fields.size(),
                              result.data(), result.size()));
    return result;
}

/// M = a(out) b(in)^T of two fields.
struct OuterProduct {
    std::uint32_t order;
    Doubles a, b;

    static std::int32_t callback(void* user, const double* in, const double* out, double* mueller) {
        const auto& self = *static_cast<const OuterProduct*>(user);
        const auto a = value(self.order, self.a.data(), {out[0], out[1], out[2]});
        const auto b = value(self.order, self.b.data(), {in[0], in[1], in[2]});
        for (std::size_t i = 0; i < 16; ++i) mueller[i] = a[i / 4] * b[i % 4];
        return 1;
    }
};

/// A polarizing film's roughness in miniature: depends on both heights and on the angle between the azimuths.
std::int32_t isotropic_field(void*, const double* in, const double* out, double* mueller) {
    const double difference = std::atan2(in[1], in[0]) - std::atan2(out[1], out[0]);
    for (int i = 0; i < 16; ++i)
        mueller[i] = std::exp(in[2] - 0.5 * out[2]) * std::cos((i % 3) * difference + 0.1 * i) +
                     std::sin(difference) * in[2] * i;
    return 1;
}

nicol_psh_mueller_field field_of(std::uint32_t out, std::uint32_t in, nicol_psh_mueller_callback callback,
                                 void* user = nullptr) {
    nicol_psh_mueller_field field = NICOL_PSH_MUELLER_FIELD_INIT;
    field.order_out = out;
    field.order_in = in;
    field.callback = callback;
    field.user = user;
    return field;
}

}  // namespace

TEST_CASE("psh: a shadow matrix multiplies by its scalar field") {
    std::mt19937 random(1);
    const std::uint32_t scalar_order = 7, out = 5, in = 4;
    const Doubles scalar = random_numbers(random, 64);
    const Doubles fields = random_fields(random, in, 3);
    Doubles wanted(3 * vector_size(out));
    OK(nicol_psh_multiply(scalar_order, scalar.data(), scalar.size(), in, 3, fields.data(), fields.size(),
                          out, wanted.data(), wanted.size()));
    CHECK(difference(apply(shadow_matrix(scalar_order, scalar, out, in), out, in, fields), wanted) < 1e-13);
}

TEST_CASE("psh: the shadow matrix of the authors' visibility is the authors' matrix") {
    const char* data = std::getenv("NICOL_TEST_DATA");
    const auto folder = std::filesystem::path(data != nullptr ? data : "") / "polarsh";
    const auto visibility_file = folder / "vis_SHVec_buddha_v17650_256_L9.npz";
    if (data == nullptr || !std::filesystem::exists(visibility_file)) {
        MESSAGE("skipped: no polarsh in NICOL_TEST_DATA");
        return;
    }
    const nicol::NpyArray visibility = nicol::read_npz_member(visibility_file, "coeff");
    const nicol::NpyArray theirs =
        nicol::read_npz_member(folder / "vis_TPmat_buddha_v17650_256_L5.npz", "coeff");
    REQUIRE(visibility.shape == std::vector<std::size_t>{81});
    REQUIRE(theirs.shape == std::vector<std::size_t>{25, 25, 3, 3});  // (l, m) out and in, p out and in
    const Doubles ours = shadow_matrix(8, visibility.values, 4, 4);
    double largest = 0, scale = 0;
    for (std::size_t i = 0; i < 25; ++i)
        for (std::size_t j = 0; j < 25; ++j)
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b) {
                    const double wanted = theirs.values[((i * 25 + j) * 3 + a) * 3 + b];
                    largest = std::max(largest, std::abs(ours[(4 * i + a) * 100 + 4 * j + b] - wanted));
                    scale = std::max(scale, std::abs(wanted));
                }
    MESSAGE("largest difference ", largest, ", largest element ", scale);
    CHECK(scale > 0.1);
    CHECK(largest < 1e-6);
}

TEST_CASE("psh: the matrix of an outer product of fields is that of their coefficients") {
    std::mt19937 random(2);
    OuterProduct product{3, random_fields(random, 3), random_fields(random, 3)};
    for (const std::uint32_t out : {2U, 3U}) {
        const nicol_psh_mueller_field field = field_of(out, 3, OuterProduct::callback, &product);
        Doubles matrix(vector_size(out) * vector_size(3)), wanted;
        OK(nicol_psh_project_matrix(&field, matrix.data(), matrix.size()));
        for (std::size_t i = 0; i < vector_size(out); ++i)
            for (const double b : product.b) wanted.push_back(product.a[i] * b);
        CHECK(difference(matrix, wanted) < 1e-12);
    }
}

TEST_CASE("psh: an isotropic field needs one outgoing azimuth only") {
    nicol_psh_mueller_field field = field_of(4, 3, isotropic_field);
    field.rows_out = 9;
    field.columns_out = 20;
    field.rows_in = 8;
    field.columns_in = 20;
    Doubles full(vector_size(4) * vector_size(3)), isotropic(full.size());
    OK(nicol_psh_project_matrix(&field, full.data(), full.size()));
    field.isotropic = 1;
    field.columns_out = 0;
    OK(nicol_psh_project_matrix(&field, isotropic.data(), isotropic.size()));
    CHECK(*std::ranges::max_element(full) > 1);
    CHECK(difference(full, isotropic) < 1e-12);
}

TEST_CASE("psh: a composed matrix applies the first, then the second") {
    std::mt19937 random(3);
    const Doubles first = random_numbers(random, vector_size(2) * vector_size(3));
    const Doubles second = random_numbers(random, vector_size(4) * vector_size(2));
    Doubles both(vector_size(4) * vector_size(3));
    OK(nicol_psh_compose_matrix(4, 2, 3, second.data(), second.size(), first.data(), first.size(),
                                both.data(), both.size()));
    const Doubles fields = random_numbers(random, 2 * vector_size(3));
    CHECK(difference(apply(both, 4, 3, fields), apply(second, 4, 2, apply(first, 2, 3, fields))) < 1e-11);
}
