// SPDX-License-Identifier: MIT
#include "methods/lobe_photons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "material/followed_terms.hpp"
#include "material/mixed_terms.hpp"
#include "material/spatial_variation.hpp"
#include "methods/photon_targets.hpp"
#include "methods/receiver_areas.hpp"
#include "polarization/moved_axis.hpp"
#include "polarization/mueller.hpp"
#include "shading/light_samples.hpp"
#include "shading/lobe_sample.hpp"
#include "surfaces/focusing_surfaces.hpp"
#include "surfaces/local_lights.hpp"
#include "surfaces/tangents.hpp"
#include "surfaces/triangle_point.hpp"
#include "transfer/nearest_directions.hpp"
#include "transfer/surface_points.hpp"

namespace nicol {
namespace {

constexpr std::size_t kPaths = std::size_t{1} << 15;
constexpr std::size_t kGroups = kPaths / kLanes;  // sixteen paths begin together
// Share of the paths that begin evenly over the surfaces. All others begin where links end.
constexpr double kEvenly = 0.1;
// Least cosine to a surface of the direction that stands for a photon's. The radiance of others would be
// noise.
constexpr double kLeastCosine = 0.1;

/// Light that reaches receivers, as LobePhotons has it.
struct Arrivals {
    std::vector<LobePhotons::Part> parts;
    std::vector<glm::vec4> stokes;
    std::uint64_t rays = 0;
};

/// Point of a surface with narrow lobes where a path begins.
struct Start {
    TrianglePoint at;
    std::uint32_t triangle;
    std::size_t range;
    glm::vec3 weights;  // of the triangle's corners
    Frame frame;        // z: unit shading normal
    double area;        // that the path stands for
};

// Returns the point of [0, 1)^2 that chooses a path's facet. Each block of a power of two of consecutive
// paths fills the square evenly, in an order unlike that of the places where they begin.
glm::dvec2 facet_point(std::size_t path) {
    const std::uint32_t seed = 0;
    Lanes u, v;
    light_samples(shuffled(static_cast<std::uint32_t>(path)), std::span(&seed, 1), u, v);
    return {u[0], v[0]};
}

// Returns a frame whose z is moved to another direction along the shortest way.
Frame turned(const Frame& frame, const glm::dvec3& z) {
    return {moved(frame[0], frame[2], z), moved(frame[1], frame[2], z), z};
}

class Tracer {
public:
    Tracer(const TransferInput& input, const LinkedSurfaces& surfaces)
        : input_(input), surfaces_(surfaces), lighting_(input.local_lights->lighting()) {
        find_starts();
    }

    [[nodiscard]] bool any() const { return !starts_.areas.empty() && starts_.areas.back() > 0; }

    [[nodiscard]] std::vector<Arrivals> trace(RenderRun& run) {
        const BakeGeometry baked = link_geometry(input_.geometry);
        const TriangleSides sides = sides_of(input_.geometry);
        std::optional<SurfacePoints> points;
        run.workers.run([&] { points.emplace(baked, sides); });
        points_ = &*points;
        present_ = baked.present;
        areas_ = areas_of_receivers(input_.geometry, surfaces_, present_);
        targets_.emplace(input_.geometry, surfaces_);
        nearest_.emplace(*input_.directions);
        std::vector<Arrivals> out(kGroups);
        run.workers.for_blocks(kGroups, "relight", run.progress, [&](std::size_t first, std::size_t last) {
            for (std::size_t group = first; group < last; ++group) follow(group, out[group]);
        });
        return out;
    }

private:
    // Finds the triangles with narrow lobes. Paths begin there in proportion to the links that end there,
    // because other places are seen by few receivers.
    void find_starts() {
        const WorldGeometry& geometry = input_.geometry;
        layers_.resize(geometry.ranges.size());
        std::vector<double> shares;  // of the light along the normal that narrow lobes reflect
        for (const TriangleBatch& batch : triangle_batches(geometry)) {
            std::vector<FollowedLayer>& layers = layers_[batch.range];
            layers = layers_with(*geometry.ranges[batch.range].material, sends_photons);
            double share = 0;
            for (const FollowedLayer& layer : layers) {
                double of_layer = 0;
                for (const FollowedLayer::Part& part : layer.parts) of_layer += part.reflectance;
                share = std::max(share, of_layer);
            }
            if (!(share > 0)) continue;
            for (std::size_t t = batch.first; t < batch.last; ++t) {
                starts_.triangles.push_back(static_cast<std::uint32_t>(t));
                shares.push_back(share);
            }
        }
        if (shares.empty()) return;
        std::vector<double> links(geometry.triangles.size());
        for (const SurfaceLink& link : surfaces_.links()) ++links[link.triangle];
        std::vector<double> areas;
        areas.reserve(shares.size());
        double all_links = 0, all_areas = 0;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            areas.push_back(glm::length(area_vector(geometry, starts_.triangles[k])));
            all_links += shares[k] * links[starts_.triangles[k]];
            all_areas += shares[k] * areas[k];
        }
        if (!(all_areas > 0)) return;
        const double evenly = all_links > 0 ? kEvenly : 1;
        const double per_link = all_links > 0 ? (1 - evenly) / all_links : 0;
        double sum = 0;
        starts_.areas.reserve(shares.size());
        for (std::size_t k = 0; k < shares.size(); ++k) {
            sum += shares[k] * (per_link * links[starts_.triangles[k]] + evenly * areas[k] / all_areas);
            starts_.areas.push_back(sum);
        }
    }

    // Returns where a path begins; none: a mask leaves nothing there.
    [[nodiscard]] std::optional<Start> start_of(std::size_t path) const {
        const WorldGeometry& geometry = input_.geometry;
        const FocusingSurface::Place place = starts_.place(path, kPaths);
        if (present_ && !present_(place.triangle, static_cast<float>(place.b1), static_cast<float>(place.b2)))
            return std::nullopt;
        const auto k = static_cast<std::size_t>(std::ranges::lower_bound(starts_.triangles, place.triangle) -
                                                starts_.triangles.begin());
        const double paths =
            kPaths * (starts_.areas[k] - (k > 0 ? starts_.areas[k - 1] : 0)) / starts_.areas.back();
        const TrianglePoint at = triangle_point(geometry, place.triangle, place.b1, place.b2);
        const std::size_t range = range_of(geometry, geometry.triangles[place.triangle].x);
        const glm::vec3 weights(1 - place.b1 - place.b2, place.b1, place.b2);
        glm::vec3 along(0);
        if (geometry.ranges[range].material->anisotropic() && !geometry.texcoords.empty())
            along = tangent(geometry, place.triangle, weights);
        return Start{.at = at,
                     .triangle = place.triangle,
                     .range = range,
                     .weights = weights,
                     .frame = frame_along(at.normal, glm::dvec3(along)),
                     .area = glm::length(area_vector(geometry, place.triangle)) / paths};
    }

    // Chooses a light by its brightness at the starts. Returns its index, and sets `probability`.
    [[nodiscard]] std::size_t light_for(std::span<const std::optional<Start>> starts, double at,
                                        double& probability) const {
        thread_local std::vector<double> sums;
        sums.clear();
        double sum = 0;
        for (const LightSource* const source : sources_) {
            for (const std::optional<Start>& start : starts)
                if (start) sum += double{source->brightness(glm::vec3(start->at.position))};
            sums.push_back(sum);
        }
        const auto chosen = static_cast<std::size_t>(std::ranges::upper_bound(sums, at * sum) - sums.begin());
        const std::size_t light = std::min(chosen, sums.size() - 1);
        probability = sum > 0 ? (sums[light] - (light > 0 ? sums[light - 1] : 0)) / sum : 0;
        return light;
    }

    void follow(std::size_t group, Arrivals& out) const {
        std::array<std::optional<Start>, kLanes> starts;
        LaneVectors positions{}, origins{};
        Lanes u, v;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t path = i * kGroups + group;
            const glm::vec2 of_source = even_point(path);
            u[i] = of_source.x;
            v[i] = of_source.y;
            starts[i] = start_of(path);
            if (!starts[i]) continue;
            const TrianglePoint& at = starts[i]->at;
            put(positions, i, glm::vec3(at.position));
            put(origins, i, glm::vec3(at.position + at.offset * at.facet));
        }
        double probability = 0;
        const double at = sample_seed(static_cast<std::uint32_t>(group), 0) * 0x1p-32;
        const std::size_t source = light_for(starts, at, probability);
        if (!(probability > 0)) return;
        LaneLight light;
        sources_[source]->sample(positions, u, v, light);
        std::uint32_t lit = 0;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::dvec3 towards(vector_at(light.towards, i));
            if (starts[i] && glm::dot(starts[i]->at.facet, towards) > 0 &&
                glm::dot(starts[i]->frame[2], towards) > 0)
                lit |= light.points & 1U << i;
        }
        lit = lighting_.reached(light, lit, positions, origins, out.rays);
        for (std::size_t i = 0; i < kLanes; ++i)
            if ((lit >> i & 1) != 0) scatter(*starts[i], light, i, i * kGroups + group, probability, out);
    }

    // Sends the light that reaches a start to another surface.
    void scatter(const Start& start, const LaneLight& light, std::size_t lane, std::size_t path,
                 double probability, Arrivals& out) const {
        const auto channels = static_cast<std::size_t>(input_.channels);
        thread_local std::vector<glm::vec3> weights;
        weights.assign(1, glm::vec3(1));
        const WorldGeometry& geometry = input_.geometry;
        if (const SpatialVariation* const variation = geometry.ranges[start.range].material->variation()) {
            const TexturePoint at = texture_point(geometry, start.triangle, start.weights);
            weights.resize(variation->layers.size());
            variation->weights(at, weights);
        }
        const glm::dvec3 towards = glm::normalize(glm::dvec3(vector_at(light.towards, lane)));
        const glm::dvec3 from = glm::normalize(towards * start.frame);
        thread_local std::vector<Mueller> muellers;
        muellers.resize(channels);
        const LobeChoice choice{.lobe = sample_seed(static_cast<std::uint32_t>(path), 1) * 0x1p-32,
                                .facet = facet_point(path)};
        const std::optional<AimedCone> aim = targets_->seen_from(start.range, start.at.position, start.frame);
        const glm::dvec3 to = scatter_by_lobes(layers_[start.range], weights, from, choice, aim, muellers);
        if (!(to.z > 0)) return;
        const glm::dvec3 direction = glm::normalize(start.frame * to);
        const double facing = glm::dot(direction, start.at.facet);
        if (!(facing > 0)) return;
        ++out.rays;
        const std::optional<RayHit> hit =
            points_->find(leaving(start.at.position, start.at.facet, direction, start.at.offset));
        if (!hit) return;

        // The reflected radiance is that by the shading normal, the surface that it leaves is the triangle.
        const double scale = start.area * from.z * facing / to.z / probability;
        const double into =
            light.components > 1
                ? angle_between({glm::dvec3(vector_at(light.x, lane)),
                                 glm::cross(-towards, glm::dvec3(vector_at(light.x, lane))), -towards},
                                start.frame * theta_phi_frame(-from))
                : 0;
        const glm::dvec3 normal = triangle_point(geometry, hit->triangle, hit->b1, hit->b2).facet;
        const std::uint32_t nearest = direction_for(normal, direction);
        const glm::dvec3 sight(input_.directions->directions()[nearest]);
        const double out_of =
            angle_between(turned(start.frame * theta_phi_frame(to), -sight), frames_.frame(-sight));
        thread_local std::vector<Stokes> powers;
        powers.clear();
        for (std::size_t c = 0; c < channels; ++c) {
            const std::array<Lanes, 4>& irradiance = light.irradiance[light.irradiance.size() == 1 ? 0 : c];
            Stokes arriving(0.0);
            for (std::size_t q = 0; q < light.components; ++q)
                arriving[static_cast<glm::length_t>(q)] = double{irradiance[q][lane]};
            powers.push_back(scale * rotated(muellers[c] * rotated(arriving, into), out_of));
        }
        arrive(*hit, nearest, glm::dot(sight, normal), powers, out);
    }

    // Returns the index of the direction that stands for that of a photon: the nearest, or one that is higher
    // above the surface of this normal.
    [[nodiscard]] std::uint32_t direction_for(const glm::dvec3& normal, const glm::dvec3& direction) const {
        for (int lift = 0;; ++lift) {
            const std::uint32_t out = nearest_->of(glm::vec3(0.1 * lift * normal - direction));
            if (glm::dot(glm::dvec3(input_.directions->directions()[out]), normal) >= kLeastCosine)
                return out;
        }
    }

    // Spreads a photon over the receivers. cosine: that of the nearest direction, which keeps the irradiance.
    void arrive(const RayHit& hit, std::uint32_t nearest, double cosine, std::span<const Stokes> powers,
                Arrivals& out) const {
        const glm::uvec3& corners = input_.geometry.triangles[hit.triangle];
        const glm::dvec3 weights(1 - hit.b1 - hit.b2, hit.b1, hit.b2);
        std::array<std::pair<std::uint32_t, double>, 3 * Receivers::Blend::kMost> shares;
        std::size_t count = 0;
        for (glm::length_t k = 0; k < 3; ++k) {
            const Receivers::Blend& blend = surfaces_.blends()[corners[k]];
            for (std::size_t i = 0; i < blend.weights.size(); ++i) {
                if (!(blend.weights[i] > 0)) continue;
                const auto known =
                    std::find_if(shares.begin(), shares.begin() + count,
                                 [&](const auto& share) { return share.first == blend.receivers[i]; });
                const double share = weights[k] * double{blend.weights[i]};
                if (known != shares.begin() + count)
                    known->second += share;
                else
                    shares[count++] = {blend.receivers[i], share};
            }
        }
        for (const auto& [receiver, share] : std::span(shares).first(count)) {
            if (!(areas_[receiver] > 0)) continue;
            out.parts.push_back({receiver, nearest});
            for (const Stokes& power : powers)
                out.stokes.emplace_back(share / (cosine * areas_[receiver]) * power);
        }
    }

    const TransferInput& input_;
    const LinkedSurfaces& surfaces_;
    const LocalLighting& lighting_;
    std::vector<const LightSource*> sources_ = lighting_.sources();
    std::optional<NearestDirections> nearest_;
    Presence present_;
    Viewpoint frames_ = link_frames();
    std::vector<std::vector<FollowedLayer>> layers_;                    // [range]
    FocusingSurface starts_{.range = 0, .triangles = {}, .areas = {}};  // with shares in place of areas
    const SurfacePoints* points_ = nullptr;
    std::vector<double> areas_;  // [receiver]
    std::optional<PhotonTargets> targets_;
};

}  // namespace

bool sends_photons(const Material& material, int term) {
    return !is_mixed(material, term) && !material.smooth(term) &&
           material.isotropic().lobe_width(term) < kWidestPhotonLobe;
}

std::uint64_t most_photon_bytes(std::size_t channels) {
    constexpr std::uint64_t parts = kPaths * 3 * Receivers::Blend::kMost;
    // The arrivals and their copy. Receivers that corners share leave room for vectors that grow.
    return 2 * parts * (sizeof(LobePhotons::Part) + channels * sizeof(glm::vec4));
}

LobePhotons::LobePhotons(const TransferInput& input, const LinkedSurfaces& surfaces, RenderRun& run)
    : channels_(static_cast<std::size_t>(input.channels)) {
    Tracer tracer(input, surfaces);
    if (!tracer.any()) return;
    std::vector<Arrivals> arrivals = tracer.trace(run);
    firsts_.resize(surfaces.blocks() + 1);
    for (const Arrivals& some : arrivals) {
        run.statistics.light_rays += some.rays;
        for (const Part& part : some.parts) ++firsts_[part.receiver / kLanes + 1];
    }
    for (std::size_t block = 0; block < surfaces.blocks(); ++block) firsts_[block + 1] += firsts_[block];
    std::vector<std::size_t> next(firsts_.begin(), firsts_.end() - 1);
    parts_.resize(firsts_.back());
    stokes_.resize(firsts_.back() * channels_);
    for (Arrivals& some : arrivals) {
        for (std::size_t k = 0; k < some.parts.size(); ++k) {
            const std::size_t to = next[some.parts[k].receiver / kLanes]++;
            parts_[to] = some.parts[k];
            std::copy_n(&some.stokes[k * channels_], channels_, &stokes_[to * channels_]);
        }
        some = {};
    }
}

}  // namespace nicol
