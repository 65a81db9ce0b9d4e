// SPDX-License-Identifier: MIT
// The reference method (reference/render_reference.hpp) as one of the renderer's.
#pragma once

#include "render/framebuffer.hpp"
#include "render/render.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Traces an image of the framebuffer's size, on `threads` threads (0: one a core), and puts it there; the
/// luminance of three channels in a framebuffer of one. Throws
/// what render_reference() throws; the framebuffer then holds what it held.
void render_by_reference(const Scene& scene, const Camera& camera, const RenderOptions& options, int threads,
                         Framebuffer& target);

}  // namespace nicol
