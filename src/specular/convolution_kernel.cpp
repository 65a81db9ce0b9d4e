// SPDX-License-Identifier: MIT
#include "specular/convolution_kernel.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "error.hpp"
#include "material/material_projection.hpp"
#include "material/response_table.hpp"

namespace nicol {

ConvolutionKernel mirrored_kernel(const IsotropicMatrix& matrix) {
    if (matrix.order_in() != matrix.order_out())
        throw Error(ErrorCode::invalid_argument, "a kernel needs a matrix of the same order on both sides");
    // Mirroring the outgoing light keeps l and m and changes rows only. It multiplies s0 by (-1)^(l+m) and s3
    // by -(-1)^(l+m). It multiplies (w_lm, conj w_l-m) by (-1)^l and exchanges these two rows.
    ConvolutionKernel kernel(static_cast<std::size_t>(matrix.order_out()) + 1);
    for (int l = 0; l <= matrix.order_out(); ++l) {
        KernelBand& k = kernel[static_cast<std::size_t>(l)];
        const double even_l = l % 2 == 0 ? 1 : -1;
        for (int m = 0; m <= l; ++m) {
            const IsotropicMatrix::Block& b = matrix.block(m, l, l);
            const double even_m = m % 2 == 0 ? 1 : -1;
            // The kernel takes the mean over m and -m. The block of -m is the conjugate with the last two
            // lanes exchanged.
            const double weight =
                (m == 0 ? 1 : 2) / ((2 * l + 1) * std::sqrt(4 * std::numbers::pi / (2 * l + 1)));
            const double s0 = weight * even_l * even_m;
            const double spin = weight * even_l / 2;
            k.k00 += s0 * b[0].real();
            k.k03 += s0 * b[1].real();
            k.k30 -= s0 * b[4].real();
            k.k33 -= s0 * b[5].real();
            if (l < 2) continue;
            k.from_p0 += s0 * (b[2] + even_m * std::conj(b[3]));
            k.from_p3 -= s0 * (b[6] + even_m * std::conj(b[7]));
            k.p0 += spin * (b[12] + even_m * std::conj(b[8]));
            k.p3 += spin * (b[13] + even_m * std::conj(b[9]));
            k.iso += spin * (b[14] + std::conj(b[11]));
            k.conj += spin * even_m * (b[15] + std::conj(b[10]));
        }
    }
    return kernel;
}

std::vector<ConvolutionKernel> mirrored_kernels(const Material& material, int order, int channels) {
    const int count = ResponseTable::channels_for(material, channels);
    std::vector<ConvolutionKernel> kernels;
    kernels.reserve(static_cast<std::size_t>(count));
    for (int c = 0; c < count; ++c) kernels.push_back(mirrored_kernel(project_material(material, c, order)));
    return kernels;
}

}  // namespace nicol
