// SPDX-License-Identifier: MIT
// Colours of a scene file.
#include "nicol/error.hpp"
#include "nicol/scene_description.hpp"

namespace nicol {

ColorDescription::operator const glm::dvec3&() const {
    if (!spectrum.empty())
        throw Error(ErrorCode::unsupported,
                    "a colour given as a table over the wavelength is not supported here; give <rgb>");
    return rgb;
}

}  // namespace nicol
