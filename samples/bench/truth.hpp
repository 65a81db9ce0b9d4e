// SPDX-License-Identifier: MIT
// The image that errors are measured against.
#pragma once

#include "image.hpp"
#include "stage.hpp"

/// By the reference method with two seeds, `samples` per pixel each. The mask has the pixels that objects
/// cover completely, without those next to other pixels.
Truth make_truth(const SceneSource& source, std::uint32_t size, std::uint32_t samples, bool shadows);

/// A compared pixel is the mean of a square of this side, since the reference averages over pixels too;
/// otherwise silhouettes would dominate the errors.
inline constexpr std::uint32_t kReduction = 4;

/// In a framebuffer that has kReduction times the size.
Image reduced_image(const Stage& stage, const Recipe& recipe, nicol_framebuffer framebuffer);
