// SPDX-License-Identifier: MIT
#include "harmonics/convolution.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "harmonics/isotropic_lanes.hpp"
#include "harmonics/spin_harmonics.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

double band_scale(std::size_t l) {
    return std::sqrt(4 * pi / (2 * static_cast<double>(l) + 1));
}

int order_of(const ConvolutionKernel& kernel) {
    require(!kernel.empty(), "the kernel has no bands");
    const int order = static_cast<int>(kernel.size()) - 1;
    require_order(order);
    for (const KernelBand& k : kernel) {
        // The numbers are finite if their sum is.
        const Complex sum =
            k.k00 + k.k03 + k.k30 + k.k33 + k.p0 + k.p3 + k.from_p0 + k.from_p3 + k.iso + k.conj;
        require(std::isfinite(sum.real()) && std::isfinite(sum.imag()), "the kernel is not finite");
    }
    return order;
}

/// Returns the block of a band for the four lanes of degree m (Eq. 69), without the scale of the band. The
/// real part that Eq. 235 takes of a complex scalar field is half the sum of the field and its conjugate.
IsotropicMatrix::Block block_of(const KernelBand& k, int m) {
    const double sign = parity(m);
    return {k.k00,
            k.k03,
            0.5 * k.from_p0,
            0.5 * sign * std::conj(k.from_p0),
            k.k30,
            k.k33,
            0.5 * k.from_p3,
            0.5 * sign * std::conj(k.from_p3),
            k.p0,
            k.p3,
            k.iso,
            sign * k.conj,
            sign * std::conj(k.p0),
            sign * std::conj(k.p3),
            sign * std::conj(k.conj),
            std::conj(k.iso)};
}

/// Returns the band for which block_of() gives this block at m = 0.
KernelBand band_of(const IsotropicMatrix::Block& b) {
    return {b[0].real(), b[1].real(), b[4].real(), b[5].real(), b[8],
            b[9],        2.0 * b[2],  2.0 * b[6],  b[10],       b[11]};
}

/// Values, by l, of the four harmonics in which a kernel is expanded, at one angle.
struct KernelHarmonics {
    std::vector<double> scalar, spin2;

    KernelHarmonics(int order, double sin_half, double cos_half)
        : scalar(psh_count(order)), spin2(psh_count(order)) {
        spin_harmonics(0, order, sin_half, cos_half, scalar);
        spin_harmonics(2, order, sin_half, cos_half, spin2);
    }
};

}  // namespace

ConvolutionKernel project_kernel(const KernelFunction& kernel, int order, const LatitudeRows& rows) {
    require_order(order);
    ConvolutionKernel out(static_cast<std::size_t>(order) + 1);
    for (std::size_t j = 0; j < rows.theta.size(); ++j) {
        const Mueller k = kernel(rows.theta[j]);
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b)
                require(std::isfinite(k(a, b)),
                        "the kernel is not finite at " + std::to_string(rows.theta[j]));
        const KernelHarmonics y(order, rows.sin_half[j], rows.cos_half[j]);
        const double weight = 2 * pi * rows.weight[j];
        for (int l = 0; l <= order; ++l) {
            KernelBand& band = out[static_cast<std::size_t>(l)];
            const double zonal = weight * y.scalar[psh_index(l, 0)];
            band.k00 += zonal * k(0, 0);
            band.k03 += zonal * k(0, 3);
            band.k30 += zonal * k(3, 0);
            band.k33 += zonal * k(3, 3);
            if (l < 2) continue;
            const double into = weight * y.spin2[psh_index(l, 0)];
            const double from = weight * y.scalar[psh_index(l, -2)];
            band.p0 += into * Complex(k(1, 0), k(2, 0));
            band.p3 += into * Complex(k(1, 3), k(2, 3));
            band.from_p0 += from * Complex(k(0, 1), -k(0, 2));
            band.from_p3 += from * Complex(k(3, 1), -k(3, 2));
            band.iso +=
                0.5 * weight * y.spin2[psh_index(l, -2)] * Complex(k(1, 1) + k(2, 2), k(2, 1) - k(1, 2));
            band.conj +=
                0.5 * weight * y.spin2[psh_index(l, 2)] * Complex(k(1, 1) - k(2, 2), k(2, 1) + k(1, 2));
        }
    }
    return out;
}

Mueller kernel_at(const ConvolutionKernel& kernel, double theta) {
    const int order = order_of(kernel);
    require(theta >= 0 && theta <= pi, "theta is " + std::to_string(theta) + ", expected 0 to pi");
    const KernelHarmonics y(order, std::sin(theta / 2), std::cos(theta / 2));
    KernelBand sum;
    for (int l = 0; l <= order; ++l) {
        const KernelBand& band = kernel[static_cast<std::size_t>(l)];
        const double zonal = y.scalar[psh_index(l, 0)];
        sum.k00 += zonal * band.k00;
        sum.k03 += zonal * band.k03;
        sum.k30 += zonal * band.k30;
        sum.k33 += zonal * band.k33;
        if (l < 2) continue;
        sum.p0 += y.spin2[psh_index(l, 0)] * band.p0;
        sum.p3 += y.spin2[psh_index(l, 0)] * band.p3;
        sum.from_p0 += y.scalar[psh_index(l, -2)] * band.from_p0;
        sum.from_p3 += y.scalar[psh_index(l, -2)] * band.from_p3;
        sum.iso += y.spin2[psh_index(l, -2)] * band.iso;
        sum.conj += y.spin2[psh_index(l, 2)] * band.conj;
    }
    const Complex i = sum.iso;
    const Complex c = sum.conj;
    return Mueller({sum.k00, sum.from_p0.real(), -sum.from_p0.imag(), sum.k03,  //
                    sum.p0.real(), i.real() + c.real(), c.imag() - i.imag(), sum.p3.real(), sum.p0.imag(),
                    i.imag() + c.imag(), i.real() - c.real(), sum.p3.imag(), sum.k30, sum.from_p3.real(),
                    -sum.from_p3.imag(), sum.k33});
}

void convolve(const ConvolutionKernel& kernel, std::span<const double> in, std::span<double> out) {
    const int highest = order_of(kernel);
    require_size(out.size(), in.size(), "out");
    int order = 0;
    while (order < highest && 4 * psh_count(order) < in.size()) ++order;
    require_size(in.size(), 4 * psh_count(order), "in, for a kernel of this order,");
    for (int l = 0; l <= order; ++l) {
        const KernelBand& band = kernel[static_cast<std::size_t>(l)];
        const double scale = band_scale(static_cast<std::size_t>(l));
        for (int m = 0; m <= l; ++m) {
            const IsotropicMatrix::Block block = block_of(band, m);
            const IsotropicLanes lanes = load_lanes(in, l, m);
            IsotropicLanes sum{};
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = 0; b < 4; ++b) multiply_add(sum[a], scale * block[4 * a + b], lanes[b]);
            store_lanes(sum, out, l, m);
        }
    }
}

PshVector convolved(const ConvolutionKernel& kernel, const PshVector& field) {
    require_finite(field.data(), "field");
    PshVector out = field;
    for (int c = 0; c < field.channels(); ++c) convolve(kernel, field.channel(c), out.channel(c));
    return out;
}

ConvolutionKernel compose(const ConvolutionKernel& second, const ConvolutionKernel& first) {
    require(second.size() == first.size(), "the kernels differ in order");
    ConvolutionKernel out(first.size());
    for (std::size_t l = 0; l < out.size(); ++l) {
        // Degree 0 determines the whole band.
        const IsotropicMatrix::Block x = block_of(second[l], 0);
        const IsotropicMatrix::Block y = block_of(first[l], 0);
        IsotropicMatrix::Block z{};
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t b = 0; b < 4; ++b)
                    multiply_add(z[4 * a + b], band_scale(l) * x[4 * a + c], y[4 * c + b]);
        out[l] = band_of(z);
    }
    return out;
}

IsotropicMatrix kernel_matrix(const ConvolutionKernel& kernel) {
    const int order = order_of(kernel);
    IsotropicMatrix out(order, order);
    for (int m = 0; m <= order; ++m)
        for (int l = m; l <= order; ++l) {
            IsotropicMatrix::Block& block = out.block(m, l, l);
            block = block_of(kernel[static_cast<std::size_t>(l)], m);
            for (Complex& value : block) value *= band_scale(static_cast<std::size_t>(l));
        }
    return out;
}

ConvolutionKernel nearest_kernel(const CoefficientMatrix& matrix) {
    const int order = matrix.order_out();
    require(order >= 0 && order == matrix.order_in(), "the matrix must have one order on both sides");
    ConvolutionKernel out(static_cast<std::size_t>(order) + 1);
    const double half = std::numbers::sqrt2 / 2;
    for (int l = 0; l <= order; ++l) {
        KernelBand& band = out[static_cast<std::size_t>(l)];
        for (int m = -l; m <= l; ++m) {
            const std::size_t i = 4 * psh_index(l, m);
            const std::size_t j = 4 * psh_index(l, -m);
            band.k00 += matrix(i, i);
            band.k03 += matrix(i, i + 3);
            band.k30 += matrix(i + 3, i);
            band.k33 += matrix(i + 3, i + 3);
            if (l < 2) continue;
            // The complex scalar coefficient at m is same * real_m + other * real_-m.
            const double sign = m < 0 ? parity(m) : 1;
            const Complex same = m == 0 ? 1 : m > 0 ? Complex(half) : Complex(0, sign * half);
            const Complex other = m == 0 ? 0 : m > 0 ? Complex(0, -half) : Complex(sign * half);
            const auto into = [&](std::size_t scalar) {
                return std::conj(same) * Complex(matrix(i + 1, i + scalar), matrix(i + 2, i + scalar)) +
                       std::conj(other) * Complex(matrix(i + 1, j + scalar), matrix(i + 2, j + scalar));
            };
            const auto from = [&](std::size_t scalar) {
                return same * Complex(matrix(i + scalar, i + 1), -matrix(i + scalar, i + 2)) +
                       other * Complex(matrix(j + scalar, i + 1), -matrix(j + scalar, i + 2));
            };
            band.p0 += into(0);
            band.p3 += into(3);
            band.from_p0 += from(0);
            band.from_p3 += from(3);
            band.iso += 0.5 * Complex(matrix(i + 1, i + 1) + matrix(i + 2, i + 2),
                                      matrix(i + 2, i + 1) - matrix(i + 1, i + 2));
            band.conj += 0.5 * parity(m) *
                         Complex(matrix(i + 1, j + 1) - matrix(i + 2, j + 2),
                                 matrix(i + 2, j + 1) + matrix(i + 1, j + 2));
        }
        const double mean = 1 / ((2 * l + 1) * band_scale(static_cast<std::size_t>(l)));
        for (double* value : {&band.k00, &band.k03, &band.k30, &band.k33}) *value *= mean;
        for (Complex* value : {&band.p0, &band.p3, &band.from_p0, &band.from_p3, &band.iso, &band.conj})
            *value *= mean;
    }
    return out;
}

}  // namespace nicol
