// SPDX-License-Identifier: MIT
// Figure 17: a pBRDF averaged over the surface's normals approaches the constraints of a convolution.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "experiment.hpp"
#include "field.hpp"
#include "image.hpp"

namespace {

constexpr std::uint32_t kOrder = 4;
const std::size_t n = vector_size(kOrder);

/// Evaluates rough glass: Fresnel reflection at the half vector times a lobe about the normal +z, and a
/// depolarizing base. Both cosines are included, so the value vanishes at the horizon.
std::int32_t rough_glass(void*, const double in[3], const double out[3], double mueller[16]) {
    if (in[2] >= 0 || out[2] <= 0) return 1;
    const Vec3 i = {in[0], in[1], in[2]}, o = {out[0], out[1], out[2]};
    const double cosines = -i[2] * o[2];
    mueller[0] = 0.1 * cosines;
    const Vec3 h = unit({o[0] - i[0], o[1] - i[1], o[2] - i[2]});
    const Vec3 s = cross(i, h);
    if (dot(s, s) < 1e-20) return 1;
    const double c = dot(o, h), ior = 1.5;
    const double t = std::sqrt(ior * ior - 1 + c * c);  // ior times the cosine of refraction
    const double rs = (c - t) / (c + t), rp = (ior * ior * c - t) / (ior * ior * c + t);
    const double lobe = cosines * std::exp(8 * (h[2] - 1));
    const double a = lobe * (rs * rs + rp * rp) / 2, b = lobe * (rs * rs - rp * rp) / 2, d = lobe * rs * rp;
    // e and f rotate from the frames with x along s to the theta-phi frames.
    const std::complex<double> e = frame_phase(unit(s), i), f = frame_phase(unit(s), o);
    mueller[0] += a;
    mueller[1] = b * e.real();
    mueller[2] = b * e.imag();
    mueller[4] = b * f.real();
    mueller[8] = b * f.imag();
    // The linear block is diag(a, d) between the rotations by conj(e) and f.
    const double ce = e.real(), se = e.imag(), cf = f.real(), sf = f.imag();
    mueller[5] = cf * a * ce + sf * d * se;
    mueller[6] = cf * a * se - sf * d * ce;
    mueller[9] = sf * a * ce - cf * d * se;
    mueller[10] = sf * a * se + cf * d * ce;
    mueller[15] = d;
    return 1;
}

/// Returns R M R^-1, column by column.
Doubles rotated(const Doubles& matrix, const Rotation& rotation) {
    Doubles units(n * n);
    for (std::size_t j = 0; j < n; ++j) units[j * n + j] = 1;
    const Doubles from = rotate(kOrder, units, transposed(rotation));
    Doubles to(n * n);
    check(nicol_psh_apply_matrix(kOrder, kOrder, matrix.data(), matrix.size(), n, from.data(), from.size(),
                                 to.data(), to.size()));
    to = rotate(kOrder, to, rotation);
    Doubles out(n * n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) out[i * n + j] = to[j * n + i];
    return out;
}

/// Returns the mean over normals on a grid of size x 2 size; size 0 keeps the single normal +z.
Doubles average(const Doubles& matrix, nicol_psh_grid kind, std::uint32_t size) {
    if (size == 0) return matrix;
    const Grid normals(kind, 0, size, 2 * size);
    Doubles sum(n * n);
    for (std::size_t k = 0; k < normals.points(); ++k) {
        const double theta = normals.theta[k / normals.columns], phi = normals.phi(k % normals.columns);
        const Vec3 x = theta_hat(theta, phi), y = phi_hat(phi), z = direction(theta, phi);
        const Doubles m = rotated(matrix, {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]});
        const double weight = normals.solid_angle(k / normals.columns) / (4 * pi);
        for (std::size_t i = 0; i < m.size(); ++i) sum[i] += weight * m[i];
    }
    return sum;
}

/// RMS distance to the nearest convolution in blocks of spins, divided by the RMS of the matrix.
struct Errors {
    double from_0_to_0, from_0_to_2, from_2_to_0, from_2_to_2, other_degrees;
};

Errors errors_of(const Doubles& matrix, double scale) {
    Doubles bands(NICOL_PSH_BAND_SIZE * (kOrder + 1)), nearest(n * n);
    check(nicol_psh_nearest_kernel(kOrder, matrix.data(), matrix.size(), bands.data(), bands.size()));
    check(nicol_psh_kernel_matrix(kOrder, bands.data(), bands.size(), nearest.data(), nearest.size()));
    double sum[5] = {}, count[5] = {};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const auto degree = [](std::size_t k) {
                const auto l = static_cast<int>(std::sqrt(static_cast<double>(k / 4) + 0.5));
                return std::abs(static_cast<int>(k / 4) - l * l - l);
            };
            const auto spin2 = [](std::size_t k) { return k % 4 == 1 || k % 4 == 2; };
            if ((spin2(i) && i < 16) || (spin2(j) && j < 16)) continue;
            const std::size_t block =
                degree(i) != degree(j) ? 4 : (spin2(i) ? 1U : 0U) + (spin2(j) ? 2U : 0U);
            const double d = matrix[i * n + j] - nearest[i * n + j];
            sum[block] += d * d;
            ++count[block];
        }
    const auto rms = [&](std::size_t k) { return std::sqrt(sum[k] / count[k]) / scale; };
    return {rms(0), rms(1), rms(2), rms(3), rms(4)};
}

}  // namespace

void figure_17(Experiment& experiment) {
    nicol_psh_mueller_field field = NICOL_PSH_MUELLER_FIELD_INIT;
    field.isotropic = 1;
    field.order_out = field.order_in = kOrder;
    field.rows_out = field.rows_in = 48;
    field.columns_in = 64;
    field.callback = rough_glass;
    Doubles matrix(n * n);
    check(nicol_psh_project_matrix(&field, matrix.data(), matrix.size()));
    double sum = 0;
    for (const double x : matrix) sum += x * x;
    const double scale = std::sqrt(sum) / static_cast<double>(n);

    Image image(4);
    double worst_exact = 0, unaveraged = 0;
    for (const nicol_psh_grid kind : std::initializer_list<nicol_psh_grid>{NICOL_PSH_GRID_CLENSHAW_CURTIS,
                                                                           NICOL_PSH_GRID_GAUSS_LEGENDRE}) {
        const bool gauss = kind == NICOL_PSH_GRID_GAUSS_LEGENDRE;
        std::printf("  rms distance to the nearest convolution, over the rms of the matrix; %s rows\n",
                    gauss ? "Gauss-Legendre" : "equally spaced");
        std::printf("  %-14s %12s %12s %12s %12s %14s\n", "normals", "0 to 0", "0 to 2", "2 to 0", "2 to 2",
                    "|mi| != |mo|");
        for (const std::uint32_t size : {0U, 2U, 3U, 4U, 5U, 6U, 8U, 12U}) {
            const Doubles averaged = average(matrix, kind, size);
            const Errors e = errors_of(averaged, scale);
            char name[32];
            std::snprintf(name, sizeof name, size == 0 ? "one" : "%u x %u", size, 2 * size);
            std::printf("  %-14s %12.2e %12.2e %12.2e %12.2e %14.2e\n", name, e.from_0_to_0, e.from_0_to_2,
                        e.from_2_to_0, e.from_2_to_2, e.other_degrees);
            const double worst =
                std::max({e.from_0_to_0, e.from_0_to_2, e.from_2_to_0, e.from_2_to_2, e.other_degrees});
            if (size >= (gauss ? kOrder + 1 : 2 * kOrder + 1)) worst_exact = std::max(worst_exact, worst);
            if (size == 0) unaveraged = worst;
            if (gauss && (size == 0 || size == 2 || size == 4 || size == 6)) {
                Panel panel{n, n, averaged};
                image.add(panel, Magnitude{10 * scale, 6});
            }
        }
    }
    experiment.claim(unaveraged > 0.01, "the pBRDF itself is no convolution");
    experiment.claim(
        worst_exact < 1e-13,
        "averaged over enough normals it is one, to rounding: Eq. 69 has all that rotation leaves");
    image.write(experiment.image("fig17_averaged_matrix.png"), 2);
}
