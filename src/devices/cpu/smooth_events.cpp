// SPDX-License-Identifier: MIT
// Events of chains at boundaries: reflection and refraction by smooth ones and by facets of rough ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "devices/cpu/chain_numbers.hpp"
#include "devices/cpu/lane_boundary.hpp"
#include "devices/cpu/smooth_chains.hpp"
#include "draw/visibility_buffer.hpp"
#include "material/reflectance.hpp"
#include "polarization/mueller.hpp"
#include "shading/boundary_split.hpp"
#include "shading/light_samples.hpp"
#include "shading/rough_boundary.hpp"
#include "surfaces/triangle_offset.hpp"

namespace nicol {
namespace {

// Returns the variance, along an axis, of directions that facets of a rough boundary send light in.
double facet_variance(const SmoothBoundary& boundary, double eta, bool reflects) {
    // The slopes of facets have about this variance.
    const double slopes = boundary.alpha * boundary.alpha / 2;
    const bool mirrors = reflects || boundary.behind == SmoothBoundary::Behind::slab;
    const double bend = mirrors ? 2.0 : 1 - 1 / eta;
    return bend * bend * slopes;
}

// Returns the matrix of a part in the received frame, times a factor, in columns.
glm::mat4 matrix_at(const LaneSplit& split, std::size_t lane, bool reflects, float factor) {
    const LanePart& part = reflects ? split.reflected : split.transmitted;
    const float scale = reflects ? factor : factor * split.radiance_scale[lane];
    const float a = scale * part.block[0][lane], b = scale * part.block[1][lane];
    const float c = scale * part.block[2][lane], d = scale * part.block[3][lane];
    const float cosine = split.cosine2[lane], sine = split.sine2[lane];
    return {{a, cosine * b, -sine * b, 0},
            {b, cosine * a, -sine * a, 0},
            {0, sine * c, cosine * c, d},
            {0, -sine * d, -cosine * d, c}};
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
    Chain next = after_event(chain, matrices, event.number);
    next.ray = leaving(place.position, place.facet, part.towards_light, place.offset);
    next.received = part.incident;
    next.carried *= mean_factor(factors) * part.share / event.probability;
    next.scattered = true;
    next.body = body_before(event.boundary, event.split, part, chain.body);
    next.open = leaves_all(place.point.triangle, place.facet, part.towards_light);
    const auto bends = bends_at(place, event.split.normal, chain.ray, next.spread);
    if (event.reflects)
        next.spread.reflect(chain.ray.direction, event.split.normal, bends);
    else if (event.boundary.behind == SmoothBoundary::Behind::body)
        next.spread.refract(chain.ray.direction, event.split.normal, bends, event.split.eta);
    rest.push_back(next);
}

void SmoothChains::pass_all(std::vector<Meeting>& meetings, std::vector<Chain>& rest, Ends& ends) const {
    const auto range = [](const Meeting& meeting) { return meeting.point.range; };
    if (!std::ranges::is_sorted(meetings, {}, range)) std::ranges::stable_sort(meetings, {}, range);
    for (std::size_t begin = 0; begin < meetings.size();) {
        std::size_t end = begin + 1;
        while (end < std::min(begin + kLanes, meetings.size()) &&
               range(meetings[end]) == range(meetings[begin]))
            ++end;
        pass(std::span(meetings).subspan(begin, end - begin), rest, ends);
        begin = end;
    }
}

void SmoothChains::pass(std::span<const Meeting> meetings, std::vector<Chain>& rest, Ends& ends) const {
    const WorldGeometry& geometry = input_.geometry;
    const SmoothBoundary& boundary =
        *geometry.ranges[meetings.front().point.range].material->smooth_boundary();
    BoundaryHits hits;
    std::array<std::uint32_t, kLanes> triangles;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const auto& [chain, point, hit] = meetings[i < meetings.size() ? i : 0];
        triangles[i] = hit.triangle;
        put(hits.directions, i, glm::vec3(chain->ray.direction));
        put(hits.received_x, i, glm::vec3(chain->received[0]));
        hits.distances[i] = static_cast<float>(hit.distance);
        hits.b1[i] = static_cast<float>(hit.b1);
        hits.b2[i] = static_cast<float>(hit.b2);
        for (std::size_t k = 0; k < 2; ++k) {
            put(hits.places[k], i, glm::vec3(chain->spread.places[k]));
            put(hits.changes[k], i, glm::vec3(chain->spread.directions[k]));
        }
    }
    hits.triangles = LaneTriangles::of(geometry, triangles);
    LaneSplit split;
    split_lanes(boundary, hits, split);

    struct Next {
        std::size_t lane;
        bool reflects;
        double probability;
        std::uint32_t matrices;
    };
    std::array<Next, 2 * kLanes> next;
    std::size_t count = 0;
    const auto add = [&](std::size_t lane, bool reflects, double probability) {
        const Meeting& meeting = meetings[lane];
        const Chain& chain = *meeting.chain;
        const LanePart& part = reflects ? split.reflected : split.transmitted;
        const double factor = mean_factor(reflects ? boundary.reflectance : boundary.transmittance);
        const auto matrices = static_cast<std::uint32_t>(ends.matrices.size());
        ends.matrices.resize(matrices + static_cast<std::size_t>(input_.channels));
        next[count++] = {lane, reflects, probability, matrices};
        const glm::dvec3 towards_light = glm::normalize(glm::dvec3(vector_at(part.towards_light, lane)));
        const glm::dvec3 facet(vector_at(split.facets, lane)), x(vector_at(split.s_axes, lane));
        Chain onward = after_event(chain, matrices, reflects ? 1 : 0);
        onward.ray = leaving(vector_at(split.positions, lane), facet, towards_light,
                             offset_of_triangle(geometry, meeting.hit.triangle));
        for (std::size_t k = 0; k < 2; ++k) {
            onward.spread.places[k] = vector_at(split.places[k], lane);
            onward.spread.directions[k] = vector_at(part.changes[k], lane);
        }
        onward.received = Frame(x, glm::cross(-towards_light, x), -towards_light);
        onward.carried *= factor * static_cast<double>(part.block[0][lane]) / probability;
        onward.body = body_before(boundary, split.inside[lane] > 0, reflects, chain.body);
        onward.open = leaves_all(meeting.hit.triangle, facet, towards_light);
        rest.push_back(onward);
    };
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        const Chain& chain = *meetings[i].chain;
        const double reflected =
            mean_factor(boundary.reflectance) * static_cast<double>(split.reflected.block[0][i]);
        const double transmitted =
            mean_factor(boundary.transmittance) * static_cast<double>(split.transmitted.block[0][i]);
        const double both = reflected + transmitted;
        if (!(both > 0)) continue;
        if (std::min(reflected, transmitted) * chain.carried >= kBothCarry) {
            add(i, false, 1);
            add(i, true, 1);
        } else {
            const bool reflects = fraction(chain.seed) * both < reflected;
            add(i, reflects, (reflects ? reflected : transmitted) / both);
        }
    }
    for (int c = 0; c < input_.channels; ++c) {
        if (boundary.film) take_channel(boundary, c, split);
        for (const Next& of : std::span(next).first(count)) {
            const std::vector<double>& factors = of.reflects ? boundary.reflectance : boundary.transmittance;
            const auto factor = static_cast<float>(of_channel(factors, c) / of.probability);
            const auto channel = static_cast<std::size_t>(c);
            ends.matrices[of.matrices + channel] =
                ends.matrices[meetings[of.lane].chain->way.matrices + channel] *
                matrix_at(split, of.lane, of.reflects, factor);
        }
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
        go_on(sampled, place,
              {boundary, split, reflects, samples * (reflects ? share : 1 - share),
               static_cast<std::uint32_t>(i)},
              rest, ends);
    }
}

}  // namespace nicol
