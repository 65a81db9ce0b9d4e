// SPDX-License-Identifier: MIT
#include "transfer/outgoing_shade.hpp"

#include <glm/vec2.hpp>
#include <numbers>

#include "nicol/spin_harmonics.hpp"
#include "transfer/simd.hpp"
#include "transfer/vertex_view.hpp"

namespace nicol {
namespace {

// sum over begin <= j < end of row[j] z_j exp(i k_j phi)
struct Sum {
    float re;
    float im;
};

NICOL_MULTIVERSION
Sum evaluate(std::size_t begin, std::size_t end, const float* low, const float* high, float fraction,
             const float* z_re, const float* z_im, const float* cosine, const float* sine) {
    float re = 0;
    float im = 0;
#pragma omp simd reduction(+ : re, im)
    for (std::size_t j = begin; j < end; ++j) {
        const float row = low[j] + fraction * (high[j] - low[j]);
        re += row * (z_re[j] * cosine[j] - z_im[j] * sine[j]);
        im += row * (z_im[j] * cosine[j] + z_re[j] * sine[j]);
    }
    return {re, im};
}

}  // namespace

OutgoingShade::OutgoingShade(const LightLayout& layout) : layout_(layout) {
    const std::size_t n = layout.size();
    for (const LightLayout::Entry& e : layout.entries()) {
        const std::size_t part = e.part == LightKind::unpolarized ? 1 : e.part == LightKind::linear ? 2 : 3;
        ++part_[part];
    }
    for (std::size_t p = 1; p < 4; ++p) part_[p] += part_[p - 1];

    std::vector<double> scalar(psh_count(layout.order()));
    std::vector<double> spin2(psh_count(layout.order()));
    table_.resize(kAngles * n);
    for (int angle = 0; angle < kAngles; ++angle) {
        const double theta = angle * std::numbers::pi / 2 / (kAngles - 1);
        spin_harmonics(0, layout.order(), theta, scalar);
        spin_harmonics(2, layout.order(), theta, spin2);
        for (std::size_t j = 0; j < n; ++j) {
            const LightLayout::Entry& e = layout.entries()[j];
            const std::size_t index = psh_index(e.l, e.m);
            // Real harmonics of m > 0 are sqrt2 times the parts of the complex ones.
            const double real = e.m > 0 ? std::numbers::sqrt2 * scalar[index] : scalar[index];
            table_[static_cast<std::size_t>(angle) * n + j] =
                static_cast<float>(e.part == LightKind::linear ? spin2[index] : real);
        }
    }
}

void OutgoingShade::run(const OutgoingLight& light, const Viewpoint& view,
                        std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                        std::span<const std::uint8_t> visible, std::size_t first, std::size_t last,
                        std::span<const std::span<glm::vec4>> out) const {
    const std::size_t n = layout_.size();
    VertexView seen(layout_);
    for (std::size_t v = first; v < last; ++v) {
        if (visible[v] == 0) continue;
        seen.look(view, positions[v], normals[v]);
        const VertexView::TablePosition at = seen.position_in(kAngles);
        const float* low = table_.data() + static_cast<std::size_t>(at.angle) * n;
        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            if (light.channels() == 1 && channel > 0) {
                out[channel][v] = out[0][v];
                continue;
            }
            const float* z = light.at(v, static_cast<int>(channel)).data();
            const auto part = [&](std::size_t p) {
                return evaluate(part_[p], part_[p + 1], low, low + n, at.fraction, z, z + n,
                                seen.cosine().data(), seen.sine().data());
            };
            glm::vec4& stokes = out[channel][v];
            stokes = {part(0).re, 0, 0, 0};
            if (layout_.kind() == LightKind::unpolarized) continue;
            const Sum linear = part(1);
            const glm::vec2 turned = seen.in_camera_frame(linear.re, linear.im);
            stokes.y = turned.x;
            stokes.z = turned.y;
            if (layout_.kind() == LightKind::full) stokes.w = part(2).im;
        }
    }
}

}  // namespace nicol
