// SPDX-License-Identifier: MIT
// Expansion of light into coefficients, and operations on single vectors of coefficients.
#include <complex>
#include <vector>

#include "handles.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/product.hpp"
#include "harmonics/rotation.hpp"
#include "psh_arguments.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

void project(const Environment& light, std::uint32_t order, double* coefficients, std::uint64_t count) {
    const int highest = read_order(order, "order");
    const auto channels = static_cast<std::uint64_t>(light.channels());
    const auto out = write_array(coefficients, count, channels, vector_size(highest), "coefficients");
    const PshVector projected = light.project(highest);
    std::ranges::copy(projected.data(), out.begin());
}

glm::dmat3 read_rotation(const double* rows) {
    require(rows, "rotation");
    glm::dmat3 m;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) m[column][row] = rows[3 * row + column];
    return m;
}

std::vector<glm::dvec3> read_directions(std::span<const double> values) {
    std::vector<glm::dvec3> out;
    out.reserve(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        out.emplace_back(values[i], values[i + 1], values[i + 2]);
        if (out.back() == glm::dvec3(0)) refuse("direction " + std::to_string(i / 3) + " is zero");
    }
    return out;
}

}  // namespace

nicol_result nicol_psh_project_image(const nicol_image* image, uint32_t order, double* coefficients,
                                     uint64_t count) {
    return guarded([&] {
        const ImagePixels pixels = read_image(image);
        const int highest = read_order(order, "order");
        const auto channels = static_cast<std::uint64_t>(pixels.view.channels);
        const auto out = write_array(coefficients, count, channels, vector_size(highest), "coefficients");
        const PshVector projected = project_image(pixels.view, highest);
        std::ranges::copy(projected.data(), out.begin());
    });
}

nicol_result nicol_psh_project_environment(nicol_environment environment, uint32_t order,
                                           double* coefficients, uint64_t count) {
    return guarded([&] {
        const nicol_environment_impl& self = resolve(environment);
        WorkerPool(self.session->workers).run([&] { project(*self.content, order, coefficients, count); });
    });
}

nicol_result nicol_psh_project_file(const char* path, uint32_t order, uint32_t* channels,
                                    double* coefficients, uint64_t count) {
    return guarded([&] {
        require(path, "path");
        (void)read_order(order, "order");
        const EnvironmentPtr light = load_environment(path);
        if (coefficients != nullptr || count != 0) project(*light, order, coefficients, count);
        if (channels != nullptr) *channels = static_cast<std::uint32_t>(light->channels());
    });
}

nicol_result nicol_psh_evaluate(uint32_t order, uint64_t vectors, const double* coefficients,
                                uint64_t coefficient_count, const double* directions,
                                uint64_t direction_count, double* stokes, uint64_t stokes_count) {
    return guarded([&] {
        const int highest = read_order(order, "order");
        const std::size_t size = vector_size(highest);
        const auto fields = read_array(coefficients, coefficient_count, vectors, size, "coefficients");
        const std::uint64_t points = direction_count / 3;
        const auto towards =
            read_directions(read_array(directions, direction_count, points, 3, "directions"));
        const auto out = write_array(stokes, stokes_count, vectors, 4 * points, "stokes");
        if (out.empty()) return;
        if (vectors == 1) {
            PshVector field(highest, 1);
            std::ranges::copy(fields, field.data().begin());
            std::vector<Stokes> values(points);
            evaluate(field, 0, towards, values);
            for (std::size_t i = 0; i < points; ++i)
                for (std::size_t p = 0; p < 4; ++p) out[4 * i + p] = values[i][static_cast<int>(p)];
            return;
        }
        // All vectors share the harmonics of a direction.
        std::vector<double> scalar(psh_count(highest));
        std::vector<std::complex<double>> spin2(scalar.size());
        std::vector<double> sums(4 * vectors * points);
        for (std::size_t i = 0; i < points; ++i) {
            harmonics_at(highest, towards[i], scalar, spin2);
            for (std::size_t v = 0; v < vectors; ++v) {
                const double* f = fields.data() + v * size;
                Stokes s(0);
                for (std::size_t k = 0; k < scalar.size(); ++k, f += 4) {
                    s[0] += scalar[k] * f[0];
                    s[1] += spin2[k].real() * f[1] - spin2[k].imag() * f[2];
                    s[2] += spin2[k].real() * f[2] + spin2[k].imag() * f[1];
                    s[3] += scalar[k] * f[3];
                }
                for (std::size_t p = 0; p < 4; ++p) sums[4 * (v * points + i) + p] = s[static_cast<int>(p)];
            }
        }
        std::ranges::copy(sums, out.begin());
    });
}

nicol_result nicol_psh_rotate(uint32_t order, uint64_t vectors, const double* in, uint64_t in_count,
                              const double rotation[9], double* out, uint64_t out_count) {
    return guarded([&] {
        const int highest = read_order(order, "order");
        const auto from = read_array(in, in_count, vectors, vector_size(highest), "in");
        const auto to = write_array(out, out_count, vectors, vector_size(highest), "out");
        require_same_or_apart(from, to, "in and out");
        const PshRotation by(highest, read_rotation(rotation));
        if (!from.empty()) by.apply(from, to);
    });
}

nicol_result nicol_psh_reflect(uint32_t order, uint64_t vectors, const double* in, uint64_t in_count,
                               double* out, uint64_t out_count) {
    return guarded([&] {
        const int highest = read_order(order, "order");
        const auto from = read_array(in, in_count, vectors, vector_size(highest), "in");
        const auto to = write_array(out, out_count, vectors, vector_size(highest), "out");
        require_same_or_apart(from, to, "in and out");
        const std::size_t size = vector_size(highest);
        PshVector field(highest, 1);
        for (std::size_t first = 0; first < from.size(); first += size) {
            std::ranges::copy(from.subspan(first, size), field.data().begin());
            const PshVector mirrored = reflected(field);
            std::ranges::copy(mirrored.data(), to.begin() + static_cast<std::ptrdiff_t>(first));
        }
    });
}

nicol_result nicol_psh_multiply(uint32_t scalar_order, const double* scalar, uint64_t scalar_count,
                                uint32_t order, uint64_t vectors, const double* in, uint64_t in_count,
                                uint32_t order_out, double* out, uint64_t out_count) {
    return guarded([&] {
        const int scalar_highest = read_order(scalar_order, "scalar_order");
        const int highest = read_order(order, "order");
        const int highest_out = read_order(order_out, "order_out");
        const auto factor = read_array(scalar, scalar_count, 1, psh_count(scalar_highest), "scalar");
        const auto from = read_array(in, in_count, vectors, vector_size(highest), "in");
        const auto to = write_array(out, out_count, vectors, vector_size(highest_out), "out");
        require_same_or_apart(from, to, "in and out");
        require_apart(factor, to, "scalar and out");
        if (from.empty()) return;
        PshProduct product(scalar_highest, highest, highest_out);
        for (std::size_t v = 0; v < vectors; ++v) {
            product.multiply(factor, from.subspan(v * vector_size(highest), vector_size(highest)),
                             to.subspan(v * vector_size(highest_out), vector_size(highest_out)));
        }
    });
}
