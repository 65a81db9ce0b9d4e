// SPDX-License-Identifier: MIT
// Ray queries against triangles.
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

namespace embree {
struct Hit;
}

/// Alpha mask of a surface: returns whether the surface is present at a point of one of its triangles. b1 and
/// b2 are the barycentric weights of the triangle's corners 1 and 2. Called from several threads at once;
/// must not throw.
using Presence = std::function<bool(std::uint32_t triangle, float b1, float b2)>;

/// Numbers of consecutive triangles in hits: triangle `first` has `number`, the next one number + 1.
struct TriangleNumbers {
    std::uint32_t first;
    std::uint32_t number;
    /// Difference between the numbers of the back and the front of a triangle. Corners 1 and 2 of the back
    /// are corners 2 and 1 of the front. 0: both sides are one triangle.
    std::uint32_t back = 0;
};

/// Triangles of one surface in the world: indices into positions.
struct RaySurface {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
    Presence present = {};  ///< alpha mask (rays pass if it returns false); empty: present everywhere
    /// Whether rays pass from the back, the side on which corners follow one another clockwise.
    bool front_only = false;
    /// Numbers of the triangles in hits, ascending by `first`, from 0; empty: their indices.
    std::span<const TriangleNumbers> numbers = {};
};

struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0, 0, 1};  ///< unit vector
    double nearest = 0;             ///< hits count from the distance `nearest` (>= 0) to `farthest`
    double farthest = std::numeric_limits<double>::infinity();
};

struct RayHit {
    std::uint32_t surface;   ///< index into the given surfaces or parts
    std::uint32_t triangle;  ///< number of the surface's triangle
    double distance;
    double b1, b2;  ///< barycentric weights of the triangle's corners 1 and 2; corner 0 has the rest
};

/// Distance between a surface and the start of rays that leave it, per unit of the largest coordinate of the
/// surface's triangle there: about 30 units in the last place of the 32-bit floats that hold this coordinate.
/// The plane of a triangle is accurate to about 1 such unit.
inline constexpr double kRayOffset = 0x1p-19;

/// Returns the distance between a triangle and the start of rays that leave it.
[[nodiscard]] double ray_offset(const std::array<glm::vec3, 3>& corners);

/// Returns the ray in the unit `direction` from `point`, which lies on a triangle with the unit `normal`
/// (either sign). The ray starts `offset` away from the triangle, on the side of `direction`.
[[nodiscard]] Ray leaving(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& direction,
                          double offset);

/// Unit directions of sixteen rays that start at one point. Directions close to each other are traced faster.
struct alignas(64) RayBundle {
    static constexpr std::size_t kRays = 16;
    std::array<float, kRays> x, y, z;
};

/// Sixteen rays with origins and unit directions of their own, each up to a distance: infinite for distant
/// lights.
struct alignas(64) RayPacket {
    static constexpr std::size_t kRays = 16;
    std::array<float, kRays> origin_x, origin_y, origin_z;
    std::array<float, kRays> direction_x, direction_y, direction_z;
    std::array<float, kRays> farthest;
};

/// First hits of a packet's rays, as in RayHit.
struct alignas(64) HitPacket {
    std::array<float, RayPacket::kRays> distance, b1, b2;
    std::array<std::uint32_t, RayPacket::kRays> surface, triangle;
};

class RayScene;

/// A scene of one surface as part of another scene.
struct RayPart {
    std::shared_ptr<const RayScene> scene;
    std::vector<TriangleNumbers> numbers;  ///< see RaySurface::numbers; not empty
};

/// A bounding volume hierarchy (Embree's, in its robust mode: a ray does not slip between two triangles that
/// share an edge). Triangles block rays from both sides unless their surface says otherwise. Immutable;
/// queries may be made from any thread.
///
/// A scene of parts has hits equal to those of a scene of the parts' surfaces. It is made within microseconds
/// a part.
class RayScene {
public:
    /// Copies what it needs; surfaces may be empty. Throws Error(invalid_argument), naming the surface and
    /// the vertex or triangle, for a position that is not finite or beyond 1e15 and for an index out of
    /// range. Throws Error(unsupported) without Embree, Error(out_of_memory), and Error(internal) if Embree
    /// fails.
    explicit RayScene(std::span<const RaySurface> surfaces);
    /// Makes a scene of parts, none of which is scaled(). Throws Error(out_of_memory) and Error(internal).
    explicit RayScene(std::vector<RayPart> parts);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// Returns whether Embree has another scale than the world, because the largest coordinate is tiny.
    [[nodiscard]] bool scaled() const noexcept { return scale_ != 1; }

    [[nodiscard]] std::optional<RayHit> intersect(const Ray& ray) const;
    /// Sets hits[i] to the first hit of rays[i]. Rays close to each other are traced faster than one by one.
    void intersect(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits) const;

    /// Finds the first hits of the rays whose bit in `active` is set, and returns the bits of those that hit
    /// something. Rays close to each other are traced faster. Each origin must lie beside the surface that
    /// the ray leaves.
    [[nodiscard]] std::uint16_t intersect(const RayPacket& packet, std::uint16_t active,
                                          HitPacket& hits) const;

    /// Returns whether anything lies on a ray, nearer than its distance `farthest`. The ray begins at its
    /// origin, and ends 1e-4 of `farthest` and kRayOffset before that distance, so that an area light's own
    /// surface does not hide it.
    [[nodiscard]] bool occluded(const Ray& ray) const;

    /// Returns which rays of a bundle from `origin` are occluded: bit i is that of ray i. Only rays whose bit
    /// in `active` is set are traced; the other bits of the result are 0.
    [[nodiscard]] std::uint16_t occluded(const glm::vec3& origin, const RayBundle& bundle,
                                         std::uint16_t active) const;

    /// Returns which rays of a packet are occluded, as for a bundle. Rays close to each other are traced
    /// faster. Each origin must lie beside the surface that the ray leaves; each ray ends as a single ray
    /// does.
    [[nodiscard]] std::uint16_t occluded(const RayPacket& packet, std::uint16_t active) const;

private:
    /// Returns the length, in Embree's units, of a ray from `origin` that may be occluded; a length that is
    /// not positive means that there is no ray.
    [[nodiscard]] double end(const glm::vec3& origin, double farthest) const noexcept;

    /// Returns what Embree found on a ray. length: to the hit, in Embree's units.
    [[nodiscard]] std::optional<RayHit> hit_of(const embree::Hit& found, float length, const Ray& ray) const;

    struct Embree;
    struct Passage;
    std::vector<std::unique_ptr<const Passage>> passages_;
    std::vector<std::vector<TriangleNumbers>> numbers_;  // by surface or part
    std::vector<RayPart> parts_;
    std::unique_ptr<Embree> embree_;
    double scale_ = 1;  ///< scale from the world to Embree: a power of two, so that nothing is rounded
};

}  // namespace nicol
