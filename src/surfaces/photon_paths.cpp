// SPDX-License-Identifier: MIT
#include "surfaces/photon_paths.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "material/conductor.hpp"
#include "material/dielectric.hpp"
#include "material/reflectance.hpp"
#include "shading/boundary_split.hpp"
#include "shading/light_samples.hpp"
#include "shading/weighted_terms.hpp"
#include "surfaces/focusing_surfaces.hpp"
#include "surfaces/photon_rays.hpp"
#include "surfaces/triangle_point.hpp"

namespace nicol {
namespace {

// Number of paths of all pairs of a source and a smooth surface together.
constexpr std::size_t kPaths = std::size_t{1} << 17;
// The pairs share the paths out by the light that pilots find to arrive. All pilots together are an eighth of
// the paths, a pair's within these limits.
constexpr std::size_t kPilots = kPaths / 8;
constexpr std::size_t kLeastPilots = kLanes;
constexpr std::size_t kMostPilots = 1024;
// Fewer photons in all have no density.
constexpr std::size_t kLeastPhotons = 48;
// Part of its power at the start below which a path ends.
constexpr double kNegligiblePower = 1e-4;
// Share of the time that pilots take, for reports of progress.
constexpr double kPilotsShare = 0.1;

/// Point of a surface that a path meets.
struct Meeting : TrianglePoint {
    std::size_t range;
    std::uint32_t triangle;
};

/// Light on its way.
struct Path {
    glm::dvec3 direction;
    const SmoothBoundary* body;  // that the path runs through; null: none
    bool bent;                   // whether any event was more than a straight passage
    std::uint32_t seed;
    std::vector<double> powers;  // by channel
    double choice;               // number by chance, from 0 to 1, that chooses between arrivals
    int arrivals = 0;            // number of places that could keep its photon
};

/// Result of some paths.
struct Arrivals {
    std::vector<Photon> photons;
    std::vector<float> powers;  // [photon][channel]
    std::uint64_t rays = 0;

    void add(const Arrivals& other) {
        photons.insert(photons.end(), other.photons.begin(), other.photons.end());
        powers.insert(powers.end(), other.powers.begin(), other.powers.end());
        rays += other.rays;
    }
};

/// A smooth surface and a source that lights it.
struct Pair {
    const FocusingSurface& smooth;
    const LightSource& source;
    std::uint32_t index;
    double power;        // that pilots found to arrive
    std::uint64_t rays;  // of pilots
};

/// Paths first <= i < last of `count` of a pair.
struct Stretch {
    const Pair* pair;
    std::size_t first, last, count;
};
// Paths of a stretch, and stretches between two reports of progress.
constexpr std::size_t kTogether = 16 * kLanes;
constexpr std::size_t kBetweenReports = 64;

// Calls body(i) for i < count on the run's threads, and reports progress as a part of `verb` between two
// fractions. Throws Error(cancelled).
template <class Body>
void for_all(std::size_t count, std::size_t at_once, double from, double to, RenderRun& run,
             const Body& body) {
    for (std::size_t first = 0; first < count; first += at_once) {
        const double part = static_cast<double>(first) / static_cast<double>(count);
        run.progress.report("shade", from + (to - from) * part);
        run.workers.run([&] { tbb::parallel_for(first, std::min(first + at_once, count), body); });
    }
}

class Tracer {
public:
    /// smooth: of the scene.
    Tracer(const PhotonScene& scene, std::span<const FocusingSurface> smooth,
           std::span<const LightSourcePtr> sources)
        : scene_(scene),
          events_(std::min(scene.events, kMostSmoothEvents)),
          smooth_(smooth),
          sources_(sources),
          rays_(scene.geometry, scene.smooth) {}

    [[nodiscard]] std::shared_ptr<const FocusedLight> trace(RenderRun& run) const {
        std::vector<Pair> pairs = lit_pairs(run);
        double all = 0;
        for (const Pair& pair : pairs) {
            all += pair.power;
            run.statistics.light_rays += pair.rays;
        }
        if (!(all > 0) || !std::isfinite(all)) return nullptr;
        std::vector<Stretch> stretches;
        for (const Pair& pair : pairs) {
            const auto count =
                static_cast<std::size_t>(std::ceil(kPaths * pair.power / all / kLanes)) * kLanes;
            for (std::size_t first = 0; first < count; first += kTogether)
                stretches.push_back({&pair, first, std::min(count, first + kTogether), count});
        }
        std::vector<Arrivals> parts(stretches.size());
        for_all(stretches.size(), kBetweenReports, kPilotsShare, 1, run, [&](std::size_t i) {
            for_starts(stretches[i], parts[i].rays,
                       [&](const Meeting& start, Path& path) { follow(start, path, parts[i]); });
        });
        Arrivals arrived;
        for (const Arrivals& part : parts) arrived.add(part);
        run.statistics.light_rays += arrived.rays;
        if (arrived.photons.size() < kLeastPhotons) return nullptr;
        std::shared_ptr<const FocusedLight> out;
        run.workers.run([&] {
            out = std::make_shared<const FocusedLight>(std::move(arrived.photons), std::move(arrived.powers),
                                                       scene_.channels);
        });
        return out;
    }

private:
    // Returns all pairs of a smooth surface and a source, with the power that pilots find.
    [[nodiscard]] std::vector<Pair> lit_pairs(RenderRun& run) const {
        std::vector<Pair> pairs;
        pairs.reserve(smooth_.size() * sources_.size());
        for (const FocusingSurface& smooth : smooth_)
            for (const LightSourcePtr& source : sources_)
                pairs.push_back({smooth, *source, static_cast<std::uint32_t>(pairs.size()), 0, 0});
        if (pairs.empty()) return pairs;
        const std::size_t pilots =
            std::clamp(kPilots / pairs.size() / kLanes * kLanes, kLeastPilots, kMostPilots);
        const std::size_t at_once = kBetweenReports * kTogether / pilots;
        for_all(pairs.size(), at_once, 0, kPilotsShare, run, [&](std::size_t i) {
            Pair& pair = pairs[i];
            for_starts({&pair, 0, pilots, pilots}, pair.rays, [&](const Meeting&, const Path& path) {
                for (const double power : path.powers) pair.power += power;
            });
        });
        return pairs;
    }

    [[nodiscard]] Meeting meeting_at(std::uint32_t triangle, double b1, double b2) const {
        const WorldGeometry& geometry = scene_.geometry;
        return {triangle_point(geometry, triangle, b1, b2),
                range_of(geometry, geometry.triangles[triangle].x), triangle};
    }

    // Calls visit(meeting, path) for light that reaches the smooth surface from the source. All paths of a
    // pair are spread evenly over the surface and over the source. Adds the number of traced rays to `rays`.
    template <class Visit>
    void for_starts(const Stretch& stretch, std::uint64_t& rays, const Visit& visit) const {
        const FocusingSurface& smooth = stretch.pair->smooth;
        const auto count = static_cast<double>(stretch.count);
        LaneLight light;
        for (std::size_t begin = stretch.first; begin < stretch.last; begin += kLanes) {
            std::array<Meeting, kLanes> meetings;
            std::array<double, kLanes> choices;
            LaneVectors positions;
            Lanes u, v;
            for (std::size_t i = 0; i < kLanes; ++i) {
                // This sequence has nothing in common with those of places, so that each place meets all
                // parts of the source.
                const glm::vec2 of_source = even_point(begin + i);
                const FocusingSurface::Place place = smooth.place(begin + i, stretch.count);
                meetings[i] = meeting_at(place.triangle, place.b1, place.b2);
                choices[i] = place.choice;
                put(positions, i, glm::vec3(meetings[i].position));
                u[i] = of_source.x;
                v[i] = of_source.y;
            }
            stretch.pair->source.sample(positions, u, v, light);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if ((light.points >> i & 1) == 0) continue;
                const Meeting& meeting = meetings[i];
                const glm::dvec3 towards = glm::normalize(glm::dvec3(vector_at(light.towards, i)));
                const double cosine = glm::dot(meeting.facet, towards);
                const bool glass = material_at(meeting).smooth_boundary() != nullptr;
                if (!glass && !(cosine > 0)) continue;
                Ray ray = leaving(meeting.position, meeting.facet, towards, meeting.offset);
                ray.farthest = static_cast<double>(light.distance[i]);
                ++rays;
                if (rays_.occluded(ray)) continue;
                Path path{.direction = -towards,
                          .body = nullptr,
                          .bent = false,
                          .seed = sample_seed(static_cast<std::uint32_t>(begin + i), stretch.pair->index),
                          .powers = {},
                          .choice = choices[i]};
                const double area = smooth.areas.back() * std::abs(cosine) / count;
                for (std::size_t c = 0; c < scene_.channels; ++c)
                    path.powers.push_back(
                        area *
                        static_cast<double>(light.irradiance[light.irradiance.size() == 1 ? 0 : c][0][i]));
                visit(meeting, path);
            }
        }
    }

    [[nodiscard]] const Material& material_at(const Meeting& meeting) const {
        return *scene_.geometry.ranges[meeting.range].material;
    }

    void follow(const Meeting& start, Path& path, Arrivals& out) const {
        send_on(start, path, out);
        // One photon stands for all places.
        if (path.arrivals < 2) return;
        for (float& power : std::span(out.powers).last(scene_.channels))
            power *= static_cast<float>(path.arrivals);
    }

    void send_on(Meeting at, Path& path, Arrivals& out) const {
        const double least = kNegligiblePower * *std::ranges::max_element(path.powers);
        for (int event = 0; focuses_light(material_at(at)); ++event) {
            if (event == events_ || !(*std::ranges::max_element(path.powers) > least)) return;
            path.seed = sample_seed(path.seed, static_cast<std::uint32_t>(event));
            const Material& material = material_at(at);
            const SmoothBoundary* const boundary = material.smooth_boundary();
            if (boundary != nullptr ? !pass(*boundary, at, path) : !mirror(material, at, path)) return;
            const std::optional<Meeting> next = next_meeting(at, path, out);
            if (!next) return;
            at = *next;
        }
        arrive(at, path, out);
    }

    // Returns where light that leaves a surface meets another one that blocks it. The light arrives at those
    // in between, too, but goes on.
    [[nodiscard]] std::optional<Meeting> next_meeting(const Meeting& from, Path& path, Arrivals& out) const {
        Ray ray = leaving(from.position, from.facet, path.direction, from.offset);
        double travelled = 0;
        while (true) {
            ++out.rays;
            const std::optional<RayHit> hit = rays_.first(ray);
            if (!hit) return std::nullopt;
            for (std::size_t c = 0; c < path.powers.size(); ++c)
                path.powers[c] *= transmitted_by(path.body, static_cast<int>(c), hit->distance - travelled);
            travelled = hit->distance;
            const Meeting at = meeting_at(hit->triangle, hit->b1, hit->b2);
            if (PhotonRays::blocks(scene_.geometry.ranges[at.range])) return at;
            if (!focuses_light(material_at(at))) arrive(at, path, out);
            ray.nearest = rays_.beyond(*hit);
        }
    }

    // Adds a photon. Light that shadow rays already find is left out. A path that arrives at several places
    // has a photon at one of them, chosen by chance, so that memory has a limit.
    void arrive(const Meeting& at, Path& path, Arrivals& out) const {
        // Backs are black; two-sided surfaces have triangles for both sides. Shadow rays find all light of
        // surfaces that receive no shadows.
        if (!path.bent || !scene_.geometry.ranges[at.range].roles.receives_shadows ||
            !(glm::dot(at.facet, path.direction) < 0))
            return;
        if (++path.arrivals == 1) {
            out.photons.emplace_back();
            out.powers.resize(out.powers.size() + scene_.channels);
        } else {
            // The latest of n places takes over in one of n cases.
            const double kept = 1 - 1.0 / path.arrivals;
            if (path.choice < kept) {
                path.choice /= kept;
                return;
            }
            path.choice = (path.choice - kept) * path.arrivals;
        }
        out.photons.back() = {.position = glm::vec3(at.position),
                              .normal = glm::vec3(at.facet),
                              .towards = glm::vec3(-path.direction)};
        std::ranges::transform(path.powers, std::span(out.powers).last(scene_.channels).begin(),
                               [](double power) { return static_cast<float>(power); });
    }

    // Reflects or transmits a path by chance. Returns whether it goes on.
    [[nodiscard]] static bool pass(const SmoothBoundary& boundary, const Meeting& at, Path& path) {
        // By reciprocity the boundary sends light where a viewer in the place of the source would see it come
        // from.
        const BoundarySplit split = split_at(boundary, at.facet, at.normal, theta_phi_frame(-path.direction));
        const double reflected = mean_factor(boundary.reflectance) * split.reflected.share;
        const double transmitted = mean_factor(boundary.transmittance) * split.transmitted.share;
        if (!(reflected + transmitted > 0)) return false;
        const bool reflects = path.seed * 0x1p-32 * (reflected + transmitted) < reflected;
        const BoundaryPart& part = reflects ? split.reflected : split.transmitted;
        const double probability = (reflects ? reflected : transmitted) / (reflected + transmitted);
        const std::vector<double>& factors = reflects ? boundary.reflectance : boundary.transmittance;
        for (std::size_t c = 0; c < path.powers.size(); ++c) {
            const int channel = static_cast<int>(c);
            const double share = boundary.film
                                     ? mueller_of(boundary, split, part, channel)(0, 0) / part.radiance_scale
                                     : part.share;
            path.powers[c] *= of_channel(factors, channel) * share / probability;
        }
        path.direction = part.towards_light;
        path.bent = path.bent || reflects || boundary.bends();
        path.body = body_before(boundary, split, part, path.body);
        return true;
    }

    [[nodiscard]] static bool mirror(const Material& material, const Meeting& at, Path& path) {
        const double cosine = -glm::dot(at.normal, path.direction);
        if (!(cosine > 0) || !(glm::dot(at.facet, path.direction) < 0)) return false;
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        thread_local std::vector<Mueller> muellers;
        muellers.assign(path.powers.size(), Mueller());
        add_terms(
            material, {-sine, 0, cosine}, {sine, 0, cosine}, glm::vec3(1), kMirrorScale * cosine * cosine,
            [](int) { return true; }, muellers);
        for (std::size_t c = 0; c < path.powers.size(); ++c) path.powers[c] *= muellers[c](0, 0);
        path.direction = glm::normalize(path.direction + 2 * cosine * at.normal);
        path.bent = true;
        return glm::dot(at.facet, path.direction) > 0;
    }

    const PhotonScene& scene_;
    int events_;
    std::span<const FocusingSurface> smooth_;
    std::span<const LightSourcePtr> sources_;
    PhotonRays rays_;
};

}  // namespace

std::size_t most_focused_bytes(std::size_t surfaces, std::size_t sources, std::size_t channels) {
    return FocusedLight::most_bytes(kPaths + kLanes * surfaces * sources, channels);
}

std::shared_ptr<const FocusedLight> focused_light(const PhotonScene& scene,
                                                  std::span<const LightSourcePtr> sources, RenderRun& run) {
    if (sources.empty()) return nullptr;
    const std::vector<FocusingSurface> smooth = focusing_surfaces(scene.geometry);
    if (smooth.empty()) return nullptr;
    return Tracer(scene, smooth, sources).trace(run);
}

}  // namespace nicol
