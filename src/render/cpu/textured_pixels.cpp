// SPDX-License-Identifier: MIT
#include "render/cpu/textured_pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

// A triangle's texture coordinates, and how they change along its plane.
class TexturedTriangle {
public:
    TexturedTriangle(const TextureView& view, std::uint32_t triangle) {
        const WorldGeometry& geometry = view.geometry;
        const glm::uvec3& t = geometry.triangles[triangle];
        const std::array<glm::vec3, 3> corners{geometry.positions[t.x], geometry.positions[t.y],
                                               geometry.positions[t.z]};
        texcoords_ = geometry.texcoords[triangle];
        axes_ = texture_axes(corners, texcoords_);
        const glm::vec3 first = corners[1] - corners[0];
        const glm::vec3 second = corners[2] - corners[0];
        normal_ = glm::cross(first, second);
        const float squared = glm::dot(normal_, normal_);
        length_ = std::sqrt(squared);
        if (!(squared > 0)) return;
        const glm::vec2 a = texcoords_[1] - texcoords_[0];
        const glm::vec2 b = texcoords_[2] - texcoords_[0];
        const glm::vec3 across_first = glm::cross(second, normal_) / squared;
        const glm::vec3 across_second = glm::cross(normal_, first) / squared;
        slope_u_ = a.x * across_first + b.x * across_second;
        slope_v_ = a.y * across_first + b.y * across_second;
    }

    [[nodiscard]] glm::vec2 at(const glm::vec3& weights) const {
        return weights.x * texcoords_[0] + weights.y * texcoords_[1] + weights.z * texcoords_[2];
    }
    [[nodiscard]] const TextureAxes& axes() const { return axes_; }

    // The change of texture coordinates where a ray moves aside by so much at the point that it meets.
    [[nodiscard]] glm::vec2 change(const glm::vec3& ray, const glm::vec3& aside) const {
        // Edge on, a pixel is as long as the surface.
        const float least = 1e-4F * glm::length(ray) * length_;
        const float facing = glm::dot(ray, normal_);
        const float safe = std::abs(facing) > least ? facing : facing < 0 ? -least : least;
        if (safe == 0) return glm::vec2(0);
        const glm::vec3 move = aside - ray * (glm::dot(aside, normal_) / safe);
        return {glm::dot(move, slope_u_), glm::dot(move, slope_v_)};
    }

private:
    std::array<glm::vec2, 3> texcoords_;
    TextureAxes axes_;
    glm::vec3 normal_;  // of length length_
    float length_;
    glm::vec3 slope_u_{0}, slope_v_{0};
};

// The steps from a pixel to its neighbours, at unit distance or, of an orthographic camera, anywhere.
struct PixelSteps {
    explicit PixelSteps(const TextureView& view) {
        const Projection& projection = view.projection;
        right = glm::vec3(projection.view.right * (2 * projection.half_width / view.width));
        down = glm::vec3(projection.view.up * (-2 * projection.half_height / view.height));
    }
    glm::vec3 right, down;
};

}  // namespace

void TexturedPixels::find(const SpatialVariation& variation, bool back, const TextureView& view,
                          std::span<SurfacePoint> points) {
    const std::size_t layers = variation.layers.size();
    weights_.resize(points.size() * layers);
    used_.resize(points.size());
    const std::span all(weights_);
    const Viewpoint& camera = view.projection.view;
    const glm::vec3 eye(camera.eye);
    const glm::vec3 forward(camera.forward);
    const PixelSteps steps(view);
    const bool turns = variation.normal.kind != NormalVariation::Kind::none;
    std::optional<TexturedTriangle> triangle;  // of the point before, which is often the same
    for (std::size_t i = 0; i < points.size(); ++i) {
        SurfacePoint& at = points[i];
        TexturePoint point;
        const glm::vec3 ray = camera.orthographic ? forward : at.position - eye;
        if (!view.geometry.texcoords.empty()) {
            if (i == 0 || at.triangle != points[i - 1].triangle) triangle.emplace(view, at.triangle);
            const float distance = camera.orthographic ? 1 : glm::dot(ray, forward);
            point.uv = triangle->at(at.weights);
            point.du = triangle->change(ray, distance * steps.right);
            point.dv = triangle->change(ray, distance * steps.down);
        }
        if (!view.geometry.colors.empty()) {
            const std::array<glm::vec3, 3>& colors = view.geometry.colors[at.triangle];
            point.color = at.weights.x * colors[0] + at.weights.y * colors[1] + at.weights.z * colors[2];
        }
        const std::span of = all.subspan(i * layers, layers);
        variation.weights(point, of);
        used_[i] = {.layers = 0, .point = static_cast<std::uint32_t>(i)};
        for (std::size_t l = 0; l < layers; ++l)
            if (of[l] != glm::vec3(0)) used_[i].layers |= std::uint64_t{1} << (l % 64);
        if (turns) {
            const glm::vec3 turned =
                turned_normal(variation.normal, point, triangle->axes(), at.normal, back);
            at.normal = facing(turned, at.normal, -glm::normalize(ray));
        }
    }
    if (!std::ranges::is_sorted(used_, {}, &Used::layers)) {
        std::ranges::stable_sort(used_, {}, &Used::layers);
        given_.assign(points.begin(), points.end());
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = given_[used_[i].point];
    }
    store_weights(layers);
}

void TexturedPixels::store_weights(std::size_t layers) {
    const std::size_t blocks = (used_.size() + kLanes - 1) / kLanes;
    lanes_.resize(layers * blocks);
    by_layer_.clear();
    for (std::size_t l = 0; l < layers; ++l) {
        const std::span own = std::span(lanes_).subspan(l * blocks, blocks);
        by_layer_.emplace_back(own);
        for (std::size_t b = 0; b < blocks; ++b) {
            std::uint64_t some = 0;
            const std::size_t last = std::min((b + 1) * kLanes, used_.size());
            for (std::size_t i = b * kLanes; i < last; ++i) some |= used_[i].layers;
            own[b].any = (some >> (l % 64) & 1) != 0;
            if (!own[b].any) continue;
            own[b].value = {};
            own[b].equal = true;
            for (std::size_t i = b * kLanes; i < last; ++i) {
                const glm::vec3& weight = weights_[used_[i].point * layers + l];
                for (glm::length_t c = 0; c < 3; ++c)
                    own[b].value[static_cast<std::size_t>(c)][i % kLanes] = weight[c];
                own[b].equal = own[b].equal && weight.x == weight.y && weight.x == weight.z;
            }
        }
    }
}

}  // namespace nicol
