// SPDX-License-Identifier: MIT
// The sums of relight and shade once more, one vertex after another, in double precision and as they are
// defined.
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

/// Vertices that are seen from every side and see what lies on one side of a plane each; every fifth sees
/// all.
struct Vertices {
    /// Normals along the axes, beside them and anywhere; each seen head-on, beside that, at 60 and at 90
    /// degrees, just above and below the horizon, from behind, from straight above and below the camera, and
    /// in the camera itself. All lengths are in multiples of `unit`.
    explicit Vertices(const DirectionSet& directions, double unit = 1, std::size_t normals_anywhere = 12);

    Viewpoint view;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint8_t> visible;  ///< all
    Visibility visibility;
    /// Seen from straight behind, where the viewer's azimuth is a matter of rounding.
    std::vector<bool> any_azimuth;
};

/// Stokes vectors in the camera's frame, [channel][vertex].
using Image = std::vector<std::vector<Stokes>>;

/// Relight, the product with visibility and shade, for every light under every response table:
/// [light * responses.size() + response]. Lights are in the world's axes, of the layout's order, and all have
/// the same number of channels.
[[nodiscard]] std::vector<Image> shaded_in_double(const Vertices& vertices, const DirectionSet& directions,
                                                  const LightLayout& layout,
                                                  std::span<const PshVector> lights,
                                                  std::span<const ResponseTable> responses);

/// A texel-by-texel look-up of HighOrderMaps with the factors of HighOrder. fractions: as for
/// HighOrder::run().
[[nodiscard]] Image high_orders_in_double(const Vertices& vertices, const HighOrderFactors& factors,
                                          const HighOrderMaps& maps, const glm::dmat3& light_to_world,
                                          std::span<const glm::dvec2> fractions, int channels);

/// The visible fractions of HighOrderVisibility for a vertex's mirrored visibility of this order.
[[nodiscard]] glm::dvec2 fractions_in_double(const Vertices& vertices, std::size_t vertex,
                                             std::span<const double> visibility, int order, double width);

/// How far floats are from doubles.
struct Deviation {
    double largest = 0;        ///< of the values in double
    double worst = 0;          ///< difference of any component, over `largest`; not where any azimuth serves
    bool finite = true;        ///< all floats are, and none is beyond twice `largest`
    std::size_t negative = 0;  ///< s0 < 0 although the double is above `tolerance` times the largest
};
[[nodiscard]] Deviation deviation(const Vertices& vertices, const std::vector<std::vector<glm::vec4>>& found,
                                  const Image& truth, double tolerance);

}  // namespace nicol::test
