// SPDX-License-Identifier: MIT
// The mathematics across the border: layouts, batches and outputs in place of inputs. What the functions
// compute is tested in tests/harmonics.
#include <algorithm>
#include <thread>

#include "image/stokes_image.hpp"
#include "psh_sky.hpp"

using namespace capi_test;

namespace {

struct Size {
    std::uint32_t rows = 0, columns = 0;
    [[nodiscard]] std::size_t samples() const { return std::size_t{4} * rows * columns; }
};

Size size_of(nicol_psh_transform transform) {
    Size size;
    OK(nicol_psh_transform_get_size(transform, &size.rows, &size.columns));
    return size;
}

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

/// Depends on both heights and on the angle between the azimuths.
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

TEST_CASE("psh: coefficients stand where the header says, with the header's signs") {
    std::mt19937 random(1);
    for (int trial = 0; trial < 20; ++trial) {
        const Vec3 w = random_direction(random);
        const auto at = [&](int l, int m, int p) {
            Doubles f(vector_size(2));
            f[position(l, m, p)] = 1;
            return value(2, f.data(), w);
        };
        for (const int p : {0, 3})
            CHECK(at(1, -1, p)[static_cast<std::size_t>(p)] ==
                  doctest::Approx(-std::sqrt(3 / (4 * pi)) * w[1]));
        const auto wanted =
            std::polar(std::sqrt(5 / (4 * pi)) * std::pow((1 - w[2]) / 2, 2), 2 * std::atan2(w[1], w[0]));
        const auto real = at(2, 2, 1), imaginary = at(2, 2, 2);  // the coefficients 1 and i
        CHECK(std::abs(std::complex(real[1], real[2]) - wanted) < 1e-14);
        CHECK(std::abs(std::complex(imaginary[2], -imaginary[1]) - wanted) < 1e-14);
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

TEST_CASE(
    "psh: fields are rotated by row-major matrices and reflected in z = 0, each vector, also in place") {
    std::mt19937 random(3);
    const std::uint32_t order = 12;
    const Doubles fields = random_fields(random, order, 2);
    const Rotation rotation = random_rotation(random);
    Doubles rotated(fields.size()), mirrored(fields.size());
    OK(nicol_psh_rotate(order, 2, fields.data(), fields.size(), rotation.data(), rotated.data(),
                        rotated.size()));
    OK(nicol_psh_reflect(order, 2, fields.data(), fields.size(), mirrored.data(), mirrored.size()));
    for (std::size_t v = 0; v < 2; ++v)
        for (int trial = 0; trial < 20; ++trial) {
            const Vec3 w = random_direction(random);
            const std::size_t at = v * vector_size(order);
            const auto s = value(order, fields.data() + at, w);
            const auto wanted = in_theta_phi(s.data(), rotation * theta_phi(w)[0], rotation * w);
            const auto now = value(order, rotated.data() + at, rotation * w);
            const auto t = value(order, mirrored.data() + at, {w[0], w[1], -w[2]});
            for (std::size_t p = 0; p < 4; ++p) {
                CHECK(std::abs(now[p] - wanted[p]) < 1e-11);
                // A mirror keeps the lengths along both axes and reverses every sense of rotation.
                CHECK(std::abs(t[p] - (p < 2 ? s[p] : -s[p])) < 1e-12);
            }
        }
    OK(nicol_psh_reflect(order, 2, mirrored.data(), fields.size(), mirrored.data(), mirrored.size()));
    CHECK(mirrored == fields);
    Doubles& back = rotated;
    OK(nicol_psh_rotate(order, 2, back.data(), back.size(), transposed(rotation).data(), back.data(),
                        back.size()));
    CHECK(difference(back, fields) < 1e-13);
}

TEST_CASE("psh: a product is the product at every direction, cut, in place and as a matrix") {
    std::mt19937 random(6);
    const std::uint32_t scalar_order = 5, order = 8, order_out = scalar_order + order;
    const Doubles scalar = random_numbers(random, 36);
    const Doubles fields = random_fields(random, order, 2);
    const auto multiply = [&](const Doubles& in, std::uint32_t out, double* to) {
        OK(nicol_psh_multiply(scalar_order, scalar.data(), scalar.size(), order, 2, in.data(), in.size(), out,
                              to, 2 * vector_size(out)));
    };
    Doubles product(2 * vector_size(order_out)), scalar_field(vector_size(scalar_order));
    multiply(fields, order_out, product.data());
    for (std::size_t i = 0; i < scalar.size(); ++i) scalar_field[4 * i] = scalar[i];
    for (std::size_t v = 0; v < 2; ++v)
        for (int trial = 0; trial < 20; ++trial) {
            const Vec3 w = random_direction(random);
            const double factor = value(scalar_order, scalar_field.data(), w)[0];
            const auto s = value(order, fields.data() + v * vector_size(order), w);
            const auto t = value(order_out, product.data() + v * vector_size(order_out), w);
            for (std::size_t p = 0; p < 4; ++p) CHECK(std::abs(t[p] - factor * s[p]) < 1e-11);
        }
    Doubles cut = fields;
    multiply(cut, order, cut.data());
    for (std::size_t v = 0; v < 2; ++v)
        for (std::size_t i = 0; i < vector_size(order); ++i)
            CHECK(std::abs(cut[v * vector_size(order) + i] - product[v * vector_size(order_out) + i]) <
                  1e-12);
    Doubles low(2 * vector_size(5));
    multiply(fields, 5, low.data());
    CHECK(difference(apply(shadow_matrix(scalar_order, scalar, 5, order), 5, order, fields), low) < 1e-13);
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

TEST_CASE("psh: the parts of a Mueller matrix stand in a band where the header says") {
    // Position in the band of each element of the matrix, by rows; the four in the middle mix two parts each.
    const std::size_t places[16] = {0, 8, 9, 1, 4, 16, 16, 6, 5, 16, 16, 7, 2, 10, 11, 3};
    for (std::size_t element = 0; element < 16; ++element) {
        CAPTURE(element);
        // max(cos, 0) has pi, 2 pi / 3, pi / 4, 0 times the harmonic's norm (Ramamoorthi and Hanrahan).
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
            } else if (element == 0 || element == 3 || element == 12 || element == 15) {
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
    std::mt19937 random(4);
    for (const std::uint32_t order : {0U, 1U, 2U, 11U}) {
        Kernel kernel{order, random_bands(random, order)};
        const std::size_t n = vector_size(order), bands = kernel.bands.size();
        Doubles back(bands), matrix(n * n);
        OK(nicol_psh_project_kernel(kernel_value, &kernel, order, 0, back.data(), bands));
        CHECK(difference(back, kernel.bands) < 1e-13);
        OK(nicol_psh_kernel_matrix(order, kernel.bands.data(), bands, matrix.data(), matrix.size()));
        OK(nicol_psh_nearest_kernel(order, matrix.data(), matrix.size(), back.data(), bands));
        CHECK(difference(back, kernel.bands) < 1e-14);
        const Doubles fields = random_fields(random, order, 3);
        Doubles out(3 * n);
        OK(nicol_psh_convolve(order, kernel.bands.data(), bands, 3, fields.data(), 3 * n, out.data(), 3 * n));
        CHECK(difference(out, apply(matrix, order, order, fields)) < 1e-13);
        Doubles replaced = fields;
        OK(nicol_psh_convolve(order, kernel.bands.data(), bands, 3, replaced.data(), 3 * n, replaced.data(),
                              3 * n));
        CHECK(replaced == out);
    }
}

TEST_CASE("psh: coefficients survive every grid, whose samples are the field at its rows and columns") {
    std::mt19937 random(1);
    for (const nicol_psh_grid grid :
         {NICOL_PSH_GRID_FEJER, NICOL_PSH_GRID_CLENSHAW_CURTIS, NICOL_PSH_GRID_GAUSS_LEGENDRE})
        for (const std::uint32_t order : {0U, 1U, 2U, 9U, 30U}) {
            CAPTURE(grid);
            CAPTURE(order);
            const double phi0 = 0.3;
            const nicol_psh_transform transform = make_transform(grid, order, 0, 0, phi0);
            const Size size = size_of(transform);
            CHECK(size.columns == 2 * order + 1);
            if (grid == NICOL_PSH_GRID_GAUSS_LEGENDRE)
                CHECK(size.rows == order + 1);
            else
                CHECK(size.rows == std::max(2 * order + 1, grid == NICOL_PSH_GRID_FEJER ? 1U : 2U));
            const Doubles fields = random_fields(random, order, 3);
            Doubles samples(3 * size.samples()), back(fields.size());
            OK(nicol_psh_synthesize(transform, 3, fields.data(), fields.size(), samples.data(),
                                    samples.size()));
            OK(nicol_psh_analyze(transform, 3, samples.data(), samples.size(), back.data(), back.size()));
            CHECK(difference(fields, back) < 1e-13);

            Doubles theta(size.rows), weight(size.rows);
            OK(nicol_psh_transform_get_rows(transform, theta.data(), weight.data(), size.rows));
            CHECK(std::ranges::is_sorted(theta));
            double sum = 0;
            for (const double w : weight) sum += w;
            CHECK(sum == doctest::Approx(2).epsilon(1e-14));
            if (grid == NICOL_PSH_GRID_FEJER) CHECK(theta[0] == doctest::Approx(pi / (2 * size.rows)));
            if (grid == NICOL_PSH_GRID_CLENSHAW_CURTIS) CHECK(theta[0] == 0);
            if (order == 9) {
                for (std::size_t j = 0; j < size.rows; ++j)
                    for (std::size_t c = 0; c < size.columns; ++c) {
                        if (std::sin(theta[j]) < 1e-6) continue;  // there phi is that of the column
                        const double phi = phi0 + 2 * pi * static_cast<double>(c) / size.columns;
                        const auto s = value(order, fields.data(), direction(theta[j], phi));
                        for (std::size_t p = 0; p < 4; ++p)
                            CHECK(std::abs(samples[4 * (j * size.columns + c) + p] - s[p]) < 1e-12);
                    }
            }
            OK(nicol_psh_transform_release(transform));
        }
}

TEST_CASE("psh: calls of many threads on one transform run one after another") {
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

TEST_CASE("psh: an image and a file of a polarized sky are that sky, in every channel") {
    const std::vector<float> pixels = sky_image(512, 257, 3);
    const nicol_image image = image_of(pixels, 512, 257, 3);
    for (const std::uint32_t order : {2U, 6U}) {
        Doubles f(3 * vector_size(order));
        OK(nicol_psh_project_image(&image, order, f.data(), f.size()));
        CHECK(difference_from_sky(order, f.data()) < 2e-4);
        for (std::size_t i = 0; i < vector_size(order); ++i) {
            CHECK(std::abs(f[vector_size(order) + i] - 2 * f[i]) < 1e-5);
            CHECK(std::abs(f[2 * vector_size(order) + i] - 3 * f[i]) < 1e-5);
        }
    }

    const TemporaryFolder folder;
    nicol::StokesImage stored(512, 257, 3);
    for (std::size_t i = 0; i < 512 * 257; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(4 * (3 * i + c)), 4,
                        stored.data.begin() + static_cast<std::ptrdiff_t>(4 * (c * 512 * 257 + i)));
    const std::string path = folder.file("sky.exr");
    nicol::write_exr(path, stored);
    std::uint32_t channels = 0;
    OK(nicol_psh_project_file(path.c_str(), 5, &channels, nullptr, 0));
    CHECK(channels == 3);
    Doubles of_file(3 * vector_size(5)), of_image(of_file.size());
    OK(nicol_psh_project_file(path.c_str(), 5, nullptr, of_file.data(), of_file.size()));
    OK(nicol_psh_project_image(&image, 5, of_image.data(), of_image.size()));
    CHECK(of_file == of_image);
}
