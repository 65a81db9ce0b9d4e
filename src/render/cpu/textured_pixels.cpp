// SPDX-License-Identifier: MIT
#include "render/cpu/textured_pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

// A triangle's texture coordinates, and how they change along its plane.
class TexturedTriangle {
public:
    TexturedTriangle(const WorldGeometry& geometry, std::uint32_t triangle) {
        const glm::uvec3& t = geometry.triangles[triangle];
        corners_ = {geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]};
        if (!geometry.texcoords.empty()) texcoords_ = geometry.texcoords[triangle];
    }

    [[nodiscard]] glm::vec2 at(const glm::vec3& weights) const {
        return weights.x * texcoords_[0] + weights.y * texcoords_[1] + weights.z * texcoords_[2];
    }
    [[nodiscard]] TextureAxes axes() const { return texture_axes(corners_, texcoords_); }

    // The change of texture coordinates to the neighbours of a pixel.
    void find_footprint(const TextureView& view, TexturePoint& point, const glm::vec3& position) const {
        const Projection& projection = view.projection;
        const Viewpoint& camera = projection.view;
        const glm::vec3 first = corners_[1] - corners_[0];
        const glm::vec3 second = corners_[2] - corners_[0];
        const glm::vec3 normal = glm::cross(first, second);
        const glm::vec3 forward(camera.forward);
        const glm::vec3 ray = camera.orthographic ? forward : position - glm::vec3(camera.eye);
        const float distance = camera.orthographic ? 1 : glm::dot(ray, forward);
        // Edge on, a pixel is as long as the surface.
        float facing = glm::dot(ray, normal);
        const float least = 1e-4F * glm::length(ray) * glm::length(normal);
        if (!(std::abs(facing) > least)) facing = facing < 0 ? -least : least;
        const float squared = glm::dot(normal, normal);
        if (!(squared > 0) || facing == 0) return;
        const auto along = [&](const glm::vec3& aside) {
            const glm::vec3 move = aside - ray * (glm::dot(aside, normal) / facing);
            const float b = glm::dot(glm::cross(move, second), normal) / squared;
            const float c = glm::dot(glm::cross(first, move), normal) / squared;
            return b * (texcoords_[1] - texcoords_[0]) + c * (texcoords_[2] - texcoords_[0]);
        };
        point.du = along(glm::vec3(camera.right) *
                         (distance * static_cast<float>(2 * projection.half_width / view.width)));
        point.dv = along(glm::vec3(camera.up) *
                         (-distance * static_cast<float>(2 * projection.half_height / view.height)));
    }

private:
    std::array<glm::vec3, 3> corners_;
    std::array<glm::vec2, 3> texcoords_{};
};

TexturePoint texture_point(const TextureView& view, const SurfacePoint& at) {
    TexturePoint point;
    if (!view.geometry.texcoords.empty()) {
        const TexturedTriangle triangle(view.geometry, at.triangle);
        point.uv = triangle.at(at.weights);
        triangle.find_footprint(view, point, at.position);
    }
    if (!view.geometry.colors.empty()) {
        const std::array<glm::vec3, 3>& colors = view.geometry.colors[at.triangle];
        point.color = at.weights.x * colors[0] + at.weights.y * colors[1] + at.weights.z * colors[2];
    }
    return point;
}

void turn(const NormalVariation& variation, bool back, const TextureView& view, const TexturePoint& point,
          SurfacePoint& at) {
    const TextureAxes axes = TexturedTriangle(view.geometry, at.triangle).axes();
    const glm::vec3 turned = turned_normal(variation, point, axes, at.normal, back);
    at.normal = facing(turned, at.normal, glm::vec3(view.projection.view.towards(glm::dvec3(at.position))));
}

}  // namespace

void TexturedPixels::find(const SpatialVariation& variation, bool back, const TextureView& view,
                          std::span<SurfacePoint> points) {
    layers_ = variation.layers.size();
    textures_.resize(points.size());
    weights_.resize(points.size() * layers_);
    used_.resize(points.size());
    const std::span all(weights_);
    for (std::size_t i = 0; i < points.size(); ++i) {
        textures_[i] = texture_point(view, points[i]);
        const std::span of = all.subspan(i * layers_, layers_);
        variation.weights(textures_[i], of);
        used_[i] = {.layers = 0, .point = static_cast<std::uint32_t>(i)};
        for (std::size_t l = 0; l < layers_; ++l)
            if (of[l] != glm::vec3(0)) used_[i].layers |= std::uint64_t{1} << (l % 64);
        if (variation.normal.kind != NormalVariation::Kind::none)
            turn(variation.normal, back, view, textures_[i], points[i]);
    }
    if (std::ranges::is_sorted(used_, {}, &Used::layers)) return;
    std::ranges::stable_sort(used_, {}, &Used::layers);
    given_.assign(points.begin(), points.end());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = given_[used_[i].point];
}

bool TexturedPixels::shown(std::size_t layer, std::span<std::uint8_t> shown) const {
    bool any = false;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i] = weight(i, layer) != glm::vec3(0) ? 1 : 0;
        any = any || shown[i] != 0;
    }
    return any;
}

void TexturedPixels::add(std::size_t layer, std::span<const std::span<glm::vec4>> part,
                         std::span<const std::span<glm::vec4>> sum) const {
    for (std::size_t c = 0; c < sum.size(); ++c) {
        // Three equal ones where there are not three channels.
        const auto of = static_cast<glm::length_t>(std::min<std::size_t>(c, 2));
        for (std::size_t i = 0; i < sum[c].size(); ++i) {
            const float factor = weight(i, layer)[of];
            if (factor != 0) sum[c][i] += factor * part[c][i];
        }
    }
}

}  // namespace nicol
