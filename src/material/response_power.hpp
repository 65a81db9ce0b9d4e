// SPDX-License-Identifier: MIT
// Strength of a material's response to each order of light.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "material/material.hpp"

namespace nicol {

/// Mean energy of a ResponseTable's rows by order; outgoing angles are weighted by their projected area on a
/// sphere.
class ResponsePower {
public:
    /// Number of outputs of reflected light: s0, and s1 with s2.
    static constexpr std::size_t kOutputs = 2;
    /// Number of parts of incident light: s0, s1 with s2, and s3.
    static constexpr std::size_t kParts = 3;

    /// Energies by order, 0..order.
    using Spectrum = std::vector<double>;

    /// Number of outgoing angles at which materials are integrated.
    static constexpr std::size_t kAngles = 6;
    /// Rows of terms at these angles by terms_key(), all of one order and kind of light.
    using KnownTerms = std::map<std::string, std::array<std::vector<double>, kAngles>>;

    /// Integrates the material at a few angles, or takes the rows of its terms from `known`, to which new
    /// rows are added. `channels` and exceptions are those of ResponseTable.
    ResponsePower(const Material& material, int order, LightKind kind, int channels, KnownTerms& known);

    /// Returns the number of channels; 1 if all channels have the same energies.
    [[nodiscard]] int channels() const noexcept { return static_cast<int>(of_.size()); }
    /// Returns power_l, 0 for parts that the kind of light lacks. Light of energy e_l in order l has a mean
    /// square of reflection, over its rotations, of sum_l e_l power_l / (2 l + 1); half of it for s1 with s2.
    [[nodiscard]] const Spectrum& of(int channel, std::size_t output, std::size_t part) const {
        return of_[static_cast<std::size_t>(channels() == 1 ? 0 : channel)][output][part];
    }

private:
    using Channel = std::array<std::array<Spectrum, kParts>, kOutputs>;
    std::vector<Channel> of_;
};

}  // namespace nicol
