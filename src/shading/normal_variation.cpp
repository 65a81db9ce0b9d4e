// SPDX-License-Identifier: MIT
#include "shading/normal_variation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "polarization/view_geometry.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Returns v with unit length, or `otherwise` if v has no direction.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> direction(const Vector3<Number>& v,
                                                        const Vector3<Number>& otherwise) {
    Number square;
    dot(v, v, square);
    // GCC 12 does not vectorise two combined conditions, nor a condition that follows a branch.
    square = square < std::numeric_limits<float>::infinity() ? square : Number{};
    const auto defined = square > 0;
    square = defined ? square : Number{} + 1.0F;
    square_root(square);
    const Number inverse = 1.0F / square;
    return {defined ? v.x * inverse : otherwise.x, defined ? v.y * inverse : otherwise.y,
            defined ? v.z * inverse : otherwise.z};
}

// Returns of.x x + of.y y + of.z z.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> combination(const Vector3<Number>& of, const Vector3<Number>& x,
                                                          const Vector3<Number>& y,
                                                          const Vector3<Number>& z) {
    return {of.x * x.x + of.y * y.x + of.z * z.x, of.x * x.y + of.y * y.y + of.z * z.y,
            of.x * x.z + of.y * y.z + of.z * z.z};
}

template <class Number>
[[gnu::always_inline]] inline Vector3<Number> times(const Number& factor, const Vector3<Number>& v) {
    return {factor * v.x, factor * v.y, factor * v.z};
}

// Computes surface_axes().
template <class Number>
[[gnu::always_inline]] inline void find_axes(const Vector3<Number>& by_u, const Vector3<Number>& by_v,
                                             const Vector3<Number>& n, bool mirrored_y, Vector3<Number>& x,
                                             Vector3<Number>& y) {
    Number number;
    dot(by_u, n, number);
    x = direction(minus_scaled(by_u, number, n), Vector3<Number>{});
    y = cross(n, x);
    if (!mirrored_y) return;
    dot(y, by_v, number);
    const Number one = Number{} + 1.0F;
    const Number sign = number > 0 ? -one : one;
    y = times(sign, y);
}

// Returns the normal of a normal map. texel: the normal in the surface's frame, as a colour.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> mapped(const Vector3<Number>& texel,
                                                     const Vector3<Number>& by_u, const Vector3<Number>& by_v,
                                                     const Vector3<Number>& n, bool mirrored_y) {
    Vector3<Number> x, y;
    find_axes(by_u, by_v, n, mirrored_y, x, y);
    // The normal is unchanged if x is 0.
    Number number;
    dot(x, x, number);
    const Vector3<Number> local{2.0F * texel.x - 1.0F, 2.0F * texel.y - 1.0F,
                                number * (2.0F * texel.z - 2.0F) + 1.0F};
    return direction(combination(local, x, y, n), n);
}

// Returns the normal of a bump map. across, down: slopes by u and by v.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> bumped(const Number& across, const Number& down,
                                                     const Vector3<Number>& by_u, const Vector3<Number>& by_v,
                                                     const Vector3<Number>& n) {
    const Number one = Number{} + 1.0F;
    // The slope counts as 0 without axes, so that the normal is unchanged.
    Number square, number;
    dot(by_u, by_u, square);
    dot(by_v, by_v, number);
    square += number;
    const Number there = square > 0 ? one : Number{};
    dot(n, by_u, number);
    number -= there * across;
    const Vector3<Number> moved_u = minus_scaled(by_u, number, n);
    dot(n, by_v, number);
    number -= there * down;
    const Vector3<Number> turned = direction(cross(moved_u, minus_scaled(by_v, number, n)), n);
    dot(turned, n, number);
    const Number sign = number < 0 ? -one : one;
    return times(sign, turned);
}

// Returns the perturbed normal. texture: value of a normal map, or gradient of a bump map times the scale.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> turned(const NormalVariation& variation,
                                                     const Vector3<Number>& texture,
                                                     const Vector3<Number>& by_u, const Vector3<Number>& by_v,
                                                     const Vector3<Number>& normal, bool back) {
    const Number one = Number{} + 1.0F;
    const Vector3<Number> front = back ? times(-one, normal) : normal;
    const Vector3<Number> out = variation.kind == NormalVariation::Kind::map
                                    ? mapped(texture, by_u, by_v, front, variation.mirrored_y)
                                    : bumped(texture.x, texture.y, by_u, by_v, front);
    if (!back) return out;
    if (variation.reversed_back) return times(-one, out);
    Number twice;
    dot(out, front, twice);
    twice += twice;
    return minus_scaled(out, twice, front);
}

template <class Number>
[[gnu::always_inline]] inline Vector3<Number> facing(const Vector3<Number>& turned,
                                                     const Vector3<Number>& normal,
                                                     const Vector3<Number>& towards_viewer) {
    // The limit is above 0 because microfacet models have no limit at the horizon itself.
    const Number edge_on = Number{} + 0.02F;
    const Number one = Number{} + 1.0F;
    Number cosine, along;
    dot(turned, towards_viewer, cosine);
    dot(turned, normal, along);
    const Number sign = cosine > 0 ? one : -one;
    along = cosine > 0 ? Number{} : -2.0F * along;
    const Vector3<Number> flipped = minus_scaled(times(sign, turned), along, normal);
    Number least;
    dot(normal, towards_viewer, least);
    least = least < edge_on ? least : edge_on;
    Number missing;
    dot(flipped, towards_viewer, missing);
    missing = least - missing;
    missing = missing > 0 ? missing : Number{};
    return direction(minus_scaled(flipped, -missing, towards_viewer), normal);
}

glm::vec3 vector(const Vector3<float>& v) {
    return {v.x, v.y, v.z};
}

// The compiler's own vector type.
using Number [[gnu::vector_size(64)]] = float;

[[gnu::always_inline]] inline Vector3<Number> load_all(const LaneVectors& from) {
    LaneVector x, y, z;
    load(&from.x, x);
    load(&from.y, y);
    load(&from.z, z);
    return {x, y, z};
}

[[gnu::always_inline]] inline void turn_all(const NormalVariation& variation, const LaneVectors& texture,
                                            const LaneTextureAxes& axes, bool back,
                                            const LaneVectors& towards_viewer, LaneVectors& normals) {
    const Vector3<Number> normal = load_all(normals);
    const Vector3<Number> all =
        turned(variation, load_all(texture), load_all(axes.by_u), load_all(axes.by_v), normal, back);
    const Vector3<Number> out = facing(all, normal, direction(load_all(towards_viewer), normal));
    store(&normals.x, out.x);
    store(&normals.y, out.y);
    store(&normals.z, out.z);
}

}  // namespace

TextureAxes texture_axes(const std::array<glm::vec3, 3>& positions,
                         const std::array<glm::vec2, 3>& texcoords) {
    const glm::vec3 along1 = positions[1] - positions[0];
    const glm::vec3 along2 = positions[2] - positions[0];
    const glm::vec2 d1 = texcoords[1] - texcoords[0];
    const glm::vec2 d2 = texcoords[2] - texcoords[0];
    const float area = d1.x * d2.y - d1.y * d2.x;
    if (area == 0) return {};
    return {.by_u = (d2.y * along1 - d1.y * along2) / area, .by_v = (d1.x * along2 - d2.x * along1) / area};
}

TextureAxes tangent_axes(const std::array<glm::vec4, 3>& tangents, const glm::vec3& weights,
                         const glm::vec3& normal, const TextureAxes& otherwise) {
    const glm::vec4 tangent = weights.x * tangents[0] + weights.y * tangents[1] + weights.z * tangents[2];
    const glm::vec3 x(tangent);
    if (x == glm::vec3(0)) return otherwise;
    const glm::vec3 y = glm::cross(normal, x);
    return {.by_u = x, .by_v = tangent.w < 0 ? y : -y};
}

SurfaceAxes surface_axes(const TextureAxes& axes, const glm::vec3& normal, bool mirrored_y) {
    Vector3<float> x, y;
    find_axes(components(axes.by_u), components(axes.by_v), components(normal), mirrored_y, x, y);
    return {vector(x), vector(y)};
}

glm::vec3 perturbed_normal(const NormalVariation& variation, const TexturePoint& point,
                           const TextureAxes& axes, const glm::vec3& normal, bool back) {
    const bool map = variation.kind == NormalVariation::Kind::map;
    const glm::vec3 texture =
        map ? glm::vec3(variation.texture->at(point))
            : glm::vec3(static_cast<float>(variation.scale) * variation.texture->gradient(point), 0);
    return vector(turned(variation, components(texture), components(axes.by_u), components(axes.by_v),
                         components(normal), back));
}

glm::vec3 facing(const glm::vec3& turned, const glm::vec3& normal, const glm::vec3& towards_viewer) {
    return vector(facing(components(turned), components(normal), components(towards_viewer)));
}

float terminator_shadowing(float perturbation, float incidence) {
    const auto squared_tangent = [](float cosine) {
        const float square = std::clamp(cosine * cosine, 1e-12F, 1.0F);
        return (1 - square) / square;
    };
    const float squared_alpha = std::min(0.125F * squared_tangent(perturbation), 1.0F);
    return 2 / (1 + std::sqrt(1 + squared_alpha * squared_tangent(incidence)));
}

void turn_normals(const NormalVariation& variation, const TexturePoints& points, const LaneTextureAxes& axes,
                  bool back, const LaneVectors& towards_viewer, LaneVectors& normals) {
    LaneVectors texture;
    if (variation.kind == NormalVariation::Kind::map) {
        std::array<Lanes, 4> color;
        variation.texture->at_lanes(points, color);
        texture = {color[0], color[1], color[2]};
    } else {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::vec2 slope =
                static_cast<float>(variation.scale) * variation.texture->gradient(points.at(i));
            texture.x[i] = slope.x;
            texture.y[i] = slope.y;
            texture.z[i] = 0;
        }
    }
    dispatch<turn_all>(variation, texture, axes, back, towards_viewer, normals);
}

}  // namespace nicol
