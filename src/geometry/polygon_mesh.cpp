// SPDX-License-Identifier: MIT
#include "geometry/polygon_mesh.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "error.hpp"
#include "geometry/ear_clipping.hpp"
#include "geometry/finite.hpp"
#include "geometry/mesh_normals.hpp"
#include "geometry/position_hash.hpp"

namespace nicol::geometry {
namespace {

// Further vertices at the position of a first one, by their normals.
class Splits {
public:
    // Returns the vertex at the position of `first` with this normal; records and returns `fresh` if there is
    // none.
    std::uint32_t of(std::uint32_t first, const glm::vec3& normal, std::uint32_t fresh) {
        return known_.try_emplace(Key{first, normal}, fresh).first->second;
    }

private:
    struct Key {
        std::uint32_t first;
        glm::vec3 normal;
        bool operator==(const Key& o) const { return first == o.first && normal == o.normal; }
    };
    struct Hash {
        std::size_t operator()(const Key& key) const { return hash_of(key.normal) * 31 + key.first; }
    };
    std::unordered_map<Key, std::uint32_t, Hash> known_;
};

glm::vec3 finite_color(const glm::vec3& color) {
    return is_finite(color) ? color : glm::vec3(1);
}

class Triangulation {
public:
    Triangulation(const PolygonMesh& polygons, const LoadBudget& budget)
        : polygons_(polygons), budget_(budget), first_of_(polygons.positions.size(), PolygonMesh::kNone) {
        for (const PolygonMesh::Corner& corner : polygons.corners) first_of_[corner.position] = 0;
        for (std::uint32_t p = 0; p < first_of_.size(); ++p)
            if (first_of_[p] != PolygonMesh::kNone) first_of_[p] = add(p, glm::vec3(0));
        taken_.resize(mesh.positions.size(), false);
        unused = polygons.positions.size() - mesh.positions.size();
    }

    void run() {
        mesh.texcoords = polygons_.texcoords;
        for (glm::vec2& uv : mesh.texcoords)
            if (!is_finite(uv)) uv = glm::vec2(0);
        if (!mesh.texcoords.empty()) mesh.texcoords.emplace_back(0);  // for corners without texcoord
        std::vector<glm::dvec3> points;
        std::vector<glm::uvec3> triangles;
        std::vector<std::uint32_t> vertices;
        for (std::size_t f = 0, begin = 0; f < polygons_.face_ends.size(); begin = polygons_.face_ends[f++]) {
            const std::span face =
                std::span(polygons_.corners).subspan(begin, polygons_.face_ends[f] - begin);
            points.clear();
            triangles.clear();
            vertices.clear();
            budget_.step(8 * face.size());
            for (const PolygonMesh::Corner& corner : face) {
                points.emplace_back(polygons_.positions[corner.position]);
                vertices.push_back(vertex_of(corner));
            }
            clip_ears(points, budget_, triangles);
            for (const glm::uvec3& t : triangles) {
                mesh.triangles.emplace_back(vertices[t.x], vertices[t.y], vertices[t.z]);
                if (!polygons_.face_colors.empty())
                    mesh.face_colors.push_back(finite_color(polygons_.face_colors[f]));
                if (mesh.texcoords.empty()) continue;
                mesh.texcoord_triangles.emplace_back(texcoord_of(face[t.x]), texcoord_of(face[t.y]),
                                                     texcoord_of(face[t.z]));
            }
        }
    }

    Mesh mesh;
    std::size_t unused = 0;  // number of positions that no face uses

private:
    std::uint32_t vertex_of(const PolygonMesh::Corner& corner) {
        const glm::vec3 normal =
            corner.normal == PolygonMesh::kNone ? glm::vec3(0) : polygons_.normals[corner.normal];
        const std::uint32_t first = first_of_[corner.position];
        if (!taken_[first]) {
            taken_[first] = true;
            mesh.normals[first] = normal;
        }
        if (mesh.normals[first] == normal) return first;
        const auto fresh = static_cast<std::uint32_t>(mesh.positions.size());
        const std::uint32_t v = split_.of(first, normal, fresh);
        return v == fresh ? add(corner.position, normal) : v;
    }

    [[nodiscard]] std::uint32_t texcoord_of(const PolygonMesh::Corner& corner) const {
        return std::min(corner.texcoord, static_cast<std::uint32_t>(mesh.texcoords.size() - 1));
    }

    std::uint32_t add(std::uint32_t position, const glm::vec3& normal) {
        mesh.positions.push_back(polygons_.positions[position]);
        mesh.normals.push_back(normal);
        if (!polygons_.colors.empty()) mesh.colors.push_back(finite_color(polygons_.colors[position]));
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }

    const PolygonMesh& polygons_;
    const LoadBudget& budget_;
    std::vector<std::uint32_t> first_of_;  // by position, its first vertex
    std::vector<bool> taken_;              // by first vertex, whether it has the normal of a corner
    Splits split_;
};

}  // namespace

Mesh triangulated(const PolygonMesh& polygons, std::string_view name, LeftOut& left_out,
                  const LoadBudget& budget) {
    Triangulation made(polygons, budget);
    made.run();
    budget.check();
    Mesh mesh = std::move(made.mesh);
    left_out.add("vertices of no face", made.unused);
    left_out.add("triangles without area", remove_flat_triangles(mesh));
    if (mesh.triangles.empty()) {
        throw Error(ErrorCode::invalid_file, std::string(name) + ": none of its " +
                                                 std::to_string(polygons.face_ends.size()) +
                                                 " faces has an area; a mesh needs one that has");
    }
    budget.check();
    complete_normals(mesh);
    budget.check();
    return mesh;
}

}  // namespace nicol::geometry
