// SPDX-License-Identifier: MIT
// Tests of PSH functions through the C interface: layouts, batches and in-place outputs. The results are
// compared with the library's, which tests/harmonics verifies.
#include <thread>

#include "harmonics/convolution.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/product.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/transform.hpp"
#include "light/images.hpp"
#include "psh.hpp"

using namespace capi_test;
using nicol::PshVector;

namespace {

/// Returns random valid bands of a kernel, without a spin-2 part below l = 2.
Doubles random_bands(std::uint32_t order) {
    Doubles bands = random_numbers(NICOL_PSH_BAND_SIZE * std::size_t{order + 1});
    for (std::size_t l = 0; l < std::min<std::size_t>(2, order + 1); ++l)
        std::fill_n(bands.begin() + static_cast<std::ptrdiff_t>(16 * l + 4), 12, 0.0);
    return bands;
}

Doubles apply(const Doubles& matrix, std::uint32_t out, std::uint32_t in, std::span<const double> fields) {
    const std::size_t vectors = fields.size() / vector_size(in);
    Doubles result(vectors * vector_size(out));
    OK(nicol_psh_apply_matrix(out, in, matrix.data(), matrix.size(), vectors, fields.data(), fields.size(),
                              result.data(), result.size()));
    return result;
}

/// The Mueller field M = a(out) b(in)^T of two Stokes fields.
struct OuterProduct {
    PshVector a, b;

    static std::int32_t callback(void* user, const double* in, const double* out, double* mueller) {
        const auto& self = *static_cast<const OuterProduct*>(user);
        const nicol::Stokes a = nicol::evaluate(self.a, 0, {out[0], out[1], out[2]});
        const nicol::Stokes b = nicol::evaluate(self.b, 0, {in[0], in[1], in[2]});
        for (int i = 0; i < 16; ++i) mueller[i] = a[i / 4] * b[i % 4];
        return 1;
    }
};

/// Evaluates an isotropic Mueller field, which depends on both heights and on the difference of the azimuths.
std::int32_t isotropic_field(void*, const double* in, const double* out, double* mueller) {
    const double difference = std::atan2(in[1], in[0]) - std::atan2(out[1], out[0]);
    for (int i = 0; i < 16; ++i)
        mueller[i] = std::exp(in[2] - 0.5 * out[2]) * std::cos((i % 3) * difference + 0.1 * i) +
                     std::sin(difference) * in[2] * i;
    return 1;
}

}  // namespace

TEST_CASE("psh: coefficients stand where the header says, with the header's signs") {
    for (const glm::dvec3& w : random_directions(20)) {
        const auto at = [&](std::size_t l, std::size_t m, std::size_t p) {
            Doubles f(vector_size(2)), s(4);
            f[4 * (l * l + l + m) + p] = 1;
            OK(nicol_psh_evaluate(2, 1, f.data(), f.size(), &w.x, 3, s.data(), 4));
            return s;
        };
        for (const std::size_t p : {0U, 3U})
            CHECK(at(1, std::size_t(-1), p)[p] == doctest::Approx(-std::sqrt(3 / (4 * pi)) * w.y));
        const auto wanted =
            std::polar(std::sqrt(5 / (4 * pi)) * std::pow((1 - w.z) / 2, 2), 2 * std::atan2(w.y, w.x));
        const auto real = at(2, 2, 1), imaginary = at(2, 2, 2);  // the coefficients 1 and i
        CHECK(std::abs(std::complex(real[1], real[2]) - wanted) < 1e-14);
        CHECK(std::abs(std::complex(imaginary[2], -imaginary[1]) - wanted) < 1e-14);
    }
}

TEST_CASE("psh: vectors and directions of any length, one or many, are evaluated as the library does") {
    std::vector<glm::dvec3> directions = random_directions(5);
    for (glm::dvec3& w : directions) w *= 3e5;
    directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -2}});
    for (const int vectors : {1, 3}) {
        const PshVector fields = random_fields(7, vectors);
        Doubles stokes(static_cast<std::size_t>(vectors) * 7 * 4);
        OK(nicol_psh_evaluate(7, static_cast<std::uint64_t>(vectors), fields.data().data(),
                              fields.data().size(), &directions[0].x, 21, stokes.data(), stokes.size()));
        for (int i = 0; i < vectors * 7; ++i) {
            const nicol::Stokes single =
                nicol::evaluate(fields, i / 7, directions[static_cast<std::size_t>(i % 7)]);
            for (int p = 0; p < 4; ++p)
                CHECK(stokes[static_cast<std::size_t>(4 * i + p)] ==
                      doctest::Approx(single[p]).epsilon(1e-12));
        }
    }
}

TEST_CASE(
    "psh: fields are rotated by row-major matrices and reflected in z = 0, each vector, also in place") {
    const std::uint32_t order = 12;
    const PshVector fields = random_fields(order, 2);
    const glm::dmat3 rotation = some_rotation();
    const std::size_t n = fields.data().size();
    Doubles rotated(n), mirrored(n);
    OK(nicol_psh_rotate(order, 2, fields.data().data(), n, rows_of(rotation).data(), rotated.data(), n));
    CHECK(largest_difference(rotated, nicol::rotated(fields, rotation).data()) < 1e-13);
    OK(nicol_psh_reflect(order, 2, fields.data().data(), n, mirrored.data(), n));
    CHECK(largest_difference(mirrored, nicol::reflected(fields).data()) < 1e-13);
    OK(nicol_psh_reflect(order, 2, mirrored.data(), n, mirrored.data(), n));
    CHECK(std::ranges::equal(mirrored, fields.data()));
    const Rotation back = rows_of(glm::transpose(rotation));
    OK(nicol_psh_rotate(order, 2, rotated.data(), n, back.data(), rotated.data(), n));
    CHECK(largest_difference(rotated, fields.data()) < 1e-13);
}

TEST_CASE("psh: a product is the library's of each vector, cut, in place and as a matrix") {
    const std::uint32_t scalar_order = 5, order = 8;
    const Doubles scalar = random_numbers(36, 2);
    const PshVector fields = random_fields(order, 2);
    const auto multiply = [&](std::span<const double> in, std::uint32_t out, double* to) {
        OK(nicol_psh_multiply(scalar_order, scalar.data(), scalar.size(), order, 2, in.data(), in.size(), out,
                              to, 2 * vector_size(out)));
    };
    for (const std::uint32_t out : {13U, 8U, 5U}) {
        PshVector wanted(static_cast<int>(out), 2);
        nicol::PshProduct product(scalar_order, order, static_cast<int>(out));
        for (int v = 0; v < 2; ++v) product.multiply(scalar, fields.channel(v), wanted.channel(v));
        Doubles found(wanted.data().size());
        if (out == order) std::ranges::copy(fields.data(), found.begin());
        multiply(out == order ? found : fields.data(), out, found.data());
        CHECK(largest_difference(found, wanted.data()) < 1e-12);
        Doubles matrix(vector_size(out) * vector_size(order));
        OK(nicol_psh_shadow_matrix(scalar_order, scalar.data(), scalar.size(), out, order, matrix.data(),
                                   matrix.size()));
        CHECK(largest_difference(apply(matrix, out, order, fields.data()), found) < 1e-13);
    }
}

TEST_CASE("psh: the matrix of an outer product of fields is that of their coefficients") {
    OuterProduct product{random_fields(3), random_fields(3, 1, 2)};
    for (const std::uint32_t out : {2U, 3U}) {
        nicol_psh_mueller_field field = NICOL_PSH_MUELLER_FIELD_INIT;
        field.order_out = out;
        field.order_in = 3;
        field.callback = OuterProduct::callback;
        field.user = &product;
        Doubles matrix(vector_size(out) * vector_size(3)), wanted;
        OK(nicol_psh_project_matrix(&field, matrix.data(), matrix.size()));
        for (std::size_t i = 0; i < vector_size(out); ++i)
            for (const double b : product.b.data()) wanted.push_back(product.a.data()[i] * b);
        CHECK(largest_difference(matrix, wanted) < 1e-12);
    }
}

TEST_CASE("psh: an isotropic field needs one outgoing azimuth only") {
    nicol_psh_mueller_field field = {sizeof field, 0, 4, 3, 9, 20, 8, 20, isotropic_field, nullptr};
    Doubles full(vector_size(4) * vector_size(3)), isotropic(full.size());
    OK(nicol_psh_project_matrix(&field, full.data(), full.size()));
    field.isotropic = 1;
    field.columns_out = 0;
    OK(nicol_psh_project_matrix(&field, isotropic.data(), isotropic.size()));
    CHECK(*std::ranges::max_element(full) > 1);
    CHECK(largest_difference(full, isotropic) < 1e-12);
}

TEST_CASE("psh: a composed matrix applies the first, then the second") {
    const Doubles first = random_numbers(vector_size(2) * vector_size(3));
    const Doubles second = random_numbers(vector_size(4) * vector_size(2), 2);
    Doubles both(vector_size(4) * vector_size(3));
    OK(nicol_psh_compose_matrix(4, 2, 3, second.data(), second.size(), first.data(), first.size(),
                                both.data(), both.size()));
    const Doubles fields = random_numbers(2 * vector_size(3), 3);
    CHECK(largest_difference(apply(both, 4, 3, fields), apply(second, 4, 2, apply(first, 2, 3, fields))) <
          1e-11);
}

TEST_CASE("psh: the parts of a Mueller matrix stand in a band where the header says") {
    // Position in the band of each matrix element, row by row. Each of the four middle elements mixes two
    // parts.
    const std::size_t places[16] = {0, 8, 9, 1, 4, 16, 16, 6, 5, 16, 16, 7, 2, 10, 11, 3};
    for (std::size_t element = 0; element < 16; ++element) {
        CAPTURE(element);
        // The coefficients of max(cos, 0) are pi, 2 pi / 3, pi / 4, 0 times the harmonic's norm (Ramamoorthi
        // and Hanrahan).
        const auto lobe = [](void* user, double theta, double* m) {
            m[*static_cast<std::size_t*>(user)] = std::max(std::cos(theta), 0.0);
            return std::int32_t{1};
        };
        Doubles bands(4 * 16);
        OK(nicol_psh_project_kernel(lobe, &element, 3, 4000, bands.data(), bands.size()));
        for (std::size_t i = 0; i < bands.size(); ++i) {
            const bool here = places[element] == 16 ? i % 16 >= 12 : i % 16 == places[element];
            if (!here || (i % 16 >= 4 && i < 32)) {
                CHECK(bands[i] == 0);
            } else if (i % 16 < 4) {
                const double wanted[] = {pi, 2 * pi / 3, pi / 4, 0};
                CHECK(bands[i] * std::sqrt(4 * pi / (2.0 * static_cast<double>(i / 16) + 1)) ==
                      doctest::Approx(wanted[i / 16]).epsilon(1e-5));
            }
        }
        const double sign = element == 2 || element == 14 ? -1 : 1;  // k01 - i k02, k31 - i k32
        if (places[element] < 16) CHECK(sign * bands[32 + places[element]] > 0.1);
    }
}

TEST_CASE("psh: a kernel survives the angular domain, its matrix, and convolves in place") {
    struct Kernel {
        std::uint32_t order;
        Doubles bands;
    };
    const auto kernel_value = [](void* user, double theta, double* mueller) -> std::int32_t {
        const auto& kernel = *static_cast<const Kernel*>(user);
        return nicol_psh_kernel_at(kernel.order, kernel.bands.data(), kernel.bands.size(), &theta, 1, mueller,
                                   16) == NICOL_OK;
    };
    for (const std::uint32_t order : {0U, 1U, 2U, 11U}) {
        Kernel kernel{order, random_bands(order)};
        const std::size_t n = vector_size(order), bands = kernel.bands.size();
        Doubles back(bands), matrix(n * n);
        OK(nicol_psh_project_kernel(kernel_value, &kernel, order, 0, back.data(), bands));
        CHECK(largest_difference(back, kernel.bands) < 1e-13);
        OK(nicol_psh_kernel_matrix(order, kernel.bands.data(), bands, matrix.data(), matrix.size()));
        OK(nicol_psh_nearest_kernel(order, matrix.data(), matrix.size(), back.data(), bands));
        CHECK(largest_difference(back, kernel.bands) < 1e-14);
        const PshVector fields = random_fields(order, 3);
        Doubles out(fields.data().begin(), fields.data().end());
        OK(nicol_psh_convolve(order, kernel.bands.data(), bands, 3, out.data(), 3 * n, out.data(), 3 * n));
        CHECK(largest_difference(out, apply(matrix, order, order, fields.data())) < 1e-13);
        Doubles apart(3 * n);
        OK(nicol_psh_convolve(order, kernel.bands.data(), bands, 3, fields.data().data(), 3 * n, apart.data(),
                              3 * n));
        CHECK(apart == out);
    }
}

TEST_CASE("psh: every grid has the library's rows, its least size, and each vector's samples") {
    for_all({NICOL_PSH_GRID_FEJER, NICOL_PSH_GRID_CLENSHAW_CURTIS, NICOL_PSH_GRID_GAUSS_LEGENDRE},
            {0U, 1U, 2U, 9U, 30U}, [](nicol_psh_grid grid, std::uint32_t order) {
                CAPTURES(grid, order);
                const Owned transform(make_transform(grid, order, 0.3));
                std::uint32_t rows = 0, columns = 0;
                OK(nicol_psh_transform_get_size(transform, &rows, &columns));
                CHECK(columns == 2 * order + 1);
                const bool gauss = grid == NICOL_PSH_GRID_GAUSS_LEGENDRE;
                const std::uint32_t least = grid == NICOL_PSH_GRID_CLENSHAW_CURTIS ? 2 : 1;
                REQUIRE(rows == (gauss ? order + 1 : std::max(2 * order + 1, least)));
                const auto count = static_cast<int>(rows);
                const nicol::LatitudeRows wanted = gauss        ? nicol::gauss_legendre_rows(count)
                                                   : least == 2 ? nicol::clenshaw_curtis_rows(count)
                                                                : nicol::fejer_rows(count);
                Doubles theta(rows), weight(rows);
                OK(nicol_psh_transform_get_rows(transform, theta.data(), weight.data(), rows));
                CHECK(theta == wanted.theta);
                CHECK(weight == wanted.weight);
                const PshVector fields = random_fields(order, 3);
                const std::size_t size = std::size_t{4} * rows * columns;
                Doubles samples(3 * size), single(size), back(fields.data().size());
                OK(nicol_psh_synthesize(transform, 3, fields.data().data(), back.size(), samples.data(),
                                        samples.size()));
                nicol::PshTransform library(static_cast<int>(order), wanted, static_cast<int>(columns), 0.3);
                for (int v = 0; v < 3; ++v) {
                    library.synthesize(fields.channel(v), single);
                    CHECK(largest_difference(single, std::span(samples).subspan(
                                                         static_cast<std::size_t>(v) * size, size)) < 1e-12);
                }
                OK(nicol_psh_analyze(transform, 3, samples.data(), samples.size(), back.data(), back.size()));
                CHECK(largest_difference(fields.data(), back) < 1e-13);
            });
}

TEST_CASE("psh: calls of many threads on one transform run one after another") {
    const std::uint32_t order = 16;
    const Owned transform(make_transform(NICOL_PSH_GRID_GAUSS_LEGENDRE, order));
    const PshVector fields = random_fields(order, 4);
    Doubles errors(4, 1);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            const std::span<const double> field = fields.channel(t);
            Doubles samples(std::size_t{4} * 17 * 33), back(field.size());
            double most = 0;
            for (int i = 0; i < 50; ++i) {
                const bool ok = nicol_psh_synthesize(transform, 1, field.data(), field.size(), samples.data(),
                                                     samples.size()) == NICOL_OK &&
                                nicol_psh_analyze(transform, 1, samples.data(), samples.size(), back.data(),
                                                  back.size()) == NICOL_OK;
                most = std::max(most, ok ? largest_difference(back, field) : 1);
            }
            errors[static_cast<std::size_t>(t)] = most;
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const double error : errors) CHECK(error < 1e-13);
}

TEST_CASE("psh: an image, its file and the light of it have the same coefficients") {
    const nicol::EquirectImage stored = random_image(64, 33, 3, 1);
    std::vector<float> pixels;
    for (int i = 0; i < 64 * 33; ++i)
        for (int c = 0; c < 3; ++c) {
            const auto s = stored.at(c, i / 64, i % 64);
            pixels.insert(pixels.end(), s.begin(), s.end());
        }
    const nicol_image image = image_of(pixels, 64, 33, 3);
    const TemporaryFolder folder;
    const std::string path = folder.file("image.exr");
    nicol::write_exr(path, stored);
    std::uint32_t channels = 0;
    OK(nicol_psh_project_file(path.c_str(), 5, &channels, nullptr, 0));
    CHECK(channels == 3);
    const PshVector wanted = nicol::image_environment(stored)->project(5);
    Doubles of_file(3 * vector_size(5)), of_image(of_file.size());
    OK(nicol_psh_project_file(path.c_str(), 5, nullptr, of_file.data(), of_file.size()));
    OK(nicol_psh_project_image(&image, 5, of_image.data(), of_image.size()));
    CHECK(of_file == of_image);
    CHECK(largest_difference(of_file, wanted.data()) < 1e-13);
}
