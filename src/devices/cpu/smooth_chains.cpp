// SPDX-License-Identifier: MIT
#include "devices/cpu/smooth_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>

#include "devices/mirrored_pixel.hpp"
#include "draw/visibility_buffer.hpp"
#include "light/light_pyramid.hpp"
#include "material/conductor.hpp"
#include "material/reflectance.hpp"
#include "material/spatial_variation.hpp"
#include "polarization/mueller.hpp"
#include "shading/boundary_split.hpp"
#include "shading/channel_spans.hpp"
#include "shading/light_samples.hpp"
#include "shading/normal_variation.hpp"
#include "surfaces/smooth_surfaces.hpp"
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

}  // namespace

// Point of a surface where an event happens.
struct SmoothChains::Place {
    SurfacePoint point;
    glm::vec3 weights;  // barycentric
    glm::dvec3 position;
    glm::dvec3 facet;   // unit normal of the triangle, towards its front
    glm::dvec3 normal;  // unit shading normal
    double offset;      // distance between the surface and the start of rays that leave it
    double distance;    // along the ray
};

// Ends of chains.
struct SmoothChains::Ends {
    struct Surface {
        RayPoint point;
        Way way;
    };
    struct Sky {
        glm::vec3 direction, x;  // in the light's axes
        float variance;          // of the direction within the sample
        Way way;
    };
    std::vector<Surface> surfaces;
    std::vector<Sky> sky;
    std::vector<glm::mat4> matrices;  // into the camera's frames, by channels
    std::uint64_t rays = 0;
    std::size_t range = 0;  // of the previous point
};

SmoothChains::SmoothChains(const SurfaceShading& surfaces)
    : surfaces_(surfaces), input_(surfaces.input()), wanted_(0) {
    for (std::size_t p = 0; p < input_.most_components; ++p) wanted_[static_cast<glm::length_t>(p)] = 1;
}

void SmoothChains::add(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out,
                       PointCounts& counts) const {
    thread_local std::vector<Chain> chains;
    thread_local Ends ends;
    ends.surfaces.clear();
    ends.sky.clear();
    ends.matrices.clear();
    ends.rays = 0;
    ends.range = 0;
    const std::size_t samples = input_.hits.offsets().size();
    for (std::size_t pixel = first; pixel < last; ++pixel) {
        for (std::size_t s = 0; s < samples; ++s) {
            const std::optional<Hit> hit = input_.hits.at(s, pixel);
            if (!hit || input_.smooth->of(hit->triangle) == Smoothness::none) continue;
            chains.push_back(first_chain(pixel, s, ends));
            while (!chains.empty()) {
                const Chain chain = chains.back();
                chains.pop_back();
                follow(chain, chains, ends);
            }
        }
    }
    add_surfaces(ends, out, counts);
    add_sky(ends, out);
    counts.ray_count += ends.rays;
}

SmoothChains::Chain SmoothChains::first_chain(std::size_t pixel, std::size_t sample, Ends& ends) const {
    const Projection& projection = input_.projection;
    const Viewpoint& view = projection.view;
    const auto columns = static_cast<std::size_t>(input_.hits.width());
    const glm::dvec2 place =
        glm::dvec2(pixel % columns, pixel / columns) + 0.5 + input_.hits.offsets()[sample];
    const glm::dvec2 at =
        on_image_plane(projection, input_.hits.width(), input_.hits.height(), place.x, place.y);
    const glm::dvec3 beside = at.x * view.right + at.y * view.up;
    const double weight = 1 / static_cast<double>(input_.hits.offsets().size());
    Chain out{
        .way = {.pixel = static_cast<std::uint32_t>(pixel),
                .matrices = static_cast<std::uint32_t>(ends.matrices.size())},
        .ray = {.origin = view.orthographic ? view.eye + beside : view.eye,
                .direction = view.orthographic ? view.forward : glm::normalize(view.forward + beside)},
        .spread = {},
        .received = {},
        .carried = 1,
        .events = 0,
        .lit = false,
        .seed = sample_seed(static_cast<std::uint32_t>(pixel * kMostPixelSamples + sample), input_.seed)};
    ends.matrices.resize(ends.matrices.size() + static_cast<std::size_t>(input_.channels),
                         glm::mat4(static_cast<float>(weight)));
    out.ray.nearest = projection.near_clip / glm::dot(out.ray.direction, view.forward);
    out.received = view.frame(-out.ray.direction);
    const double size = projection.sample_size * std::sqrt(weight);
    const std::array steps{2 * size * projection.half_width / input_.hits.width() * view.right,
                           -2 * size * projection.half_height / input_.hits.height() * view.up};
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3 step = steps[i] - glm::dot(steps[i], out.ray.direction) * out.ray.direction;
        if (view.orthographic)
            out.spread.places[i] = step;
        else
            out.spread.directions[i] = glm::dot(out.ray.direction, view.forward) * step;
    }
    return out;
}

SmoothChains::Place SmoothChains::place_at(const RayHit& hit, const Ray& ray, Ends& ends) const {
    const WorldGeometry& geometry = input_.geometry;
    const Corners& corners = geometry.triangles[hit.triangle];
    const std::array positions{geometry.positions[corners.x], geometry.positions[corners.y],
                               geometry.positions[corners.z]};
    const glm::dvec3 a(positions[0]), b(positions[1]), c(positions[2]);
    const glm::dvec3 weights(1 - hit.b1 - hit.b2, hit.b1, hit.b2);
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double area = glm::length(across);
    const glm::dvec3 normal = weights.x * glm::dvec3(geometry.normals[corners.x]) +
                              weights.y * glm::dvec3(geometry.normals[corners.y]) +
                              weights.z * glm::dvec3(geometry.normals[corners.z]);
    const double length = glm::length(normal);
    const glm::dvec3 facet = area > 0 ? across / area : -ray.direction;
    return {.point = surface_point(input_, hit.triangle, 0, ends.range),
            .weights = glm::vec3(weights),
            .position = glm::dmat3(a, b, c) * weights,
            .facet = facet,
            .normal = length > 0 ? normal / length : facet,
            .offset = ray_offset(positions),
            .distance = hit.distance};
}

std::array<glm::dvec3, 2> SmoothChains::bends_at(const Place& place, const glm::dvec3& normal, const Ray& ray,
                                                 RaySpread& spread) const {
    const WorldGeometry& geometry = input_.geometry;
    const Corners& corners = geometry.triangles[place.point.triangle];
    const ShownTriangle triangle{
        .corners = {geometry.positions[corners.x], geometry.positions[corners.y],
                    geometry.positions[corners.z]},
        .normals = {geometry.normals[corners.x], geometry.normals[corners.y], geometry.normals[corners.z]},
        .facet = glm::vec3(place.facet)};
    spread.meet(ray.direction, place.distance, place.facet);
    const double side = glm::dot(normal, place.normal) < 0 ? -1 : 1;
    return {side * bend_of_normal(triangle, spread.places[0], place.normal),
            side * bend_of_normal(triangle, spread.places[1], place.normal)};
}

void SmoothChains::follow(const Chain& chain, std::vector<Chain>& rest, Ends& ends) const {
    ++ends.rays;
    const std::optional<RayHit> hit = input_.smooth->intersect(chain.ray);
    if (!hit) {
        if (chain.lit || input_.sky == nullptr) return;
        const glm::dmat3 to_light = glm::transpose(input_.light_to_geometry);
        ends.sky.push_back({.direction = glm::vec3(to_light * chain.ray.direction),
                            .x = glm::vec3(to_light * chain.received[0]),
                            .variance = static_cast<float>(chain.spread.variance()),
                            .way = chain.way});
        return;
    }
    const Smoothness smoothness = input_.smooth->of(hit->triangle);
    Place place = place_at(*hit, chain.ray, ends);
    place.point.pixel = chain.way.pixel;
    if (smoothness == Smoothness::boundary) return pass(chain, place, rest, ends);
    if (!(glm::dot(place.facet, chain.ray.direction) < 0)) return;  // backs are black
    if (smoothness == Smoothness::mirror) {
        mirror(chain, place, rest, ends);
        if (chain.events == 0) return;  // the rest of the pixel's light is shaded as that of other pixels
    }
    ends.surfaces.push_back({.point = {place.point, place.weights.y, place.weights.z,
                                       Viewpoint{.orthographic = true,
                                                 .eye = chain.ray.origin,
                                                 .forward = chain.ray.direction,
                                                 .up = chain.received[1],
                                                 .right = chain.received[0]},
                                       !chain.lit},
                             .way = chain.way});
}

void SmoothChains::pass(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const {
    if (chain.events == kMostEvents) return;
    const SmoothBoundary& boundary = *input_.geometry.ranges[place.point.range].material->smooth_boundary();
    const BoundarySplit split = split_at(boundary, place.facet, place.normal, chain.received);
    const double reflected = mean_factor(boundary.reflectance) * split.reflected.share;
    const double transmitted = mean_factor(boundary.transmittance) * split.transmitted.share;
    const double both = reflected + transmitted;
    if (!(both > 0)) return;
    RaySpread reflected_spread = chain.spread;
    const auto bends = bends_at(place, split.normal, chain.ray, reflected_spread);
    RaySpread transmitted_spread = reflected_spread;
    reflected_spread.reflect(chain.ray.direction, split.normal, bends);
    if (boundary.behind == SmoothBoundary::Behind::body)
        transmitted_spread.refract(chain.ray.direction, split.normal, bends, split.eta);
    const auto go_on = [&](const BoundaryPart& part, const std::vector<double>& factors, double probability,
                           double carried) {
        const auto matrices = static_cast<std::uint32_t>(ends.matrices.size());
        const glm::mat4 event = in_columns(part.mueller);
        for (int c = 0; c < input_.channels; ++c) {
            const auto factor = static_cast<float>(of_channel(factors, c) / probability);
            const glm::mat4 before = ends.matrices[chain.way.matrices + static_cast<std::size_t>(c)];
            ends.matrices.push_back(before * (factor * event));
        }
        rest.push_back({.way = {.pixel = chain.way.pixel, .matrices = matrices},
                        .ray = leaving(place.position, place.facet, part.towards_light, place.offset),
                        .spread = &part == &split.reflected ? reflected_spread : transmitted_spread,
                        .received = part.incident,
                        .carried = carried,
                        .events = chain.events + 1,
                        .lit = false,
                        .seed = sample_seed(chain.seed, matrices - chain.way.matrices)});
    };
    if (std::min(reflected, transmitted) * chain.carried >= kBothCarry) {
        go_on(split.transmitted, boundary.transmittance, 1, transmitted * chain.carried);
        go_on(split.reflected, boundary.reflectance, 1, reflected * chain.carried);
    } else if (fraction(chain.seed) * both < reflected) {
        go_on(split.reflected, boundary.reflectance, reflected / both, both * chain.carried);
    } else {
        go_on(split.transmitted, boundary.transmittance, transmitted / both, both * chain.carried);
    }
}

void SmoothChains::mirror(const Chain& chain, const Place& place, std::vector<Chain>& rest,
                          Ends& ends) const {
    if (chain.events == kMostEvents) return;
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
                    .received = frame * theta_phi_frame(-mirrored),
                    .carried = share * chain.carried,
                    .events = chain.events + 1,
                    .lit = true,
                    .seed = sample_seed(chain.seed, matrices - chain.way.matrices)});
}

void SmoothChains::add_surfaces(Ends& ends, std::span<const std::span<glm::vec4>> out,
                                PointCounts& counts) const {
    thread_local PixelBatch batch;
    thread_local std::vector<RayPoint> points;
    thread_local std::vector<glm::vec4> light;
    std::ranges::stable_sort(ends.surfaces, {}, [](const Ends::Surface& end) { return end.point.group(); });
    points.clear();
    for (const Ends::Surface& end : ends.surfaces) points.push_back(end.point);
    for (std::size_t begin = 0; begin < points.size(); begin += batch.points().size()) {
        batch.take(input_, std::span<const RayPoint>(points).subspan(begin));
        const std::size_t count = batch.points().size();
        const std::vector<std::span<glm::vec4>> stokes = channel_spans(light, out.size(), count);
        surfaces_.run(batch, stokes, counts);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t c = 0; c < out.size(); ++c)
                add_arriving(ends, ends.surfaces[begin + i].way, c, stokes[c][i], out);
        }
    }
}

void SmoothChains::add_sky(const Ends& ends, std::span<const std::span<glm::vec4>> out) const {
    thread_local LaneLight light;
    Lanes variances;
    for (std::size_t begin = 0; begin < ends.sky.size(); begin += kLanes) {
        const std::span some = std::span(ends.sky).subspan(begin, std::min(kLanes, ends.sky.size() - begin));
        for (std::size_t i = 0; i < kLanes; ++i) {
            const Ends::Sky& end = some[i < some.size() ? i : 0];
            put(light.towards, i, glm::normalize(end.direction));
            variances[i] = end.variance;
        }
        input_.sky->look_up(variances, light);
        for (std::size_t i = 0; i < some.size(); ++i) {
            // From the image's frame into that of the chain: both have z along the light.
            const glm::vec3 z = -vector_at(light.towards, i);
            const glm::vec3 x = light.components > 1 ? vector_at(light.x, i) : some[i].x;
            const float c = glm::dot(some[i].x, x), s = glm::dot(some[i].x, glm::cross(z, x));
            const float cosine = c * c - s * s, sine = 2 * c * s;
            for (std::size_t channel = 0; channel < out.size(); ++channel) {
                const std::array<Lanes, 4>& of = light.irradiance[light.irradiance.size() == 1 ? 0 : channel];
                const auto component = [&](std::size_t p) { return p < light.components ? of[p][i] : 0.0F; };
                const glm::vec4 arriving(component(0), cosine * component(1) + sine * component(2),
                                         cosine * component(2) - sine * component(1), component(3));
                add_arriving(ends, some[i].way, channel, static_cast<float>(input_.light_scale) * arriving,
                             out);
            }
        }
    }
}

void SmoothChains::add_arriving(const Ends& ends, const Way& way, std::size_t channel,
                                const glm::vec4& stokes, std::span<const std::span<glm::vec4>> out) const {
    out[channel][way.pixel] += wanted_ * (ends.matrices[way.matrices + channel] * stokes);
}

}  // namespace nicol
