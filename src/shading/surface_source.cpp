// SPDX-License-Identifier: MIT
#include "shading/surface_source.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {

SurfaceSource::SurfaceSource(const ShiningSurface& surface)
    : two_sided_(surface.emission.two_sided),
      color_(surface.emission.radiance, surface.emission.texture, surface.emission.state, surface.axis) {
    std::vector<double> areas;
    std::vector<glm::dvec3> normals;  // squares of very small or large edges are no floats
    for (const std::array<glm::vec3, 3>& t : surface.triangles) {
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(t[1]) - glm::dvec3(t[0]), glm::dvec3(t[2]) - glm::dvec3(t[0]));
        const double length = glm::length(normal);
        normals.push_back(normal / length);
        areas.push_back(length / 2);
        area_ += areas.back();
    }
    double before = 0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        if (!(areas[t] > 0)) continue;
        const std::array<glm::vec3, 3>& corners = surface.triangles[t];
        triangles_.push_back({.corner = corners[0],
                              .first = corners[1] - corners[0],
                              .second = corners[2] - corners[0],
                              .normal = glm::vec3(normals[t]),
                              .before = static_cast<float>(before / area_),
                              .scale = static_cast<float>(area_ / areas[t])});
        if (!surface.texcoords.empty()) texcoords_.push_back(surface.texcoords[t]);
        before += areas[t];
        for (const glm::vec3& corner : corners) centre_ += static_cast<float>(areas[t] / area_ / 3) * corner;
    }
    // A power of two, so that a part's first u is exact.
    guide_.resize(std::bit_ceil(2 * triangles_.size()));
    for (std::size_t part = 0; part < guide_.size() && !triangles_.empty(); ++part) {
        const float first = static_cast<float>(part) / static_cast<float>(guide_.size());
        const auto after = std::ranges::upper_bound(triangles_, first, {}, &Triangle::before);
        guide_[part] = static_cast<std::uint32_t>(after - triangles_.begin() - 1);
    }
    for (const std::array<glm::vec3, 3>& corners : surface.triangles)
        for (const glm::vec3& corner : corners) radius_ = std::max(radius_, glm::distance(centre_, corner));
}

std::size_t SurfaceSource::triangle_at(float u) const {
    std::size_t index = guide_[static_cast<std::size_t>(u * static_cast<float>(guide_.size()))];
    while (index + 1 < triangles_.size() && triangles_[index + 1].before <= u) ++index;
    return index;
}

float SurfaceSource::angular_radius(const glm::vec3& from) const noexcept {
    return angular_radius_of_ball(from, centre_, radius_);
}

void SurfaceSource::sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const {
    Lanes factor;
    TexturePoints at{};
    out.points = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        // u chooses the triangle, and what is left of it a place: neighbours in u are neighbours there.
        const std::size_t index = triangle_at(u[i]);
        const Triangle& triangle = triangles_[index];
        const float root = std::sqrt(1 - std::clamp((u[i] - triangle.before) * triangle.scale, 0.0F, 1.0F));
        const float b1 = 1 - root;
        const float b2 = v[i] * root;
        const float x = triangle.corner.x + b1 * triangle.first.x + b2 * triangle.second.x - points.x[i];
        const float y = triangle.corner.y + b1 * triangle.first.y + b2 * triangle.second.y - points.y[i];
        const float z = triangle.corner.z + b1 * triangle.first.z + b2 * triangle.second.z - points.z[i];
        const float square = x * x + y * y + z * z;
        const float distance = std::sqrt(square);
        float across = -(triangle.normal.x * x + triangle.normal.y * y + triangle.normal.z * z);
        if (two_sided_) across = std::abs(across);
        const bool shines = across > 0;
        const float scale = shines ? 1 / distance : 0;
        out.distance[i] = distance;
        out.towards.x[i] = scale * x;
        out.towards.y[i] = scale * y;
        out.towards.z[i] = scale * z;
        // Radiance times the solid angle that the place stands for: area cos / distance^2.
        factor[i] = static_cast<float>(area_) * scale * scale * (across * scale);
        if (shines) out.points |= 1U << i;
        if (!color_.textured()) continue;
        const std::array<glm::vec2, 3>& texcoords = texcoords_[index];
        const glm::vec2 uv =
            texcoords[0] + b1 * (texcoords[1] - texcoords[0]) + b2 * (texcoords[2] - texcoords[0]);
        at.uv[0][i] = uv.x;
        at.uv[1][i] = uv.y;
    }
    color_.put(factor, at, out);
}

}  // namespace nicol
