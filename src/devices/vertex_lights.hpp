// SPDX-License-Identifier: MIT
// Local lights at vertices, on threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "methods/executor.hpp"
#include "surfaces/local_lights.hpp"

namespace nicol {

class VertexLights {
public:
    VertexLights(const LocalLights& lights, const ShadeInput& input) : lights_(lights), input_(input) {}

    /// Adds to out[c][v] the chosen vertices' reflection of local lights and their emission. Adds to
    /// the run's tally.
    void add(RenderRun& run, std::span<const std::span<glm::vec4>> out) const;

private:
    // Adds the light of the vertices first <= v < last of a range.
    LightingTally add(const VertexRange& range, std::size_t first, std::size_t last,
                      std::span<const std::span<glm::vec4>> out) const;
    LightingTally add(const VertexRange& range, std::span<const std::uint32_t> vertices,
                      std::span<const std::span<glm::vec4>> out) const;

    const LocalLights& lights_;
    const ShadeInput& input_;
};

}  // namespace nicol
