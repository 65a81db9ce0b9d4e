// SPDX-License-Identifier: MIT
#include "inspect/material_report.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "harmonics/operator.hpp"
#include "harmonics/spin_harmonics.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Returns the integrals of max(cos theta, 0) Y_l0 over the sphere.
std::vector<double> cosine_lobe(int order) {
    std::vector<double> at_zero{1, 0};  // P_l(0)
    for (int l = 2; l <= order + 2; ++l)
        at_zero.push_back(-(l - 1.0) / l * at_zero[static_cast<std::size_t>(l) - 2]);
    const auto upper = [&at_zero](int l) {  // integral of P_l over 0 to 1
        const auto i = static_cast<std::size_t>(l);
        return l == 0 ? 1.0 : (at_zero[i - 1] - at_zero[i + 1]) / (2 * l + 1);
    };
    std::vector<double> out;
    for (int l = 0; l <= order; ++l) {
        const double moment = ((l + 1) * upper(l + 1) + (l > 0 ? l * upper(l - 1) : 0)) / (2 * l + 1);
        out.push_back(2 * pi * std::sqrt((2 * l + 1) / (4 * pi)) * moment);
    }
    return out;
}

double largest_albedo_of(const IsotropicMatrix& matrix, const std::vector<double>& lobe) {
    const int order = matrix.order_in();
    // Total outgoing light as a row over incoming lanes. Only m = 0 contributes to the total.
    std::vector<std::array<std::complex<double>, 3>> row(static_cast<std::size_t>(order) + 1);
    for (int k = 0; k <= order; ++k)
        for (int l = 0; l <= matrix.order_out(); ++l)
            for (std::size_t lane = 0; lane < 3; ++lane)
                row[static_cast<std::size_t>(k)][lane] +=
                    lobe[static_cast<std::size_t>(l)] * matrix.block(0, l, k)[lane];
    std::vector<double> scalar(psh_count(order));
    std::vector<double> spin2(scalar.size());
    double largest = 0;
    for (int degrees = 0; degrees <= 75; degrees += 5) {
        const double zenith = degrees * pi / 180;
        spin_harmonics(0, order, pi - zenith, scalar);
        spin_harmonics(2, order, pi - zenith, spin2);
        double even = 0;
        double circular = 0;
        std::complex<double> linear = 0;
        for (int k = 0; k <= order; ++k) {
            const auto& lanes = row[static_cast<std::size_t>(k)];
            even += lanes[0].real() * scalar[psh_index(k, 0)];
            circular += lanes[1].real() * scalar[psh_index(k, 0)];
            linear += 2.0 * lanes[2] * spin2[psh_index(k, 0)];
        }
        largest = std::max(largest, (even + std::hypot(std::abs(linear), circular)) / std::cos(zenith));
    }
    return largest;
}

// Returns 26 fully polarized Stokes vectors, evenly distributed over the Poincare sphere.
std::vector<Stokes> polarizations() {
    std::vector<Stokes> out;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                const glm::dvec3 n = glm::normalize(glm::dvec3(x, y, z));
                out.emplace_back(1, n.x, n.y, n.z);
            }
    return out;
}

}  // namespace

MatrixReport describe(const IsotropicMatrix& matrix) {
    constexpr std::array<std::size_t, 4> group{0, 2, 1, 1};  // group of each lane
    MatrixReport out;
    out.energy.assign(static_cast<std::size_t>(std::max(matrix.order_out(), matrix.order_in())) + 1, 0.0);
    out.asymmetry = asymmetry(matrix);
    for (int m = 0; m <= std::min(matrix.order_out(), matrix.order_in()); ++m) {
        for (int l = m; l <= matrix.order_out(); ++l) {
            for (int k = m; k <= matrix.order_in(); ++k) {
                const IsotropicMatrix::Block& block = matrix.block(m, l, k);
                for (std::size_t e = 0; e < 16; ++e) {
                    const double square = block_weight(m, e / 4, e % 4) * std::norm(block[e]);
                    out.energy[static_cast<std::size_t>(std::max(l, k))] += square;
                    out.norms[3 * group[e / 4] + group[e % 4]] += square;
                }
            }
        }
    }
    for (double& norm : out.norms) norm = std::sqrt(norm);
    const std::vector<double> lobe = cosine_lobe(matrix.order_out());
    for (int l = 0; l <= matrix.order_out(); ++l)
        out.albedo += lobe[static_cast<std::size_t>(l)] * matrix.block(0, l, 0)[0].real();
    out.albedo *= std::sqrt(4 * pi) / pi;
    out.largest_albedo = largest_albedo_of(matrix, lobe);
    return out;
}

MuellerReport describe(const Material& material, int channel) {
    constexpr int pairs = 4096;
    constexpr double tolerance = 1e-3;
    static const std::vector<Stokes> states = polarizations();
    std::vector<double> excess;
    double mean = 0;
    for (int i = 0; i < pairs; ++i) {
        // Additive recurrence with powers of the root of x^4 = x + 1 covers three dimensions evenly.
        const auto part = [i](double step) { return std::fmod(0.5 + i * step, 1.0); };
        const auto direction = [](double u, double phi) {
            const double sine = std::sqrt(u);
            return glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - u));
        };
        const glm::dvec3 light = direction(part(0.8191725133961645), 0);
        const glm::dvec3 viewer = direction(part(0.6710436067037893), 2 * pi * part(0.5497004779019703));
        const Mueller m = evaluate(material, channel, light, viewer);
        mean += m(0, 0) / pairs;
        double most = 0;
        for (const Stokes& state : states) {
            const Stokes s = m * state;
            most = std::max(most, std::sqrt(s[1] * s[1] + s[2] * s[2] + s[3] * s[3]) - s[0]);
        }
        excess.push_back(most);
    }
    MuellerReport out;
    if (mean <= 0) return out;
    for (const double e : excess) {
        if (e > tolerance * mean) out.unphysical += 1.0 / pairs;
        out.excess += e / mean / pairs;
    }
    return out;
}

}  // namespace nicol
