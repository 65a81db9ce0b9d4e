// SPDX-License-Identifier: MIT
// Light source for an emissive surface.
#pragma once

#include <optional>

#include "geometry/ray_scene.hpp"
#include "shading/light_source.hpp"

namespace nicol {

class SurfaceSource final : public LightSource {
public:
    /// A triangle, or two triangles that make a parallelogram.
    struct Patch {
        glm::vec3 corner, first, second;  ///< one corner and the two edges from it
        glm::vec3 normal;                 ///< unit normal
        float before;                     ///< fraction of the total area in the patches before this one
        float scale;                      ///< 1 over the patch's fraction of the area
        float parallelogram;              ///< 1 for a parallelogram, 0 for a triangle
    };

    explicit SurfaceSource(const EmissiveSurface& surface);

    [[nodiscard]] float angular_radius(const glm::vec3& from) const noexcept override;
    [[nodiscard]] float brightness(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

    [[nodiscard]] double area() const noexcept { return area_; }

private:
    void make_rays();
    [[nodiscard]] std::size_t patch_at(float u) const;
    // Replaces a lane's sample, uniform over a patch, by one that is uniform over the solid angle of the
    // patch from the point. factor: the solid angle that the sample represents. weights: those of the patch's
    // edges.
    void sample_near(std::size_t patch, const glm::dvec3& point, double u, double v, std::size_t lane,
                     LaneLight& out, Lanes& factor, std::array<Lanes, 2>& weights) const;
    // Sets the texture point of one lane. b1, b2: coordinates along the patch's edges.
    void put_texture_point(std::size_t patch, float b1, float b2, std::size_t lane, TexturePoints& out) const;

    bool two_sided_;
    SourceColor color_;
    std::vector<Patch> patches_;
    // Texture coordinates and colours at the ends of each patch's edges. Empty: the texture needs none.
    std::vector<std::array<glm::vec2, 3>> texcoords_;
    std::vector<std::array<glm::vec3, 3>> colors_;
    double area_ = 0;
    std::vector<std::uint32_t> guide_;  // by equal parts of u: last patch that begins by their start
    glm::vec3 centre_{0};               // centre of a sphere that contains the surface
    float radius_ = 0;
    std::optional<RayScene> rays_;  // two triangles per patch; none if no mirror needs them
};

}  // namespace nicol
