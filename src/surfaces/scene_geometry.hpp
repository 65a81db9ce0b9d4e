// SPDX-License-Identifier: MIT
// A scene's surfaces, and the parts of them that a change keeps.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/graded_mesh.hpp"
#include "material/spatial_variation.hpp"
#include "scene/scene.hpp"
#include "surfaces/equal_materials.hpp"
#include "surfaces/geometry.hpp"
#include "versioned.hpp"
#include "visibility/bake.hpp"

namespace nicol {

/// Surfaces in axes that move with the scene's largest instance, the instance with the most vertices, unless
/// instances with more vertices stay where they are in the world. In these axes a scene that is rotated and
/// shifted as a whole does not change, so all results computed for it stay valid: light and camera move
/// instead. When the largest instance moves without the axes, own_axes() are no longer those of a fresh
/// start, and images differ as by another choice of the bake's directions. When an instance becomes the
/// largest or changes its shape, the axes are parallel to the world's and begin in the instance's
/// middle_of(), so that single precision serves scenes far from the world's origin.
class SceneGeometry {
public:
    /// Takes over the scene's changes. Throws Error(invalid_argument) if there are more than 2^32 vertices;
    /// the next call then starts from nothing.
    void update(const Scene& scene);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return *geometry_; }
    /// Returns the geometry. A change of materials changes the ranges and corners of this object in place; a
    /// change of vertices or triangles makes a new object.
    [[nodiscard]] std::shared_ptr<const WorldGeometry> shared_geometry() const noexcept { return geometry_; }
    /// Returns the version of vertices and triangles.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Returns the version of the ranges, their materials and emission, and the corners' texture coordinates
    /// and colours.
    [[nodiscard]] Version material_version() const noexcept { return material_version_; }

    /// Returns the rigid motion (a rotation and a shift) from geometry()'s axes to the world's.
    [[nodiscard]] const glm::dmat4& to_world() const noexcept { return to_world_; }
    /// Returns the axes of the largest instance, which rotate with its transform and its vertices, and with
    /// its motions that geometry()'s axes follow. The axes stay while its mesh deforms.
    [[nodiscard]] const glm::dmat3& own_axes() const noexcept { return own_axes_; }

    /// Triangles of an instance that block light, and their vertices; the front side of a two-sided instance.
    struct Blocker {
        /// Version of geometry() in which the instance was placed where it is.
        Version placed;
        /// Blockers of equal `placed` and `batch` have some thousand triangles together, unless one has more.
        std::uint32_t batch;
        std::size_t first, last;  ///< vertices first .. last - 1
        std::size_t first_triangle, triangles;
        bool two_sided;  ///< the back has as many triangles, which follow those of the front
    };
    /// Returns the blockers, in the order of their vertices. An instance that has not moved since an earlier
    /// version has the same `placed` and `batch`, and the same triangles and positions, as then.
    [[nodiscard]] const std::vector<Blocker>& blockers() const noexcept { return blockers_; }

    /// Bounds of instances.
    struct Bounds {
        std::vector<Ball> balls;
        std::vector<Box> boxes;
    };
    /// Vertices of an instance that has moved or has another mesh of the same triangles.
    struct MovedRun {
        VertexRun vertices;
        glm::dmat3 rotation;  ///< rotation in its motion
        bool deformed;        ///< whether the mesh is another one, so that normals have turned one by one
        /// Bounds of all other instances that block light, if the instance was only shifted: where they are,
        /// and where they were, shifted with the instance. Empty if that would be too many.
        std::optional<std::array<Bounds, 2>> others;
        glm::dvec3 shift{0};  ///< of such an instance
    };

    /// Change from the previous version to the current one.
    struct Change {
        Version before = 0;           ///< previous version; 0: none
        std::vector<VertexRun> kept;  ///< vertices of instances that have not moved
        std::vector<Ball> added;      ///< balls that contain all other triangles of the current version
        std::vector<Ball> removed;    ///< balls that contain all other triangles of the previous version
        std::vector<MovedRun> moved;  ///< vertices of instances that have moved and not changed otherwise
        std::vector<VertexRun> triangles;  ///< triangles of kept and moved vertices
    };
    [[nodiscard]] const Change& change() const noexcept { return change_; }

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    // Number of each vertex of a mesh among the vertices of an instance's side, see block_numbers().
    using VertexOrder = std::shared_ptr<const std::vector<std::uint32_t>>;

    // Instance in geometry_.
    struct Piece {
        std::uint32_t id;
        bool twosided;
        std::string glass;  // content key of the boundary that light passes, and shadow rays do; else empty
        InstanceRoles roles;
        bool divided;  // whether triangles of in_place are parts of those of `mesh`
        std::shared_ptr<const Mesh> mesh;
        AlphaMask mask;        // shadows depend on it
        glm::dmat4 placement;  // in geometry()'s axes
        MeshExtent extent;
        std::vector<Ball> details;             // objects for which large triangles are divided
        std::shared_ptr<const Mesh> in_place;  // mesh in these axes; build() keeps it if it is divided
        VertexOrder order;                     // that of parts(), or of the mesh before it was deformed
        std::size_t first;                     // index of the first vertex
        std::size_t last;
        std::size_t former;              // index among the former pieces if it has not moved, or kNone
        std::size_t elsewhere = kNone;   // index among the former pieces if it has moved, or kNone
        std::size_t first_triangle = 0;  // index of the first triangle
        Version placed = 0;              // see Blocker
        std::uint32_t batch = 0;
        bool deformed = false;  // whether `order` may be that of another shape

        // Returns the mesh whose vertices and triangles are drawn, and whether the placement mirrors it.
        [[nodiscard]] const Mesh& parts() const { return divided ? *in_place : *mesh; }
        [[nodiscard]] bool blocks() const { return glass.empty() && roles.casts_shadows; }
        [[nodiscard]] std::size_t triangles() const { return (twosided ? 2 : 1) * parts().triangles.size(); }
        [[nodiscard]] bool mirrored() const {
            return !divided && glm::determinant(glm::dmat3(placement)) < 0;
        }
    };
    [[nodiscard]] std::vector<Piece> place(const Scene& scene);
    // Divides triangles that are far larger than an object beside them.
    void divide(std::vector<Piece>& pieces) const;
    // Sets the pieces' orders. A mesh that deforms keeps the order of its first shape, so that its vertices
    // can be followed; bounced light then has other noise than after a fresh start.
    void order_vertices(std::vector<Piece>& pieces) const;
    void find_axes(const Scene& scene, std::size_t largest);
    // Returns whether no fewer vertices stay in place with these axes than with the present ones.
    [[nodiscard]] bool keeps_most(const Scene& scene, const glm::dmat4& to_world) const;
    // Returns whether an instance has not moved, in axes that `to_world` takes to the world's.
    [[nodiscard]] static bool stays(const Piece& former, const glm::dmat4& placement,
                                    const glm::dmat4& to_world);
    void build(const Scene& scene, std::vector<Piece>& pieces);
    void find_blockers();
    // Adds the moved instances to a change, and the triangles of kept and moved ones.
    void follow_pieces(const std::vector<Piece>& pieces, Change& change) const;
    // Returns the bounds of all pieces but one that block light, shifted.
    [[nodiscard]] static Bounds others(const std::vector<Piece>& pieces, const Piece& piece,
                                       const glm::dvec3& shift);
    void set_materials(const Scene& scene);
    void set_corners();

    std::shared_ptr<WorldGeometry> geometry_ = std::make_shared<WorldGeometry>();
    std::vector<Piece> pieces_;
    EqualMaterials equal_materials_;
    glm::dmat4 to_world_{1.0};
    glm::dmat3 own_axes_{1.0};
    glm::dmat3 mesh_axes_{1.0};  // axes of largest_mesh_, without its placement
    // Mesh of the largest instance when the axes were found. It may have been deformed since.
    std::shared_ptr<const Mesh> largest_mesh_;
    std::uint32_t largest_ = 0;          // id of the largest instance
    glm::dmat4 largest_placement_{1.0};  // in geometry()'s axes
    Version version_ = 0;
    Version material_version_ = 0;
    Stage<Version> placing_;             // version of the scene's geometry
    Stage<Version, Version> assigning_;  // versions of the scene's materials and emission
    Stage<Version, Version> completing_;
    Change change_;
    std::vector<Blocker> blockers_;
};

}  // namespace nicol
