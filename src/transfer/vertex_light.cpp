// SPDX-License-Identifier: MIT
#include "transfer/vertex_light.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

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
struct Rotated {
    bool exchange;
    float re;
    float im;
};

Rotated quarter_rotations(int m) {
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

// A packed number as one result of LaneRotation: (-i)^m times it, and what the layout makes of that.
struct Pick {
    std::size_t position;
    float factor;
};

std::vector<Pick> picks(const LightLayout& layout) {
    const std::size_t size = layout.size();
    const std::size_t imaginary = psh_count(layout.order());
    std::vector<Pick> out(2 * size);
    for (std::size_t j = 0; j < size; ++j) {
        const LightLayout::Entry& e = layout.entries()[j];
        Rotated rotated = quarter_rotations(e.m);
        std::size_t position = psh_index(e.l, e.m);
        if (e.part != LightKind::linear) {
            position = static_cast<std::size_t>(e.l * (e.l + 1) / 2 + e.m);
            const float norm = e.m > 0 ? std::numbers::sqrt2_v<float> : 1.0F;
            rotated.re *= norm;
            rotated.im *= norm;
            if (e.part == LightKind::unpolarized) {  // conj
                rotated.im = -rotated.im;
            } else {  // i times
                rotated = {!rotated.exchange, -rotated.im, rotated.re};
            }
        }
        out[j] = {position + (rotated.exchange ? imaginary : 0), rotated.re};
        out[size + j] = {position + (rotated.exchange ? 0 : imaginary), rotated.im};
    }
    return out;
}

Relight::Term sum(const Pick& a, float a_factor, const Pick& b, float b_factor) {
    return {a.position, b.position, a_factor * a.factor, b_factor * b.factor};
}

Relight::Term alone(const Pick& a, float factor) {
    return {a.position, a.position, factor * a.factor, 0};
}

// s0 keeps the coefficients of m >= 0 as real parts of packed numbers and s3 as imaginary ones.
std::vector<Relight::Term> scalar_terms(const MirrorBasis& basis, const std::vector<Pick>& packed,
                                        std::size_t first_cosine, std::size_t first_sine) {
    std::vector<Relight::Term> terms(basis.spin_begin());
    for (const MirrorBasis::ScalarPair& pair : basis.scalar_pairs()) {
        terms[pair.cosine] = alone(packed[first_cosine + pair.entry], 1);
        if (pair.m > 0) terms[pair.sine] = alone(packed[first_sine + pair.entry], 1);
    }
    return terms;
}

// What MirrorBasis::split makes of them.
std::vector<Relight::Term> spin_terms(const MirrorBasis& basis, const std::vector<Pick>& packed) {
    constexpr float root2 = std::numbers::sqrt2_v<float>;
    const std::size_t imaginary = packed.size() / 2;
    const std::size_t odd = basis.spin().size();
    std::vector<Relight::Term> terms(2 * odd);
    for (const MirrorBasis::SpinPair& pair : basis.spin_pairs()) {
        const float sign = pair.l % 2 == 0 ? 1.0F : -1.0F;
        const Pick& re = packed[pair.plus];
        const Pick& im = packed[imaginary + pair.plus];
        const Pick& re_minus = packed[pair.minus];
        const Pick& im_minus = packed[imaginary + pair.minus];
        const std::size_t cosine = pair.cosine - basis.spin_begin();
        const std::size_t sine = pair.sine - basis.spin_begin();
        if (pair.m > 0) {
            terms[cosine] = sum(re, 1, re_minus, sign);
            terms[sine] = sum(im, 1, im_minus, -sign);
            terms[odd + cosine] = sum(im, 1, im_minus, sign);
            terms[odd + sine] = sum(re, -1, re_minus, sign);
        } else {
            terms[cosine] = alone(pair.l % 2 == 0 ? re : im, root2);
            terms[odd + cosine] = alone(pair.l % 2 == 0 ? im : re, sign * root2);
        }
    }
    return terms;
}

[[gnu::always_inline]] inline void add_up(const std::vector<Relight::Term>& terms, const Lanes* results,
                                          std::size_t fields, std::size_t field, Lanes* out) {
    results += field;
    for (const Relight::Term& term : terms) {
        LaneVector first;
        load(results + fields * term.first, first);
        first *= term.first_factor;
        if (term.second_factor != 0) {
            LaneVector second;
            load(results + fields * term.second, second);
            first += term.second_factor * second;
        }
        store(out++, first);
    }
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
    : order_(layout.order()), rotation_(layout.order()) {
    const MirrorBasis basis(layout);
    const std::vector<Pick> packed = picks(layout);
    const std::size_t imaginary = layout.size();
    add_part(light, LightKind::unpolarized, 0, scalar_terms(basis, packed, 0, imaginary));
    if (layout.kind() != LightKind::unpolarized) {
        add_part(light, LightKind::linear, basis.spin_begin(), spin_terms(basis, packed));
    }
    if (layout.kind() == LightKind::full) {
        const std::size_t first = basis.s3_entry();
        add_part(light, LightKind::full, basis.s3_begin(),
                 scalar_terms(basis, packed, imaginary + first, first));
    }
}

void Relight::add_part(const PshVector& light, LightKind part, std::size_t begin, std::vector<Term> terms) {
    Part& made = parts_.emplace_back(
        Part{.channels = {}, .terms = std::move(terms), .begin = begin, .spin = part == LightKind::linear});
    for (int c = 0; c < light.channels(); ++c) {
        const std::span<const double> from = light.channel(c);
        Field& field = made.channels.emplace_back();
        if (!made.spin) {
            field = complex_half(from, order_, part == LightKind::full ? 3 : 0);
            continue;
        }
        for (std::size_t index = 0; index < psh_count(order_); ++index) {
            field.emplace_back(static_cast<float>(from[4 * index + 1]),
                               static_cast<float>(from[4 * index + 2]));
        }
    }
}

void Relight::run_part(const Part& part, LaneRotation::Work& work, std::size_t block,
                       VertexLight& out) const {
    const auto channels = static_cast<std::size_t>(out.channels());
    for (std::size_t first = 0; first < channels; first += LaneRotation::kMostFields) {
        std::array<const std::complex<float>*, LaneRotation::kMostFields> fields{};
        const std::size_t count = std::min(fields.size(), channels - first);
        for (std::size_t f = 0; f < count; ++f) fields[f] = part.channels[first + f].data();
        if (part.spin) {
            rotation_.rotate_complex(std::span(fields).first(count), work);
        } else {
            rotation_.rotate_real(std::span(fields).first(count), work);
        }
        for (std::size_t f = 0; f < count; ++f) {
            dispatch<add_up>(part.terms, work.results(), count, f,
                             out.block(block, static_cast<int>(first + f)).data() + part.begin);
        }
    }
}

void Relight::run(std::span<const glm::vec3> normals, std::size_t first, std::size_t last,
                  VertexLight& out) const {
    thread_local LaneRotation::Work work;
    thread_local int order = -1;  // that it is for
    if (order != order_) work = rotation_.work();
    order = order_;
    for (std::size_t block = first; block < last; ++block) {
        const std::size_t begin = block * kLanes;
        rotation_.set_normals(normals.subspan(begin, std::min(kLanes, normals.size() - begin)), work);
        for (const Part& part : parts_) run_part(part, work, block, out);
    }
}

}  // namespace nicol
