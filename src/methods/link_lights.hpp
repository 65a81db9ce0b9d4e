// SPDX-License-Identifier: MIT
// Reflection along links of the lights of many columns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "simd/lanes.hpp"

namespace nicol {

/// Lights that leave along a link together, each times its weight.
struct LinkLights {
    std::array<const Lanes*, 4> lights;  ///< [number][Lanes of columns] each
    std::array<float, 4> weights;
    std::uint32_t count = 0;  ///< 0, 1, 3 or 4
    std::uint32_t whole = 0;  ///< leading ones that have numbers beyond those of s0: all, the first or none
    float share = 1;          ///< factor of these numbers' part of s0

    void add(const Lanes* light, float weight) {
        lights[count] = light;
        weights[count++] = weight;
    }
    /// Asks for the memory where the lights begin. The rest comes by itself, because it is read in order.
    [[gnu::always_inline]] void prefetch() const {
        constexpr std::size_t lines = 4;
        for (std::size_t n = 0; n < count; ++n)
            for (std::size_t k = 0; k < lines; ++k) __builtin_prefetch(lights[n] + k);
    }
};

/// Rows of a batch of links and the numbers that they multiply.
struct LinkRows {
    const float* rows;  ///< [link][component][number]
    std::size_t row_size;
    std::size_t components;
    std::size_t scalars;  ///< count of the numbers of s0
    std::size_t numbers;
    std::size_t lanes;
};

/// Adds what a batch of links reflects of lights to Stokes components, [link][component][Lanes of columns].
void add_links(const LinkRows& rows, std::span<const LinkLights> links, Lanes* stokes);

}  // namespace nicol
