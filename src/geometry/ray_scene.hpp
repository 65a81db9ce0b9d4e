// SPDX-License-Identifier: MIT
// Rays against triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace nicol {

/// Whether a surface is there, at a point of one of its triangles; b1 and b2 are the barycentric weights of
/// the triangle's corners 1 and 2. Called from several threads at once; must not throw.
using Presence = std::function<bool(std::uint32_t triangle, float b1, float b2)>;

/// Triangles of one surface in the world: indices into positions.
struct RaySurface {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
    Presence present = {};  ///< empty: everywhere. Rays pass where it is not.
};

struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0, 0, 1};  ///< unit
    double nearest = 0;             ///< distances that count: nearest to farthest, nearest >= 0
    double farthest = std::numeric_limits<double>::infinity();
};

struct RayHit {
    std::uint32_t surface;   ///< index into the surfaces given
    std::uint32_t triangle;  ///< index into its triangles
    double distance;
    double b1, b2;  ///< barycentric weights of the triangle's corners 1 and 2; corner 0 has the rest
};

/// Unit directions of sixteen rays that start at one point; the nearer to each other, the faster.
struct alignas(64) RayBundle {
    static constexpr std::size_t kRays = 16;
    std::array<float, kRays> x, y, z;
};

/// Sixteen rays from anywhere, in unit directions, up to a distance each: infinite for a light of the sky.
struct alignas(64) RayPacket {
    static constexpr std::size_t kRays = 16;
    std::array<float, kRays> origin_x, origin_y, origin_z;
    std::array<float, kRays> direction_x, direction_y, direction_z;
    std::array<float, kRays> farthest;
};

/// A bounding volume hierarchy (Embree's, in its robust mode: a ray does not slip between two triangles that
/// share an edge). Triangles are seen from both sides. Immutable; queries may be made from any thread.
class RayScene {
public:
    /// Copies what it needs; surfaces may be empty. Throws Error(invalid_argument) naming the surface and
    /// vertex or triangle for a position that is not finite or beyond 1e15 and an index out of range,
    /// Error(unsupported) without Embree, Error(out_of_memory), Error(internal) where Embree fails.
    explicit RayScene(std::span<const RaySurface> surfaces);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    [[nodiscard]] std::optional<RayHit> intersect(const Ray& ray) const;

    /// The ray in the unit `direction` from `point`, which lies on a triangle with the unit `normal` (either
    /// sign). It starts offset() away from the triangle, on the side that it leaves to.
    [[nodiscard]] Ray leaving(const glm::dvec3& point, const glm::dvec3& normal,
                              const glm::dvec3& direction) const;
    /// Whether anything lies on the ray leaving() there, nearer than the distance `farthest`: the ray ends
    /// 1e-4 of `farthest` and offset() before that, so that an area light's own surface does not hide it.
    [[nodiscard]] bool occluded(const glm::dvec3& point, const glm::dvec3& normal,
                                const glm::dvec3& direction,
                                double farthest = std::numeric_limits<double>::infinity()) const;

    /// Whether anything lies in the directions of a bundle from `origin`: bit i is that of ray i. Only rays
    /// whose bit in `active` is set are traced; the other bits of the result are 0.
    [[nodiscard]] std::uint16_t occluded(const glm::vec3& origin, const RayBundle& bundle,
                                         std::uint16_t active) const;

    /// The same of rays from anywhere; the nearer to each other, the faster. They start at their origins,
    /// which lie offset() off a surface that they leave, and end as the single ray does.
    [[nodiscard]] std::uint16_t occluded(const RayPacket& packet, std::uint16_t active) const;

    /// 2^-19 of the largest coordinate in the scene: some 30 units in the last place of the 32-bit floats
    /// that hold it, against which a triangle's own plane is known to about 1.
    [[nodiscard]] double offset() const noexcept { return offset_; }

private:
    /// Where a ray ends, in Embree's units; it is no ray if that is not positive.
    [[nodiscard]] double end(double farthest) const noexcept;

    struct Embree;
    std::vector<std::unique_ptr<const Presence>> presences_;
    std::unique_ptr<Embree> embree_;
    double offset_ = 0;
    double scale_ = 1;  ///< from the world to Embree's: a power of two, so that nothing is rounded
};

}  // namespace nicol
