// SPDX-License-Identifier: MIT
#include "visibility/flat_blockers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "geometry/largest_coordinate.hpp"
#include "simd/dispatch.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

constexpr std::size_t kMostFaces = 16;
// Smallest area of a face, relative to the square of the geometry's extent.
constexpr double kLeastArea = 1.0 / 256;
// Largest number of edges on the border of a face.
constexpr std::size_t kMostBorderEdges = 1024;
// Tolerance for points beside the line of an edge, relative to the face's extent: rounding of positions.
constexpr double kStraight = 1e-5;
// Smallest sine of the angle between a ray and the planes of a cone.
constexpr float kMargin = 1e-3F;
// Smallest height of a point above a face, relative to the largest coordinate of both.
constexpr double kLeastHeight = 0x1p-14;

// Disjoint sets of vertices that triangles connect.
class ConnectedVertices {
public:
    explicit ConnectedVertices(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0U);
    }
    void connect(std::uint32_t a, std::uint32_t b) { parents_[set_of(a)] = set_of(b); }
    std::uint32_t set_of(std::uint32_t v) {
        while (parents_[v] != v) v = parents_[v] = parents_[parents_[v]];
        return v;
    }

private:
    std::vector<std::uint32_t> parents_;
};

}  // namespace

FlatBlockers::FlatBlockers(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
    others_.assign(triangles.begin(), triangles.end());
    if (positions.empty()) return;
    glm::dvec3 least(positions[0]), most = least;
    for (const glm::vec3& p : positions) {
        least = glm::min(least, glm::dvec3(p));
        most = glm::max(most, glm::dvec3(p));
    }
    ConnectedVertices connected(positions.size());
    for (const glm::uvec3& t : triangles) {
        connected.connect(t.x, t.y);
        connected.connect(t.x, t.z);
    }
    // Triangles are in one plane if the sum of their areas is the length of the sum of their normals.
    struct Part {
        double area = 0;
        glm::dvec3 normal{0.0};
    };
    std::vector<Part> parts(positions.size());
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a(positions[t.x]);
        const glm::dvec3 normal =
            0.5 * glm::cross(glm::dvec3(positions[t.y]) - a, glm::dvec3(positions[t.z]) - a);
        Part& part = parts[connected.set_of(t.x)];
        part.area += glm::length(normal);
        part.normal += normal;
    }
    const double wanted = kLeastArea * glm::dot(most - least, most - least);
    std::vector<std::pair<double, std::uint32_t>> flat;
    for (std::uint32_t v = 0; v < parts.size(); ++v) {
        const Part& part = parts[v];
        if (part.area > wanted && glm::length(part.normal) > (1 - 1e-9) * part.area)
            flat.emplace_back(part.area, v);
    }
    if (flat.empty()) return;
    std::ranges::sort(flat, std::greater());
    flat.resize(std::min(flat.size(), kMostFaces));
    std::vector<std::vector<glm::uvec3>> faces(flat.size());
    for (const glm::uvec3& t : triangles) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        const auto found =
            std::ranges::find(flat, connected.set_of(t.x), &std::pair<double, std::uint32_t>::second);
        if (found != flat.end()) faces[static_cast<std::size_t>(found - flat.begin())].push_back(t);
    }
    std::vector<std::uint32_t> added;
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (add(positions, faces[i])) added.push_back(flat[i].second);
    std::erase_if(others_, [&](const glm::uvec3& t) {
        return std::ranges::find(added, connected.set_of(t.x)) != added.end();
    });
}

bool FlatBlockers::add(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
    Face face;
    std::unordered_set<std::uint64_t> directed;
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a(positions[t.x]);
        face.normal += glm::cross(glm::dvec3(positions[t.y]) - a, glm::dvec3(positions[t.z]) - a);
        for (glm::length_t k = 0; k < 3; ++k) directed.insert(std::uint64_t{t[k]} << 32U | t[(k + 1) % 3]);
    }
    if (directed.size() != 3 * triangles.size()) return false;  // an edge of two triangles on one side
    face.normal = glm::normalize(face.normal);
    std::vector<std::array<glm::dvec3, 2>> border;
    for (const std::uint64_t edge : directed) {
        if (directed.contains(edge << 32U | edge >> 32U)) continue;
        border.push_back({glm::dvec3(positions[edge >> 32U]), glm::dvec3(positions[edge & 0xFFFFFFFFU])});
    }
    if (border.empty() || border.size() > kMostBorderEdges) return false;
    // If all points lie to the left of all edges on the border, then the border is that of a convex polygon,
    // and every point inside it is covered as often as every other.
    glm::dvec3 least = border[0][0], most = least;
    for (const auto& [a, b] : border) {
        least = glm::min(least, a);
        most = glm::max(most, a);
    }
    const double tolerance = kStraight * glm::length(most - least);
    for (const auto& [a, b] : border) {
        const glm::dvec3 along = glm::normalize(b - a);
        const glm::dvec3 left = glm::cross(face.normal, along);
        std::array<glm::dvec3, 2> line{a, b};
        for (const auto& [p, unused] : border) {
            const double beside = glm::dot(left, p - a);
            if (beside < -tolerance) return false;
            if (beside > tolerance) continue;
            if (glm::dot(along, p - line[0]) < 0) line[0] = p;
            if (glm::dot(along, p - line[1]) > 0) line[1] = p;
        }
        face.middle += a / static_cast<double>(border.size());
        face.size = std::max(face.size, largest_coordinate(a));
        const auto edges = std::span(face.edges).first(face.count);
        if (std::ranges::find(edges, line) != edges.end()) continue;
        if (face.count == kMostEdges) return false;
        face.edges[face.count++] = line;
    }
    for (const Face& other : faces_)
        if (glm::distance(other.middle, face.middle) <= tolerance &&
            std::abs(glm::dot(other.normal, face.normal)) > 1 - kStraight)
            return true;  // the other side of a two-sided face
    faces_.push_back(face);
    return true;
}

bool FlatBlockers::find(const glm::vec3& origin, const glm::vec3& normal, std::vector<Cone>& cones) const {
    cones.clear();
    const glm::dvec3 from(origin);
    bool all = true;
    for (const Face& face : faces_) {
        const bool above =
            std::ranges::any_of(std::span(face.edges).first(face.count), [&](const auto& edge) {
                return glm::dot(glm::dvec3(normal), edge[0] - from) > 0 ||
                       glm::dot(glm::dvec3(normal), edge[1] - from) > 0;
            });
        if (!above) continue;
        const double height = glm::dot(face.normal, from - face.middle);
        if (std::abs(height) <= kLeastHeight * std::max(face.size, largest_coordinate(from))) {
            all = false;
            continue;
        }
        Cone& cone = cones.emplace_back(Cone{.count = face.count});
        for (std::size_t i = 0; i < face.count; ++i) {
            const glm::dvec3 a = face.edges[i][0] - from;
            const glm::dvec3 b = face.edges[i][1] - from;
            cone.normals[i] = glm::vec3(glm::normalize(height > 0 ? glm::cross(b, a) : glm::cross(a, b)));
        }
    }
    return all;
}

std::uint16_t FlatBlockers::reaching(std::span<const Cone> cones, const RayBundle& bundle) {
    unsigned any = 0;
    for (const Cone& cone : cones) {
        unsigned inside = 0xFFFF;
        for (std::size_t i = 0; i < cone.count && inside != 0; ++i)
            inside &= dispatch<rays_above>(bundle, cone.normals[i], -kMargin);
        any |= inside;
    }
    return static_cast<std::uint16_t>(any);
}

std::uint16_t FlatBlockers::blocked(std::span<const Cone> cones, const RayBundle& bundle,
                                    std::uint16_t rays) {
    std::uint16_t left = rays;
    for (const Cone& cone : cones) {
        std::uint16_t inside = left;
        for (std::size_t i = 0; i < cone.count && inside != 0; ++i)
            inside =
                static_cast<std::uint16_t>(inside & dispatch<rays_above>(bundle, cone.normals[i], kMargin));
        left = static_cast<std::uint16_t>(left & ~inside);
        if (left == 0) break;
    }
    return static_cast<std::uint16_t>(rays & ~left);
}

}  // namespace nicol
