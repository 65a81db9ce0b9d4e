// SPDX-License-Identifier: MIT
// Convolution with rotation-equivariant kernels.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/convolution.hpp"
#include "psh_arguments.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

constexpr std::size_t kBandSize = NICOL_PSH_BAND_SIZE;

ConvolutionKernel read_kernel(const double* bands, std::uint64_t count, int order) {
    const auto bands_in_order = static_cast<std::uint64_t>(order) + 1;
    const auto values = read_array(bands, count, bands_in_order, kBandSize, "bands");
    ConvolutionKernel kernel(bands_in_order);
    for (std::size_t l = 0; l < kernel.size(); ++l) {
        const double* b = values.data() + l * kBandSize;
        if (l < 2 && std::any_of(b + 4, b + kBandSize, [](double x) { return x != 0; }))
            refuse("bands: band " + std::to_string(l) + " has a part with spin 2; it must be 0 below l = 2");
        kernel[l] = {b[0],         b[1],         b[2],           b[3],           {b[4], b[5]},
                     {b[6], b[7]}, {b[8], b[9]}, {b[10], b[11]}, {b[12], b[13]}, {b[14], b[15]}};
    }
    return kernel;
}

void write_kernel(const ConvolutionKernel& kernel, std::span<double> out) {
    auto to = out.begin();
    for (const KernelBand& b : kernel) {
        to = std::ranges::copy(std::array{b.k00, b.k03, b.k30, b.k33}, to).out;
        for (const auto& z : {b.p0, b.p3, b.from_p0, b.from_p3, b.iso, b.conj}) {
            *to++ = z.real();
            *to++ = z.imag();
        }
    }
}

std::span<double> write_bands(double* bands, std::uint64_t count, int order) {
    return write_array(bands, count, static_cast<std::uint64_t>(order) + 1, kBandSize, "bands");
}

}  // namespace

nicol_result nicol_psh_project_kernel(nicol_psh_kernel_callback callback, void* user, uint32_t order,
                                      uint32_t rows, double* bands, uint64_t band_count) {
    return guarded([&] {
        if (callback == nullptr) refuse("callback is NULL");
        const int highest = read_order(order, "order");
        if (rows > static_cast<std::uint32_t>(kMaxGaussRows)) {
            refuse("rows is " + std::to_string(rows) + "; it must be at most " +
                   std::to_string(kMaxGaussRows));
        }
        const int count = rows == 0 ? 2 * highest + 2 : static_cast<int>(rows);
        const auto to = write_bands(bands, band_count, highest);
        const auto at = [&](double theta) {
            std::array<double, 16> m{};
            if (callback(user, theta, m.data()) == 0)
                throw Error(ErrorCode::cancelled, "callback returned 0");
            if (!std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); })) {
                refuse("callback gave a Mueller matrix that is not finite at theta = " +
                       std::to_string(theta));
            }
            return Mueller(m);
        };
        write_kernel(project_kernel(at, highest, gauss_legendre_rows(count)), to);
    });
}

nicol_result nicol_psh_kernel_at(uint32_t order, const double* bands, uint64_t band_count,
                                 const double* theta, uint64_t theta_count, double* mueller,
                                 uint64_t mueller_count) {
    return guarded([&] {
        const ConvolutionKernel kernel = read_kernel(bands, band_count, read_order(order, "order"));
        const auto angles = read_array(theta, theta_count, theta_count, 1, "theta");
        const auto to = write_array(mueller, mueller_count, theta_count, 16, "mueller");
        for (std::size_t i = 0; i < angles.size(); ++i) {
            if (angles[i] < 0 || angles[i] > std::numbers::pi) {
                refuse("theta[" + std::to_string(i) + "] is " + std::to_string(angles[i]) +
                       "; it must lie in 0 to pi");
            }
        }
        require_apart(angles, to, "theta and mueller");
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const Mueller m = kernel_at(kernel, angles[i]);
            for (std::size_t k = 0; k < 16; ++k) to[16 * i + k] = m(k / 4, k % 4);
        }
    });
}

nicol_result nicol_psh_convolve(uint32_t order, const double* bands, uint64_t band_count, uint64_t vectors,
                                const double* in, uint64_t in_count, double* out, uint64_t out_count) {
    return guarded([&] {
        const int highest = read_order(order, "order");
        const ConvolutionKernel kernel = read_kernel(bands, band_count, highest);
        const std::size_t size = vector_size(highest);
        const auto from = read_array(in, in_count, vectors, size, "in");
        const auto to = write_array(out, out_count, vectors, size, "out");
        require_same_or_apart(from, to, "in and out");
        for (std::size_t first = 0; first < from.size(); first += size)
            convolve(kernel, from.subspan(first, size), to.subspan(first, size));
    });
}

nicol_result nicol_psh_kernel_matrix(uint32_t order, const double* bands, uint64_t band_count, double* matrix,
                                     uint64_t matrix_count) {
    return guarded([&] {
        const int highest = read_order(order, "order", NICOL_PSH_MAX_MATRIX_ORDER);
        const ConvolutionKernel kernel = read_kernel(bands, band_count, highest);
        const auto to =
            write_array(matrix, matrix_count, vector_size(highest), vector_size(highest), "matrix");
        const CoefficientMatrix dense = kernel_matrix(kernel).dense();
        std::ranges::copy(dense.data(), to.begin());
    });
}

nicol_result nicol_psh_nearest_kernel(uint32_t order, const double* matrix, uint64_t matrix_count,
                                      double* bands, uint64_t band_count) {
    return guarded([&] {
        const int highest = read_order(order, "order", NICOL_PSH_MAX_MATRIX_ORDER);
        const auto values =
            read_array(matrix, matrix_count, vector_size(highest), vector_size(highest), "matrix");
        const auto to = write_bands(bands, band_count, highest);
        CoefficientMatrix m(highest, highest);
        std::ranges::copy(values, m.data().begin());
        write_kernel(nearest_kernel(m), to);
    });
}
