// SPDX-License-Identifier: MIT
// Measured optical constants of named metals, and of other solids that go by that name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nicol {

/// The index n - ik at a wavelength in nm.
struct MetalSample {
    double wavelength, n, k;
};

struct NamedMetal {
    std::string_view name;
    /// By increasing wavelength, linear between; from below 380 to beyond 800 nm where it was measured there.
    std::span<const MetalSample> samples;
};

/// The names of Mitsuba 3's conductors, and gold, silver, copper, aluminium and aluminum.
[[nodiscard]] std::span<const NamedMetal> named_metals();

/// All names, for messages.
[[nodiscard]] std::string metal_names();

}  // namespace nicol
