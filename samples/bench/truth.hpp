// SPDX-License-Identifier: MIT
// The image against which errors are measured.
#pragma once

#include "image.hpp"
#include "stage.hpp"

/// Renders by the reference method with two seeds, `samples` per pixel each. The mask has the pixels that
/// objects cover completely, without those next to other pixels.
Truth make_truth(const SceneSource& source, std::uint32_t size, std::uint32_t samples, bool shadows);

/// Side of the square whose mean is a compared pixel. The reference method also averages over pixels, so
/// silhouettes would otherwise dominate the errors.
inline constexpr std::uint32_t kReduction = 4;

/// Renders into a framebuffer of kReduction times the size and averages.
Image reduced_image(const Stage& stage, const Recipe& recipe, nicol_framebuffer framebuffer);

/// Errors of default_recipe() against the reference method.
struct DefaultErrors {
    StokesErrors errors;
    double inside;  ///< error of s0 in pixels that are away from the outlines of all instances
    nicol_statistics statistics;
};
DefaultErrors default_errors(const SceneSource& source, std::uint32_t size, std::uint32_t samples);
