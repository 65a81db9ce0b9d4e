// SPDX-License-Identifier: MIT
// How strongly a material responds to each order of light.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "material/material.hpp"

namespace nicol {

/// Mean energy of a ResponseTable's rows by order; outgoing angles are weighted by their projected area on a
/// sphere.
class ResponsePower {
public:
    /// Of outgoing light: s0, and s1 and s2 together.
    static constexpr std::size_t kOutputs = 2;
    /// Of incident light: s0, s1 and s2 together, s3.
    static constexpr std::size_t kParts = 3;

    /// Energies by order, 0..order.
    using Spectrum = std::vector<double>;

    /// Integrates the material at a few angles. channels: as for ResponseTable. Throws as it does.
    ResponsePower(const Material& material, int order, LightKind kind, int channels);

    /// 1 if all channels have the same.
    [[nodiscard]] int channels() const noexcept { return static_cast<int>(of_.size()); }
    /// Zero for parts that the kind of light lacks. Light of energy e_l in order l reflects to a mean square,
    /// over all rotations of the light, of the sum of e_l power_l / (2 l + 1), half of it for s1 and s2.
    [[nodiscard]] const Spectrum& of(int channel, std::size_t output, std::size_t part) const {
        return of_[static_cast<std::size_t>(channels() == 1 ? 0 : channel)][output][part];
    }

private:
    using Channel = std::array<std::array<Spectrum, kParts>, kOutputs>;
    std::vector<Channel> of_;
};

}  // namespace nicol
