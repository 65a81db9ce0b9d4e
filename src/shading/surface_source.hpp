// SPDX-License-Identifier: MIT
// Light from a surface that shines.
#pragma once

#include "shading/light_source.hpp"

namespace nicol {

class SurfaceSource final : public LightSource {
public:
    struct Triangle {
        glm::vec3 corner, first, second;  // edges
        glm::vec3 normal;                 // unit
        float before;                     // part of the area in the triangles before it
        float scale;                      // 1 over its part
    };

    explicit SurfaceSource(const ShiningSurface& surface);

    [[nodiscard]] float angular_radius(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;

    [[nodiscard]] double area() const noexcept { return area_; }

private:
    [[nodiscard]] std::size_t triangle_at(float u) const;

    bool two_sided_;
    SourceColor color_;
    std::vector<Triangle> triangles_;
    std::vector<std::array<glm::vec2, 3>> texcoords_;
    double area_ = 0;
    std::vector<std::uint32_t> guide_;  // of parts of u, in equal steps: the last triangle before each
    glm::vec3 centre_{0};               // of a sphere that all of it is in
    float radius_ = 0;
};

}  // namespace nicol
