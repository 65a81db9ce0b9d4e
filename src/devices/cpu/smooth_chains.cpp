// SPDX-License-Identifier: MIT
#include "devices/cpu/smooth_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "devices/mirrored_pixel.hpp"
#include "draw/visibility_buffer.hpp"
#include "light/light_pyramid.hpp"
#include "material/reflectance.hpp"
#include "shading/boundary_split.hpp"
#include "shading/channel_spans.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/smooth_surfaces.hpp"
#include "surfaces/triangle_point.hpp"

namespace nicol {
namespace {

bool reflects_alone(Smoothness smoothness) {
    return smoothness == Smoothness::mirror || smoothness == Smoothness::lobes;
}

// Returns the point of a triangle that a ray meets, inside the triangle; none if the ray runs along it.
std::optional<RayHit> hit_on(const WorldGeometry& geometry, std::uint32_t triangle, const Ray& ray) {
    const Corners& corners = geometry.triangles[triangle];
    const glm::dvec3 first(geometry.positions[corners.x]);
    const glm::dvec3 second = glm::dvec3(geometry.positions[corners.y]) - first;
    const glm::dvec3 third = glm::dvec3(geometry.positions[corners.z]) - first;
    const glm::dvec3 across = glm::cross(ray.direction, third);
    const double determinant = glm::dot(second, across);
    if (determinant == 0) return std::nullopt;
    const glm::dvec3 begin = ray.origin - first;
    const glm::dvec3 beside = glm::cross(begin, second);
    const double b1 = std::clamp(glm::dot(begin, across) / determinant, 0.0, 1.0);
    const double b2 = std::clamp(glm::dot(ray.direction, beside) / determinant, 0.0, 1 - b1);
    return RayHit{.surface = 0,
                  .triangle = triangle,
                  .distance = std::max(0.0, glm::dot(third, beside) / determinant),
                  .b1 = b1,
                  .b2 = b2};
}

}  // namespace

SmoothChains::SmoothChains(const SurfaceShading& surfaces)
    : surfaces_(surfaces),
      input_(surfaces.input()),
      wanted_(0),
      to_light_(glm::transpose(input_.light_to_geometry)) {
    for (std::size_t p = 0; p < input_.most_components; ++p) wanted_[static_cast<glm::length_t>(p)] = 1;
    if (!input_.follows_lobes) return;
    for (const VertexRange& range : input_.geometry.ranges) {
        Lobes& lobes = lobes_.emplace_back(Lobes{.layers = {}, .mirrors = false});
        if (!input_.follows(*range.material)) continue;
        lobes = {.layers = followed_layers(*range.material, input_.sampled),
                 .mirrors = smoothness_of(*range.material, false) == Smoothness::mirror};
    }
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
    ends.first = first;
    ends.halves.assign((last - first) * out.size(), {});
    thread_local std::vector<Shown> boundaries;
    boundaries.clear();
    ends.lobes.assign(last - first, 0);
    const std::size_t samples = input_.hits.offsets().size();
    for (std::size_t pixel = first; pixel < last; ++pixel) {
        for (std::size_t s = 0; s < samples; ++s) {
            const std::optional<Hit> hit = input_.hits.at(s, pixel);
            const Smoothness shown = hit ? input_.smooth->of(hit->triangle) : Smoothness::none;
            if (shown == Smoothness::none) continue;
            if (shown == Smoothness::lobes) ++ends.lobes[pixel - first];
            // The lights that mirrors and lobes reflect are those of the surface; rays find other surfaces.
            if (reflects_alone(shown) && input_.smooth->open(hit->triangle)) continue;
            if (shown == Smoothness::boundary) {
                const SurfacePoint at = surface_point(input_, hit->triangle, pixel, ends.range);
                boundaries.push_back({at.pixel, static_cast<std::uint32_t>(s), at.triangle, at.range});
                continue;
            }
            chains.push_back(first_chain(pixel, s, ends));
            chains.back().shown = hit->triangle;
        }
    }
    follow_bundles(boundaries, chains, ends, out);
    follow_all(chains, ends);
    add_surfaces(ends, out, counts);
    add_sky(ends, out);
    counts.ray_count += ends.rays;
    for (std::size_t pixel = 0; pixel < ends.lobes.size(); ++pixel) {
        if (ends.lobes[pixel] == 0) continue;
        counts.followed.values += static_cast<double>(out.size());
        // At outlines, the halves also differ by what they show.
        if (ends.lobes[pixel] < samples) continue;
        for (const auto& [one, other] : std::span(ends.halves).subspan(pixel * out.size(), out.size())) {
            counts.followed.power += std::pow(double{one} + double{other}, 2);
            // Halves of rays do not fill each other's gaps, because few of them meet what is bright.
            counts.followed.noise += std::pow(double{one} - double{other}, 2);
        }
    }
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
        .blur = 0,
        .received = {},
        .carried = 1,
        .events = 0,
        .lit = false,
        .lobes_lit = false,
        .scattered = false,
        .body = nullptr,
        .seed = sample_seed(static_cast<std::uint32_t>(pixel * kMostPixelSamples + sample), input_.seed),
        .pixel_seed = sample_seed(static_cast<std::uint32_t>(pixel), input_.seed),
        .sample = static_cast<std::uint32_t>(sample)};
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
    const TrianglePoint at = triangle_point(input_.geometry, hit.triangle, hit.b1, hit.b2, -ray.direction);
    return {.point = surface_point(input_, hit.triangle, 0, ends.range),
            .weights = glm::vec3(1 - hit.b1 - hit.b2, hit.b1, hit.b2),
            .position = at.position,
            .facet = at.facet,
            .normal = at.normal,
            .offset = at.offset,
            .distance = hit.distance};
}

void SmoothChains::absorb(Chain& chain, double distance, Ends& ends) const {
    if (chain.body == nullptr || black(chain.body->absorption)) return;
    double mean = 0;
    for (int c = 0; c < input_.channels; ++c) {
        const double factor = transmitted_by(chain.body, c, distance);
        ends.matrices[chain.way.matrices + static_cast<std::size_t>(c)] *= static_cast<float>(factor);
        mean += factor / input_.channels;
    }
    chain.carried *= mean;
}

void SmoothChains::follow_all(std::vector<Chain>& chains, Ends& ends) const {
    thread_local std::vector<Chain> rest;
    thread_local std::vector<Meeting> meetings;
    thread_local std::vector<std::optional<RayHit>> hits;
    while (!chains.empty()) {
        rest.clear();
        meetings.clear();
        find_hits(chains, hits, ends);
        for (std::size_t i = 0; i < chains.size(); ++i) follow(chains[i], hits[i], meetings, rest, ends);
        pass_all(meetings, rest, ends);
        std::swap(chains, rest);
    }
}

void SmoothChains::find_hits(std::span<const Chain> chains, std::vector<std::optional<RayHit>>& hits,
                             Ends& ends) const {
    thread_local std::vector<std::size_t> traced;  // indices of chains
    thread_local std::vector<Ray> rays;
    thread_local std::vector<std::optional<RayHit>> found;
    traced.clear();
    rays.clear();
    hits.assign(chains.size(), std::nullopt);
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const Chain& chain = chains[i];
        if (chain.open) continue;
        if (chain.shown != kNoTriangle) hits[i] = hit_on(input_.geometry, chain.shown, chain.ray);
        if (hits[i]) continue;
        traced.push_back(i);
        rays.push_back(chain.ray);
    }
    found.resize(rays.size());
    input_.smooth->intersect(rays, found);
    for (std::size_t k = 0; k < traced.size(); ++k) hits[traced[k]] = found[k];
    ends.rays += rays.size();
}

SmoothChains::Chain SmoothChains::after_event(const Chain& chain, std::uint32_t matrices,
                                              std::uint32_t number) const {
    const bool shows_glass = all_followed_sampled(input_.sampled);
    Chain next = chain;
    next.way.matrices = matrices;
    ++next.events;
    next.lit = chain.lobes_lit && !shows_glass;
    next.seed = sample_seed(chain.seed, kFirstOnward + number);
    next.shown = kNoTriangle;
    return next;
}

void SmoothChains::follow(Chain& chain, const std::optional<RayHit>& hit, std::vector<Meeting>& meetings,
                          std::vector<Chain>& rest, Ends& ends) const {
    absorb(chain, hit ? hit->distance : std::numeric_limits<double>::infinity(), ends);
    if (!hit) {
        if (chain.lit || input_.sky == nullptr) return;
        ends.sky.push_back({.direction = to_light_ * glm::vec3(chain.ray.direction),
                            .x = to_light_ * glm::vec3(chain.received[0]),
                            .variance = static_cast<float>(chain.spread.variance() + chain.blur),
                            .way = chain.way});
        return;
    }
    const Smoothness smoothness = input_.smooth->of(hit->triangle);
    if (smoothness == Smoothness::boundary) {
        if (chain.events < input_.smooth_events)
            meetings.push_back(
                {&chain, surface_point(input_, hit->triangle, chain.way.pixel, ends.range), *hit});
        return;
    }
    Place place = place_at(*hit, chain.ray, ends);
    // Samples of a pixel take other samples of light, whose noise the pixel's mean lessens.
    place.point.pixel = chain.way.pixel + chain.sample * 0x9e3779b9U;
    if (smoothness == Smoothness::rough_boundary) scatter(chain, place, rest, ends);
    if (!(glm::dot(place.facet, chain.ray.direction) < 0)) return;  // backs are black
    if (smoothness == Smoothness::mirror ||
        (smoothness == Smoothness::lobes && lobes_[place.point.range].mirrors))
        mirror(chain, place, rest, ends);
    if (smoothness == Smoothness::lobes) follow_lobes(chain, place, rest, ends);
    // The rest of the pixel's light is shaded as that of other pixels.
    if (smoothness != Smoothness::none && chain.events == 0) return;
    ends.surfaces.push_back({.point = {place.point, place.weights.y, place.weights.z,
                                       Viewpoint{.orthographic = true,
                                                 .eye = chain.ray.origin,
                                                 .forward = chain.ray.direction,
                                                 .up = chain.received[1],
                                                 .right = chain.received[0]},
                                       !chain.lit && !chain.lobes_lit, chain.events < input_.bounces,
                                       noise_factor(chain.way, ends)},
                             .way = chain.way,
                             .events = chain.events});
}

void SmoothChains::add_surfaces(Ends& ends, std::span<const std::span<glm::vec4>> out,
                                PointCounts& counts) const {
    thread_local PixelBatch batch;
    thread_local std::vector<RayPoint> points;
    thread_local std::vector<glm::vec4> light;
    // Points of neighbouring rays follow one another, so that they find the same lights.
    std::ranges::stable_sort(
        ends.surfaces, {}, [](const Ends::Surface& end) { return std::pair(end.point.group(), end.events); });
    points.clear();
    for (const Ends::Surface& end : ends.surfaces) points.push_back(end.point);
    for (std::size_t begin = 0; begin < points.size(); begin += batch.points().size()) {
        batch.take(input_, std::span<const RayPoint>(points).subspan(begin));
        const std::size_t count = batch.points().size();
        const std::vector<std::span<glm::vec4>> stokes = channel_spans(light, out.size(), count);
        // The image's values are its pixels.
        const LightingTally of_pixels = counts.lighting;
        surfaces_.run(batch, stokes, counts);
        counts.lighting.values = of_pixels.values;
        counts.lighting.power = of_pixels.power;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < out.size(); ++c)
                add_arriving(ends, ends.surfaces[begin + i].way, c, stokes[c][i], out);
    }
}

float SmoothChains::noise_factor(const Way& way, const Ends& ends) const {
    const std::size_t pixel = way.pixel - ends.first;
    const bool known = way.half != kNoHalf && ends.lobes[pixel] == input_.hits.offsets().size();
    if (known) return 0;
    const std::size_t channels = ends.halves.size() / ends.lobes.size();
    float sum = 0;
    for (const glm::mat4& matrix : std::span(ends.matrices).subspan(way.matrices, channels))
        sum += matrix[0][0] * matrix[0][0];
    return sum / static_cast<float>(channels);
}

void SmoothChains::add_sky(Ends& ends, std::span<const std::span<glm::vec4>> out) const {
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

void SmoothChains::add_arriving(Ends& ends, const Way& way, std::size_t channel, const glm::vec4& stokes,
                                std::span<const std::span<glm::vec4>> out) const {
    const glm::vec4 arrived = ends.matrices[way.matrices + channel] * stokes;
    out[channel][way.pixel] += wanted_ * arrived;
    if (way.half != kNoHalf)
        ends.halves[(way.pixel - ends.first) * out.size() + channel][way.half] += arrived.x;
}

}  // namespace nicol
