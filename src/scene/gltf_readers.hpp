// SPDX-License-Identifier: MIT
// One reader for each kind of object in a glTF file.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "geometry/left_out.hpp"
#include "geometry/mesh.hpp"
#include "scene/gltf_document.hpp"
#include "scene/scene_description.hpp"

namespace nicol::scene {

/// What is read and not followed, a sentence for each kind.
class GltfNotices {
public:
    explicit GltfNotices(const std::filesystem::path& file) : name_(file.string()) {}
    /// Keeps a sentence, once.
    void add(const std::string& sentence);
    [[nodiscard]] std::vector<std::string> take() { return std::move(sentences_); }

private:
    std::string name_;
    std::vector<std::string> sentences_;
};

/// The extent of shapes in the world.
struct GltfBounds {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
};

// Each throws as read_gltf_scene does.

/// The triangles of a primitive, `where` in the file, with its colours and texture coordinates; null where
/// none has an area. `left_out` counts what is not drawn.
[[nodiscard]] std::shared_ptr<const Mesh> read_gltf_primitive(const GltfDocument& document,
                                                              const tinygltf::Primitive& primitive,
                                                              const std::string& where, LoadBudget& budget,
                                                              geometry::LeftOut& left_out);

/// The material of this index; that of primitives without one for -1.
[[nodiscard]] MaterialDescription read_gltf_material(const GltfDocument& document, int index,
                                                     GltfNotices& notices);

/// The camera of a node that `to_world` places, its scale without effect.
[[nodiscard]] SensorDescription read_gltf_camera(const GltfDocument& document, const tinygltf::Node& node,
                                                 const std::string& where, const glm::dmat4& to_world,
                                                 const GltfBounds& bounds);
/// One that looks along -z at all of the scene, its field of view 45 degrees high.
[[nodiscard]] SensorDescription gltf_camera_in_front(const GltfBounds& bounds);

}  // namespace nicol::scene
