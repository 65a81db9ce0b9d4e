// SPDX-License-Identifier: MIT
// The sky of RayleighSky with turbidity.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// The image for a unit vector `sun` that is not below the horizon and members of `sky` that are in range,
/// turbidity > 0.
[[nodiscard]] EquirectImage turbid_sky_image(const RayleighSky& sky, const glm::dvec3& sun);

}  // namespace nicol
