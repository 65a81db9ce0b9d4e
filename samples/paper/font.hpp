// SPDX-License-Identifier: MIT
// A bitmap font of lower-case letters, digits and punctuation of numbers.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

inline constexpr std::size_t kGlyphWidth = 5;
inline constexpr std::size_t kGlyphHeight = 9;  ///< the last two rows are below the baseline
inline constexpr std::size_t kGlyphAdvance = kGlyphWidth + 1;

/// Returns whether a letter is set at x < kGlyphWidth, y < kGlyphHeight from the top; characters missing from
/// the font are blank.
bool glyph_pixel(char letter, std::size_t x, std::size_t y);
