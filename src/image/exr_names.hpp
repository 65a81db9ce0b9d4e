// SPDX-License-Identifier: MIT
// Channel names of Stokes pictures in OpenEXR files.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace nicol {

/// `S<component>.<colour>`, as Mitsuba 3 writes it.
inline std::string exr_channel(std::size_t component, const std::string& colour) {
    constexpr std::array<const char*, 4> stems = {"S0.", "S1.", "S2.", "S3."};
    return stems[component] + colour;
}

}  // namespace nicol
