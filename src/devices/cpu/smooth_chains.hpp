// SPDX-License-Identifier: MIT
// Rays at pixels that show smooth surfaces, glass or metal with narrow lobes, on threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "devices/cpu/lane_chains.hpp"
#include "devices/cpu/surface_shading.hpp"
#include "geometry/ray_scene.hpp"
#include "material/followed_terms.hpp"
#include "polarization/mueller.hpp"
#include "shading/boundary_split.hpp"
#include "shading/ray_spread.hpp"

namespace nicol {

/// Chains of mirrored and refracted rays. A chain begins at each sample of a pixel that shows a smooth
/// surface, a rough boundary or followed lobes. It ends at other surfaces, whose light SurfaceShading
/// computes, and at the environment, which is looked up in its image. A Mueller matrix for each event takes
/// the light to the camera. Calls for different pixels may run in parallel.
class SmoothChains {
public:
    /// A chain has both branches of an event if each carries at least this fraction of its sample's light;
    /// otherwise one of them, chosen at random by the light that it carries.
    static constexpr double kBothCarry = 0.01;
    /// Number of facets that a chain follows at its first rough boundary. At later ones it follows one.
    static constexpr int kFacetSamples = 4;
    /// Number of facets that a pixel's samples follow together where it shows lobes; each at least one.
    static constexpr std::size_t kLobeSamples = 4;

    /// Keeps a reference. The input must have smooth surfaces.
    explicit SmoothChains(const SurfaceShading& surfaces);

    /// Adds to out[c][pixel], for first <= pixel < last, the light of the pixel's chains. `counts.followed`
    /// is that of pixels all of whose samples show lobes; its values are all pixels that show them.
    void add(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out,
             PointCounts& counts) const;

private:
    static constexpr std::uint32_t kNoHalf = 2;
    static constexpr std::uint32_t kNoTriangle = ~0U;
    /// Number of a chain's first seed for a chain that goes on; events take smaller ones for their choices.
    static constexpr std::uint32_t kFirstOnward = 1U << 16;
    /// Way of light from the end of a chain to the pixel.
    struct Way {
        std::uint32_t pixel;
        std::uint32_t matrices;  ///< index in Ends::matrices of the matrix of the first channel
        /// Half of the pixel's samples of lobes that found the way: 0 or 1; kNoHalf: no lobe was sampled.
        std::uint32_t half = kNoHalf;
    };
    /// Chain that goes on along a ray.
    struct Chain {
        Way way;
        Ray ray;
        RaySpread spread;
        double blur;     ///< variance of the directions that this chain stands for among those of facets
        Frame received;  ///< frame of the light that travels against the ray
        double carried;  ///< fraction of the sample's light
        int events;      ///< number of events so far
        bool lit;        ///< whether the surfaces before have reflected the lights on the ray already
        /// Whether a lobe has reflected the surfaces' own emission on the ray already, even behind glass.
        bool lobes_lit;
        bool scattered;              ///< whether facets have scattered the chain
        const SmoothBoundary* body;  ///< body that the ray travels through; null: none
        std::uint32_t seed;
        std::uint32_t pixel_seed;  ///< seed that the pixel's samples share
        std::uint32_t sample;      ///< number of the sample
        /// Triangle that the image shows, which the ray meets; kNoTriangle: the ray must be traced.
        std::uint32_t shown = kNoTriangle;
        bool open = false;  ///< whether the ray meets nothing, see SmoothSurfaces::open()
    };
    /// Chain whose ray meets a smooth boundary.
    struct Meeting {
        Chain* chain;
        SurfacePoint point;
        RayHit hit;
    };
    struct Place;
    struct Ends;
    /// Sample that shows a smooth boundary.
    struct Shown {
        std::uint32_t pixel, sample, triangle, range;
    };
    struct Bundle;
    /// Continuation of a chain at a facet of a rough boundary.
    struct Event {
        const SmoothBoundary& boundary;
        const BoundarySplit& split;
        bool reflects;         ///< whether the chain goes on with the reflected part
        double probability;    ///< of this choice, times the number of chains that the event starts
        std::uint32_t number;  ///< of the chain that goes on, among those of the event
    };

    /// A surface as a chain sees it.
    struct Appearance {
        Frame frame;        ///< frame of the material, z along the perturbed normal
        glm::dvec3 viewer;  ///< direction towards the viewer in that frame
        /// Weights of the material's layers, or 1. Valid until the thread's next call of appearance_at().
        std::span<const glm::vec3> weights;
    };
    /// Continuation of a chain at an opaque surface.
    struct Reflection {
        glm::dvec3 towards_light;           ///< in the frame of the appearance
        std::span<const Mueller> muellers;  ///< by channels, between the frames of Material::evaluate()
        std::uint32_t half = kNoHalf;       ///< half of the samples of lobes, see Way::half
        std::uint32_t number = 0;           ///< of the chain that goes on, among those of the event
    };

    using Image = std::span<const std::span<glm::vec4>>;

    [[nodiscard]] Chain first_chain(std::size_t pixel, std::size_t sample, Ends& ends) const;
    /// Follows the chains of samples as bundles while they meet the boundary that the samples show. Adds the
    /// chains that meet others, and those of few samples or of a film, to `chains`.
    void follow_bundles(std::vector<Shown>& shown, std::vector<Chain>& chains, Ends& ends, Image out) const;
    /// Sets the first `count` chains of a bundle, which are at the boundary.
    void begin_bundle(std::size_t count, LaneChains& out, Bundle& bundle) const;
    /// Finds what the rays of levels.front() meet, and goes on from the boundary. The other levels are room.
    void meet(std::span<LaneChains> levels, Bundle& bundle) const;
    /// Finds the chains whose rays leave the bundle's body, which is convex, where rays of nearby samples
    /// left it. Sets what they meet, and returns their bits. exits: the triangles at which those left, by
    /// columns of pixels.
    [[nodiscard]] std::uint32_t leave(LaneChains& chains, std::uint32_t some,
                                      std::span<const std::uint32_t> exits, const Bundle& bundle) const;
    /// Traces the rays of some chains. Adds those that meet the boundary to `met`, whose triangles are then
    /// set, and those that meet nothing to `sky`. The others leave the bundle.
    void trace(LaneChains& chains, std::uint32_t some, std::uint32_t& met, std::uint32_t& sky,
               Bundle& bundle) const;
    /// Passes the boundary.
    void pass(std::span<LaneChains> levels, Bundle& bundle) const;
    /// Continues some chains beyond the boundary.
    void go_on(const LaneChains& from, const LaneSplit& split, const LaneChoice& choice, std::uint32_t some,
               LaneChains& to, const Bundle& bundle) const;
    void add_sky(const LaneChains& chains, std::uint32_t some, Bundle& bundle) const;
    void absorb(LaneChains& chains, std::uint32_t some, std::uint32_t met, const Bundle& bundle) const;
    /// Returns a chain of a bundle, whose ray meets a triangle.
    [[nodiscard]] Chain single(const LaneChains& chains, std::size_t lane, std::uint32_t triangle,
                               const Bundle& bundle) const;
    /// Multiplies a chain by what the body around its ray transmits over a distance.
    void absorb(Chain& chain, double distance, Ends& ends) const;
    /// Follows chains to their ends.
    void follow_all(std::vector<Chain>& chains, Ends& ends) const;
    /// Follows a chain to what its ray meets. Adds the chains that go on to `rest`, and the chain to
    /// `meetings` if the surface is a smooth boundary.
    void follow(Chain& chain, const std::optional<RayHit>& hit, std::vector<Meeting>& meetings,
                std::vector<Chain>& rest, Ends& ends) const;
    /// Sets hits[i] to the first hit of the ray of chains[i].
    void find_hits(std::span<const Chain> chains, std::vector<std::optional<RayHit>>& hits, Ends& ends) const;
    /// Passes boundaries, sixteen chains at a time.
    void pass_all(std::vector<Meeting>& meetings, std::vector<Chain>& rest, Ends& ends) const;
    /// Passes one boundary with at most sixteen chains.
    void pass(std::span<const Meeting> meetings, std::vector<Chain>& rest, Ends& ends) const;
    void scatter(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const;
    /// Goes on from a facet of a rough boundary.
    void go_on(const Chain& chain, const Place& place, const Event& event, std::vector<Chain>& rest,
               Ends& ends) const;
    void mirror(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const;
    void follow_lobes(const Chain& chain, const Place& place, std::vector<Chain>& rest, Ends& ends) const;
    void reflect(const Chain& chain, const Place& place, const Appearance& seen, const Reflection& reflection,
                 std::vector<Chain>& rest, Ends& ends) const;
    [[nodiscard]] Appearance appearance_at(const Place& place, const glm::dvec3& towards_viewer) const;
    void add_surfaces(Ends& ends, std::span<const std::span<glm::vec4>> out, PointCounts& counts) const;
    /// Returns RayPoint::noise_factor. 0: halves of the pixel's samples have the noise of what they meet.
    [[nodiscard]] float noise_factor(const Way& way, const Ends& ends) const;
    void add_sky(Ends& ends, std::span<const std::span<glm::vec4>> out) const;
    void add_arriving(Ends& ends, const Way& way, std::size_t channel, const glm::vec4& stokes,
                      std::span<const std::span<glm::vec4>> out) const;
    [[nodiscard]] Place place_at(const RayHit& hit, const Ray& ray, Ends& ends) const;
    /// Moves a chain's spread to the place, and returns the changes of the normal along it.
    [[nodiscard]] std::array<glm::dvec3, 2> bends_at(const Place& place, const glm::dvec3& normal,
                                                     const Ray& ray, RaySpread& spread) const;

    /// Returns a chain that goes on after an event; its ray is still the one that came to the event.
    /// matrices: Way::matrices. number: of the chain, among those of the event.
    [[nodiscard]] Chain after_event(const Chain& chain, std::uint32_t matrices, std::uint32_t number) const;
    /// Returns whether a ray that leaves a point meets nothing.
    [[nodiscard]] bool leaves_all(std::uint32_t triangle, const glm::dvec3& facet,
                                  const glm::dvec3& direction) const {
        return input_.smooth->open(triangle) && glm::dot(facet, direction) > 0;
    }

    const SurfaceShading& surfaces_;
    const PixelInput& input_;
    glm::vec4 wanted_;    // 1 for the image's components, else 0
    glm::mat3 to_light_;  // from the geometry's axes to the light's
    struct Lobes {
        std::vector<FollowedLayer> layers;
        bool mirrors;  // whether the material has smooth terms as well
    };
    std::vector<Lobes> lobes_;  // by ranges; empty: rays follow no lobes
};

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
        int events;  // of the chain
    };
    struct Sky {
        glm::vec3 direction, x;  // in the light's axes
        float variance;          // of the direction within the sample
        Way way;
    };
    std::vector<Surface> surfaces;
    std::vector<Sky> sky;
    std::vector<glm::mat4> matrices;  // into the camera's frames, by channels
    std::size_t first = 0;            // pixel
    std::vector<std::size_t> lobes;   // number of each pixel's samples that show them
    // s0 of light that lobes reflect, by pixels and channels: of each half of their samples.
    std::vector<std::array<float, 2>> halves;
    std::uint64_t rays = 0;
    std::size_t range = 0;  // of the previous point
};

}  // namespace nicol
