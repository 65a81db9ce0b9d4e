// SPDX-License-Identifier: MIT
// Light of lamps that narrow lobes send to receivers of bounced light, followed from the lamps on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "methods/linked_surfaces.hpp"
#include "methods/transfer_input.hpp"
#include "stage/workers.hpp"

namespace nicol {

/// Lobes narrower than this many radians send photons. Links meet so little of what narrow lobes show of a
/// lamp that some receivers would be far too bright and all others too dark.
inline constexpr double kWidestPhotonLobe = 0.25;
/// Returns whether a term of a material without variation() sends photons: if it reflects light by facets
/// with a narrow lobe. Links carry what all other terms reflect of lamps, and what photons' terms reflect of
/// the light that glass and mirrors focus.
[[nodiscard]] bool sends_photons(const Material& material, int term);

/// Photons of one scene. Each photon is spread over the receivers that interpolation at its place blends.
class LobePhotons {
public:
    /// Part of a photon that a receiver gets.
    struct Part {
        std::uint32_t receiver;
        std::uint32_t direction;  ///< index in the DirectionSet of the direction that is near the photon's
    };

    LobePhotons() = default;
    /// Follows the light of input.local_lights, which must not be null. Adds the rays to the statistics.
    LobePhotons(const TransferInput& input, const LinkedSurfaces& surfaces, RenderRun& run);

    /// Returns the range of the parts of a block of sixteen receivers.
    [[nodiscard]] std::size_t first(std::size_t block) const { return firsts_.empty() ? 0 : firsts_[block]; }
    [[nodiscard]] std::size_t last(std::size_t block) const {
        return firsts_.empty() ? 0 : firsts_[block + 1];
    }
    [[nodiscard]] const Part& part(std::size_t index) const { return parts_[index]; }
    /// Returns the Stokes vector of the radiance times its solid angle, in the frame field of link_frames().
    [[nodiscard]] const glm::vec4& stokes(std::size_t index, std::size_t channel) const {
        return stokes_[index * channels_ + channel];
    }

private:
    std::size_t channels_ = 0;
    std::vector<Part> parts_;
    std::vector<glm::vec4> stokes_;    // [part][channel]
    std::vector<std::size_t> firsts_;  // of each block, and the number of parts; empty: there are none
};

/// Returns the most bytes that the photons of a scene take, also while they are sorted.
[[nodiscard]] std::uint64_t most_photon_bytes(std::size_t channels);

}  // namespace nicol
