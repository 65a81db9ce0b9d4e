// SPDX-License-Identifier: MIT
#include "shading/surface_source.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "shading/spherical_triangle.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

using Patch = SurfaceSource::Patch;

/// The patches of the light samples.
template <class Number>
struct Chosen {
    Vector3<Number> corner, first, second, normal;
    Number before, scale, parallelogram;
};

template <class Number, class Mask>
[[gnu::always_inline]] inline void replace(const Mask& where, const glm::vec3& by, Vector3<Number>& v) {
    v = {where ? Number{} + by.x : v.x, where ? Number{} + by.y : v.y, where ? Number{} + by.z : v.z};
}

/// Finds the patches of samples by comparing u with all patches, which suits few patches. u chooses the
/// patch, and its remainder a point on the patch, so neighbours in u are neighbours on the surface.
template <class Number>
[[gnu::always_inline]] inline void choose(std::span<const Patch> patches, const Number& u,
                                          Chosen<Number>& out) {
    for (const Patch& patch : patches) {
        const auto here = u >= patch.before;
        replace(here, patch.corner, out.corner);
        replace(here, patch.first, out.first);
        replace(here, patch.second, out.second);
        replace(here, patch.normal, out.normal);
        out.before = here ? Number{} + patch.before : out.before;
        out.scale = here ? Number{} + patch.scale : out.scale;
        out.parallelogram = here ? Number{} + patch.parallelogram : out.parallelogram;
    }
}

/// Loads the patches of samples whose patch indices are known.
template <class Number>
[[gnu::always_inline]] inline void choose(std::span<const Patch> patches, const std::uint32_t* indices,
                                          Chosen<Number>& out) {
    for (std::size_t i = 0; i < kPart<Number>; ++i) {
        const Patch& patch = patches[indices[i]];
        const auto put = [i](const glm::vec3& from, Vector3<Number>& to) {
            to.x[i] = from.x;
            to.y[i] = from.y;
            to.z[i] = from.z;
        };
        put(patch.corner, out.corner);
        put(patch.first, out.first);
        put(patch.second, out.second);
        put(patch.normal, out.normal);
        out.before[i] = patch.before;
        out.scale[i] = patch.scale;
        out.parallelogram[i] = patch.parallelogram;
    }
}

struct PatchSamples {
    std::span<const Patch> patches;
    const std::uint32_t* indices;  // patch of each sample; null: to be found
    bool two_sided;
    float area;
    const LaneVectors& points;
    const Lanes& u;
    const Lanes& v;
};

struct FoundPatchSamples {
    LaneLight& light;
    Lanes& factor;
    std::array<Lanes, 2>& weights;  // weights of the patches' edges
};

template <class Number>
[[gnu::always_inline]] inline void find_on_patches(const PatchSamples& places, const FoundPatchSamples& out) {
    std::array<std::int32_t, kLanes> emits;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number u, v;
        load_part(places.u, first, u);
        load_part(places.v, first, v);
        Chosen<Number> patch{};
        if (places.indices == nullptr)
            choose(places.patches, u, patch);
        else
            choose(places.patches, places.indices + first, patch);

        Number part = (u - patch.before) * patch.scale;
        part = part > 0.0F ? part : Number{};
        part = part < 1.0F ? part : Number{} + 1.0F;
        Number root = 1.0F - part;
        square_root(root);
        const auto whole = patch.parallelogram > 0.0F;
        const Number b1 = whole ? part : 1.0F - root;
        const Number b2 = whole ? v : v * root;
        store_part(b1, first, out.weights[0]);
        store_part(b2, first, out.weights[1]);

        Vector3<Number> way;
        load_part(places.points, first, way);
        way.x = patch.corner.x + b1 * patch.first.x + b2 * patch.second.x - way.x;
        way.y = patch.corner.y + b1 * patch.first.y + b2 * patch.second.y - way.y;
        way.z = patch.corner.z + b1 * patch.first.z + b2 * patch.second.z - way.z;
        Number distance, across;
        dot(way, way, distance);
        square_root(distance);
        dot(patch.normal, way, across);
        across = -across;
        if (places.two_sided) across = across < 0.0F ? -across : across;
        const auto lit = (across > 0.0F) & (distance > 0.0F);
        const Number scale = lit ? 1.0F / distance : Number{};
        store_part(distance, first, out.light.distance);
        store_part(Vector3<Number>{scale * way.x, scale * way.y, scale * way.z}, first, out.light.towards);
        // The factor of the radiance is the solid angle that the sample represents: area cos / distance^2.
        store_part(Number(places.area * scale * scale * (across * scale)), first, out.factor);
        __builtin_memcpy(emits.data() + first, &lit, sizeof lit);
    }
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < kLanes; ++i) bits |= static_cast<std::uint32_t>(emits[i]) & (1U << i);
    out.light.points = bits;
}

/// Returns the corner opposite the edge that triangles t and t + 1 share if the two triangles make a
/// parallelogram, in texture coordinates and colours too.
std::optional<std::size_t> parallelogram_corner(const EmissiveSurface& surface, std::size_t t) {
    if (t + 1 >= surface.triangles.size()) return std::nullopt;
    const auto completes = [](const auto& one, const auto& other, std::size_t k) {
        const auto b = one[(k + 1) % 3], c = one[(k + 2) % 3], d = b + c - one[k];
        // The other triangle has the corner d and the shared edge in opposite direction.
        constexpr float rounding = 1e-6F;
        const float most =
            std::min(rounding * (glm::length(b) + glm::length(c)), 1e-3F * glm::distance(b, c));
        for (std::size_t i = 0; i < 3; ++i)
            if (other[(i + 1) % 3] == c && other[(i + 2) % 3] == b) return glm::distance(other[i], d) <= most;
        return false;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        if (!completes(surface.triangles[t], surface.triangles[t + 1], k)) continue;
        const auto also = [&](const auto& corners) {
            return corners.empty() || completes(corners[t], corners[t + 1], k);
        };
        if (also(surface.texcoords) && also(surface.colors)) return k;
    }
    return std::nullopt;
}

}  // namespace

SurfaceSource::SurfaceSource(const EmissiveSurface& surface)
    : two_sided_(surface.emission.two_sided),
      color_(surface.emission.radiance, surface.emission.texture, surface.emission.state, surface.axis) {
    struct Area {
        glm::dvec3 normal;  // squares of very small or large edges exceed the range of float
        double own;
    };
    std::vector<Area> areas;
    for (const std::array<glm::vec3, 3>& t : surface.triangles) {
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(t[1]) - glm::dvec3(t[0]), glm::dvec3(t[2]) - glm::dvec3(t[0]));
        const double length = glm::length(normal);
        areas.push_back({normal / length, length / 2});
        area_ += areas.back().own;
    }
    double before = 0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const std::optional<std::size_t> corner = parallelogram_corner(surface, t);
        const std::size_t k = corner.value_or(0);
        const double own = corner ? 2 * areas[t].own : areas[t].own;
        if (own > 0) {
            const std::array<glm::vec3, 3>& corners = surface.triangles[t];
            const glm::vec3 &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
            patches_.push_back({.corner = a,
                                .first = b - a,
                                .second = c - a,
                                .normal = glm::vec3(areas[t].normal),
                                .before = static_cast<float>(before / area_),
                                .scale = static_cast<float>(area_ / own),
                                .parallelogram = corner ? 1.0F : 0.0F});
            const auto add_corners = [&](const auto& from, auto& to) {
                if (!from.empty()) to.push_back({from[t][k], from[t][(k + 1) % 3], from[t][(k + 2) % 3]});
            };
            add_corners(surface.texcoords, texcoords_);
            add_corners(surface.colors, colors_);
            before += own;
            centre_ += static_cast<float>(own / area_) * (corner ? (b + c) / 2.0F : (a + b + c) / 3.0F);
        }
        if (corner) ++t;
    }
    // The size is a power of two, so that the first u of each part is exact.
    guide_.resize(std::bit_ceil(2 * patches_.size()));
    for (std::size_t part = 0; part < guide_.size() && !patches_.empty(); ++part) {
        const float first = static_cast<float>(part) / static_cast<float>(guide_.size());
        const auto after = std::ranges::upper_bound(patches_, first, {}, &Patch::before);
        guide_[part] = static_cast<std::uint32_t>(after - patches_.begin() - 1);
    }
    for (const std::array<glm::vec3, 3>& corners : surface.triangles)
        for (const glm::vec3& corner : corners) radius_ = std::max(radius_, glm::distance(centre_, corner));
    if (surface.mirrored) make_rays();
}

void SurfaceSource::make_rays() {
    std::vector<glm::vec3> corners;
    std::vector<glm::uvec3> triangles;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        triangles.emplace_back(glm::uvec3(0, 1, 2) + static_cast<std::uint32_t>(corners.size()));
        corners.insert(corners.end(), {a, b, c});
    };
    for (const Patch& patch : patches_) {
        const glm::vec3 b = patch.corner + patch.first, c = patch.corner + patch.second;
        add(patch.corner, b, c);
        // The second triangle is the rest of a parallelogram, or has no area if the patch is a triangle.
        if (patch.parallelogram > 0)
            add(b + patch.second, c, b);
        else
            add(b, b, b);
    }
    const RaySurface surface{.positions = corners, .triangles = triangles};
    rays_.emplace(std::span(&surface, 1));
}

std::size_t SurfaceSource::patch_at(float u) const {
    std::size_t index = guide_[static_cast<std::size_t>(u * static_cast<float>(guide_.size()))];
    while (index + 1 < patches_.size() && patches_[index + 1].before <= u) ++index;
    return index;
}

void SurfaceSource::put_texture_point(std::size_t patch, float b1, float b2, std::size_t lane,
                                      TexturePoints& out) const {
    const auto put = [&](const auto& of_patches, auto& to) {
        if (of_patches.empty()) return;
        const auto& corners = of_patches[patch];
        const auto value = corners[0] + b1 * (corners[1] - corners[0]) + b2 * (corners[2] - corners[0]);
        for (std::size_t k = 0; k < to.size(); ++k) to[k][lane] = value[static_cast<glm::length_t>(k)];
    };
    put(texcoords_, out.uv);
    put(colors_, out.color);
}

float SurfaceSource::angular_radius(const glm::vec3& from) const noexcept {
    return angular_radius_of_ball(from, centre_, radius_);
}

float SurfaceSource::brightness(const glm::vec3& from) const noexcept {
    return color_.brightest() * irradiance_of_ball(from, centre_, radius_);
}

void SurfaceSource::sample_near(std::size_t patch, const glm::dvec3& point, double u, double v,
                                std::size_t lane, LaneLight& out, Lanes& factor,
                                std::array<Lanes, 2>& weights) const {
    const Patch& of = patches_[patch];
    const glm::dvec3 first(of.first), second(of.second), corner = glm::dvec3(of.corner) - point;
    const glm::dvec3 far = corner + first + second;
    const double height = -glm::dot(glm::dvec3(of.normal), corner);  // of the point above the patch
    // A point of the light itself lies beside its plane only by rounding. Points of other surfaces at the
    // light's border do by their offset, which is larger, see bake().
    constexpr double rounding = 5e-7;
    const double size = std::max({glm::length(point), glm::length(first), glm::length(second)});
    if (!((two_sided_ ? std::abs(height) : height) > rounding * size)) {
        out.points &= ~(1U << lane);
        return;
    }
    const bool whole = of.parallelogram > 0;
    const SphericalTriangle triangles[] = {
        SphericalTriangle({corner, corner + first, corner + second}),
        SphericalTriangle({far, corner + second, whole ? corner + first : corner + second})};
    const double near = triangles[0].solid_angle(), rest = triangles[1].solid_angle();
    const double part =
        std::clamp((u - static_cast<double>(of.before)) * static_cast<double>(of.scale), 0.0, 1.0) *
        (near + rest);
    const bool on_rest = part > near;
    if (!(near + rest > 0)) return;
    const glm::dvec3 towards =
        on_rest ? triangles[1].sample((part - near) / rest, v) : triangles[0].sample(part / near, v);
    const double approach = -glm::dot(glm::dvec3(of.normal), towards);
    if (!(approach * height > 0)) return;
    const double distance = height / approach;
    const glm::dvec3 place = distance * towards - corner;
    // Coordinates of the place along the edges, from its products with them.
    const double aa = glm::dot(first, first), ab = glm::dot(first, second), bb = glm::dot(second, second);
    const double pa = glm::dot(place, first), pb = glm::dot(place, second);
    const double inverse = 1 / (aa * bb - ab * ab);
    weights[0][lane] = static_cast<float>((pa * bb - pb * ab) * inverse);
    weights[1][lane] = static_cast<float>((pb * aa - pa * ab) * inverse);
    put(out.towards, lane, glm::vec3(towards));
    out.distance[lane] = static_cast<float>(distance);
    factor[lane] = static_cast<float>((near + rest) * static_cast<double>(of.scale));
}

void SurfaceSource::sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const {
    constexpr std::size_t few = 4;
    // Angular radius, in radians, of lights from which the irradiance of equal areas varies.
    constexpr float near = 0.3F;
    const bool close = angular_radius({points.x[0], points.y[0], points.z[0]}) > near;
    const bool search = patches_.size() > few || color_.textured() || close;
    std::array<std::uint32_t, kLanes> indices;
    if (search)
        for (std::size_t i = 0; i < kLanes; ++i) indices[i] = static_cast<std::uint32_t>(patch_at(u[i]));

    Lanes factor;
    std::array<Lanes, 2> weights;
    dispatch<find_on_patches<FourLanes>, find_on_patches<EightLanes>, find_on_patches<AllLanes>>(
        PatchSamples{patches_, search ? indices.data() : nullptr, two_sided_, static_cast<float>(area_),
                     points, u, v},
        FoundPatchSamples{out, factor, weights});
    for (std::size_t i = 0; i < kLanes && close; ++i)
        if ((out.points >> i & 1) != 0)
            sample_near(indices[i], glm::dvec3(vector_at(points, i)), static_cast<double>(u[i]),
                        static_cast<double>(v[i]), i, out, factor, weights);
    if (!color_.textured()) return color_.put(factor, out);
    TexturePoints at{};
    for (std::size_t i = 0; i < kLanes; ++i)
        put_texture_point(indices[i], weights[0][i], weights[1][i], i, at);
    color_.put(factor, at, out);
}

void SurfaceSource::intersect(const LaneVectors& points, const LaneVectors& directions,
                              LaneLight& out) const {
    Lanes one;
    TexturePoints at{};
    out.towards = directions;
    out.points = 0;
    if (!rays_) return;
    for (std::size_t i = 0; i < kLanes; ++i) {
        one[i] = 1;
        const glm::vec3 origin = vector_at(points, i);
        const glm::vec3 direction = vector_at(directions, i);
        const glm::vec3 way = centre_ - origin;
        const glm::vec3 beside = way - glm::dot(way, direction) * direction;
        if (glm::dot(beside, beside) > radius_ * radius_) continue;
        const std::optional<RayHit> hit = rays_->intersect(
            {.origin = glm::dvec3(origin), .direction = glm::normalize(glm::dvec3(direction))});
        if (!hit) continue;
        const std::size_t patch = hit->triangle / 2;
        if (!two_sided_ && !(glm::dot(patches_[patch].normal, direction) < 0)) continue;
        out.points |= 1U << i;
        out.distance[i] = static_cast<float>(hit->distance);
        if (!color_.textured()) continue;
        const bool rest = hit->triangle % 2 != 0;  // whether the hit is measured from the far corner
        const auto b1 = static_cast<float>(rest ? 1 - hit->b1 : hit->b1);
        const auto b2 = static_cast<float>(rest ? 1 - hit->b2 : hit->b2);
        put_texture_point(patch, b1, b2, i, at);
    }
    if (out.points != 0) color_.put(one, at, out);
}

}  // namespace nicol
