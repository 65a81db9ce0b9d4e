// SPDX-License-Identifier: MIT
#include "transfer/light_fields.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "harmonics/psh.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using Term = LightFields::Term;

// The real or imaginary part of a field's coefficient, times a factor.
struct PartOfField {
    std::size_t position;
    double factor;
};

// Returns the real or imaginary part of f_m; the stored complex number is at `position`.
PartOfField part_of(std::size_t position, int m, bool imaginary, std::size_t imaginary_begin,
                    LightFields::Form form) {
    if (form == LightFields::Form::coefficients) return {position + (imaginary ? imaginary_begin : 0), 1.0};
    const bool exchanged = m % 2 != 0;  // (-i)^m is real or imaginary
    const int quarter = (m % 4 + 4) % 4;
    const bool negative = imaginary ? quarter == 1 || quarter == 2 : quarter == 2 || quarter == 3;
    return {position + (imaginary != exchanged ? imaginary_begin : 0), negative ? -1.0 : 1.0};
}

// Returns the part of a field that holds the light's coefficient 4 psh_index(l, m) + p.
PartOfField part_of(std::size_t coefficient, std::size_t imaginary_begin, LightFields::Form form) {
    const std::size_t p = coefficient % 4;
    const std::size_t index = coefficient / 4;
    const auto l = static_cast<int>(std::sqrt(static_cast<double>(index)));
    const int m = static_cast<int>(index) - l * l - l;
    if (p == 1 || p == 2) return part_of(index, m, p == 2, imaginary_begin, form);
    // a_lm + i a_l-m = sqrt 2 conj(f_lm) over real harmonics.
    const int degree = std::abs(m);
    PartOfField out =
        part_of(static_cast<std::size_t>(l * (l + 1) / 2 + degree), degree, m < 0, imaginary_begin, form);
    if (m != 0) out.factor *= m > 0 ? std::numbers::sqrt2 : -std::numbers::sqrt2;
    return out;
}

// Returns the inverse of `terms`. Numbers that are sums over parts of a field have orthogonal factors, so the
// inverse has these factors divided by the sum of their squares.
std::vector<Term> reversed(const std::vector<Term>& terms, std::size_t parts) {
    std::vector<Term> out(parts, Term{0, 0, 0, 0});
    std::vector<float> squares(parts, 0);
    const auto add = [&](std::size_t part, std::size_t number, float factor) {
        if (factor == 0) return;
        squares[part] += factor * factor;
        Term& term = out[part];
        if (term.first_factor == 0) {
            term.first = number;
            term.first_factor = factor;
        } else {
            term.second = number;
            term.second_factor = factor;
        }
    };
    for (std::size_t j = 0; j < terms.size(); ++j) {
        add(terms[j].first, j, terms[j].first_factor);
        add(terms[j].second, j, terms[j].second_factor);
    }
    for (std::size_t i = 0; i < parts; ++i) {
        if (squares[i] == 0) continue;
        out[i].first_factor /= squares[i];
        out[i].second_factor /= squares[i];
    }
    return out;
}

[[gnu::always_inline]] inline void add_up(const std::vector<Term>& terms, const Lanes* from,
                                          std::size_t from_step, Lanes* to, std::size_t to_step) {
    for (const Term& term : terms) {
        LaneVector first;
        load(from + from_step * term.first, first);
        first *= term.first_factor;
        if (term.second_factor != 0) {
            LaneVector second;
            load(from + from_step * term.second, second);
            first += term.second_factor * second;
        }
        store(to, first);
        to += to_step;
    }
}

}  // namespace

LightFields::LightFields(const LightLayout& layout, Form form) {
    const std::size_t positions = psh_count(layout.order());
    const std::size_t spin = layout.spin_begin();
    const std::size_t s3 = layout.s3_begin();
    const auto add = [&](LightKind component, std::size_t begin, std::size_t end) {
        if (begin == end) return;
        std::vector<Term> terms;
        for (std::size_t j = begin; j < end; ++j) {
            const auto& [first, second] = layout.terms()[j];
            const PartOfField a = part_of(first.coefficient, positions, form);
            const PartOfField b = part_of(second.coefficient, positions, form);
            terms.push_back({a.position, b.position, static_cast<float>(first.factor * a.factor),
                             static_cast<float>(second.factor * b.factor)});
        }
        const auto kind =
            component == LightKind::linear ? LaneRotation::Field::complex : LaneRotation::Field::real;
        parts_.push_back({component, kind, begin, terms, reversed(terms, 2 * positions)});
    };
    add(LightKind::unpolarized, 0, spin);
    add(LightKind::linear, spin, s3);
    add(LightKind::full, s3, layout.size());
}

void LightFields::to_light(const Part& part, const Lanes* all, std::size_t fields, std::size_t field,
                           Lanes* light) {
    dispatch<add_up>(part.to_light, all + field, fields, light + part.begin, std::size_t{1});
}

void LightFields::from_light(const Part& part, const Lanes* light, std::size_t fields, std::size_t field,
                             Lanes* all) {
    dispatch<add_up>(part.from_light, light + part.begin, std::size_t{1}, all + field, fields);
}

}  // namespace nicol
