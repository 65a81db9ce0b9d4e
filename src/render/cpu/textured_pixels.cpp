// SPDX-License-Identifier: MIT
#include "render/cpu/textured_pixels.hpp"

#include <algorithm>
#include <array>

#include "shading/lane_footprint.hpp"
#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

PixelSteps steps_of(const TextureView& view) {
    const Projection& p = view.projection;
    return {.forward = p.view.forward,
            .right = p.view.right * (2 * p.sample_size * p.half_width / view.width),
            .down = p.view.up * (-2 * p.sample_size * p.half_height / view.height),
            .orthographic = p.view.orthographic};
}

// What textures and normals need to know of sixteen points.
class Block {
public:
    Block(const SpatialVariation& variation, const TextureView& view)
        : view_(view),
          steps_(steps_of(view)),
          footprint_(variation.needs_footprint()),
          axes_(footprint_ || variation.normal.kind != NormalVariation::Kind::none) {}

    // triangles: up to sixteen. Other lanes repeat the first.
    void set(std::span<const std::uint32_t> triangles, const LaneSurface& surface) {
        const WorldGeometry& geometry = view_.geometry;
        const Viewpoint& camera = view_.projection.view;
        const glm::vec3 eye(camera.eye), forward(camera.forward);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::uint32_t triangle = triangles[i < triangles.size() ? i : 0];
            const glm::vec3 weights(surface.weights[0][i], surface.weights[1][i], surface.weights[2][i]);
            const glm::vec3 ray = camera.orthographic ? forward : surface.positions[i] - eye;
            put(towards_viewer, i, -ray);
            put(normals, i, surface.normals[i]);
            if (!geometry.texcoords.empty()) {
                const std::array<glm::vec2, 3>& texcoords = geometry.texcoords[triangle];
                if (axes_ && triangle != known_) use(triangle, texcoords);
                for (glm::length_t k = 0; k < 2; ++k)
                    points.uv[static_cast<std::size_t>(k)][i] = weights.x * texcoords[0][k] +
                                                                weights.y * texcoords[1][k] +
                                                                weights.z * texcoords[2][k];
                put(axes.by_u, i, triangle_axes_.by_u);
                put(axes.by_v, i, triangle_axes_.by_v);
            }
            if (!geometry.colors.empty()) {
                const std::array<glm::vec3, 3>& colors = geometry.colors[triangle];
                for (glm::length_t k = 0; k < 3; ++k)
                    points.color[static_cast<std::size_t>(k)][i] =
                        weights.x * colors[0][k] + weights.y * colors[1][k] + weights.z * colors[2][k];
            }
        }
        if (footprint_) find_footprints(steps_, axes, towards_viewer, points);
    }

    TexturePoints points{};
    LaneTextureAxes axes{};
    LaneVectors towards_viewer, normals;

private:
    void use(std::uint32_t triangle, const std::array<glm::vec2, 3>& texcoords) {
        known_ = triangle;
        const std::vector<glm::vec3>& positions = view_.geometry.positions;
        const glm::uvec3& t = view_.geometry.triangles[triangle];
        triangle_axes_ = texture_axes({positions[t.x], positions[t.y], positions[t.z]}, texcoords);
    }

    const TextureView& view_;
    PixelSteps steps_;
    bool footprint_, axes_;
    std::uint32_t known_ = ~std::uint32_t{0};  // the triangle before, which is often the same
    TextureAxes triangle_axes_;
};

}  // namespace

void TexturedPixels::find(const SpatialVariation& variation, bool back, const TextureView& view,
                          std::span<const std::uint32_t> triangles, std::span<LaneSurface> surfaces) {
    const std::size_t layers = variation.layers.size();
    weights_.resize(surfaces.size() * layers);
    Block block(variation, view);
    for (std::size_t b = 0; b < surfaces.size(); ++b) {
        const std::span own = triangles.subspan(b * kLanes, std::min(kLanes, triangles.size() - b * kLanes));
        block.set(own, surfaces[b]);
        const std::span weights = std::span(weights_).subspan(b * layers, layers);
        variation.weights(block.points, weights);
        if (variation.normal.kind == NormalVariation::Kind::none) continue;
        turn_normals(variation.normal, block.points, block.axes, back, block.towards_viewer, block.normals);
        for (std::size_t i = 0; i < kLanes; ++i)
            surfaces[b].normals[i] = {block.normals.x[i], block.normals.y[i], block.normals.z[i]};
    }
}

}  // namespace nicol
