// SPDX-License-Identifier: MIT
// Places of a glTF file's nodes at a time of an animation.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"

namespace nicol::scene {

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
