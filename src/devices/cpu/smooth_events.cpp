// SPDX-License-Identifier: MIT
// Events of chains at boundaries: reflection and refraction by smooth ones and by facets of rough ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "devices/cpu/chain_numbers.hpp"
#include "devices/cpu/smooth_chains.hpp"
#include "material/reflectance.hpp"
#include "polarization/mueller.hpp"
#include "shading/boundary_split.hpp"
#include "shading/light_samples.hpp"
#include "shading/rough_boundary.hpp"

namespace nicol {
namespace {

// Golden ratios of the plane: 1 / g and 1 / g^2 for g^3 = g + 1.
constexpr glm::dvec2 kEvenSteps(0.7548776662466927, 0.5698402909980532);

// Returns the variance, along an axis, of directions that facets of a rough boundary send light in.
double facet_variance(const SmoothBoundary& boundary, double eta, bool reflects) {
    // The slopes of facets have about this variance.
    const double slopes = boundary.alpha * boundary.alpha / 2;
    const bool mirrors = reflects || boundary.behind == SmoothBoundary::Behind::slab;
    const double bend = mirrors ? 2.0 : 1 - 1 / eta;
    return bend * bend * slopes;
}

}  // namespace

std::array<glm::dvec3, 2> SmoothChains::bends_at(const Place& place, const glm::dvec3& normal, const Ray& ray,
                                                 RaySpread& spread) const {
    const WorldGeometry& geometry = input_.geometry;
    const Corners& corners = geometry.triangles[place.point.triangle];
    const ShownTriangle triangle{
        .corners = {geometry.positions[corners.x], geometry.positions[corners.y],
                    geometry.positions[corners.z]},
        .normals = {geometry.normals[corners.x], geometry.normals[corners.y], geometry.normals[corners.z]}};
    spread.meet(ray.direction, place.distance, place.facet);
    const double side = glm::dot(normal, place.normal) < 0 ? -1 : 1;
    return {side * bend_of_normal(triangle, spread.places[0], place.normal),
            side * bend_of_normal(triangle, spread.places[1], place.normal)};
}

void SmoothChains::go_on(const Chain& chain, const Place& place, const Event& event, std::vector<Chain>& rest,
                         Ends& ends) const {
    const auto matrices = static_cast<std::uint32_t>(ends.matrices.size());
    const BoundaryPart& part = event.reflects ? event.split.reflected : event.split.transmitted;
    const std::vector<double>& factors =
        event.reflects ? event.boundary.reflectance : event.boundary.transmittance;
    const bool coated = event.boundary.film != nullptr;
    glm::mat4 mueller = in_columns(part.mueller);
    for (int c = 0; c < input_.channels; ++c) {
        if (coated) mueller = in_columns(mueller_of(event.boundary, event.split, part, c));
        const auto factor = static_cast<float>(of_channel(factors, c) / event.probability);
        const glm::mat4 before = ends.matrices[chain.way.matrices + static_cast<std::size_t>(c)];
        ends.matrices.push_back(before * (factor * mueller));
    }
    Chain next{.way = {.pixel = chain.way.pixel, .matrices = matrices, .half = chain.way.half},
               .ray = leaving(place.position, place.facet, part.towards_light, place.offset),
               .spread = chain.spread,
               .blur = chain.blur,
               .received = part.incident,
               .carried = chain.carried * mean_factor(factors) * part.share / event.probability,
               .events = chain.events + 1,
               .lit = chain.lobes_lit,
               .lobes_lit = chain.lobes_lit,
               .scattered = chain.scattered || event.boundary.rough(),
               .body = body_before(event.boundary, event.split, part, chain.body),
               .seed = sample_seed(chain.seed, matrices - chain.way.matrices),
               .pixel_seed = chain.pixel_seed,
               .sample = chain.sample};
    const auto bends = bends_at(place, event.split.normal, chain.ray, next.spread);
    if (event.reflects)
        next.spread.reflect(chain.ray.direction, event.split.normal, bends);
    else if (event.boundary.behind == SmoothBoundary::Behind::body)
        next.spread.refract(chain.ray.direction, event.split.normal, bends, event.split.eta);
    rest.push_back(next);
}

void SmoothChains::pass(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const {
    if (chain.events == input_.smooth_events) return;
    const SmoothBoundary& boundary = *input_.geometry.ranges[place.point.range].material->smooth_boundary();
    const BoundarySplit split = split_at(boundary, place.facet, place.normal, chain.received);
    const double reflected = mean_factor(boundary.reflectance) * split.reflected.share;
    const double transmitted = mean_factor(boundary.transmittance) * split.transmitted.share;
    const double both = reflected + transmitted;
    if (!(both > 0)) return;
    if (std::min(reflected, transmitted) * chain.carried >= kBothCarry) {
        go_on(chain, place, {boundary, split, false, 1}, rest, ends);
        go_on(chain, place, {boundary, split, true, 1}, rest, ends);
    } else {
        const bool reflects = fraction(chain.seed) * both < reflected;
        go_on(chain, place, {boundary, split, reflects, (reflects ? reflected : transmitted) / both}, rest,
              ends);
    }
}

void SmoothChains::scatter(const Chain& chain, const Place& place, std::vector<Chain>& rest,
                           Ends& ends) const {
    if (chain.events == input_.smooth_events) return;
    const SmoothBoundary& boundary = *input_.geometry.ranges[place.point.range].material->smooth_boundary();
    const bool front = glm::dot(place.facet, chain.ray.direction) < 0;
    const int samples = chain.scattered ? 1 : kFacetSamples;
    const double of_pixel = static_cast<double>(input_.hits.offsets().size()) /
                            (input_.projection.sample_size * input_.projection.sample_size);
    const glm::dvec2 first(fraction(chain.seed), fraction(sample_seed(chain.seed, 1)));
    for (int i = 0; i < samples; ++i) {
        // Multiples of these numbers fill a square evenly (Roberts, 2018).
        const glm::dvec2 point = glm::fract(first + static_cast<double>(i) * kEvenSteps);
        const BoundarySplit split =
            split_at_facet(boundary, place.facet, place.normal, chain.received, point);
        const double transmitted = mean_factor(boundary.transmittance) * split.transmitted.share;
        // The light that the front reflects is that of the material's terms.
        const double reflected = front ? 0 : mean_factor(boundary.reflectance) * split.reflected.share;
        if (!(reflected + transmitted > 0)) continue;
        const double share = reflected / (reflected + transmitted);
        const bool reflects = fraction(sample_seed(chain.seed, static_cast<std::uint32_t>(i) + 2)) < share;
        Chain sampled = chain;
        if (!chain.scattered)
            sampled.blur += facet_variance(boundary, split.eta, reflects) / (samples * of_pixel);
        go_on(sampled, place, {boundary, split, reflects, samples * (reflects ? share : 1 - share)}, rest,
              ends);
    }
}

}  // namespace nicol
