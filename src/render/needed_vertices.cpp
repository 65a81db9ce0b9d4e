// SPDX-License-Identifier: MIT
#include "render/needed_vertices.hpp"

#include <algorithm>
#include <cstddef>

#include "material/spatial_variation.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {
namespace {

// Vertices of an instance that are needed at least, if it has as many.
constexpr std::size_t kSampledVertices = 1024;
// Fewest vertices that are worth a bake of a part.
constexpr std::size_t kLeastSpared = 4096;
// Samples of pixels, and cameras that are jittered within a pixel, reach no farther beyond an image than so
// many times what find_visible() allows.
constexpr double kMargin = 4;

bool reflects(const Material& material) {
    return material.smooth_boundary() != nullptr || any_term(material, [](const Material& layer, int term) {
               for (int c = 0; c < layer.channels(); ++c)
                   if (layer.weight(term, c) != 0) return true;
               return false;
           });
}

}  // namespace

std::vector<std::uint8_t> needed_vertices(const WorldGeometry& geometry, const Projection& projection) {
    Projection wide = projection;
    wide.pixel *= kMargin;
    std::vector<std::uint8_t> needed;
    find_visible(geometry, wide, needed);
    const auto at = [&needed](std::size_t v) { return needed.begin() + static_cast<std::ptrdiff_t>(v); };
    for (const VertexRange& range : geometry.ranges)
        if (!reflects(*range.material)) std::fill(at(range.first), at(range.last), std::uint8_t{0});
    if (std::ranges::find(needed, 1) == needed.end()) return needed;
    for (const VertexRange& range : geometry.ranges) {
        const std::size_t step = std::max<std::size_t>(1, (range.last - range.first) / kSampledVertices);
        for (std::size_t v = range.first; v < range.last; v += step) needed[v] = 1;
    }
    if (static_cast<std::size_t>(std::ranges::count(needed, 0)) < kLeastSpared) return {};
    return needed;
}

bool shows_others(const WorldGeometry& geometry) {
    return std::ranges::any_of(geometry.ranges, [](const VertexRange& range) {
        return smoothness_of(*range.material, false) != Smoothness::none;
    });
}

}  // namespace nicol
