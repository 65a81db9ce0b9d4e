// SPDX-License-Identifier: MIT
#include "transfer/mirror_basis.hpp"

#include <algorithm>
#include <numbers>

#include "transfer/simd.hpp"

namespace nicol {
namespace {

constexpr float root2 = std::numbers::sqrt2_v<float>;

using Harmonics = std::vector<MirrorBasis::Harmonic>;

// All (l, m) from `lowest` on of which `member` is true.
template <class Member>
Harmonics harmonics(int order, int lowest, Member member) {
    Harmonics out;
    for (int m = 0; m <= order; ++m) {
        for (const int sign : {1, -1}) {
            if (m == 0 && sign < 0) continue;
            for (int l = std::max(m, lowest); l <= order; ++l) {
                if (member(l, m)) out.push_back({l, sign * m});
            }
        }
    }
    return out;
}

std::size_t position(const Harmonics& in, int l, int m) {
    const auto same = [&](const MirrorBasis::Harmonic& h) { return h.l == l && h.m == m; };
    return static_cast<std::size_t>(std::ranges::find_if(in, same) - in.begin());
}

std::size_t entry(const LightLayout& layout, LightKind part, int l, int m) {
    const auto same = [&](const LightLayout::Entry& e) { return e.part == part && e.l == l && e.m == m; };
    return static_cast<std::size_t>(std::ranges::find_if(layout.entries(), same) - layout.entries().begin());
}

// e = (f + its mirror image) / 2 and o = (f - its mirror image) / 2i over their real harmonics, times sqrt 2,
// which join() divides by.
NICOL_MULTIVERSION
void split_pair(const Lanes& re_plus, const Lanes& im_plus, const Lanes& re_minus, const Lanes& im_minus,
                float sign, Lanes& e_cosine, Lanes& e_sine, Lanes& o_cosine, Lanes& o_sine) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float a = re_plus.value[i];
        const float b = im_plus.value[i];
        const float c = sign * re_minus.value[i];
        const float d = sign * im_minus.value[i];
        e_cosine.value[i] = a + c;
        e_sine.value[i] = b - d;
        o_cosine.value[i] = b + d;
        o_sine.value[i] = c - a;
    }
}

NICOL_MULTIVERSION
void join_pair(const Lanes& e_cosine, const Lanes& e_sine, const Lanes& o_cosine, const Lanes& o_sine,
               float sign, Lanes& re_plus, Lanes& im_plus, Lanes& re_minus, Lanes& im_minus) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float a = 0.5F * e_cosine.value[i];
        const float b = 0.5F * e_sine.value[i];
        const float c = 0.5F * o_cosine.value[i];
        const float d = 0.5F * o_sine.value[i];
        re_plus.value[i] = a - d;
        im_plus.value[i] = b + c;
        re_minus.value[i] = sign * (a + d);
        im_minus.value[i] = sign * (c - b);
    }
}

NICOL_MULTIVERSION
void scale(const Lanes& in, float factor, Lanes& out) {
    for (std::size_t i = 0; i < kLanes; ++i) out.value[i] = factor * in.value[i];
}

}  // namespace

MirrorBasis::MirrorBasis(const LightLayout& layout) : kind_(layout.kind()), packed_size_(2 * layout.size()) {
    even_ = harmonics(layout.order(), 0, [](int l, int m) { return (l + m) % 2 == 0; });
    odd_ = harmonics(layout.order(), 0, [](int l, int m) { return (l + m) % 2 != 0; });
    if (kind_ != LightKind::unpolarized) {
        spin_ = harmonics(layout.order(), 2, [](int, int) { return true; });
    }
    size_ = s3_begin() + (kind_ == LightKind::full ? spin_begin() : 0);
    add_scalars(layout, LightKind::unpolarized, 0);
    add_spins(layout);
    if (kind_ == LightKind::full) add_scalars(layout, LightKind::full, s3_begin());
}

void MirrorBasis::add_scalars(const LightLayout& layout, LightKind part, std::size_t first) {
    // s0 keeps the coefficients of m >= 0 as real parts and s3 as imaginary ones; those of m < 0 the other
    // way round.
    const std::size_t not_negative = part == LightKind::unpolarized ? 0 : layout.size();
    std::size_t slot = first;
    for (const Harmonics* group : {&even_, &odd_}) {
        for (const Harmonic& h : *group) {
            const std::size_t at = entry(layout, part, h.l, std::abs(h.m));
            scalars_.push_back({at + (h.m >= 0 ? not_negative : layout.size() - not_negative), slot++});
            if (h.m == 0) zeros_.push_back(at + layout.size() - not_negative);
        }
    }
}

void MirrorBasis::add_spins(const LightLayout& layout) {
    for (const Harmonic& h : spin_) {
        if (h.m < 0) continue;
        spins_.push_back({.plus = entry(layout, LightKind::linear, h.l, h.m),
                          .minus = entry(layout, LightKind::linear, h.l, -h.m),
                          .cosine = spin_begin() + position(spin_, h.l, h.m),
                          .sine = spin_begin() + position(spin_, h.l, -h.m),
                          .zonal = h.m == 0,
                          .odd = h.l % 2 != 0});
    }
}

void MirrorBasis::split(const Lanes* packed, Lanes* out) const {
    for (const Scalar& s : scalars_) out[s.split] = packed[s.packed];
    const Lanes* imaginary = packed + packed_size_ / 2;
    Lanes* odd = out + spin_.size();
    for (const Spin& s : spins_) {
        if (!s.zonal) {
            split_pair(packed[s.plus], imaginary[s.plus], packed[s.minus], imaginary[s.minus],
                       s.odd ? -1.0F : 1.0F, out[s.cosine], out[s.sine], odd[s.cosine], odd[s.sine]);
        } else if (s.odd) {  // f = i e - o
            scale(imaginary[s.plus], root2, out[s.cosine]);
            scale(packed[s.plus], -root2, odd[s.cosine]);
        } else {
            scale(packed[s.plus], root2, out[s.cosine]);
            scale(imaginary[s.plus], root2, odd[s.cosine]);
        }
    }
}

void MirrorBasis::join(const Lanes* in, Lanes* packed) const {
    for (const Scalar& s : scalars_) packed[s.packed] = in[s.split];
    for (const std::size_t zero : zeros_) packed[zero] = Lanes{};
    Lanes* imaginary = packed + packed_size_ / 2;
    const Lanes* odd = in + spin_.size();
    for (const Spin& s : spins_) {
        if (!s.zonal) {
            join_pair(in[s.cosine], in[s.sine], odd[s.cosine], odd[s.sine], s.odd ? -1.0F : 1.0F,
                      packed[s.plus], imaginary[s.plus], packed[s.minus], imaginary[s.minus]);
        } else if (s.odd) {
            scale(in[s.cosine], 1 / root2, imaginary[s.plus]);
            scale(odd[s.cosine], -1 / root2, packed[s.plus]);
        } else {
            scale(in[s.cosine], 1 / root2, packed[s.plus]);
            scale(odd[s.cosine], 1 / root2, imaginary[s.plus]);
        }
    }
}

}  // namespace nicol
