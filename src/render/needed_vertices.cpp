// SPDX-License-Identifier: MIT
#include "render/needed_vertices.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>

#include "geometry/unit.hpp"
#include "material/spatial_variation.hpp"
#include "render/baked_vertices.hpp"
#include "render/hidden_vertices.hpp"
#include "simd/lanes.hpp"
#include "surfaces/smooth_surfaces.hpp"
#include "visibility/points_in_pixels.hpp"
#include "visibility/visibility.hpp"

namespace nicol {
namespace {

// Vertices of an instance that are needed at least, if it has as many.
constexpr std::size_t kSampledVertices = 1024;
// Fewest vertices that are worth a bake of a part.
constexpr std::size_t kLeastSpared = 1024;
// Fewest vertices beyond those of rays that are worth a search for hidden ones. Pixels may show vertices that
// it finds hidden, through gaps narrower than a pixel.
constexpr std::size_t kLeastSearched = 4096;
// Samples of pixels, and cameras that are jittered within a pixel, reach no farther beyond an image than so
// many times what find_visible() allows.
constexpr double kMargin = 4;
// Share of a ray from a pixel in the cost of baking a vertex, with that of the vertices that rays find
// hidden.
constexpr double kVerticesOfRay = 0.2;
// Share of a ray through a sample in the cost of baking a vertex, with the vertices that its refinement adds
// around it.
constexpr double kVerticesOfSample = 0.004;

// Returns the side of a pixel at the nearest of some vertices.
double pixel_at_nearest(const WorldGeometry& geometry, const Projection& projection,
                        std::span<const std::uint8_t> vertices) {
    const double side = projection.pixel.x * projection.half_width;
    if (projection.view.orthographic) return side;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v] == 0) continue;
        const glm::dvec3 from_eye = glm::dvec3(geometry.positions[v]) - projection.view.eye;
        nearest = std::min(nearest, glm::dot(from_eye, projection.view.forward));
    }
    return side * std::max(nearest, projection.near_clip);
}

// Returns the vertices that an image needs, but not the sample of the others.
NeededVertices needed_by(const WorldGeometry& geometry, const Projection& projection,
                         std::span<const glm::dvec2> samples, SurfaceRays& rays,
                         std::span<const std::uint8_t> known) {
    Projection wide = projection;
    wide.pixel *= kMargin;
    std::vector<std::uint8_t> needed;
    find_visible(geometry, wide, needed);
    const auto at = [&needed](std::size_t v) { return needed.begin() + static_cast<std::ptrdiff_t>(v); };
    for (const VertexRange& range : geometry.ranges)
        if (!reflects(*range.material)) std::fill(at(range.first), at(range.last), std::uint8_t{0});
    const double pixels = 4 / (projection.pixel.x * projection.pixel.y);
    if (!any(needed)) return {.flags = needed, .seen = needed};
    double seen = 0;  // number of vertices that rays may spare
    for (std::size_t v = 0; v < needed.size(); ++v)
        seen += needed[v] != 0 && (known.empty() || known[v] == 0) ? 1 : 0;
    const double of_samples = kVerticesOfSample * static_cast<double>(samples.size());
    // Masks let some samples pass, as drawing decides.
    const bool sampled = !samples.empty() && !has_masks(geometry) && seen > of_samples * pixels;
    if (sampled)
        remove_unsampled(geometry, *rays.get(), projection, samples, needed);
    else if (seen > kLeastSearched + kVerticesOfRay * pixels)
        remove_hidden(geometry, *rays.get(), projection, needed);
    const double pixel = pixel_at_nearest(geometry, projection, needed);
    return {.flags = needed, .seen = needed, .pixel = pixel, .sampled = sampled};
}

void add_flags(std::vector<std::uint8_t>& sum, const std::vector<std::uint8_t>& flags) {
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] |= flags[v];
}

// Adds a sample of each instance: blocks of kLanes vertices, which later steps compute together. Known
// vertices are left out: they would be baked for it alone, and count as not baked where it is used.
void add_sample(const WorldGeometry& geometry, std::span<const std::uint8_t> known,
                std::vector<std::uint8_t>& flags) {
    for (const VertexRange& range : geometry.ranges) {
        const std::size_t count = range.last - range.first;
        const std::size_t step = kLanes * std::max<std::size_t>(1, count / kSampledVertices);
        for (std::size_t first = range.first; first < range.last; first += step)
            for (std::size_t v = first / kLanes * kLanes; v < first / kLanes * kLanes + kLanes; ++v)
                if (v >= range.first && v < range.last && (known.empty() || known[v] == 0)) flags[v] = 1;
    }
}

bool need_the_same_vertices(const Projection& a, const Projection& b) {
    const glm::dvec2 moved = glm::abs(a.shift - b.shift);
    return a.view == b.view && a.near_clip == b.near_clip && a.far_clip == b.far_clip &&
           a.half_width == b.half_width && a.half_height == b.half_height && a.pixel == b.pixel &&
           moved.x <= a.pixel.x && moved.y <= a.pixel.y;
}

}  // namespace

bool reflects(const Material& material) {
    return material.smooth_boundary() != nullptr || any_term(material, [](const Material& layer, int term) {
               for (int c = 0; c < layer.channels(); ++c)
                   if (layer.weight(term, c) != 0) return true;
               return false;
           });
}

NeededVertices needed_vertices(const WorldGeometry& geometry, std::span<const Projection> views,
                               std::span<const glm::dvec2> samples, SurfaceRays& rays,
                               std::span<const std::uint8_t> known) {
    NeededVertices all = needed_by(geometry, views.front(), samples, rays, known);
    for (const Projection& view : views.subspan(1)) {
        const NeededVertices more = needed_by(geometry, view, samples, rays, known);
        all.sampled = all.sampled || more.sampled;
        add_flags(all.flags, more.flags);
        add_flags(all.seen, more.seen);
        if (more.pixel > 0 && (all.pixel == 0 || more.pixel < all.pixel)) all.pixel = more.pixel;
    }
    if (all.pixel == 0) return all;  // nothing is seen
    add_sample(geometry, known, all.flags);
    if (static_cast<std::size_t>(std::ranges::count(all.flags, 0)) < kLeastSpared) all.flags.clear();
    return all;
}

std::vector<std::uint32_t> vertices_in_pixels(const WorldGeometry& geometry,
                                              std::span<const std::uint8_t> flags, double pixel) {
    PointsInPixels cells(pixel);
    std::vector<std::uint32_t> like(geometry.positions.size(), kNoVertex);
    std::size_t shared = 0;
    for (std::uint32_t v = 0; v < like.size(); ++v) {
        if (!flags.empty() && flags[v] == 0) continue;
        const std::uint32_t first = cells.add(geometry.positions[v], unit(geometry.normals[v]), v);
        if (first == v) continue;
        like[v] = first;
        ++shared;
    }
    if (shared < kLeastSpared) like.clear();
    return like;
}

bool need_the_same(std::span<const Projection> a, std::span<const Projection> b) {
    return std::ranges::equal(a, b, need_the_same_vertices);
}

bool are_equal(std::span<const Projection> a, std::span<const Projection> b) {
    return std::ranges::equal(a, b, [](const Projection& left, const Projection& right) {
        return need_the_same_vertices(left, right) && left.shift == right.shift;
    });
}

bool shows_others(const WorldGeometry& geometry, std::span<const std::uint8_t> shown, bool lobes) {
    return std::ranges::any_of(geometry.ranges, [&](const VertexRange& range) {
        return smoothness_of(*range.material, lobes) != Smoothness::none &&
               any(shown.subspan(range.first, range.last - range.first));
    });
}

}  // namespace nicol
