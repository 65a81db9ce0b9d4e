// SPDX-License-Identifier: MIT
// <bsdf>s of metals.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "import/late_parameters.hpp"
#include "material/conductor.hpp"

namespace nicol::scene {

/// A rough_conductor() whose index waits for the channels of the light.
struct MetalModel final : MaterialModel, LateParameters<RoughConductorParameters> {
    std::string metal;          ///< of named_metals(); empty: eta and k hold
    ColorDescription eta{0.0};  ///< real part of the index, 0 to 100
    ColorDescription k{1.0};    ///< imaginary part, 0 to 100

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;

private:
    /// n - ik, one or one a channel.
    [[nodiscard]] std::vector<std::complex<double>> index(const SceneChannels& channels) const;
};

}  // namespace nicol::scene
