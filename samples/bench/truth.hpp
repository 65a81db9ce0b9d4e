// SPDX-License-Identifier: MIT
// The image that errors are measured against.
#pragma once

#include "image.hpp"
#include "stage.hpp"

/// By the reference method with two seeds, `samples` a pixel each. The mask holds the pixels that objects
/// cover wholly, less those beside others.
Truth make_truth(const Workshop& workshop, std::uint32_t size, std::int32_t samples, bool shadows);

/// Sides of the squares of pixels of which one pixel of a comparison is the mean: references are means over
/// a pixel too, and without that silhouettes would be what differs most.
inline constexpr std::uint32_t kReduction = 4;

/// In a framebuffer that has kReduction times the size.
Image reduced_image(const Stage& stage, const Recipe& recipe, nicol_framebuffer framebuffer);
