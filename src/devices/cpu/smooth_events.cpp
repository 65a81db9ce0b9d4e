// SPDX-License-Identifier: MIT
// Events of chains: reflection and refraction by smooth boundaries, by facets of rough ones, and by mirrors.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "devices/cpu/smooth_chains.hpp"
#include "material/conductor.hpp"
#include "material/reflectance.hpp"
#include "material/spatial_variation.hpp"
#include "polarization/mueller.hpp"
#include "shading/boundary_split.hpp"
#include "shading/light_samples.hpp"
#include "shading/normal_variation.hpp"
#include "shading/rough_boundary.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {
namespace {

double fraction(std::uint32_t bits) {
    return bits * 0x1p-32;
}

// Returns a matrix by columns, as glm multiplies.
glm::mat4 in_columns(const Mueller& m) {
    glm::mat4 out;
    for (glm::length_t row = 0; row < 4; ++row)
        for (glm::length_t column = 0; column < 4; ++column)
            out[column][row] =
                static_cast<float>(m(static_cast<std::size_t>(row), static_cast<std::size_t>(column)));
    return out;
}

// Adds the matrices of smooth terms, as mirrors, times weights, to those of the channels. towards_viewer: in
// the surface's frame.
void add_mirrors(const Material& material, const glm::dvec3& towards_viewer, const glm::vec3& weights,
                 std::vector<Mueller>& out) {
    thread_local std::vector<Mueller> terms;
    terms.resize(static_cast<std::size_t>(material.terms()));
    material.evaluate_terms({-towards_viewer.x, -towards_viewer.y, towards_viewer.z}, towards_viewer, terms);
    // ReflectedLight::add_mirrored() scales a smooth term by the same factor.
    const double scale =
        4 * std::numbers::pi * kSmoothAlpha * kSmoothAlpha * towards_viewer.z * towards_viewer.z;
    for (int t = 0; t < material.terms(); ++t) {
        if (!material.smooth(t)) continue;
        for (std::size_t c = 0; c < out.size(); ++c) {
            const auto of_layer = static_cast<double>(weights[out.size() == 3 ? static_cast<int>(c) : 0]);
            const double of_term = material.weight(t, material.channels() == 1 ? 0 : static_cast<int>(c));
            out[c] = out[c] + scale * of_layer * of_term * terms[static_cast<std::size_t>(t)];
        }
    }
}

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
    const glm::mat4 mueller = in_columns(part.mueller);
    for (int c = 0; c < input_.channels; ++c) {
        const auto factor = static_cast<float>(of_channel(factors, c) / event.probability);
        const glm::mat4 before = ends.matrices[chain.way.matrices + static_cast<std::size_t>(c)];
        ends.matrices.push_back(before * (factor * mueller));
    }
    Chain next{.way = {.pixel = chain.way.pixel, .matrices = matrices},
               .ray = leaving(place.position, place.facet, part.towards_light, place.offset),
               .spread = chain.spread,
               .blur = chain.blur,
               .received = part.incident,
               .carried = chain.carried * mean_factor(factors) * part.share / event.probability,
               .events = chain.events + 1,
               .lit = false,
               .scattered = chain.scattered || event.boundary.rough(),
               .body = body_before(event.boundary, event.split, part, chain.body),
               .seed = sample_seed(chain.seed, matrices - chain.way.matrices)};
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

void SmoothChains::mirror(const Chain& chain, const Place& place, std::vector<Chain>& rest,
                          Ends& ends) const {
    if (chain.events == input_.smooth_events) return;
    const WorldGeometry& geometry = input_.geometry;
    const VertexRange& range = geometry.ranges[place.point.range];
    const glm::dvec3 towards_viewer = chain.received[2];
    thread_local std::vector<Mueller> mirrors;
    mirrors.assign(static_cast<std::size_t>(input_.channels), Mueller());
    glm::dvec3 normal = place.normal;
    const auto local = [&](const Frame& frame) { return glm::normalize(towards_viewer * frame); };
    Frame frame = theta_phi_frame(normal);
    if (const SpatialVariation* const variation = range.material->variation()) {
        const std::uint32_t triangle = place.point.triangle;
        const TexturePoint at =
            texture_point(place.weights, geometry.texcoords.empty() ? nullptr : &geometry.texcoords[triangle],
                          geometry.colors.empty() ? nullptr : &geometry.colors[triangle]);
        if (variation->normal.kind != NormalVariation::Kind::none) {
            const bool back = is_back(geometry, range);
            const glm::vec3 of_mesh(normal);
            TextureAxes axes = texture_axes(geometry, triangle);
            if (variation->normal.kind == NormalVariation::Kind::map)
                axes = material_axes(geometry, triangle, place.weights, back ? -of_mesh : of_mesh, axes);
            normal =
                glm::normalize(glm::dvec3(facing(perturbed_normal(variation->normal, at, axes, of_mesh, back),
                                                 of_mesh, glm::vec3(towards_viewer))));
            frame = theta_phi_frame(normal);
        }
        thread_local std::vector<glm::vec3> weights;
        weights.resize(variation->layers.size());
        variation->weights(at, weights);
        for (std::size_t l = 0; l < weights.size(); ++l)
            add_mirrors(*variation->layers[l].material, local(frame), weights[l], mirrors);
    } else {
        add_mirrors(*range.material, local(frame), glm::vec3(1), mirrors);
    }
    const glm::dvec3 viewer = local(frame);
    if (!(viewer.z > 0)) return;
    const glm::dvec3 mirrored(-viewer.x, -viewer.y, viewer.z);
    const glm::dvec3 towards_light = glm::normalize(frame * mirrored);
    if (!(glm::dot(towards_light, place.facet) > 0)) return;
    const Mueller into_received =
        frame_rotation(angle_between(frame * theta_phi_frame(viewer), chain.received));
    const auto matrices = static_cast<std::uint32_t>(ends.matrices.size());
    double share = 0;
    for (std::size_t c = 0; c < mirrors.size(); ++c) {
        share += mirrors[c](0, 0) / static_cast<double>(mirrors.size());
        const glm::mat4 before = ends.matrices[chain.way.matrices + c];
        ends.matrices.push_back(before * in_columns(into_received * mirrors[c]));
    }
    RaySpread spread = chain.spread;
    const auto bends = bends_at(place, normal, chain.ray, spread);
    spread.reflect(chain.ray.direction, normal, bends);
    rest.push_back({.way = {.pixel = chain.way.pixel, .matrices = matrices},
                    .ray = leaving(place.position, place.facet, towards_light, place.offset),
                    .spread = spread,
                    .blur = chain.blur,
                    .received = frame * theta_phi_frame(-mirrored),
                    .carried = share * chain.carried,
                    .events = chain.events + 1,
                    .lit = true,
                    .scattered = chain.scattered,
                    .body = chain.body,
                    .seed = sample_seed(chain.seed, matrices - chain.way.matrices)});
}

}  // namespace nicol
