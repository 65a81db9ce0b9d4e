// SPDX-License-Identifier: MIT
// The sky of RayleighSky with turbidity.
#pragma once

#include "nicol/environment.hpp"

namespace nicol {

/// The picture for a unit vector `sun` that is not below the horizon and members of `sky` that are in range,
/// turbidity > 0.
[[nodiscard]] EquirectImage turbid_sky_picture(const RayleighSky& sky, const glm::dvec3& sun);

}  // namespace nicol
