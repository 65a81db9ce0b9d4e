// SPDX-License-Identifier: MIT
#include "transfer/vertex_light.hpp"

#include <algorithm>
#include <numbers>

#include "transfer/lane_rotation.hpp"

namespace nicol {
namespace {

// Coefficients over complex harmonics of a real field, m >= 0, from those over real ones.
std::vector<std::complex<float>> complex_half(std::span<const double> channel, int order, std::size_t p) {
    std::vector<std::complex<float>> half;
    for (int l = 0; l <= order; ++l) {
        half.emplace_back(static_cast<float>(channel[4 * psh_index(l, 0) + p]));
        for (int m = 1; m <= l; ++m) {
            half.emplace_back(static_cast<float>(channel[4 * psh_index(l, m) + p] / std::numbers::sqrt2),
                              static_cast<float>(-channel[4 * psh_index(l, -m) + p] / std::numbers::sqrt2));
        }
    }
    return half;
}

// How (-i)^m times a result, and what the layout makes of it, picks and signs the result's two parts.
struct Pick {
    bool exchange;  // the real part comes from the imaginary one
    float re;
    float im;
};

Pick quarter_turns(int m) {  // (-i)^m (x + i y)
    switch (((m % 4) + 4) % 4) {
        case 0:
            return {false, 1, 1};
        case 1:
            return {true, 1, -1};
        case 2:
            return {false, -1, -1};
        default:
            return {true, -1, 1};
    }
}

}  // namespace

void VertexLight::resize(const LightLayout& layout, int channels, std::size_t vertices) {
    row_size_ = layout.size();
    channels_ = channels;
    data_.resize(vertices * static_cast<std::size_t>(channels) * 2 * row_size_);
}

Relight::Relight(const LightLayout& layout, const PshVector& light) : layout_(layout) {
    for (int c = 0; c < light.channels(); ++c) {
        const std::span<const double> from = light.channel(c);
        Channel& channel = channels_.emplace_back();
        channel.s0 = complex_half(from, layout.order(), 0);
        if (layout.kind() == LightKind::full) channel.s3 = complex_half(from, layout.order(), 3);
        if (layout.kind() == LightKind::unpolarized) continue;
        for (std::size_t index = 0; index < psh_count(layout.order()); ++index) {
            channel.spin.emplace_back(static_cast<float>(from[4 * index + 1]),
                                      static_cast<float>(from[4 * index + 2]));
        }
    }
}

void Relight::run(std::span<const glm::vec3> normals, std::size_t first, VertexLight& out) const {
    LaneRotation rotation(layout_.order());
    const std::size_t size = layout_.size();

    // Writes the entries [begin, end) of the layout for all lanes.
    const auto store = [&](std::size_t begin, std::size_t end, std::size_t vertex, std::size_t used, int c) {
        for (std::size_t j = begin; j < end; ++j) {
            const LightLayout::Entry& e = layout_.entries()[j];
            Pick pick = quarter_turns(e.m);
            std::size_t position = psh_index(e.l, e.m);
            if (e.part != LightKind::linear) {
                position = static_cast<std::size_t>(e.l * (e.l + 1) / 2 + e.m);
                const float norm = e.m > 0 ? std::numbers::sqrt2_v<float> : 1.0F;
                pick.re *= norm;
                pick.im *= norm;
                if (e.part == LightKind::unpolarized) {  // conj
                    pick.im = -pick.im;
                } else {  // i times
                    pick = {!pick.exchange, -pick.im, pick.re};
                }
            }
            const Lanes& re = pick.exchange ? rotation.im(position) : rotation.re(position);
            const Lanes& im = pick.exchange ? rotation.re(position) : rotation.im(position);
            for (std::size_t i = 0; i < used; ++i) {
                const std::span<float> packed = out.at(vertex + i, c);
                packed[j] = pick.re * re[i];
                packed[size + j] = pick.im * im[i];
            }
        }
    };
    const auto part_begin = [&](LightKind part) {
        const auto& entries = layout_.entries();
        return static_cast<std::size_t>(std::ranges::find(entries, part, &LightLayout::Entry::part) -
                                        entries.begin());
    };
    const std::size_t linear = part_begin(LightKind::linear);
    const std::size_t full = part_begin(LightKind::full);

    for (std::size_t block = 0; block < normals.size(); block += kLanes) {
        const std::size_t used = std::min(kLanes, normals.size() - block);
        rotation.set_normals(normals.subspan(block, used));
        for (int c = 0; c < out.channels(); ++c) {
            const Channel& channel = channels_[static_cast<std::size_t>(c)];
            rotation.turn_real(channel.s0);
            store(0, std::min(linear, full), first + block, used, c);
            if (!channel.spin.empty()) {
                rotation.turn_complex(channel.spin);
                store(linear, full, first + block, used, c);
            }
            if (!channel.s3.empty()) {
                rotation.turn_real(channel.s3);
                store(full, size, first + block, used, c);
            }
        }
    }
}

}  // namespace nicol
