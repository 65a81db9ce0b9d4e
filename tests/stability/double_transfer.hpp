// SPDX-License-Identifier: MIT
// The sums of relight and shade by definition, vertex by vertex in double precision.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "harmonics/psh.hpp"
#include "material/response_table.hpp"
#include "polarization/stokes.hpp"
#include "polarization/viewpoint.hpp"
#include "specular/high_order.hpp"
#include "visibility/visibility.hpp"

namespace nicol::test {

/// Vertices that are seen from every side. Each sees the environment on one side of a plane, and every fifth
/// sees all of it.
struct Vertices {
    /// Makes normals along the axes, near them and in random directions. Each is seen head-on, nearly
    /// head-on, at 60 and 90 degrees, just above and below the horizon, from behind, from straight above and
    /// below the camera, and from the camera's position. All lengths are multiples of `unit`.
    explicit Vertices(const DirectionSet& directions, double unit = 1, std::size_t normals_anywhere = 12);

    Viewpoint view;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint8_t> visible;  ///< 1 for every vertex
    Visibility visibility;
    /// Vertices seen from straight behind, for which rounding decides the viewer's azimuth.
    std::vector<bool> any_azimuth;
};

/// Stokes vectors in the camera's frame, [channel][vertex].
using Image = std::vector<std::vector<Stokes>>;

/// Returns relight, product with visibility, and shade for every light and response table: [light *
/// responses.size() + response]. Lights are in the world's axes, have the layout's order, and all have
/// equally many channels.
[[nodiscard]] std::vector<Image> shaded_in_double(const Vertices& vertices, const DirectionSet& directions,
                                                  const LightLayout& layout,
                                                  std::span<const PshVector> lights,
                                                  std::span<const ResponseTable> responses);

/// Looks up HighOrderMaps texel by texel with the factors of HighOrder. `fractions` are those of
/// HighOrder::run().
[[nodiscard]] Image high_orders_in_double(const Vertices& vertices, const HighOrderFactors& factors,
                                          const HighOrderMaps& maps, const glm::dmat3& light_to_world,
                                          std::span<const glm::dvec2> fractions, int channels);

/// Returns the visible fractions of HighOrderVisibility for a vertex's mirrored visibility of this order.
[[nodiscard]] glm::dvec2 fractions_in_double(const Vertices& vertices, std::size_t vertex,
                                             std::span<const double> visibility, int order, double width);

/// Deviation of floats from doubles.
struct Deviation {
    double largest = 0;        ///< largest value in double precision
    double worst = 0;          ///< largest difference over `largest`, except at vertices of any_azimuth
    bool finite = true;        ///< whether all floats are finite and at most twice `largest`
    std::size_t negative = 0;  ///< number of s0 < 0 whose double exceeds `tolerance` times the largest
};
[[nodiscard]] Deviation deviation(const Vertices& vertices, const std::vector<std::vector<glm::vec4>>& found,
                                  const Image& truth, double tolerance);

}  // namespace nicol::test
