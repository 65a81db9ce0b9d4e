// SPDX-License-Identifier: MIT
// Vertices at which bounced light is computed, and interpolation of it between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "transfer/surface_links.hpp"

namespace nicol {

/// Receivers of bounced light: some of the vertices, dense where other surfaces are near or where the surface
/// bends. Bounced light varies slowly elsewhere, so the other vertices interpolate it.
struct Receivers {
    /// Interpolation at one vertex.
    struct Blend {
        static constexpr std::size_t kMost = 4;

        std::array<std::uint32_t, kMost> receivers;
        std::array<float, kMost> weights;  ///< their sum is 1, or 0 where no surface sends light
    };

    std::vector<std::uint32_t> vertices;  ///< vertex of each receiver
    std::vector<SurfaceLink> links;       ///< links of all receivers, in their order
    std::vector<Blend> blends;            ///< blend of each vertex
};

/// Chooses the receivers of a geometry. Each vertex with a link is a receiver, or close to one relative to
/// the distance of the surfaces that the receiver sees, with a similar normal (the condition of Ward's
/// irradiance cache) and similar hidden light. Runs on the calling thread's TBB arena; the result does not
/// depend on the number of threads.
[[nodiscard]] Receivers find_receivers(const BakeGeometry& geometry, const LinkSearch& search,
                                       const Visibility& visibility, const BakeProgress& progress = {});

}  // namespace nicol
