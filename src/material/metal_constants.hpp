// SPDX-License-Identifier: MIT
// Measured optical constants of metals and other solids, by name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nicol {

/// Measured index n - ik at a wavelength in nm.
struct MetalSample {
    double wavelength, n, k;
};

struct NamedMetal {
    std::string_view name;
    /// Samples by increasing wavelength, linear between. They cover 380 to 800 nm if that range was measured.
    std::span<const MetalSample> samples;
};

/// Returns all metals: Mitsuba 3's conductors, and gold, silver, copper, aluminium and aluminum.
[[nodiscard]] std::span<const NamedMetal> named_metals();

/// Returns all names, separated by commas, for messages.
[[nodiscard]] std::string metal_names();

}  // namespace nicol
