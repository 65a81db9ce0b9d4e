// SPDX-License-Identifier: MIT
// Gradients by the coefficients of a light from gradients by the numbers of its layout.
#pragma once

#include <cstddef>
#include <span>

#include "harmonics/light_layout.hpp"
#include "harmonics/psh.hpp"

namespace nicol {

/// Returns the gradient by coefficients from that by numbers, [channel][number]: the transpose of
/// LightLayout::terms().
[[nodiscard]] inline PshVector gradient_by_coefficients(std::span<const double> numbers,
                                                        const LightLayout& layout, int channels) {
    PshVector out(layout.order(), channels);
    for (int c = 0; c < channels; ++c) {
        const std::span<double> channel = out.channel(c);
        const std::span own = numbers.subspan(static_cast<std::size_t>(c) * layout.size(), layout.size());
        for (std::size_t j = 0; j < own.size(); ++j)
            for (const LightLayout::Term& term : layout.terms()[j])
                channel[term.coefficient] += term.factor * own[j];
    }
    return out;
}

}  // namespace nicol
