// SPDX-License-Identifier: MIT
// The sun of a clear sky, behind the same atmosphere.
#pragma once

#include "light/environment.hpp"
#include "light/local_light.hpp"

namespace nicol {

/// Returns the sun that lights rayleigh_sky(sky), a directional light of 0.27 degrees in the units of the
/// sky's radiance: a black body of 5778 K and 128 klx beyond the atmosphere, times the transmittances that
/// Preetham et al. (1999) give for air, haze and ozone. Channels are those of the sky: linear sRGB for three,
/// else luminance. A sky of turbidity 0 gets the sun of turbidity 1.7. A sun below the horizon has no
/// irradiance. Throws what unit_sun() throws.
[[nodiscard]] LocalLight sun_of(const RayleighSky& sky);

}  // namespace nicol
