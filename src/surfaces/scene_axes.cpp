// SPDX-License-Identifier: MIT
// Axes of a scene's geometry, which follow its largest instance.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "geometry/deformed_mesh.hpp"
#include "geometry/principal_axes.hpp"
#include "scene/middle.hpp"
#include "surfaces/rigid_motion.hpp"
#include "surfaces/scene_geometry.hpp"

namespace nicol {
namespace {

// Returns whether two placements of one mesh differ by no more than rounding. The placements' shifts were
// computed as differences of numbers as large as `shift`, which hosts may keep in single precision.
bool near(const glm::dmat4& a, const glm::dmat4& b, const Ball& ball, double shift) {
    double size = 0;
    double linear = 0;
    double offset = 0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double difference = std::abs(a[column][row] - b[column][row]);
            (column < 3 ? linear : offset) = std::max(column < 3 ? linear : offset, difference);
            if (column < 3) size = std::max(size, std::abs(b[column][row]));
        }
    }
    constexpr double of_floats = 2e-7;
    constexpr double visible = 1e-4;  // shift that can be seen, relative to the radius
    const auto radius = static_cast<double>(ball.radius);
    return linear <= kRotationTolerance * size &&
           offset <= kRotationTolerance * radius + std::min(of_floats * shift, visible * radius);
}

}  // namespace

void SceneGeometry::find_axes(const Scene& scene, std::size_t largest) {
    const Instance& instance = scene.instances()[largest];
    const bool same = largest_mesh_ != nullptr && largest_ == scene.ids()[largest] &&
                      (largest_mesh_ == instance.mesh || same_triangles(*largest_mesh_, *instance.mesh));
    if (same) {
        if (const auto motion = rigid_motion(largest_placement_, instance.to_world)) {
            if (keeps_most(scene, *motion))
                to_world_ = *motion;
            else
                largest_placement_ = inverse_motion(to_world_) * instance.to_world;
            return;
        }
    }
    if (largest_mesh_ != instance.mesh) mesh_axes_ = principal_axes(instance.mesh->positions);
    largest_mesh_ = instance.mesh;
    largest_ = scene.ids()[largest];
    const glm::dvec3 middle = middle_of(instance);
    largest_placement_ = from_middle(middle) * instance.to_world;
    to_world_ = from_middle(-middle);
    // The axes are not aligned with the mesh. Otherwise bake directions could lie in a mesh's planes of
    // symmetry, and rounding would decide whether they are above the horizons of its vertices.
    const glm::dmat3 askew = glm::mat3_cast(glm::normalize(glm::dquat(0.9, 0.31, 0.17, 0.23)));
    own_axes_ = rotate_in(glm::dmat3(instance.to_world)) * mesh_axes_ * askew;
}

bool SceneGeometry::keeps_most(const Scene& scene, const glm::dmat4& to_world) const {
    if (to_world == to_world_) return true;
    std::size_t with_them = 0;
    std::size_t with_present = 0;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        const auto former = std::ranges::lower_bound(pieces_, scene.ids()[i], {}, &Piece::id);
        if (former == pieces_.end() || former->id != scene.ids()[i] || former->mesh != instance.mesh)
            continue;
        const std::size_t vertices = instance.mesh->positions.size();
        const auto stays_in = [&](const glm::dmat4& axes) {
            return stays(*former, inverse_motion(axes) * instance.to_world, axes);
        };
        if (stays_in(to_world)) with_them += vertices;
        if (stays_in(to_world_)) with_present += vertices;
    }
    return with_them >= with_present;
}

bool SceneGeometry::stays(const Piece& former, const glm::dmat4& placement, const glm::dmat4& to_world) {
    const bool moved = to_world != glm::dmat4(1.0);
    const double shift = glm::length(glm::dvec3(to_world * placement[3])) +
                         glm::length(glm::dvec3(to_world[3])) + glm::length(glm::dvec3(former.placement[3]));
    return near(placement, former.placement, former.extent.ball, moved ? shift : 0);
}

}  // namespace nicol
