// SPDX-License-Identifier: MIT
#include "shading/surface_source.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

using Triangle = SurfaceSource::Triangle;

/// The triangle that holds each place.
template <class Number>
struct Chosen {
    Vector3<Number> corner, first, second, normal;
    Number before, scale;
};

template <class Number, class Mask>
[[gnu::always_inline]] inline void replace(const Mask& where, const glm::vec3& by, Vector3<Number>& v) {
    v = {where ? Number{} + by.x : v.x, where ? Number{} + by.y : v.y, where ? Number{} + by.z : v.z};
}

/// u chooses the triangle, and what is left of it a place: neighbours in u are neighbours there. For few
/// triangles, which are all looked at.
template <class Number>
[[gnu::always_inline]] inline void choose(std::span<const Triangle> triangles, const Number& u,
                                          Chosen<Number>& out) {
    for (const Triangle& triangle : triangles) {
        const auto here = u >= triangle.before;
        replace(here, triangle.corner, out.corner);
        replace(here, triangle.first, out.first);
        replace(here, triangle.second, out.second);
        replace(here, triangle.normal, out.normal);
        out.before = here ? Number{} + triangle.before : out.before;
        out.scale = here ? Number{} + triangle.scale : out.scale;
    }
}

/// The same of triangles of which each place's is known.
template <class Number>
[[gnu::always_inline]] inline void choose(std::span<const Triangle> triangles, const std::uint32_t* indices,
                                          Chosen<Number>& out) {
    for (std::size_t i = 0; i < kPart<Number>; ++i) {
        const Triangle& triangle = triangles[indices[i]];
        const auto put = [i](const glm::vec3& from, Vector3<Number>& to) {
            to.x[i] = from.x;
            to.y[i] = from.y;
            to.z[i] = from.z;
        };
        put(triangle.corner, out.corner);
        put(triangle.first, out.first);
        put(triangle.second, out.second);
        put(triangle.normal, out.normal);
        out.before[i] = triangle.before;
        out.scale[i] = triangle.scale;
    }
}

struct Places {
    std::span<const Triangle> triangles;
    const std::uint32_t* indices;  // of each place's; null: to be found
    bool two_sided;
    float area;
    const LaneVectors& points;
    const Lanes& u;
    const Lanes& v;
};

struct FoundPlaces {
    LaneLight& light;
    Lanes& factor;
    std::array<Lanes, 2>& weights;  // of the triangles' second and third corner
};

template <class Number>
[[gnu::always_inline]] inline void find_places(const Places& places, const FoundPlaces& out) {
    std::array<std::int32_t, kLanes> shines;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number u, v;
        load_part(places.u, first, u);
        load_part(places.v, first, v);
        Chosen<Number> triangle{};
        if (places.indices == nullptr)
            choose(places.triangles, u, triangle);
        else
            choose(places.triangles, places.indices + first, triangle);

        Number part = (u - triangle.before) * triangle.scale;
        part = part > 0.0F ? part : Number{};
        part = part < 1.0F ? part : Number{} + 1.0F;
        Number root = 1.0F - part;
        square_root(root);
        const Number b1 = 1.0F - root;
        const Number b2 = v * root;
        store_part(b1, first, out.weights[0]);
        store_part(b2, first, out.weights[1]);

        Vector3<Number> way;
        load_part(places.points, first, way);
        way.x = triangle.corner.x + b1 * triangle.first.x + b2 * triangle.second.x - way.x;
        way.y = triangle.corner.y + b1 * triangle.first.y + b2 * triangle.second.y - way.y;
        way.z = triangle.corner.z + b1 * triangle.first.z + b2 * triangle.second.z - way.z;
        Number distance, across;
        dot(way, way, distance);
        square_root(distance);
        dot(triangle.normal, way, across);
        across = -across;
        if (places.two_sided) across = across < 0.0F ? -across : across;
        const auto lit = across > 0.0F;
        const Number scale = lit ? 1.0F / distance : Number{};
        store_part(distance, first, out.light.distance);
        store_part(Vector3<Number>{scale * way.x, scale * way.y, scale * way.z}, first, out.light.towards);
        // Radiance times the solid angle that the place stands for: area cos / distance^2.
        store_part(Number(places.area * scale * scale * (across * scale)), first, out.factor);
        __builtin_memcpy(shines.data() + first, &lit, sizeof lit);
    }
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < kLanes; ++i) bits |= static_cast<std::uint32_t>(shines[i]) & (1U << i);
    out.light.points = bits;
}

}  // namespace

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
    constexpr std::size_t few = 4;
    const bool search = triangles_.size() > few || color_.textured();
    std::array<std::uint32_t, kLanes> indices;
    if (search)
        for (std::size_t i = 0; i < kLanes; ++i) indices[i] = static_cast<std::uint32_t>(triangle_at(u[i]));

    Lanes factor;
    std::array<Lanes, 2> weights;
    dispatch<find_places<FourLanes>, find_places<EightLanes>, find_places<AllLanes>>(
        Places{triangles_, search ? indices.data() : nullptr, two_sided_, static_cast<float>(area_), points,
               u, v},
        FoundPlaces{out, factor, weights});
    if (!color_.textured()) return color_.put(factor, out);
    TexturePoints at{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::array<glm::vec2, 3>& texcoords = texcoords_[indices[i]];
        const glm::vec2 uv = texcoords[0] + weights[0][i] * (texcoords[1] - texcoords[0]) +
                             weights[1][i] * (texcoords[2] - texcoords[0]);
        at.uv[0][i] = uv.x;
        at.uv[1][i] = uv.y;
    }
    color_.put(factor, at, out);
}

}  // namespace nicol
