// SPDX-License-Identifier: MIT
// One reader for each kind of object in a glTF file.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "files/load_budget.hpp"
#include "geometry/left_out.hpp"
#include "geometry/mesh.hpp"
#include "import/gltf_deformation.hpp"
#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"
#include "import/gltf_textures.hpp"
#include "import/scene_description.hpp"

namespace nicol::scene {

/// The extent of shapes in the world.
struct GltfBounds {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
    bool empty = true;

    /// Adds a box of other axes.
    void add(const GltfBounds& box, const glm::dmat4& to_world);
};
[[nodiscard]] GltfBounds bounds_of(const Mesh& mesh);

/// Returns whether a matrix is invertible, which a mesh's transform must be.
[[nodiscard]] bool is_gltf_placement(const glm::dmat4& m);

/// Returns the name of a node in the file.
[[nodiscard]] inline std::string node_name(std::size_t node) {
    return "nodes[" + std::to_string(node) + "]";
}

// Each throws as read_gltf_scene does.

/// The properties of a primitive on which its material depends.
struct GltfSurface {
    int material = -1;    ///< its own, else that of the first variant; -1: none, which is white metal
    bool colors = false;  ///< it has COLOR_0
    std::vector<int> texcoord_sets;  ///< n of each TEXCOORD_n that it has

    /// `where`: the primitive in the file.
    GltfSurface(const GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& where);
    bool operator<(const GltfSurface& other) const {
        return std::tie(material, colors, texcoord_sets) <
               std::tie(other.material, other.colors, other.texcoord_sets);
    }
};

/// The material of such primitives, and the texture coordinates that its textures take.
struct GltfMaterial {
    MaterialDescription description;
    int texcoord_set = 0;
    std::optional<EmissionDescription> emission;  ///< of an unlit surface; none: it reflects light
};
[[nodiscard]] GltfMaterial read_gltf_material(const GltfDocument& document, const GltfSurface& surface,
                                              GltfTextures& textures, GltfNotices& notices);

/// The triangles of a primitive, `where` in the file, with its colours and the texture coordinates that its
/// material takes, if it has them; null where none has an area. An unlit one is flat. `left_out` counts what
/// is not drawn. deformation: of its vertices; null: none.
[[nodiscard]] std::shared_ptr<const Mesh> read_gltf_primitive(
    const GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& where,
    const GltfMaterial& material, const GltfDeformation* deformation, const LoadBudget& budget,
    geometry::LeftOut& left_out);

/// The light that a node has by KHR_lights_punctual, which `to_world` places, its scale without effect; none
/// if it has none.
[[nodiscard]] std::optional<LightDescription> read_gltf_light(const GltfDocument& document,
                                                              const tinygltf::Node& node,
                                                              const std::string& where,
                                                              const glm::dmat4& to_world,
                                                              GltfNotices& notices);

/// How a thing of glTF that looks along its -z with +y up is placed as one of ours, which looks along +z.
/// Throws, naming the `thing`, where axes have no length or are parallel.
[[nodiscard]] glm::dmat4 gltf_view(const GltfDocument& document, const std::string& where, const char* thing,
                                   const glm::dmat4& to_world);

/// The camera of a node that `to_world` places, its scale without effect.
[[nodiscard]] SensorDescription read_gltf_camera(const GltfDocument& document, const tinygltf::Node& node,
                                                 const std::string& where, const glm::dmat4& to_world,
                                                 const GltfBounds& bounds);
/// One that looks along -z at all of the scene, its field of view 45 degrees high.
[[nodiscard]] SensorDescription gltf_camera_in_front(const GltfBounds& bounds);

}  // namespace nicol::scene
