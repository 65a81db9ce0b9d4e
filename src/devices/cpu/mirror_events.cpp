// SPDX-License-Identifier: MIT
// Events of chains at opaque surfaces: reflection by smooth terms, as mirrors, and by facets of narrow lobes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "devices/cpu/chain_numbers.hpp"
#include "devices/cpu/smooth_chains.hpp"
#include "material/conductor.hpp"
#include "material/spatial_variation.hpp"
#include "polarization/mueller.hpp"
#include "shading/light_samples.hpp"
#include "shading/lobe_sample.hpp"
#include "shading/normal_variation.hpp"
#include "shading/tangent_rotation.hpp"
#include "shading/weighted_terms.hpp"
#include "surfaces/tangents.hpp"
#include "surfaces/triangle_point.hpp"

namespace nicol {
namespace {

// Adds the matrices of smooth terms, as mirrors, times weights, to those of the channels. towards_viewer: in
// the surface's frame.
void add_mirrors(const Material& material, const glm::dvec3& towards_viewer, const glm::vec3& weights,
                 std::span<Mueller> out) {
    const double scale = kMirrorScale * towards_viewer.z * towards_viewer.z;
    add_terms(
        material, {-towards_viewer.x, -towards_viewer.y, towards_viewer.z}, towards_viewer, weights, scale,
        [&](int term) { return material.smooth(term); }, out);
}

}  // namespace

SmoothChains::Appearance SmoothChains::appearance_at(const Place& place,
                                                     const glm::dvec3& towards_viewer) const {
    const WorldGeometry& geometry = input_.geometry;
    const VertexRange& range = geometry.ranges[place.point.range];
    const std::uint32_t triangle = place.point.triangle;
    thread_local std::vector<glm::vec3> weights;
    weights.assign(1, glm::vec3(1));
    glm::dvec3 normal = place.normal;
    glm::vec3 tangent(0);
    if (range.material->anisotropic()) tangent = nicol::tangent(geometry, triangle, place.weights);
    if (const SpatialVariation* const variation = range.material->variation()) {
        const TexturePoint at = texture_point(geometry, triangle, place.weights);
        const NormalVariation& turned = variation->normal;
        if (turned.kind != NormalVariation::Kind::none || variation->rotation.any()) {
            const bool back = is_back(geometry, range);
            const glm::vec3 of_mesh(place.normal);
            const glm::vec3 of_front = back ? -of_mesh : of_mesh;
            const TextureAxes axes = texture_axes(geometry, triangle);
            const TextureAxes followed = material_axes(geometry, triangle, place.weights, of_front, axes);
            if (variation->rotation.any())
                tangent = rotated_tangent(variation->rotation, at, followed, of_front);
            if (turned.kind != NormalVariation::Kind::none) {
                const TextureAxes& along = turned.kind == NormalVariation::Kind::map ? followed : axes;
                normal = glm::normalize(glm::dvec3(facing(perturbed_normal(turned, at, along, of_mesh, back),
                                                          of_mesh, glm::vec3(towards_viewer))));
            }
        }
        weights.resize(variation->layers.size());
        variation->weights(at, weights);
    }
    const Frame frame = frame_along(normal, glm::dvec3(tangent));
    return {.frame = frame, .viewer = glm::normalize(towards_viewer * frame), .weights = weights};
}

void SmoothChains::reflect(const Chain& chain, const Place& place, const Appearance& seen,
                           const Reflection& reflection, std::vector<Chain>& rest, Ends& ends) const {
    const glm::dvec3 towards_light = glm::normalize(seen.frame * reflection.towards_light);
    if (!(glm::dot(towards_light, place.facet) > 0)) return;
    const Mueller into_received =
        frame_rotation(angle_between(seen.frame * theta_phi_frame(seen.viewer), chain.received));
    const auto matrices = static_cast<std::uint32_t>(ends.matrices.size());
    double share = 0;
    for (std::size_t c = 0; c < reflection.muellers.size(); ++c) {
        share += reflection.muellers[c](0, 0) / static_cast<double>(reflection.muellers.size());
        const glm::mat4 before = ends.matrices[chain.way.matrices + c];
        ends.matrices.push_back(before * in_columns(into_received * reflection.muellers[c]));
    }
    const bool by_lobes = reflection.half != kNoHalf;
    Chain next = after_event(chain, matrices, reflection.number);
    // Later facets belong to the half of the first one.
    if (next.way.half == kNoHalf) next.way.half = reflection.half;
    next.ray = leaving(place.position, place.facet, towards_light, place.offset);
    const glm::dvec3& normal = seen.frame[2];
    const auto bends = bends_at(place, normal, chain.ray, next.spread);
    next.spread.reflect(chain.ray.direction, normal, bends);
    next.received = seen.frame * theta_phi_frame(-reflection.towards_light);
    next.carried *= share;
    next.lit = true;
    next.lobes_lit = by_lobes;
    next.scattered = chain.scattered || by_lobes;
    next.open = leaves_all(place.point.triangle, place.facet, towards_light);
    rest.push_back(next);
}

void SmoothChains::mirror(const Chain& chain, const Place& place, std::vector<Chain>& rest,
                          Ends& ends) const {
    if (chain.events == input_.smooth_events) return;
    const Appearance seen = appearance_at(place, chain.received[2]);
    if (!(seen.viewer.z > 0)) return;
    thread_local std::vector<Mueller> muellers;
    muellers.assign(static_cast<std::size_t>(input_.channels), Mueller());
    const Material& material = *input_.geometry.ranges[place.point.range].material;
    if (const SpatialVariation* const variation = material.variation()) {
        for (std::size_t l = 0; l < seen.weights.size(); ++l)
            add_mirrors(*variation->layers[l].material, seen.viewer, seen.weights[l], muellers);
    } else {
        add_mirrors(material, seen.viewer, glm::vec3(1), muellers);
    }
    reflect(chain, place, seen,
            {.towards_light = {-seen.viewer.x, -seen.viewer.y, seen.viewer.z}, .muellers = muellers}, rest,
            ends);
}

void SmoothChains::follow_lobes(const Chain& chain, const Place& place, std::vector<Chain>& rest,
                                Ends& ends) const {
    // The surface that the ray meets reflects light once more. A ray from a triangle meets nothing if no
    // corner of the triangle sees another surface.
    if (chain.events >= std::min(input_.bounces, input_.smooth_events) || place.point.occluded == 0) return;
    const Appearance seen = appearance_at(place, chain.received[2]);
    if (!(seen.viewer.z > 0)) return;
    thread_local std::vector<Mueller> muellers;
    muellers.resize(static_cast<std::size_t>(input_.channels));
    const std::size_t samples = input_.hits.offsets().size();
    // The more a chain has lost, the sooner it ends by chance.
    const double goes_on = chain.events > 0 ? std::min(1.0, chain.carried) : 1.0;
    if (fraction(sample_seed(chain.seed, ~0U)) >= goes_on) return;
    // Rays of a pixel's samples are spread over the lobe together.
    const std::uint32_t seed = sample_seed(chain.pixel_seed, static_cast<std::uint32_t>(chain.events));
    const auto count =
        static_cast<std::uint32_t>(chain.events > 0 ? 1 : std::max<std::size_t>(1, kLobeSamples / samples));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t number = chain.sample * count + i;
        Lanes u{}, v{};
        light_samples(number, std::span(&seed, 1), u, v);
        const LobeChoice choice{.lobe = fraction(sample_seed(chain.seed, i)), .facet = {u[0], v[0]}};
        const glm::dvec3 towards_light =
            sample_lobes(lobes_[place.point.range].layers, seen.weights, seen.viewer, choice, muellers);
        if (!(towards_light.z > 0)) continue;
        for (Mueller& mueller : muellers) mueller *= 1 / (count * goes_on);
        reflect(chain, place, seen,
                {.towards_light = towards_light,
                 .muellers = muellers,
                 .half = 2 * number < samples * count ? 0U : 1U,
                 .number = i + 1},
                rest, ends);
    }
}

}  // namespace nicol
