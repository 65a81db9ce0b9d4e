// SPDX-License-Identifier: MIT
#include "transfer/vertex_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

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

// One result of LaneRotation, v_m, times a factor.
struct Result {
    std::size_t position;
    double factor;
};

// The real or imaginary part of f_m = (-i)^m v_m, whose complex number is at `position`.
Result part_of(std::size_t position, int m, bool imaginary, std::size_t imaginary_begin) {
    const bool exchanged = m % 2 != 0;  // (-i)^m is real or imaginary
    const int quarter = (m % 4 + 4) % 4;
    const bool negative = imaginary ? quarter == 1 || quarter == 2 : quarter == 2 || quarter == 3;
    return {position + (imaginary != exchanged ? imaginary_begin : 0), negative ? -1.0 : 1.0};
}

// The result that a coefficient 4 psh_index(l, m) + p of the rotated light is.
Result result_of(std::size_t coefficient, std::size_t imaginary_begin) {
    const std::size_t p = coefficient % 4;
    const std::size_t index = coefficient / 4;
    const auto l = static_cast<int>(std::sqrt(static_cast<double>(index)));
    const int m = static_cast<int>(index) - l * l - l;
    if (p == 1 || p == 2) return part_of(index, m, p == 2, imaginary_begin);
    // a_lm + i a_l-m = sqrt 2 conj(f_lm) over real harmonics.
    const int degree = std::abs(m);
    Result out = part_of(static_cast<std::size_t>(l * (l + 1) / 2 + degree), degree, m < 0, imaginary_begin);
    if (m != 0) out.factor *= m > 0 ? std::numbers::sqrt2 : -std::numbers::sqrt2;
    return out;
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
    size_ = layout.size();
    channels_ = channels;
    blocks_ = (vertices + kLanes - 1) / kLanes;
    data_.resize(blocks_ * static_cast<std::size_t>(channels) * size_);
}

Relight::Relight(const LightLayout& layout, const PshVector& light)
    : order_(layout.order()), rotation_(layout.order()) {
    const std::size_t spin = layout.spin_begin();
    const std::size_t s3 = layout.s3_begin();
    add_part(layout, light, LightKind::unpolarized, 0, spin);
    if (s3 > spin) add_part(layout, light, LightKind::linear, spin, s3);
    if (layout.size() > s3) add_part(layout, light, LightKind::full, s3, layout.size());
}

void Relight::add_part(const LightLayout& layout, const PshVector& light, LightKind kind, std::size_t begin,
                       std::size_t end) {
    Part& part = parts_.emplace_back(
        Part{.channels = {}, .terms = {}, .begin = begin, .spin = kind == LightKind::linear});
    for (std::size_t j = begin; j < end; ++j) {
        const auto& [first, second] = layout.terms()[j];
        const Result a = result_of(first.coefficient, psh_count(order_));
        const Result b = result_of(second.coefficient, psh_count(order_));
        part.terms.push_back({a.position, b.position, static_cast<float>(first.factor * a.factor),
                              static_cast<float>(second.factor * b.factor)});
    }
    for (int c = 0; c < light.channels(); ++c) {
        const std::span<const double> from = light.channel(c);
        Field& field = part.channels.emplace_back();
        if (!part.spin) {
            field = complex_half(from, order_, kind == LightKind::full ? 3 : 0);
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
