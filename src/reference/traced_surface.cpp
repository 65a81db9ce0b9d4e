// SPDX-License-Identifier: MIT
#include "reference/traced_surface.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "geometry/perpendicular.hpp"
#include "material/spatial_variation.hpp"
#include "shading/normal_variation.hpp"
#include "shading/tangent_rotation.hpp"

namespace nicol {
namespace {

template <class Value>
std::array<Value, 3> corners_of(const std::vector<Value>& values, const glm::uvec3& corners) {
    return {values[corners.x], values[corners.y], values[corners.z]};
}

glm::dvec3 weights_of(const RayHit& hit) {
    return {1 - hit.b1 - hit.b2, hit.b1, hit.b2};
}

TexturePoint texture_point(const TracedSurface& surface, std::uint32_t triangle, const glm::vec3& weights) {
    const Mesh& mesh = surface.mesh;
    std::array<glm::vec2, 3> texcoords;
    std::array<glm::vec3, 3> colors;
    if (!mesh.texcoords.empty()) texcoords = corners_of(mesh.texcoords, mesh.texcoord_triangles[triangle]);
    if (!mesh.colors.empty()) colors = corners_of(mesh.colors, mesh.triangles[triangle]);
    TexturePoint point = nicol::texture_point(weights, mesh.texcoords.empty() ? nullptr : &texcoords,
                                              mesh.colors.empty() ? nullptr : &colors);
    if (needs_colors(*surface.front.material, ColorsOf::faces) ||
        needs_colors(surface.emission, ColorsOf::faces))
        point.color = mesh.face_colors[triangle];
    return point;
}

TextureAxes texture_axes(const Mesh& mesh, std::uint32_t triangle) {
    if (mesh.texcoords.empty()) return {};
    return nicol::texture_axes(corners_of(mesh.positions, mesh.triangles[triangle]),
                               corners_of(mesh.texcoords, mesh.texcoord_triangles[triangle]));
}

// Returns the axes that normal maps and anisotropic materials follow. normal: unit normal of the front.
TextureAxes material_axes(const Mesh& mesh, const RayHit& hit, const glm::dvec3& normal) {
    const TextureAxes axes = texture_axes(mesh, hit.triangle);
    if (mesh.tangents.empty()) return axes;
    return tangent_axes(corners_of(mesh.tangents, mesh.texcoord_triangles[hit.triangle]),
                        glm::vec3(weights_of(hit)), glm::vec3(normal), axes);
}

// Returns the frame of a shading normal, which a texture may have perturbed, for an anisotropic material.
// front: unit normal of the front that no texture has perturbed.
Frame anisotropic_frame(const TextureAxes& axes, const SurfaceHit& hit, const glm::dvec3& front,
                        const glm::dvec3& normal, const SpatialVariation* variation) {
    glm::vec3 along = axes.by_u;
    if (variation != nullptr && variation->rotation.any())
        along = rotated_tangent(variation->rotation, hit.point, axes, glm::vec3(front));
    const glm::dvec3 x = perpendicular(normal, perpendicular(hit.unturned, glm::dvec3(along)));
    return {x, glm::cross(normal, x), normal};
}

}  // namespace

Presence TracedSurface::presence() const {
    const SpatialVariation* const variation = front.material->variation();
    if (variation == nullptr || variation->opacity == nullptr) return {};
    return [this, variation](std::uint32_t triangle, float b1, float b2) {
        return variation->present(texture_point(*this, triangle, {1 - b1 - b2, b1, b2}),
                                  threshold_at(triangle, b1, b2));
    };
}

glm::dvec3 TracedSurface::position(const RayHit& hit) const {
    // The position is computed from the corners rather than along the ray, which has only single precision.
    const auto corners = corners_of(mesh.positions, mesh.triangles[hit.triangle]);
    return glm::dmat3(corners[0], corners[1], corners[2]) * weights_of(hit);
}

glm::dvec3 TracedSurface::geometric_normal(const RayHit& hit) const {
    const auto corners = corners_of(mesh.positions, mesh.triangles[hit.triangle]);
    const glm::dvec3 origin(corners[0]);
    return glm::normalize(glm::cross(glm::dvec3(corners[1]) - origin, glm::dvec3(corners[2]) - origin));
}

double TracedSurface::ray_offset(const RayHit& hit) const {
    return nicol::ray_offset(corners_of(mesh.positions, mesh.triangles[hit.triangle]));
}

glm::dvec3 TracedSurface::normal(const RayHit& hit) const {
    const auto corners = corners_of(mesh.normals, mesh.triangles[hit.triangle]);
    const glm::dvec3 weights = weights_of(hit);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i) sum += weights[i] * glm::dvec3(corners[static_cast<std::size_t>(i)]);
    const double length = glm::length(sum);
    return length > 0 ? sum / length : geometric_normal(hit);
}

bool TracedSurface::emitted(const RayHit& hit, const Frame& frame, std::span<Stokes> radiance) const {
    if (emission == nullptr) return false;
    if (!emission->two_sided && !(glm::dot(normal(hit), frame[2]) > 0)) return false;
    const TexturePoint point = texture_point(*this, hit.triangle, glm::vec3(weights_of(hit)));
    const float threshold =
        threshold_at(hit.triangle, static_cast<float>(hit.b1), static_cast<float>(hit.b2));
    if (opacity_of(*front.material) != nullptr && !front.material->variation()->present(point, threshold))
        return false;
    const glm::vec4 texel = emission->texture != nullptr ? emission->texture->at(point) : glm::vec4(1);
    const Stokes state = stokes_in(frame, emission->state, emission_axis);
    for (std::size_t c = 0; c < radiance.size(); ++c)
        radiance[c] =
            textured_value(emission->radiance, emission->texture, texel, static_cast<int>(c)) * state;
    return true;
}

SurfaceHit surface_hit(const TracedSurface& surface, const RayHit& hit, const glm::dvec3& towards_viewer) {
    glm::dvec3 shading_normal = surface.normal(hit);
    const bool behind = glm::dot(shading_normal, towards_viewer) < 0;
    const bool back = behind && surface.front.material->twosided();
    if (back) shading_normal = -shading_normal;
    SurfaceHit out{.side = back ? surface.back : surface.front,
                   .receives_shadows = surface.roles.receives_shadows,
                   .position = surface.position(hit),
                   .geometric_normal = surface.geometric_normal(hit),
                   .ray_offset = surface.ray_offset(hit),
                   .unturned = shading_normal,
                   .dimmed = false,
                   .frame = {},
                   .towards_viewer = {},
                   .point = {}};
    const SpatialVariation* const variation = surface.front.material->variation();
    const glm::dvec3 front = back ? -shading_normal : shading_normal;
    const bool anisotropic = surface.front.material->anisotropic();
    const bool map = variation != nullptr && variation->normal.kind == NormalVariation::Kind::map;
    TextureAxes axes;
    if (anisotropic || map) axes = material_axes(surface.mesh, hit, front);
    if (variation != nullptr) {
        out.point = texture_point(surface, hit.triangle, glm::vec3(weights_of(hit)));
        if (variation->normal.kind != NormalVariation::Kind::none) {
            out.dimmed = variation->normal.shadowed;
            const glm::vec3 normal_of_mesh(shading_normal);
            const glm::vec3 turned =
                perturbed_normal(variation->normal, out.point,
                                 map ? axes : texture_axes(surface.mesh, hit.triangle), normal_of_mesh, back);
            shading_normal =
                glm::normalize(glm::dvec3(facing(turned, normal_of_mesh, glm::vec3(towards_viewer))));
        }
    }
    out.frame = anisotropic ? anisotropic_frame(axes, out, front, shading_normal, variation)
                            : theta_phi_frame(shading_normal);
    out.towards_viewer = glm::normalize(towards_viewer * out.frame);
    return out;
}

}  // namespace nicol
