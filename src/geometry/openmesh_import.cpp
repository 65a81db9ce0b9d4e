// SPDX-License-Identifier: MIT
// OpenMesh's readers, delivering into a Soup.
#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <locale>
#include <mutex>
#include <sstream>

#include "error.hpp"
#include "geometry/soup.hpp"

namespace nicol::geometry {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Keeps positions, faces and normals as they come; everything else a file may hold is let go.
class SoupImporter final : public OpenMesh::IO::BaseImporter {
public:
    /// OBJ gives a normal for every corner just before the face; the others one for every vertex.
    SoupImporter(Soup& soup, bool normals_at_corners)
        : soup_(soup), normals_at_corners_(normals_at_corners) {}

    VertexHandle add_vertex(const OpenMesh::Vec3f& point) override {
        soup_.positions.emplace_back(point[0], point[1], point[2]);
        normals_.emplace_back(0.0f);
        return VertexHandle(static_cast<int>(soup_.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(OpenMesh::Vec3f(0.0f)); }
    void set_point(VertexHandle v, const OpenMesh::Vec3f& point) override {
        soup_.positions[index(v)] = {point[0], point[1], point[2]};
    }
    void set_normal(VertexHandle v, const OpenMesh::Vec3f& n) override {
        normals_[index(v)] = {n[0], n[1], n[2]};
    }
    void set_normal(VertexHandle v, const OpenMesh::Vec3d& n) override { set_normal(v, OpenMesh::Vec3f(n)); }

    FaceHandle add_face(const VHandles& vertices) override {
        for (const VertexHandle v : vertices) {
            soup_.corners.push_back({static_cast<std::uint32_t>(v.idx()), normals_[index(v)]});
            if (normals_at_corners_) normals_[index(v)] = glm::vec3(0.0f);
        }
        soup_.face_ends.push_back(soup_.corners.size());
        return FaceHandle(static_cast<int>(soup_.face_ends.size()) - 1);
    }

    std::size_t n_vertices() const override { return soup_.positions.size(); }
    std::size_t n_faces() const override { return soup_.face_ends.size(); }
    std::size_t n_edges() const override { return 0; }

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

    Soup& soup_;
    bool normals_at_corners_;
    std::vector<glm::vec3> normals_;
};

/// OpenMesh speaks to std::cerr through omerr(); while this lives it speaks into text() instead. Its own
/// connect() and disconnect() would leak.
class CapturedErrors {
public:
    CapturedErrors() : before_(stream().rdbuf(text_.rdbuf())) {}
    ~CapturedErrors() { stream().rdbuf(before_); }
    CapturedErrors(const CapturedErrors&) = delete;
    CapturedErrors& operator=(const CapturedErrors&) = delete;
    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    static std::ostream& stream() { return omerr(); }

    std::ostringstream text_;
    std::streambuf* before_;
};

}  // namespace

Soup read_soup(std::string_view name, const std::string& bytes, const std::string& suffix) {
    // The readers are singletons with state.
    static std::mutex readers;
    const std::scoped_lock lock(readers);
    CapturedErrors errors;
    OpenMesh::IO::Options options(OpenMesh::IO::Options::VertexNormal);
    if (suffix == ".stl") options += OpenMesh::IO::Options::Binary;
    Soup soup;
    SoupImporter importer(soup, suffix == ".obj");
    std::istringstream stream(bytes, std::ios::in | std::ios::binary);
    stream.imbue(std::locale::classic());
    if (!OpenMesh::IO::IOManager().read(stream, suffix, importer, options))
        throw Error(ErrorCode::internal, std::string(name) + ": OpenMesh cannot read it: " + errors.text());
    return soup;
}

}  // namespace nicol::geometry
