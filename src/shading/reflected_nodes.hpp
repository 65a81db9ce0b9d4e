// SPDX-License-Identifier: MIT
// Quadrature over the directions that pixels see reflected by the facets of a lobe.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "material/material.hpp"
#include "material/microfacet.hpp"
#include "polarization/lane_points.hpp"
#include "shading/node_grids.hpp"

namespace nicol {

/// Directions that a pixel sees mirrored by a surface: a parallelogram.
struct MirroredPixel {
    glm::vec3 shift{0.0F};  ///< from the mirrored direction at the shaded point to the parallelogram's middle
    /// Changes of the direction across the pixel, to the right and down.
    std::array<glm::vec3, 2> steps{glm::vec3(0.0F), glm::vec3(0.0F)};
};

/// The same of sixteen points.
struct MirroredPixels {
    LaneVectors shift{};
    std::array<LaneVectors, 2> steps{};

    [[nodiscard]] MirroredPixel at(std::size_t i) const {
        return {.shift = vector_at(shift, i), .steps = {vector_at(steps[0], i), vector_at(steps[1], i)}};
    }
};
inline void put(MirroredPixels& lanes, std::size_t i, const MirroredPixel& pixel) {
    put(lanes.shift, i, pixel.shift);
    for (std::size_t k = 0; k < 2; ++k) put(lanes.steps[k], i, pixel.steps[k]);
}

/// Normal distribution of slopes, part of the distribution of facets' slopes.
struct SlopePart {
    float deviation;  ///< standard deviation over alpha
    float share;      ///< of the facets
    float nodes;      ///< largest number of nodes, over that of the grids
    /// Largest blob, relative to the shorter axis of what the part reflects, for which nodes are spent.
    float blob;
};

/// Returns the parts of a distribution of facets. The three of GGX leave a two-hundredth of the slopes out,
/// the steepest ones.
[[nodiscard]] std::span<const SlopePart> slope_parts(Distribution distribution);

/// Directions of sixteen points, in their surfaces' frames.
struct ReflectedNode {
    LaneVectors towards;  ///< unit directions towards light that facets reflect to the viewer
    LaneVectors seen;     ///< directions, of any length, around which to average the light for the pixels
    Lanes variances;      ///< of the blobs to average over, along each axis, in square radians
    Lanes weights;        ///< solid angles: factors of the pBRDF times the cosine times the light
};

/// Computes the one node of mirrors whose pixels show no more than the narrowest blobs do. narrowest: see
/// ReflectedNodes. Returns bits of these points; others need several nodes.
[[nodiscard]] std::uint32_t mirror_node(float narrowest, const LaneVectors& towards_viewer,
                                        const MirroredPixels& pixels, ReflectedNode& out);

/// Two neighbouring nodes for which the pBRDF is evaluated once, in the direction of PairDirection.
struct ReflectedPair {
    std::array<ReflectedNode, 2> nodes;  ///< the weights still lack PairDirection::factors
};

/// Unpolarized light of a pair.
struct PairLight {
    std::array<Lanes, 2> brightness;  ///< by node: s0 times the node's weight, 0 where it is hidden
    /// From the middle of a node's blob to the mean direction of its light.
    LaneVectors lean;
};

/// Mean directions of the light of pairs, where their pBRDF is evaluated because the polarization varies
/// over a blob.
struct PairDirection {
    LaneVectors towards;  ///< unit directions
    Lanes factors;        ///< of the nodes' weights
};

/// The nodes of sixteen points. Sums over them have the second moments of the integral over all directions
/// and over the pixels.
class ReflectedNodes {
public:
    /// Takes the nodes of a part of a lobe. Keeps references to all but `part`, which must outlive the
    /// object.
    ReflectedNodes(const NodeGrids& grids, const Lobe& lobe, const SlopePart& part,
                   const LaneVectors& towards_viewer, const MirroredPixels& pixels);
    /// Takes the nodes of a mirror, whose weights add up to 1. narrowest: standard deviation, in radians, of
    /// the narrowest blobs that the mirrored light resolves.
    ReflectedNodes(const NodeGrids& grids, float narrowest, const LaneVectors& towards_viewer,
                   const MirroredPixels& pixels);

    /// Returns the largest number of nodes of a point. The nodes of others end with weights of 0.
    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] ReflectedNode node(std::size_t k) const;
    /// Returns nodes 2k and 2k + 1 of a part of a lobe.
    [[nodiscard]] ReflectedPair pair(std::size_t k) const;
    /// Returns where to evaluate the pBRDF for this light of a pair.
    [[nodiscard]] PairDirection direction_of(const ReflectedPair& pair, const PairLight& light) const;
    /// Returns the shares of even pairs in the weights of a lobe's part.
    [[nodiscard]] const Lanes& even_shares() const noexcept { return even_shares_; }
    /// Returns how much wider the blobs are than the wanted ones: 1 or more.
    [[nodiscard]] const Lanes& excess() const noexcept { return excess_; }

private:
    // The k-th nodes of sixteen points on their grids.
    struct GridNodes {
        Lanes x, y, weights, widths_x, widths_y;
    };
    // Facets that nodes stand for.
    template <class Number>
    struct NodeFacets {
        Number x, y;    // slopes, in standard deviations
        Number weight;  // of the grid
        Number factor;  // ReflectedNode::weights times the density of such facets
    };
    // Computes the part of a node that begins at lane `first`, but for the weights.
    template <class Number>
    static NodeFacets<Number> reflect_part(const ReflectedNodes& r, const GridNodes& nodes, std::size_t first,
                                           ReflectedNode& out);
    template <class Number>
    static void reflect(const ReflectedNodes& r, const GridNodes& nodes, ReflectedNode& out);
    template <class Number>
    static void reflect_pair(const ReflectedNodes& r, const std::array<GridNodes, 2>& nodes,
                             ReflectedPair& out);
    template <class Number>
    static void find_direction(const ReflectedNodes& r, const ReflectedPair& pair, const PairLight& light,
                               PairDirection& out);
    [[nodiscard]] GridNodes grid_nodes(std::size_t k) const;
    // Bounds of the nodes that are chosen.
    struct Limits {
        float largest_blob;  // SlopePart::blob
        float narrowest;     // standard deviation of blobs for which nodes are spent, in radians
        std::size_t nodes;
    };
    void set_all(const NodeGrids& grids, const Limits& limits);
    // Grids by their index among grids of normal distributions, or of uniform ones if `normal` is 0.
    struct Chosen {
        Lanes index, normal;
    };
    // Computes all members but those of the grids, which are left to choose.
    template <class Number>
    static void set(ReflectedNodes& r, const NodeGrids& grids, const Limits& limits, Chosen& chosen);

    Facets<float> facets_;
    glm::vec2 deviations_;  // of the slopes along x and along y
    float share_;
    const LaneVectors& towards_viewer_;
    const MirroredPixels& pixels_;
    std::array<const NodeGrid*, kLanes> grids_{};
    bool one_grid_ = true;  // whether all points have the same grid
    std::size_t count_ = 0;
    // From a node's x and y to slopes beside the middle, and to changes of direction beyond those of the
    // slopes.
    std::array<std::array<Lanes, 2>, 2> slopes_;  // in standard deviations
    std::array<LaneVectors, 2> moves_;
    std::array<Lanes, 2> middle_;  // slopes, in standard deviations
    std::array<Lanes, 2> rests_;   // standard deviations of the nodes, without blobs
    Lanes narrowing_;              // of the slopes that the viewer sees, over all
    Lanes blob_x_, blob_y_;
    // Factors from changes of slopes to those of direction at the middle slopes: along x, squared, and of
    // areas.
    Lanes middle_way_, middle_area_;
    Lanes even_shares_, excess_;
    Lanes lobes_;  // share of the lobe in the solid angle of lobe and pixel
};

}  // namespace nicol
