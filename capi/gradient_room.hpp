// SPDX-License-Identifier: MIT
// Room for gradients in the caller's memory.
#pragma once

#include "boundary.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace nicol::capi {

class GradientRoom {
public:
    /// Throws Error(invalid_argument) for a gradient that is not as nicol_gradient says, or that has no room,
    /// and Error(invalid_handle) for a texture of another context than the scene's.
    GradientRoom(const nicol_gradient* given, const nicol_scene_impl& scene);

    /// Returns the gradients that there is room for.
    [[nodiscard]] WantedGradients wanted() const;
    /// Throws Error(invalid_argument) that names the count unless each room has the size of its gradient.
    void check(const Scene& scene, const RenderOptions& options) const;
    void write(const Gradients& gradients) const;

private:
    nicol_gradient room_;
    TexturePtr texture_;
};

}  // namespace nicol::capi
