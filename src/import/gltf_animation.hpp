// SPDX-License-Identifier: MIT
// Animation of a glTF file.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/gltf_readers.hpp"
#include "import/scene_animation.hpp"

namespace nicol::scene {

/// Parts of a glTF scene that its nodes move, and the document that has their animation.
class GltfAnimation final : public SceneAnimation {
public:
    /// Primitive of a node.
    struct Part {
        std::size_t node;
        bool skinned;  ///< whether the transform of the node has no effect
        std::shared_ptr<const Mesh> mesh;
        GltfBounds bounds;  ///< bounds of the mesh
        const tinygltf::Primitive* primitive = nullptr;
        std::string where;                      ///< name of the primitive
        std::optional<GltfMaterial> deforming;  ///< its material, if the primitive deforms
    };

    /// animation: name or index; empty: the first.
    GltfAnimation(std::shared_ptr<const GltfDocument> document, std::string animation)
        : document_(std::move(document)), animation_(std::move(animation)) {}

    void add_part(Part part) { parts_.push_back(std::move(part)); }
    void add_light(std::size_t node) { lights_.push_back(node); }
    void set_camera(std::size_t node) { camera_ = node; }

    [[nodiscard]] Moment at(double time, const LoadBudget& budget) const override;

private:
    std::shared_ptr<const GltfDocument> document_;
    std::string animation_;
    std::vector<Part> parts_;
    std::vector<std::size_t> lights_;
    std::optional<std::size_t> camera_;
};

}  // namespace nicol::scene
