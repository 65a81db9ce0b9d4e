// SPDX-License-Identifier: MIT
// OpenMesh's readers.
#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <locale>
#include <mutex>
#include <sstream>

#include "error.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Keeps positions, faces and normals; ignores everything else.
class PolygonImporter final : public OpenMesh::IO::BaseImporter {
public:
    /// OBJ sets a normal for every corner just before the face; the other formats one for every vertex.
    PolygonImporter(PolygonMesh& polygons, bool normals_at_corners)
        : polygons_(polygons), normals_at_corners_(normals_at_corners) {}

    VertexHandle add_vertex(const OpenMesh::Vec3f& point) override {
        polygons_.positions.emplace_back(point[0], point[1], point[2]);
        normals_.emplace_back(0.0f);
        return VertexHandle(static_cast<int>(polygons_.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(OpenMesh::Vec3f(0.0f)); }
    void set_point(VertexHandle v, const OpenMesh::Vec3f& point) override {
        polygons_.positions[index(v)] = {point[0], point[1], point[2]};
    }
    void set_normal(VertexHandle v, const OpenMesh::Vec3f& n) override {
        normals_[index(v)] = {n[0], n[1], n[2]};
    }
    void set_normal(VertexHandle v, const OpenMesh::Vec3d& n) override { set_normal(v, OpenMesh::Vec3f(n)); }

    FaceHandle add_face(const VHandles& vertices) override {
        for (const VertexHandle v : vertices) {
            polygons_.corners.push_back({static_cast<std::uint32_t>(v.idx()), normals_[index(v)]});
            if (normals_at_corners_) normals_[index(v)] = glm::vec3(0.0f);
        }
        polygons_.face_ends.push_back(polygons_.corners.size());
        return FaceHandle(static_cast<int>(polygons_.face_ends.size()) - 1);
    }

    [[nodiscard]] std::size_t n_vertices() const override { return polygons_.positions.size(); }
    [[nodiscard]] std::size_t n_faces() const override { return polygons_.face_ends.size(); }
    [[nodiscard]] std::size_t n_edges() const override { return 0; }

    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec2f>&) override {}
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_color(VertexHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec3f&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec4f&) override {}
    void set_texcoord(VertexHandle, const OpenMesh::Vec2f&) override {}
    void set_status(VertexHandle, const OpenMesh::Attributes::StatusInfo&) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const OpenMesh::Vec2f&) override {}
    void set_texcoord(VertexHandle, const OpenMesh::Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const OpenMesh::Vec3f&) override {}
    void set_status(HalfedgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
    void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3f&) override {}
    void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override {}
    void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
    void set_normal(FaceHandle, const OpenMesh::Vec3f&) override {}
    void set_normal(FaceHandle, const OpenMesh::Vec3d&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec3f&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec4f&) override {}
    void set_status(FaceHandle, const OpenMesh::Attributes::StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}

private:
    static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

    PolygonMesh& polygons_;
    bool normals_at_corners_;
    std::vector<glm::vec3> normals_;
};

/// Redirects OpenMesh's omerr() from std::cerr to text() during its lifetime. omerr()'s own connect() and
/// disconnect() leak.
class ErrorCapture {
public:
    ErrorCapture() : before_(stream().rdbuf(text_.rdbuf())) {}
    ~ErrorCapture() { stream().rdbuf(before_); }
    ErrorCapture(const ErrorCapture&) = delete;
    ErrorCapture& operator=(const ErrorCapture&) = delete;
    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    static std::ostream& stream() { return omerr(); }

    std::ostringstream text_;
    std::streambuf* before_;
};

}  // namespace

PolygonMesh read_polygons(std::string_view name, const ParsedFile& file) {
    // OpenMesh's readers are singletons with state.
    static std::mutex readers;
    const std::scoped_lock lock(readers);
    ErrorCapture errors;
    OpenMesh::IO::Options options(OpenMesh::IO::Options::VertexNormal);
    if (file.suffix == ".stl") options += OpenMesh::IO::Options::Binary;
    PolygonMesh polygons;
    PolygonImporter importer(polygons, file.suffix == ".obj");
    std::istringstream stream(file.bytes, std::ios::in | std::ios::binary);
    stream.imbue(std::locale::classic());
    if (!OpenMesh::IO::IOManager().read(stream, file.suffix, importer, options))
        throw Error(ErrorCode::internal, std::string(name) + ": OpenMesh cannot read it: " + errors.text());
    return polygons;
}

}  // namespace nicol::geometry
