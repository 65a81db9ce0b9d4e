// SPDX-License-Identifier: MIT
#include "visibility/bake.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "geometry/ray_scene.hpp"
#include "progress.hpp"
#include "simd/dispatch.hpp"
#include "visibility/bake_origins.hpp"
#include "visibility/vertex_rays.hpp"

namespace nicol {
namespace {

// Number of rays between two calls of the progress callback.
constexpr std::size_t kRaysAtATime = std::size_t{1} << 21;

std::vector<glm::vec3> unit_normals(std::span<const glm::vec3> normals) {
    std::vector<glm::vec3> out;
    out.reserve(normals.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        // Double precision is needed because squares of floats may vanish or overflow.
        const glm::dvec3 normal(normals[v]);
        const double length = glm::length(normal);
        if (!(length > 0) || !std::isfinite(length)) {
            refuse("the normal of vertex " + std::to_string(v) +
                   (length == 0 ? " is zero" : " is not finite") +
                   "; a vertex needs one to have a front side");
        }
        out.emplace_back(normal / length);
    }
    return out;
}

// Place in the list of a former bake for vertices that were not in it.
constexpr std::size_t kNone = ~std::size_t{0};

std::vector<std::size_t> places_before(const FormerBake& former, std::size_t vertices) {
    std::vector<std::size_t> places(vertices, kNone);
    for (const VertexRun& run : former.kept) {
        const std::size_t there = run.last - std::min(run.first, run.last) + run.before;
        if (run.first > run.last || run.last > vertices || there > former.visibility.vertices()) {
            refuse("vertices " + std::to_string(run.first) + " to " + std::to_string(run.last) +
                   " are not all in both bakes");
        }
        for (std::size_t v = run.first; v < run.last; ++v) places[v] = run.before + (v - run.first);
    }
    return places;
}

// Margin against rounding: of radii relative to the distance, and of cosines.
constexpr float kSlack = 1e-4F;

// Sets disturbed[b] = 1 if the angle between axis b and the unit vector `to` is at most the sum of two
// angles: the cone's half opening angle (cosine, sine) and the ball's angle (ball_cosine, ball_sine), which
// is below a right angle.
[[gnu::always_inline]] inline void mark_near(std::size_t count, const float* x, const float* y,
                                             const float* z, const float* cosine, const float* sine,
                                             const glm::vec3& to, float ball_cosine, float ball_sine,
                                             std::uint8_t* disturbed) {
    for (std::size_t b = 0; b < count; ++b) {
        const float along = x[b] * to.x + y[b] * to.y + z[b] * to.z;
        const bool near = along >= cosine[b] * ball_cosine - sine[b] * ball_sine - kSlack;
        disturbed[b] = static_cast<std::uint8_t>(disturbed[b] | (near ? 1 : 0));
    }
}

/// Cone around each bundle of a direction set.
class BundleCones {
public:
    explicit BundleCones(const DirectionSet& directions) {
        for (const RayBundle& bundle : directions.bundles()) {
            const auto ray = [&bundle](std::size_t i) {
                return glm::dvec3(bundle.x[i], bundle.y[i], bundle.z[i]);
            };
            glm::dvec3 sum(0.0);
            for (std::size_t i = 0; i < RayBundle::kRays; ++i) sum += ray(i);
            const double length = glm::length(sum);
            const glm::dvec3 axis = length > 1e-6 ? sum / length : ray(0);
            double cosine = 1;
            for (std::size_t i = 0; i < RayBundle::kRays; ++i)
                cosine = std::min(cosine, glm::dot(axis, ray(i)));
            // A cone wider than a half sphere is replaced by the whole sphere.
            const bool wide = cosine <= 0;
            x_.push_back(static_cast<float>(axis.x));
            y_.push_back(static_cast<float>(axis.y));
            z_.push_back(static_cast<float>(axis.z));
            cosine_.push_back(wide ? -2.0F : static_cast<float>(cosine));
            sine_.push_back(wide ? 2.0F : static_cast<float>(std::sqrt(1 - cosine * cosine)));
        }
    }

    /// Sets disturbed[b] to 1 if a ray from `origin` in a direction of bundle b may meet the ball; leaves
    /// other values unchanged. For directions above the plane of the unit normal it is conservative: it may
    /// mark too many bundles, never too few.
    void mark(const glm::vec3& origin, const glm::vec3& normal, const Ball& ball,
              std::span<std::uint8_t> disturbed) const {
        const glm::vec3 to = ball.centre - origin;
        const float distance = glm::length(to);
        const float radius = ball.radius + kSlack * (distance + ball.radius);
        if (glm::dot(normal, to) < -radius) return;  // the whole ball is below the horizon
        if (!(radius < distance)) {
            std::ranges::fill(disturbed, std::uint8_t{1});
            return;
        }
        const float sine = radius / distance;
        dispatch<mark_near>(x_.size(), x_.data(), y_.data(), z_.data(), cosine_.data(), sine_.data(),
                            to / distance, std::sqrt(1 - sine * sine), sine, disturbed.data());
    }

private:
    // Unit axes of the cones; cosines and sines of half their opening angles.
    std::vector<float> x_, y_, z_, cosine_, sine_;
};

}  // namespace

std::shared_ptr<const RayScene> rays_of(const BakeGeometry& geometry) {
    if (geometry.rays) return geometry.rays();
    const RaySurface surface{
        .positions = geometry.positions, .triangles = geometry.triangles, .present = geometry.present};
    return std::make_shared<const RayScene>(std::span(&surface, 1));
}

Visibility bake(const BakeGeometry& geometry, const DirectionSet& directions, const BakeProgress& progress,
                BakeStatistics* statistics, const FormerBake* former) {
    const std::size_t vertices = geometry.positions.size();
    if (geometry.normals.size() != vertices) {
        refuse(std::to_string(geometry.normals.size()) + " normals for " + std::to_string(vertices) +
               " vertices; there must be one for each");
    }
    if (former != nullptr && former->visibility.directions() != directions.size()) {
        refuse("the former bake has " + std::to_string(former->visibility.directions()) +
               " directions and this one " + std::to_string(directions.size()) + "; they must be the same");
    }
    const std::vector<glm::vec3> normals = unit_normals(geometry.normals);
    const auto report = [&](std::size_t done) {
        if (progress)
            progress(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(vertices, 1)));
    };

    report(0);
    const Stopwatch building;
    const std::shared_ptr<const RayScene> scene = rays_of(geometry);
    const std::vector<glm::vec3> origins = bake_origins(geometry, normals);
    std::vector<std::size_t> before;
    std::optional<BundleCones> cones;
    if (former != nullptr) {
        before = places_before(*former, vertices);
        cones.emplace(directions);
    }
    const double build_milliseconds = building.milliseconds();

    const Stopwatch tracing;
    Visibility visibility(directions.size(), vertices);
    std::atomic<std::uint64_t> rays = 0;
    std::atomic<std::uint64_t> from = 0;
    const std::size_t chunk = 2 * kRaysAtATime / directions.size();
    for (std::size_t first = 0; first < vertices; first += chunk) {
        const std::size_t last = std::min(first + chunk, vertices);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, 4), [&](const auto& range) {
            std::uint64_t traced = 0;
            std::uint64_t tracing_vertices = 0;
            std::vector<std::uint8_t> disturbed(directions.bundles().size());
            for (std::size_t v = range.begin(); v < range.end(); ++v) {
                std::optional<FormerBits> known;
                if (former != nullptr && before[v] != kNone) {
                    std::ranges::fill(disturbed, std::uint8_t{0});
                    for (const Ball& ball : former->disturbances) {
                        cones->mark(origins[v], normals[v], ball, disturbed);
                    }
                    known = {.bits = former->visibility.at(before[v]), .disturbed = disturbed};
                }
                const std::uint64_t count =
                    trace_vertex(*scene, directions, origins[v], normals[v], v, known, visibility);
                traced += count;
                tracing_vertices += count > 0 ? 1 : 0;
            }
            rays += traced;
            from += tracing_vertices;
        });
        report(last);
    }
    if (statistics != nullptr) {
        *statistics = {.rays = rays,
                       .vertices = from,
                       .milliseconds = tracing.milliseconds(),
                       .build_milliseconds = build_milliseconds,
                       .unoccluded = visibility.unoccluded_count(),
                       .from_cache = false};
    }
    return visibility;
}

}  // namespace nicol
