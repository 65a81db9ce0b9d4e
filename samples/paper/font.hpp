// SPDX-License-Identifier: MIT
// A bitmap font: small letters, digits and what goes with numbers.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

inline constexpr std::size_t kGlyphWidth = 5;
inline constexpr std::size_t kGlyphHeight = 9;  ///< the last two rows are below the base line
inline constexpr std::size_t kGlyphAdvance = kGlyphWidth + 1;

/// Whether a letter is set at x < kGlyphWidth, y < kGlyphHeight from the top; characters the font lacks are
/// blank.
bool glyph_pixel(char letter, std::size_t x, std::size_t y);
