// SPDX-License-Identifier: MIT
// Cameras of the C interface and of the library.
#pragma once

#include "nicol.h"
#include "scene/camera.hpp"

namespace nicol::capi {

/// Throws Error(invalid_argument) for a projection that does not exist; other members are checked where the
/// camera is used.
Camera camera_from(const nicol_camera& given);
nicol_camera camera_to(const Camera& camera);

}  // namespace nicol::capi
