// SPDX-License-Identifier: MIT
// Texels of the image of distant light.
#pragma once

#include <cstddef>

#include "light/environment.hpp"
#include "light/equirect_texels.hpp"

namespace nicol {

/// Returns texels_of() the image of an environment. The environment's own pixels are read where they are.
[[nodiscard]] EquirectTexels texels_of(const Environment& environment, bool polarized, std::size_t channels);

}  // namespace nicol
