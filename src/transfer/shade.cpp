// SPDX-License-Identifier: MIT
#include "transfer/shade.hpp"

#include <glm/vec2.hpp>

#include "transfer/simd.hpp"
#include "transfer/vertex_view.hpp"

namespace nicol {
namespace {

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

Shade::Shade(const LightLayout& layout) : layout_(layout) {}

void Shade::run(const ResponseTable& response, const VertexLight& light, const Viewpoint& view,
                std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                std::span<const std::uint8_t> visible, std::size_t first, std::size_t last,
                std::span<const std::span<glm::vec4>> out) const {
    // Components that the material cannot make are not computed, nor channels that equal the first.
    const bool linear = response.makes(1) || response.makes(2);
    const bool alike = response.channels() == 1 && light.channels() == 1;
    const std::size_t n = layout_.size();

    VertexView seen(layout_);
    const float* cosine = seen.cosine().data();
    const float* sine = seen.sine().data();
    for (std::size_t v = first; v < last; ++v) {
        if (visible[v] == 0) continue;
        seen.look(view, positions[v], normals[v]);
        const VertexView::TablePosition at = seen.position_in(ResponseTable::kAngles);
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
                const glm::vec3 s = respond_linear(n, low, high, at.fraction, z, cosine, sine);
                const glm::vec2 turned = seen.in_camera_frame(s[1], s[2]);
                stokes = {s[0], turned, 0};
            } else {
                stokes = {respond_s0(n, low, high, at.fraction, z, cosine, sine), 0, 0, 0};
            }
            if (response.makes(3)) {
                stokes[3] = respond_s3(n, low, high, at.fraction, z, cosine, sine);
            }
        }
    }
}

}  // namespace nicol
