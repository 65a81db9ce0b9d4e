// SPDX-License-Identifier: MIT
// A render's arguments as C gives them, and the render itself.
#pragma once

#include "handles.hpp"

namespace nicol::capi {

/// What nicol_render takes, read and as far checked as can be without a scene.
struct RenderCall {
    Camera camera;
    nicol_render_options options;
};
/// Throws Error(invalid_argument). options may be null.
[[nodiscard]] RenderCall read_render_call(const nicol_camera* camera, const nicol_render_options* options);

/// Renders `scene`, which is that of `state` or one of its earlier states. The caller holds the session's
/// turn.
void render(const Session& session, SceneState& state, const Scene& scene, const RenderCall& call,
            Framebuffer& target);

}  // namespace nicol::capi
