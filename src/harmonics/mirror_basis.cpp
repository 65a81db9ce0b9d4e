// SPDX-License-Identifier: MIT
#include "harmonics/mirror_basis.hpp"

#include <algorithm>
#include <numbers>

#include "simd/lane_vector.hpp"

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

// Where a harmonic stands in a group, by psh_index.
std::vector<std::size_t> positions(const Harmonics& in, int order) {
    std::vector<std::size_t> out(psh_count(order));
    for (std::size_t i = 0; i < in.size(); ++i) out[psh_index(in[i].l, in[i].m)] = i;
    return out;
}

}  // namespace

MirrorBasis::MirrorBasis(const LightLayout& layout) : kind_(layout.kind()), packed_size_(2 * layout.size()) {
    even_ = harmonics(layout.order(), 0, [](int l, int m) { return (l + m) % 2 == 0; });
    odd_ = harmonics(layout.order(), 0, [](int l, int m) { return (l + m) % 2 != 0; });
    if (kind_ != LightKind::unpolarized) {
        spin_ = harmonics(layout.order(), 2, [](int, int) { return true; });
    }
    size_ = s3_begin() + (kind_ == LightKind::full ? spin_begin() : 0);
    add_scalars(layout);
    add_spins(layout);
}

void MirrorBasis::add_scalars(const LightLayout& layout) {
    const std::vector<std::size_t> even = positions(even_, layout.order());
    const std::vector<std::size_t> odd = positions(odd_, layout.order());
    const auto& entries = layout.entries();
    for (std::size_t j = 0; j < entries.size() && entries[j].part == LightKind::unpolarized; ++j) {
        const auto [part, l, m] = entries[j];
        const bool is_even = (l + m) % 2 == 0;
        const std::vector<std::size_t>& group = is_even ? even : odd;
        const std::size_t first = is_even ? 0 : even_.size();
        scalars_.push_back({.m = m,
                            .cosine = first + group[psh_index(l, m)],
                            .sine = first + group[psh_index(l, -m)],
                            .entry = j});
    }
    s3_entry_ = layout.size() - (kind_ == LightKind::full ? scalars_.size() : 0);
}

void MirrorBasis::add_spins(const LightLayout& layout) {
    const std::vector<std::size_t> slots = positions(spin_, layout.order());
    std::vector<std::size_t> of_entry(psh_count(layout.order()));
    for (std::size_t j = scalars_.size(); j < s3_entry_; ++j) {
        of_entry[psh_index(layout.entries()[j].l, layout.entries()[j].m)] = j;
    }
    for (const auto& [l, m] : spin_) {
        if (m < 0) continue;
        spins_.push_back({.l = l,
                          .m = m,
                          .cosine = spin_begin() + slots[psh_index(l, m)],
                          .sine = spin_begin() + slots[psh_index(l, -m)],
                          .plus = of_entry[psh_index(l, m)],
                          .minus = of_entry[psh_index(l, -m)]});
    }
}

template <class Number>
[[gnu::always_inline]] inline void MirrorBasis::split_scalars(const Number* cosines, const Number* sines,
                                                              Number* out) const {
    for (const ScalarPair& s : scalars_) {
        out[s.cosine] = cosines[s.entry];
        if (s.m > 0) out[s.sine] = sines[s.entry];
    }
}

template <class Number>
[[gnu::always_inline]] inline void MirrorBasis::join_scalars(const Number* in, Number* cosines,
                                                             Number* sines) const {
    for (const ScalarPair& s : scalars_) {
        cosines[s.entry] = in[s.cosine];
        sines[s.entry] = s.m > 0 ? in[s.sine] : Number{};
    }
}

// e = (f + its mirror image) / 2 and o = (f - its mirror image) / 2i over their real harmonics, times sqrt 2,
// which join() divides by.
template <class Number>
[[gnu::always_inline]] inline void MirrorBasis::split_numbers(const Number* packed, Number* out) const {
    const Number* imaginary = packed + packed_size_ / 2;
    split_scalars(packed, imaginary, out);
    // s3 keeps the coefficients of m >= 0 as imaginary parts.
    if (kind_ == LightKind::full) split_scalars(imaginary + s3_entry_, packed + s3_entry_, out + s3_begin());
    Number* odd = out + spin_.size();
    for (const SpinPair& s : spins_) {
        if (s.m > 0) {
            const float sign = s.l % 2 != 0 ? -1.0F : 1.0F;
            const Number a = packed[s.plus];
            const Number b = imaginary[s.plus];
            const Number c = sign * packed[s.minus];
            const Number d = sign * imaginary[s.minus];
            out[s.cosine] = a + c;
            out[s.sine] = b - d;
            odd[s.cosine] = b + d;
            odd[s.sine] = c - a;
        } else if (s.l % 2 != 0) {  // f = i e - o
            out[s.cosine] = root2 * imaginary[s.plus];
            odd[s.cosine] = -root2 * packed[s.plus];
        } else {
            out[s.cosine] = root2 * packed[s.plus];
            odd[s.cosine] = root2 * imaginary[s.plus];
        }
    }
}

template <class Number>
[[gnu::always_inline]] inline void MirrorBasis::join_numbers(const Number* in, Number* packed) const {
    Number* imaginary = packed + packed_size_ / 2;
    join_scalars(in, packed, imaginary);
    if (kind_ == LightKind::full) join_scalars(in + s3_begin(), imaginary + s3_entry_, packed + s3_entry_);
    const Number* odd = in + spin_.size();
    for (const SpinPair& s : spins_) {
        if (s.m > 0) {
            const float sign = s.l % 2 != 0 ? -1.0F : 1.0F;
            const Number a = 0.5F * in[s.cosine];
            const Number b = 0.5F * in[s.sine];
            const Number c = 0.5F * odd[s.cosine];
            const Number d = 0.5F * odd[s.sine];
            packed[s.plus] = a - d;
            imaginary[s.plus] = b + c;
            packed[s.minus] = sign * (a + d);
            imaginary[s.minus] = sign * (c - b);
        } else if (s.l % 2 != 0) {
            imaginary[s.plus] = (1 / root2) * in[s.cosine];
            packed[s.plus] = (-1 / root2) * odd[s.cosine];
        } else {
            packed[s.plus] = (1 / root2) * in[s.cosine];
            imaginary[s.plus] = (1 / root2) * odd[s.cosine];
        }
    }
}

void MirrorBasis::split(const Lanes* packed, Lanes* out) const {
    split_numbers(reinterpret_cast<const LaneVector*>(packed), reinterpret_cast<LaneVector*>(out));
}

void MirrorBasis::join(const Lanes* in, Lanes* packed) const {
    join_numbers(reinterpret_cast<const LaneVector*>(in), reinterpret_cast<LaneVector*>(packed));
}

void MirrorBasis::split(const float* packed, float* out) const {
    split_numbers(packed, out);
}

void MirrorBasis::join(const float* in, float* packed) const {
    join_numbers(in, packed);
}

}  // namespace nicol
