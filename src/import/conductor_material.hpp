// SPDX-License-Identifier: MIT
// Metals of scene files.
#pragma once

#include <complex>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "import/film_description.hpp"
#include "import/late_parameters.hpp"
#include "material/conductor.hpp"

namespace nicol::scene {

/// Model of a rough_conductor() whose index depends on the channels of the light.
struct MetalModel final : MaterialModel, LateParameters<RoughConductorParameters> {
    std::string metal;          ///< name in named_metals(); empty: eta and k hold
    ColorDescription eta{0.0};  ///< real part of the index, 0 to 100
    ColorDescription k{1.0};    ///< imaginary part, 0 to 100
    FilmDescription film;       ///< film on the facets

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;

private:
    /// Returns n - ik, one value or one per channel.
    [[nodiscard]] std::vector<std::complex<double>> index(const SceneChannels& channels) const;
};

/// Returns k of the index 1 - ik of a metal that reflects `reflectance` at normal incidence, k^2 / (4 + k^2).
/// Real parts from (1 - sqrt r) / (1 + sqrt r) to (1 + sqrt r) / (1 - sqrt r) are possible for a reflectance
/// r (Gulbrandsen, "Artist Friendly Metallic Fresnel", JCGT 3(4), 2014, where the user chooses one). The real
/// part 1 is always possible and is near that of aluminium.
[[nodiscard]] glm::dvec3 extinction_of(const glm::dvec3& reflectance);

}  // namespace nicol::scene
