// SPDX-License-Identifier: MIT
// Writes the PLY that OpenMesh reads without trouble.
#include "geometry/vet.hpp"

namespace nicol::geometry {

Vetted PlainPly::finished() const {
    Vetted out;
    out.suffix = ".ply";
    out.vertices = vertices_.size() / (sizeof(float) * (normals_ ? 6 : 3));
    out.faces = faces_count_;
    out.bytes = std::string("ply\nformat ") +
                (std::endian::native == std::endian::big ? "binary_big_endian" : "binary_little_endian") +
                " 1.0\nelement vertex " + std::to_string(out.vertices) +
                "\nproperty float x\nproperty float y\nproperty float z\n" +
                (normals_ ? "property float nx\nproperty float ny\nproperty float nz\n" : "") +
                "element face " + std::to_string(out.faces) +
                "\nproperty list int int vertex_indices\nend_header\n";
    out.bytes.append(vertices_).append(faces_);
    return out;
}

}  // namespace nicol::geometry
