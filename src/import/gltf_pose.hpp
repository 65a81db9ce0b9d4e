// SPDX-License-Identifier: MIT
// Places of a glTF file's nodes at a time of an animation, from the values of the animation's channels.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"

namespace nicol::scene {

/// Returns the value of an animation sampler at a time in seconds, as glTF 2.0 interpolates it (appendix C).
/// size: numbers per value; 0: as many as the sampler has. rotation: whether values are quaternions x, y, z,
/// w, whose result has unit length. Throws Error(invalid_file) beginning with the file and `where` for times
/// that do not ascend, counts that do not fit, and numbers that are not finite.
[[nodiscard]] std::vector<double> gltf_track_value(const GltfDocument& document,
                                                   const tinygltf::AnimationSampler& sampler, double time,
                                                   std::size_t size, bool rotation, const std::string& where,
                                                   const LoadBudget& budget);

/// A time of an animation, in seconds.
struct GltfMoment {
    double time = 0;
    std::string animation;  ///< name or index; empty: the first
};

/// Transforms and morph weights of a file's nodes: those of the nodes themselves, or at a moment those that
/// the channels of its animation give. Before a channel's first time its first value holds, and after its
/// last time its last value. Refers to the document.
class GltfPose {
public:
    /// Throws Error(invalid_argument) for a moment of an animation that the file lacks. Throws as
    /// read_gltf_scene does.
    GltfPose(const GltfDocument& document, const std::optional<GltfMoment>& moment, const LoadBudget& budget,
             GltfNotices& notices);

    /// Returns the transform of a node from its own axes to its parent's.
    [[nodiscard]] glm::dmat4 local(std::size_t node) const;
    /// Returns the transform of a node from its own axes to the scene's.
    [[nodiscard]] const glm::dmat4& world(std::size_t node) const { return worlds_[node]; }
    /// Returns the weights of the morph targets of a node's mesh, as many as are given. Others are 0.
    [[nodiscard]] std::vector<double> weights(std::size_t node) const;

private:
    // Values that channels give to a node, instead of its own.
    struct Animated {
        std::optional<glm::dvec3> translation, scale;
        std::optional<glm::dvec4> rotation;
        std::optional<std::vector<double>> weights;
    };

    [[nodiscard]] const tinygltf::Animation& animation_of(const GltfMoment& moment) const;
    void animate(const tinygltf::Animation& animation, double time, const std::string& where,
                 GltfNotices& notices);
    void find_worlds();

    const GltfDocument& document_;
    const LoadBudget& budget_;
    std::vector<Animated> animated_;
    std::vector<glm::dmat4> worlds_;
};

}  // namespace nicol::scene
