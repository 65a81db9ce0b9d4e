// SPDX-License-Identifier: MIT
// A render's arguments as C gives them.
#pragma once

#include "handles.hpp"

namespace nicol::capi {

/// What nicol_render takes, checked as far as can be without a scene.
struct RenderCall {
    Camera camera;
    RenderOptions options;
};
/// Throws Error(invalid_argument). options may be null.
[[nodiscard]] RenderCall read_render_call(const nicol_camera* camera, const nicol_render_options* options);

}  // namespace nicol::capi
