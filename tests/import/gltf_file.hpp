// SPDX-License-Identifier: MIT
// glTF files for tests.
#pragma once

#include "import/load_scene.hpp"
#include "import/scene_description.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

enum ComponentType { gltf_byte = 5120, gltf_ubyte, gltf_short, gltf_ushort, gltf_uint = 5125, gltf_float };

/// One buffer, and its views and accessors.
class GltfBuffer {
public:
    std::string bytes;

    /// Adds a bufferView of these numbers and returns its index.
    template <class Number>
    int view(const std::vector<Number>& numbers, int stride = 0) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        const std::size_t offset = bytes.size(), size = numbers.size() * sizeof(Number);
        bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
        views_ += (views_.empty() ? "" : ",") + std::string("{\"buffer\":0,\"byteOffset\":") +
                  std::to_string(offset) + ",\"byteLength\":" + std::to_string(size) +
                  (stride == 0 ? "" : ",\"byteStride\":" + std::to_string(stride)) + "}";
        return view_count_++;
    }
    /// Adds an accessor and returns its index. `more` is its other members, such as `,"bufferView":0`.
    int accessor(const std::string& shape, int type, std::size_t count, const std::string& more) {
        accessors_ += (accessors_.empty() ? "" : ",") + std::string("{\"type\":\"") + shape +
                      "\",\"componentType\":" + std::to_string(type) + ",\"count\":" + std::to_string(count) +
                      more + "}";
        return accessor_count_++;
    }
    int vectors(const std::vector<glm::vec3>& values) {
        return accessor("VEC3", gltf_float, values.size(), of(view(values)));
    }
    int indices(const std::vector<std::uint16_t>& values) {
        return accessor("SCALAR", gltf_ushort, values.size(), of(view(values)));
    }
    static std::string of(int view) { return ",\"bufferView\":" + std::to_string(view); }

    /// Returns the JSON of a file with this buffer. `rest` is its other members. An empty uri stands for the
    /// buffer of a GLB file.
    [[nodiscard]] std::string json(const std::string& rest, const std::string& uri = "a.bin") const {
        return "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{" +
               (uri.empty() ? "" : "\"uri\":\"" + uri + "\",") +
               "\"byteLength\":" + std::to_string(bytes.size()) + "}],\"bufferViews\":[" + views_ +
               "],\"accessors\":[" + accessors_ + "]," + rest + "}";
    }

private:
    std::string views_, accessors_;
    int view_count_ = 0, accessor_count_ = 0;
};

/// A file a.gltf with its buffer a.bin in the same folder.
class GltfFile : public TemporaryFolder {
public:
    GltfFile(const GltfBuffer& buffer, const std::string& rest) {
        write("a.gltf", buffer.json(rest));
        write("a.bin", buffer.bytes);
    }
    [[nodiscard]] std::filesystem::path scene() const { return *this / "a.gltf"; }
};

inline const std::vector<glm::vec3> a_gltf_triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

inline GltfBuffer triangle_buffer() {
    GltfBuffer buffer;
    buffer.vectors(a_gltf_triangle);
    return buffer;
}
inline std::string one_mesh(const std::string& more = "") {
    return "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}" + more + "}]}]";
}
/// Reads a file whose mesh 0 is a_gltf_triangle, with these nodes.
inline nicol::SceneDescription read_nodes(const std::string& nodes, const std::string& more = "") {
    return nicol::read_gltf_scene(
        GltfFile(triangle_buffer(), one_mesh() + ",\"nodes\":[" + nodes + "]" + more).scene());
}
/// Returns the only mesh of a file whose first mesh has this primitive.
inline std::shared_ptr<const nicol::Mesh> read_primitive(const GltfBuffer& buffer,
                                                         const std::string& primitive) {
    const GltfFile file(buffer, "\"meshes\":[{\"primitives\":[" + primitive + "]}],\"nodes\":[{\"mesh\":0}]");
    return nicol::read_gltf_scene(file.scene()).shapes.at(0).mesh;
}
/// Returns the corners of all triangles, in order.
inline std::vector<glm::vec3> corners(const nicol::Mesh& mesh) {
    std::vector<glm::vec3> out;
    for (const glm::uvec3& t : mesh.triangles)
        for (glm::length_t i = 0; i < 3; ++i) out.push_back(mesh.positions[t[i]]);
    return out;
}
inline bool has_notice(const nicol::SceneDescription& scene, const std::string& part) {
    return std::ranges::any_of(scene.notices,
                               [&](const std::string& n) { return n.find(part) != std::string::npos; });
}
