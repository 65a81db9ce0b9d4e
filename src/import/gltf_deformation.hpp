// SPDX-License-Identifier: MIT
// Deformation of a glTF primitive by morph targets and by the joints of a skin.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "import/gltf_accessor.hpp"
#include "import/gltf_pose.hpp"

namespace nicol::scene {

/// Deformation of the vertices of one primitive by a node: morph targets shift each vertex, which then
/// follows its joints (glTF 2.0, 3.7.2.2 and 3.7.3). Refers to the document.
class GltfDeformation {
public:
    /// Vertex in the mesh's axes, or in the scene's if the node has a skin.
    struct Vertex {
        glm::dvec3 position, normal, tangent;
    };

    /// Returns whether a node deforms a primitive.
    [[nodiscard]] static bool deforms(const tinygltf::Node& node, const tinygltf::Primitive& primitive) {
        return node.skin >= 0 || !primitive.targets.empty();
    }

    /// where: name of the primitive. Throws as read_gltf_scene does.
    GltfDeformation(const GltfDocument& document, const GltfPose& pose, std::size_t node,
                    const tinygltf::Primitive& primitive, const std::string& where);

    /// Deforms the vertex that has this index in the primitive's accessors.
    [[nodiscard]] Vertex operator()(std::size_t index, Vertex vertex) const;

private:
    struct Target {
        double weight;
        std::optional<GltfAccessor> positions, normals, tangents;
    };
    // Four joints of each vertex, as indices into joints_, and their weights.
    struct Influences {
        GltfAccessor joints, weights;
    };

    void read_targets(const GltfPose& pose, std::size_t node, const tinygltf::Primitive& primitive);
    void read_skin(const GltfPose& pose, int skin, const tinygltf::Primitive& primitive);
    [[nodiscard]] GltfAccessor attribute(int accessor, const std::string& name, std::size_t components) const;
    [[nodiscard]] glm::dmat4 motion(std::size_t index) const;

    const GltfDocument& document_;
    std::string where_;
    std::size_t vertices_ = 0;
    std::vector<Target> targets_;  // of weights other than 0
    std::vector<glm::dmat4> joints_;
    std::vector<Influences> influences_;
};

}  // namespace nicol::scene
