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

/// Box around shapes in the world.
struct GltfBounds {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
    bool empty = true;

    /// Extends the box by a box in other axes.
    void add(const GltfBounds& box, const glm::dmat4& to_world);
};
[[nodiscard]] GltfBounds bounds_of(const Mesh& mesh);

/// Returns whether a matrix is invertible, which a mesh's transform must be.
[[nodiscard]] bool is_gltf_placement(const glm::dmat4& m);

/// Returns the name of a node in the file.
[[nodiscard]] inline std::string node_name(std::size_t node) {
    return "nodes[" + std::to_string(node) + "]";
}

// All functions below throw what read_gltf_scene throws.

/// The properties of a primitive on which its material depends.
struct GltfSurface {
    int material = -1;    ///< its own material, else the first variant's; -1: none, which is white metal
    bool colors = false;  ///< it has COLOR_0
    std::vector<int> texcoord_sets;  ///< n of each TEXCOORD_n that it has

    /// where: name of the primitive in the file.
    GltfSurface(const GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& where);
    bool operator<(const GltfSurface& other) const {
        return std::tie(material, colors, texcoord_sets) <
               std::tie(other.material, other.colors, other.texcoord_sets);
    }
};

/// Material of the primitives of a GltfSurface, and the texture coordinates that its textures use.
struct GltfMaterial {
    MaterialDescription description;
    int texcoord_set = 0;
    std::optional<EmissionDescription> emission;  ///< emission of an unlit surface; none: it reflects light
};
[[nodiscard]] GltfMaterial read_gltf_material(const GltfDocument& document, const GltfSurface& surface,
                                              GltfTextures& textures, GltfNotices& notices);

/// Returns the triangles of a primitive with its colours and the texture coordinates that its material uses,
/// if the primitive has them; null if no triangle has an area. An unlit primitive is flat. where: name of the
/// primitive in the file. deformation: deformation of the primitive's vertices; null: none. left_out:
/// receives the counts of ignored elements.
[[nodiscard]] std::shared_ptr<const Mesh> read_gltf_primitive(
    const GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& where,
    const GltfMaterial& material, const GltfDeformation* deformation, const LoadBudget& budget,
    geometry::LeftOut& left_out);

/// Returns the light that a node has by KHR_lights_punctual; nothing if the node has none. The scale of
/// `to_world` has no effect.
[[nodiscard]] std::optional<LightDescription> read_gltf_light(const GltfDocument& document,
                                                              const tinygltf::Node& node,
                                                              const std::string& where,
                                                              const glm::dmat4& to_world,
                                                              GltfNotices& notices);

/// Returns the transform of a camera or a light that looks along +z, from that of a glTF object that looks
/// along -z; +y is up for both. Throws an error that names the `thing` if axes have no length or are
/// parallel.
[[nodiscard]] glm::dmat4 gltf_view(const GltfDocument& document, const std::string& where, const char* thing,
                                   const glm::dmat4& to_world);

/// Returns the camera of a node. The scale of `to_world` has no effect.
[[nodiscard]] SensorDescription read_gltf_camera(const GltfDocument& document, const tinygltf::Node& node,
                                                 const std::string& where, const glm::dmat4& to_world,
                                                 const GltfBounds& bounds);
/// Returns a camera that looks along -z at the whole scene. Its field of view is 45 degrees high.
[[nodiscard]] SensorDescription gltf_camera_in_front(const GltfBounds& bounds);

}  // namespace nicol::scene
