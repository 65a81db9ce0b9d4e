// SPDX-License-Identifier: MIT
#include "transfer/vertex_light.hpp"

#include <algorithm>
#include <numbers>

#include "transfer/lane_vector.hpp"
#include "transfer/simd.hpp"

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

// Of (-i)^m (x + i y): whether the real part comes from y, and the signs of both parts.
struct Turned {
    bool exchange;
    float re;
    float im;
};

Turned quarter_turns(int m) {
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

std::vector<Relight::Pick> picks(const LightLayout& layout) {
    const std::size_t size = layout.size();
    std::vector<Relight::Pick> out(2 * size);
    for (std::size_t j = 0; j < size; ++j) {
        const LightLayout::Entry& e = layout.entries()[j];
        Turned turned = quarter_turns(e.m);
        std::size_t position = psh_index(e.l, e.m);
        if (e.part != LightKind::linear) {
            position = static_cast<std::size_t>(e.l * (e.l + 1) / 2 + e.m);
            const float norm = e.m > 0 ? std::numbers::sqrt2_v<float> : 1.0F;
            turned.re *= norm;
            turned.im *= norm;
            if (e.part == LightKind::unpolarized) {  // conj
                turned.im = -turned.im;
            } else {  // i times
                turned = {!turned.exchange, -turned.im, turned.re};
            }
        }
        out[j] = {position, turned.exchange, turned.re};
        out[size + j] = {position, !turned.exchange, turned.im};
    }
    return out;
}

NICOL_MULTIVERSION
void pick_numbers(const Relight::Pick* picks, std::size_t count, const Lanes* re, const Lanes* im,
                  Lanes* out) {
    for (std::size_t j = 0; j < count; ++j) {
        LaneVector value;
        load((picks[j].imaginary ? im : re) + picks[j].position, value);
        store(out + j, picks[j].factor * value);
    }
}

std::size_t part_begin(const LightLayout& layout, LightKind part) {
    const auto& entries = layout.entries();
    return static_cast<std::size_t>(std::ranges::find(entries, part, &LightLayout::Entry::part) -
                                    entries.begin());
}

}  // namespace

void VertexLight::resize(const LightLayout& layout, int channels, std::size_t vertices) {
    if (!basis_ || order_ != layout.order() || basis_->kind() != layout.kind()) {
        basis_ = std::make_shared<const MirrorBasis>(layout);
        order_ = layout.order();
    }
    channels_ = channels;
    blocks_ = (vertices + kLanes - 1) / kLanes;
    data_.resize(blocks_ * static_cast<std::size_t>(channels) * basis_->size());
}

std::vector<float> VertexLight::packed(std::size_t vertex, int channel) const {
    const std::span<const Lanes> lanes = block(vertex / kLanes, channel);
    std::vector<float> split;
    for (const Lanes& number : lanes) split.push_back(number[vertex % kLanes]);
    std::vector<float> out(basis_->packed_size());
    basis_->join(split.data(), out.data());
    return out;
}

void VertexLight::set_packed(std::size_t vertex, int channel, std::span<const float> numbers) {
    std::vector<float> split(basis_->size());
    basis_->split(numbers.data(), split.data());
    const std::span<Lanes> lanes = block(vertex / kLanes, channel);
    for (std::size_t k = 0; k < split.size(); ++k) lanes[k][vertex % kLanes] = split[k];
}

Relight::Relight(const LightLayout& layout, const PshVector& light)
    : rotation_(layout.order()),
      linear_(part_begin(layout, LightKind::linear)),
      full_(part_begin(layout, LightKind::full)),
      picks_(picks(layout)) {
    linear_ = std::min(linear_, full_);
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

void Relight::run(std::span<const glm::vec3> normals, std::size_t first, std::size_t last,
                  VertexLight& out) const {
    LaneRotation::Work work = rotation_.work();
    const std::size_t size = picks_.size() / 2;
    std::vector<Lanes> packed(picks_.size());
    // Entries [begin, end) of the layout, from what was turned last.
    const auto pick = [&](std::size_t begin, std::size_t end) {
        for (const std::size_t part : {std::size_t{0}, size}) {
            pick_numbers(picks_.data() + part + begin, end - begin, &work.re(0), &work.im(0),
                         packed.data() + part + begin);
        }
    };
    for (std::size_t block = first; block < last; ++block) {
        const std::size_t begin = block * kLanes;
        rotation_.set_normals(normals.subspan(begin, std::min(kLanes, normals.size() - begin)), work);
        for (int c = 0; c < out.channels(); ++c) {
            const Channel& channel = channels_[static_cast<std::size_t>(c)];
            rotation_.turn_real(channel.s0, work);
            pick(0, linear_);
            if (!channel.spin.empty()) {
                rotation_.turn_complex(channel.spin, work);
                pick(linear_, full_);
            }
            if (!channel.s3.empty()) {
                rotation_.turn_real(channel.s3, work);
                pick(full_, size);
            }
            out.basis().split(packed.data(), out.block(block, c).data());
        }
    }
}

}  // namespace nicol
