// SPDX-License-Identifier: MIT
// Light from an emissive surface.
#pragma once

#include <optional>

#include "geometry/ray_scene.hpp"
#include "shading/light_source.hpp"

namespace nicol {

class SurfaceSource final : public LightSource {
public:
    /// A triangle, or two that make a parallelogram.
    struct Patch {
        glm::vec3 corner, first, second;  ///< edges
        glm::vec3 normal;                 ///< unit
        float before;                     ///< part of the area in the patches before it
        float scale;                      ///< 1 over its part
        float parallelogram;              ///< 1 or 0
    };

    explicit SurfaceSource(const EmissiveSurface& surface);

    [[nodiscard]] float angular_radius(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

    [[nodiscard]] double area() const noexcept { return area_; }

private:
    void make_rays();
    [[nodiscard]] std::size_t patch_at(float u) const;
    // b1, b2: along the patch's edges.
    void put_texcoords(std::size_t patch, float b1, float b2, std::size_t lane, TexturePoints& out) const;

    bool two_sided_;
    SourceColor color_;
    std::vector<Patch> patches_;
    std::vector<std::array<glm::vec2, 3>> texcoords_;
    double area_ = 0;
    std::vector<std::uint32_t> guide_;  // of parts of u, in equal steps: the last patch before each
    glm::vec3 centre_{0};               // of a sphere that all of it is in
    float radius_ = 0;
    std::optional<RayScene> rays_;  // of two triangles a patch; none: nothing mirrors it
};

}  // namespace nicol
