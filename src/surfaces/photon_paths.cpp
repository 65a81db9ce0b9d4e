// SPDX-License-Identifier: MIT
#include "surfaces/photon_paths.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "material/conductor.hpp"
#include "material/dielectric.hpp"
#include "material/reflectance.hpp"
#include "material/spatial_variation.hpp"
#include "shading/boundary_split.hpp"
#include "shading/light_samples.hpp"
#include "shading/weighted_terms.hpp"

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

/// Triangles of one smooth material.
struct SmoothRange {
    std::size_t range;
    std::vector<std::uint32_t> triangles;
    std::vector<double> areas;  // cumulative
};

// Returns whether paths go on from a surface: from smooth glass, and from mirrors without textures.
bool bends_light(const Material& material) {
    const SmoothBoundary* const boundary = material.smooth_boundary();
    if (boundary != nullptr) return !boundary->rough();
    return material.variation() == nullptr && material.terms() > 0 && is_mirror(material);
}

// Returns a point of [0, 1)^2: of a sequence that fills the square evenly, as if by chance of the seed.
glm::vec2 sample_at(std::size_t index, std::uint32_t seed) {
    Lanes u, v;
    const std::uint32_t mixed = sample_seed(seed, 0);
    light_samples(static_cast<std::uint32_t>(index), std::span(&mixed, 1), u, v);
    return {u[0], v[0]};
}

/// Point of a surface that a path meets.
struct Meeting {
    std::size_t range;
    std::uint32_t triangle;
    glm::dvec3 position;
    glm::dvec3 facet;   // unit normal of the triangle, towards its front
    glm::dvec3 normal;  // unit shading normal
    double offset;      // from the surface to the start of rays that leave it
};

/// Light on its way.
struct Path {
    glm::dvec3 direction;
    const SmoothBoundary* body;  // that the path runs through; null: none
    bool bent;                   // whether any event was more than a straight passage
    std::uint32_t seed;
    std::vector<double> powers;  // by channel
};

class Tracer {
public:
    Tracer(const PhotonScene& scene, std::span<const LightSourcePtr> sources)
        : scene_(scene), sources_(sources) {
        const WorldGeometry& geometry = scene.geometry;
        for (const TriangleBatch& batch : triangle_batches(geometry)) {
            const VertexRange& range = geometry.ranges[batch.range];
            if (!range.roles.casts_shadows || !range.roles.visible || !bends_light(*range.material)) continue;
            SmoothRange& smooth = smooth_.emplace_back(SmoothRange{batch.range, {}, {}});
            double area = 0;
            for (std::size_t t = batch.first; t < batch.last; ++t) {
                const glm::uvec3& corners = geometry.triangles[t];
                const glm::dvec3 first(geometry.positions[corners.x]);
                area += glm::length(glm::cross(glm::dvec3(geometry.positions[corners.y]) - first,
                                               glm::dvec3(geometry.positions[corners.z]) - first)) /
                        2;
                smooth.triangles.push_back(static_cast<std::uint32_t>(t));
                smooth.areas.push_back(area);
            }
            if (!(area > 0)) smooth_.pop_back();
        }
    }

    [[nodiscard]] std::shared_ptr<const FocusedLight> trace() const {
        if (smooth_.empty() || sources_.empty()) return nullptr;
        struct Pair {
            const SmoothRange& smooth;
            const LightSource& source;
            std::uint32_t index;
            double power = 0;
        };
        std::vector<Pair> pairs;
        double all = 0;
        for (const SmoothRange& smooth : smooth_)
            for (const LightSourcePtr& source : sources_)
                pairs.push_back({smooth, *source, static_cast<std::uint32_t>(pairs.size())});
        const std::size_t pilots =
            std::clamp(kPilots / pairs.size() / kLanes * kLanes, kLeastPilots, kMostPilots);
        tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
            Pair& pair = pairs[i];
            for_starts(pair.smooth, pair.source, pair.index, 0, pilots, pilots,
                       [&](const Meeting&, const Path& path) {
                           for (const double power : path.powers) pair.power += power;
                       });
        });
        for (const Pair& pair : pairs) all += pair.power;
        if (!(all > 0) || !std::isfinite(all)) return nullptr;
        std::vector<Photon> photons;
        std::vector<float> powers;
        for (const Pair& pair : pairs) {
            if (!(pair.power > 0)) continue;
            const auto count =
                static_cast<std::size_t>(std::ceil(kPaths * pair.power / all / kLanes)) * kLanes;
            constexpr std::size_t together = 16 * kLanes;
            struct Part {
                std::vector<Photon> photons;
                std::vector<float> powers;
            };
            std::vector<Part> parts((count + together - 1) / together);
            tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
                for_starts(pair.smooth, pair.source, pair.index, i * together,
                           std::min(count, (i + 1) * together), count, [&](const Meeting& start, Path& path) {
                               follow(start, path, parts[i].photons, parts[i].powers);
                           });
            });
            for (const Part& part : parts) {
                photons.insert(photons.end(), part.photons.begin(), part.photons.end());
                powers.insert(powers.end(), part.powers.begin(), part.powers.end());
            }
        }
        if (photons.size() < kLeastPhotons) return nullptr;
        return std::make_shared<const FocusedLight>(std::move(photons), std::move(powers), scene_.channels);
    }

private:
    [[nodiscard]] Meeting meeting_at(std::uint32_t triangle, double b1, double b2) const {
        const WorldGeometry& geometry = scene_.geometry;
        const glm::uvec3& corners = geometry.triangles[triangle];
        const std::array positions{geometry.positions[corners.x], geometry.positions[corners.y],
                                   geometry.positions[corners.z]};
        const glm::dvec3 a(positions[0]), b(positions[1]), c(positions[2]);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double area = glm::length(across);
        const glm::dvec3 facet = area > 0 ? across / area : glm::dvec3(0, 0, 1);
        const glm::dvec3 normal = (1 - b1 - b2) * glm::dvec3(geometry.normals[corners.x]) +
                                  b1 * glm::dvec3(geometry.normals[corners.y]) +
                                  b2 * glm::dvec3(geometry.normals[corners.z]);
        const double length = glm::length(normal);
        return {.range = range_of(geometry, corners.x),
                .triangle = triangle,
                .position = (1 - b1 - b2) * a + b1 * b + b2 * c,
                .facet = facet,
                .normal = length > 0 ? normal / length : facet,
                .offset = ray_offset(positions)};
    }

    // Returns the point of the surface where path i of `count` begins. Triangles have paths in proportion to
    // their areas, each by a sequence of its own.
    [[nodiscard]] Meeting start_at(const SmoothRange& smooth, std::size_t i, std::size_t count) const {
        const double per_area = static_cast<double>(count) / smooth.areas.back();
        const double area = (static_cast<double>(i) + 0.5) / per_area;
        const auto after = std::ranges::upper_bound(smooth.areas, area) - smooth.areas.begin();
        const auto chosen = std::min(static_cast<std::size_t>(after), smooth.triangles.size() - 1);
        const double before = chosen > 0 ? smooth.areas[chosen - 1] : 0;
        const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, before * per_area - 0.5)));
        const glm::dvec2 point(sample_at(i - std::min(i, first), smooth.triangles[chosen]));
        const double root = std::sqrt(point.x);
        return meeting_at(smooth.triangles[chosen], root * (1 - point.y), root * point.y);
    }

    // Calls visit(meeting, path) for light that reaches the smooth surface from a source: for the paths
    // first <= i < last of `count`, which are spread evenly over the surface and over the source.
    template <class Visit>
    void for_starts(const SmoothRange& smooth, const LightSource& source, std::uint32_t index,
                    std::size_t first, std::size_t last, std::size_t count, const Visit& visit) const {
        LaneLight light;
        for (std::size_t begin = first; begin < last; begin += kLanes) {
            std::array<Meeting, kLanes> meetings;
            LaneVectors positions;
            Lanes u, v;
            for (std::size_t i = 0; i < kLanes; ++i) {
                // Golden ratios of the plane (Roberts, 2018) have nothing in common with the sequences of
                // places, so that each place meets all parts of the source.
                const glm::dvec2 of_source =
                    glm::fract(0.5 + static_cast<double>(begin + i) *
                                         glm::dvec2(0.7548776662466927, 0.5698402909980532));
                meetings[i] = start_at(smooth, begin + i, count);
                put(positions, i, glm::vec3(meetings[i].position));
                u[i] = std::min(static_cast<float>(of_source.x), 1 - 0x1p-24F);
                v[i] = std::min(static_cast<float>(of_source.y), 1 - 0x1p-24F);
            }
            source.sample(positions, u, v, light);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if ((light.points >> i & 1) == 0) continue;
                const Meeting& meeting = meetings[i];
                const glm::dvec3 towards = glm::normalize(glm::dvec3(vector_at(light.towards, i)));
                const double cosine = glm::dot(meeting.facet, towards);
                const bool glass = material_at(meeting).smooth_boundary() != nullptr;
                if (!glass && !(cosine > 0)) continue;
                Ray ray = leaving(meeting.position, meeting.facet, towards, meeting.offset);
                ray.farthest = static_cast<double>(light.distance[i]);
                if (scene_.smooth.occluded(ray)) continue;
                Path path{.direction = -towards,
                          .body = nullptr,
                          .bent = false,
                          .seed = sample_seed(static_cast<std::uint32_t>(begin + i), index),
                          .powers = {}};
                const double area = smooth.areas.back() * std::abs(cosine) / static_cast<double>(count);
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

    void follow(Meeting at, Path& path, std::vector<Photon>& photons, std::vector<float>& powers) const {
        for (int event = 0;; ++event) {
            const Material& material = material_at(at);
            if (!bends_light(material)) {
                // Backs are black; two-sided surfaces have triangles for both sides.
                if (!path.bent || !(glm::dot(at.facet, path.direction) < 0)) return;
                photons.push_back({.position = glm::vec3(at.position),
                                   .normal = glm::vec3(at.facet),
                                   .towards = glm::vec3(-path.direction)});
                for (const double power : path.powers) powers.push_back(static_cast<float>(power));
                return;
            }
            if (event == scene_.events) return;
            path.seed = sample_seed(path.seed, static_cast<std::uint32_t>(event));
            const SmoothBoundary* const boundary = material.smooth_boundary();
            if (boundary != nullptr ? !pass(*boundary, at, path) : !mirror(material, at, path)) return;
            const Ray ray = leaving(at.position, at.facet, path.direction, at.offset);
            const std::optional<RayHit> hit = scene_.smooth.intersect(ray);
            if (!hit) return;
            for (std::size_t c = 0; c < path.powers.size(); ++c)
                path.powers[c] *= transmitted_by(path.body, static_cast<int>(c), hit->distance);
            at = meeting_at(hit->triangle, hit->b1, hit->b2);
        }
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
    std::span<const LightSourcePtr> sources_;
    std::vector<SmoothRange> smooth_;
};

}  // namespace

std::shared_ptr<const FocusedLight> focused_light(const PhotonScene& scene,
                                                  std::span<const LightSourcePtr> sources) {
    return Tracer(scene, sources).trace();
}

}  // namespace nicol
