// SPDX-License-Identifier: MIT
#include "transfer/shade.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "transfer/simd.hpp"

namespace nicol {
namespace {

// Where a view direction falls between the angles of a response table.
struct TablePosition {
    int angle;
    float fraction;
};

TablePosition table_position(double zenith) {
    const double x = std::min(zenith / (std::numbers::pi / 2), 1.0) * (ResponseTable::kAngles - 1);
    const int angle = std::min(static_cast<int>(x), ResponseTable::kAngles - 2);
    return {angle, static_cast<float>(x - angle)};
}

// The dot products, with the rows of two neighbouring angles interpolated and the light turned by the
// azimuth.
NICOL_MULTIVERSION
float respond_s0(std::size_t n, const float* low, const float* high, float fraction, const float* light,
                 const float* cosine, const float* sine) {
    float s0 = 0;
#pragma omp simd reduction(+ : s0)
    for (std::size_t j = 0; j < n; ++j) {
        const float re = light[j] * cosine[j] - light[n + j] * sine[j];
        s0 += (low[j] + fraction * (high[j] - low[j])) * re;
    }
    return s0;
}

NICOL_MULTIVERSION
glm::vec3 respond_linear(std::size_t n, const float* low, const float* high, float fraction,
                         const float* light, const float* cosine, const float* sine) {
    float s0 = 0;
    float s1 = 0;
    float s2 = 0;
#pragma omp simd reduction(+ : s0, s1, s2)
    for (std::size_t j = 0; j < n; ++j) {
        const float re = light[j] * cosine[j] - light[n + j] * sine[j];
        const float im = light[n + j] * cosine[j] + light[j] * sine[j];
        s0 += (low[j] + fraction * (high[j] - low[j])) * re;
        s1 += (low[n + j] + fraction * (high[n + j] - low[n + j])) * re;
        s2 += (low[2 * n + j] + fraction * (high[2 * n + j] - low[2 * n + j])) * im;
    }
    return {s0, s1, s2};
}

NICOL_MULTIVERSION
float respond_s3(std::size_t n, const float* low, const float* high, float fraction, const float* light,
                 const float* cosine, const float* sine) {
    float s3 = 0;
#pragma omp simd reduction(+ : s3)
    for (std::size_t j = 0; j < n; ++j) {
        const float im = light[n + j] * cosine[j] + light[j] * sine[j];
        s3 += (low[3 * n + j] + fraction * (high[3 * n + j] - low[3 * n + j])) * im;
    }
    return s3;
}

}  // namespace

Shade::Shade(const LightLayout& layout)
    : order_(static_cast<std::size_t>(layout.order())), row_size_(layout.size()) {
    for (const LightLayout::Entry& e : layout.entries()) frequency_.push_back(e.azimuthal_frequency());
}

void Shade::run(const ResponseTable& response, const VertexLight& light, const Viewpoint& view,
                std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                std::span<const std::uint8_t> visible, std::size_t first, std::size_t last,
                std::span<const std::span<glm::vec4>> out) const {
    // Components that the material cannot make are not computed, nor channels that equal the first.
    const bool linear = response.makes(1) || response.makes(2);
    const bool alike = response.channels() == 1 && light.channels() == 1;

    std::vector<float> powers_cos(order_ + 1);
    std::vector<float> powers_sin(order_ + 1);
    std::vector<float> cosine(row_size_);
    std::vector<float> sine(row_size_);

    for (std::size_t v = first; v < last; ++v) {
        if (visible[v] == 0) continue;
        const Frame surface = theta_phi_frame(glm::dvec3(normals[v]));
        const glm::dvec3 world = view.towards(glm::dvec3(positions[v]));
        const glm::dvec3 local = world * surface;  // transposed times world
        const double rho = std::hypot(local.x, local.y);
        const double azimuth = rho > 0 ? std::atan2(local.y, local.x) : 0;
        const TablePosition at = table_position(std::atan2(rho, local.z));

        for (std::size_t m = 0; m <= order_; ++m) {
            powers_cos[m] = static_cast<float>(std::cos(static_cast<double>(m) * azimuth));
            powers_sin[m] = static_cast<float>(std::sin(static_cast<double>(m) * azimuth));
        }
        for (std::size_t j = 0; j < row_size_; ++j) {
            const int k = frequency_[j];
            cosine[j] = powers_cos[static_cast<std::size_t>(std::abs(k))];
            sine[j] =
                k < 0 ? -powers_sin[static_cast<std::size_t>(-k)] : powers_sin[static_cast<std::size_t>(k)];
        }

        // From the theta-phi frame about the normal to the camera's frame, as cos and sin of twice the angle.
        const Frame from = surface * theta_phi_frame(local);
        const glm::dvec3 x = view.frame(world)[0];
        const double c = glm::dot(x, from[0]);
        const double s = glm::dot(x, from[1]);
        const auto cos2 = static_cast<float>(c * c - s * s);
        const auto sin2 = static_cast<float>(2 * c * s);

        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            if (alike && channel > 0) {
                out[channel][v] = out[0][v];
                continue;
            }
            const int row_channel = response.channels() == 1 ? 0 : static_cast<int>(channel);
            const int light_channel = light.channels() == 1 ? 0 : static_cast<int>(channel);
            const float* low = response.rows(at.angle, row_channel).data();
            const float* high = response.rows(at.angle + 1, row_channel).data();
            const float* z = light.at(v, light_channel).data();
            glm::vec4& stokes = out[channel][v];
            if (linear) {
                const glm::vec3 s =
                    respond_linear(row_size_, low, high, at.fraction, z, cosine.data(), sine.data());
                stokes = {s[0], cos2 * s[1] + sin2 * s[2], cos2 * s[2] - sin2 * s[1], 0};
            } else {
                stokes = {respond_s0(row_size_, low, high, at.fraction, z, cosine.data(), sine.data()), 0, 0,
                          0};
            }
            if (response.makes(3)) {
                stokes[3] = respond_s3(row_size_, low, high, at.fraction, z, cosine.data(), sine.data());
            }
        }
    }
}

}  // namespace nicol
