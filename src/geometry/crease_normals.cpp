// SPDX-License-Identifier: MIT
#include "geometry/crease_normals.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <mutex>
#include <numbers>
#include <sstream>
#include <vector>

namespace nicol::geometry {
namespace {

// Largest number of triangles at one vertex of the topology. Further triangles go to a copy of the vertex
// because OpenMesh visits all triangles at a vertex for each new one.
constexpr std::uint32_t kMostTrianglesAtVertex = 512;

// Connectivity only. Positions and normals stay in PolygonMesh.
struct Traits : OpenMesh::DefaultTraits {
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
};
using Topology = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Keeps OpenMesh, which reports faces that it rejects, from writing to std::cerr. The lock is needed because
/// all of OpenMesh shares one stream.
class QuietOpenMesh {
public:
    QuietOpenMesh() : lock_(mutex()), before_(stream().rdbuf(text_.rdbuf())) {}
    ~QuietOpenMesh() { stream().rdbuf(before_); }
    QuietOpenMesh(const QuietOpenMesh&) = delete;
    QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    static std::ostream& stream() { return omerr(); }

    std::scoped_lock<std::mutex> lock_;
    std::ostringstream text_;
    std::streambuf* before_;
};

class CreaseNormals {
public:
    CreaseNormals(PolygonMesh& triangles, double degrees, const LoadBudget& budget)
        : triangles_(triangles),
          least_cosine_(std::cos(degrees * std::numbers::pi / 180.0)),
          budget_(budget) {}

    void run() {
        const std::size_t faces = triangles_.corners.size() / 3;
        topology_.reserve(triangles_.positions.size(), 3 * faces / 2, faces);
        newest_.resize(triangles_.positions.size());
        count_.resize(triangles_.positions.size());
        for (std::uint32_t p = 0; p < triangles_.positions.size(); ++p) newest_[p] = add_vertex(p);
        for (std::size_t f = 0; f < faces; ++f) add_face(f);
        for (const FaceHandle face : topology_.faces())
            for (const HalfedgeHandle corner : topology_.fh_range(face))
                if (triangles_.corners[index_of(corner)].normal == PolygonMesh::kNone) smooth(corner);
    }

private:
    VertexHandle add_vertex(std::uint32_t position) {
        positions_.push_back(position);
        return topology_.add_vertex({});
    }

    // Returns the vertex at a position that the next triangle there shares.
    VertexHandle vertex_at(std::uint32_t position) {
        if (count_[position]++ % kMostTrianglesAtVertex == kMostTrianglesAtVertex - 1)
            newest_[position] = add_vertex(position);
        return newest_[position];
    }

    // Adds face f; its number in the topology equals its number in triangles_. The face gets vertices of its
    // own if the topology rejects it as non-manifold.
    void add_face(std::size_t f) {
        std::array<VertexHandle, 3> v;
        std::array<glm::dvec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t position = triangles_.corners[3 * f + k].position;
            v[k] = vertex_at(position);
            p[k] = glm::dvec3(triangles_.positions[position]);
        }
        budget_.step(64);
        const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double length = glm::length(area);
        normals_.push_back(length > 0 ? area / length : glm::dvec3(0));
        if (topology_.add_face(v[0], v[1], v[2]).is_valid()) return;
        for (std::size_t k = 0; k < 3; ++k) v[k] = add_vertex(triangles_.corners[3 * f + k].position);
        topology_.add_face(v[0], v[1], v[2]);
    }

    // Returns the index of the corner that a halfedge starts at.
    [[nodiscard]] std::size_t index_of(HalfedgeHandle corner) const {
        const auto face = static_cast<std::size_t>(topology_.face_handle(corner).idx());
        const auto vertex = static_cast<std::size_t>(topology_.from_vertex_handle(corner).idx());
        std::size_t i = 3 * face;
        while (triangles_.corners[i].position != positions_[vertex]) ++i;
        return i;
    }

    [[nodiscard]] const glm::dvec3& normal_of(HalfedgeHandle corner) const {
        return normals_[static_cast<std::size_t>(topology_.face_handle(corner).idx())];
    }

    // Returns whether the surface is smooth between two corners of one vertex.
    [[nodiscard]] bool smooth_between(HalfedgeHandle a, HalfedgeHandle b) const {
        return !topology_.is_boundary(a) && !topology_.is_boundary(b) &&
               glm::dot(normal_of(a), normal_of(b)) >= least_cosine_;
    }

    [[nodiscard]] double angle_at(HalfedgeHandle corner) const {
        const std::size_t i = index_of(corner);
        const std::size_t first = i / 3 * 3;
        const auto at = [&](std::size_t k) {
            return glm::dvec3(triangles_.positions[triangles_.corners[first + k % 3].position]);
        };
        const glm::dvec3 u = at(i - first + 1) - at(i - first);
        const glm::dvec3 v = at(i - first + 2) - at(i - first);
        return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
    }

    // Gives one normal to all corners about a vertex from one hard edge to the next.
    void smooth(HalfedgeHandle corner) {
        HalfedgeHandle first = corner;
        for (HalfedgeHandle before = topology_.cw_rotated_halfedge_handle(first);
             before != corner && smooth_between(before, first);
             before = topology_.cw_rotated_halfedge_handle(first))
            first = before;
        const auto normal = static_cast<std::uint32_t>(triangles_.normals.size());
        glm::dvec3 sum(0);
        for (HalfedgeHandle at = first;;) {
            sum += normal_of(at) * angle_at(at);
            triangles_.corners[index_of(at)].normal = normal;
            budget_.step(16);
            const HalfedgeHandle next = topology_.ccw_rotated_halfedge_handle(at);
            if (next == first || !smooth_between(at, next)) break;
            at = next;
        }
        const double length = glm::length(sum);
        triangles_.normals.emplace_back(length > 0 ? sum / length : glm::dvec3(0));
    }

    PolygonMesh& triangles_;
    double least_cosine_;
    const LoadBudget& budget_;
    Topology topology_;
    std::vector<std::uint32_t> positions_;  // by vertex of the topology
    std::vector<VertexHandle> newest_;      // by position, the vertex that was added last
    std::vector<std::uint32_t> count_;      // by position, its number of triangles so far
    std::vector<glm::dvec3> normals_;       // by face, its unit normal or 0
};

}  // namespace

void add_crease_normals(PolygonMesh& triangles, double degrees, const LoadBudget& budget) {
    const QuietOpenMesh quiet;
    CreaseNormals(triangles, degrees, budget).run();
}

}  // namespace nicol::geometry
