// SPDX-License-Identifier: MIT
#include "geometry/graded_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "geometry/edge_bisection.hpp"

namespace nicol {
namespace {

// Edges in units of an object's size and distance: the shortest edges that are divided, and the edges that
// result.
constexpr float kFar = 1000;
constexpr float kGraded = 64;
// Bounds of the work: pairs of a triangle and an object, and added vertices.
constexpr std::size_t kMostPairs = 10'000'000;
constexpr std::size_t kMostAdded = 16384;
constexpr int kRounds = 128;  // two halvings of the largest over the smallest normal float

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(std::span<const glm::vec3> positions, const glm::uvec3& t) {
    return {glm::dvec3(positions[t.x]), glm::dvec3(positions[t.y]), glm::dvec3(positions[t.z])};
}

float longest_edge(const Corners& c) {
    return static_cast<float>(
        std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])}));
}

// Returns the barycentric weights of the point of the segment from a to b nearest to p: of a and b.
glm::dvec2 nearest_on_edge(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
    const glm::dvec3 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
    return {1 - t, t};
}

// Returns the barycentric weights of the point of the triangle nearest to p.
glm::dvec3 nearest_on_triangle(const Corners& c, const glm::dvec3& p) {
    const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double square = glm::dot(normal, normal);
    if (square > 0) {
        const glm::dvec3 weights(glm::dot(glm::cross(c[2] - c[1], p - c[1]), normal) / square,
                                 glm::dot(glm::cross(c[0] - c[2], p - c[2]), normal) / square,
                                 glm::dot(glm::cross(c[1] - c[0], p - c[0]), normal) / square);
        if (std::min({weights.x, weights.y, weights.z}) >= 0) return weights;
    }
    glm::dvec3 best(1, 0, 0);
    double least = glm::distance(c[0], p);
    for (int k = 0; k < 3; ++k) {
        const auto from = static_cast<std::size_t>(k);
        const std::size_t to = (from + 1) % 3;
        const glm::dvec2 of_edge = nearest_on_edge(c[from], c[to], p);
        const double distance = glm::distance(of_edge.x * c[from] + of_edge.y * c[to], p);
        if (distance >= least) continue;
        least = distance;
        best = glm::dvec3(0);
        best[k] = of_edge.x;
        best[(k + 1) % 3] = of_edge.y;
    }
    return best;
}

std::vector<WantedLength> wanted_lengths(const Mesh& mesh, std::span<const Ball> details) {
    std::vector<std::pair<float, std::uint32_t>> large;
    const float least = kFar * details.front().radius;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const float longest = longest_edge(corners_of(mesh.positions, mesh.triangles[i]));
        if (longest > least) large.emplace_back(longest, i);
    }
    std::ranges::stable_sort(large, std::greater(), &std::pair<float, std::uint32_t>::first);
    if (const std::size_t most = kMostPairs / details.size(); large.size() > most) large.resize(most);
    std::vector<WantedLength> wanted;
    for (const auto& [longest, triangle] : large) {
        const Corners corners = corners_of(mesh.positions, mesh.triangles[triangle]);
        for (const Ball& detail : details) {
            if (!(longest > kFar * detail.radius)) break;  // later details are larger
            const glm::dvec3 centre(detail.centre);
            const glm::dvec3 weights = nearest_on_triangle(corners, centre);
            const glm::dvec3 nearest =
                weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
            const float size = std::max(detail.radius, static_cast<float>(glm::distance(nearest, centre)));
            if (longest > kFar * size)
                wanted.push_back(
                    {.triangle = triangle, .weights = glm::vec3(weights), .length = kGraded * size});
        }
    }
    return wanted;
}

void divide(EdgeBisection& parts, std::vector<WantedLength> wanted) {
    const std::size_t most = parts.positions().size() + kMostAdded;
    for (int round = 0; round < kRounds; ++round) {
        EdgeBisection::Edges edges;
        for (const WantedLength& point : wanted) {
            const glm::uvec3& t = parts.triangles()[point.triangle];
            if (longest_edge(corners_of(parts.positions(), t)) > point.length) edges.insert(parts.longest(t));
        }
        if (edges.empty()) return;
        parts.close(edges);
        if (parts.positions().size() + parts.cost(edges) > most) return;
        parts.split(edges, wanted);
    }
}

template <class Value>
void append_means(std::vector<Value>& values, std::span<const glm::uvec2> parents) {
    if (values.empty()) return;
    for (const glm::uvec2& pair : parents) values.push_back(0.5F * values[pair.x] + 0.5F * values[pair.y]);
}

// Returns the mesh divided into these parts.
Mesh divided(const Mesh& mesh, const EdgeBisection& bisection) {
    Mesh out = mesh;
    out.positions = bisection.positions();
    out.triangles = bisection.triangles();
    append_means(out.colors, bisection.parents());
    for (const glm::uvec2& pair : bisection.parents()) {
        const glm::vec3 mean = 0.5F * out.normals[pair.x] + 0.5F * out.normals[pair.y];
        const float length = glm::length(mean);
        out.normals.push_back(length > 1e-6F ? mean / length : out.normals[pair.x]);
    }
    if (!mesh.face_colors.empty()) {
        out.face_colors.clear();
        for (const std::uint32_t source : bisection.sources())
            out.face_colors.push_back(mesh.face_colors[source]);
    }
    if (mesh.texcoords.empty()) return out;
    out.texcoord_triangles.clear();
    const auto mean = [](const auto& values, const glm::uvec3& of, const glm::vec3& w) {
        return w.x * values[of.x] + w.y * values[of.y] + w.z * values[of.z];
    };
    for (const TrianglePart& part : triangle_parts(mesh.triangles, mesh.positions.size(), bisection.parents(),
                                                   bisection.triangles(), bisection.sources())) {
        const glm::uvec3& of = mesh.texcoord_triangles[part.source];
        glm::uvec3 corners;
        for (glm::length_t k = 0; k < 3; ++k) {
            const glm::vec3& w = part.corners[static_cast<std::size_t>(k)];
            corners[k] = static_cast<std::uint32_t>(out.texcoords.size());
            out.texcoords.push_back(mean(mesh.texcoords, of, w));
            if (!mesh.tangents.empty()) out.tangents.push_back(mean(mesh.tangents, of, w));
        }
        out.texcoord_triangles.push_back(corners);
    }
    return out;
}

auto order_of(const Ball& ball) {
    return std::tuple(ball.radius, ball.centre.x, ball.centre.y, ball.centre.z);
}

}  // namespace

MeshExtent extent_of(const Mesh& mesh) {
    MeshExtent extent{.ball = ball_around(mesh.positions), .box = {}, .detail = {}, .longest = 0};
    extent.box.add(mesh, glm::dmat4(1));
    std::vector<float> longest;
    longest.reserve(mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        longest.push_back(longest_edge(corners_of(mesh.positions, t)));
        extent.longest = std::max(extent.longest, longest.back());
    }
    std::vector<glm::vec3> small;
    for (std::size_t i = 0; i < longest.size(); ++i) {
        if (kFar * longest[i] >= extent.longest) continue;
        const glm::uvec3& t = mesh.triangles[i];
        small.insert(small.end(), {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    }
    extent.detail = small.empty() ? extent.ball : ball_around(small);
    return extent;
}

Details::Details(std::span<const MeshExtent> extents) {
    float longest = 0;
    for (const MeshExtent& extent : extents) longest = std::max(longest, extent.longest);
    for (const MeshExtent& extent : extents)
        if (extent.detail.radius > 0 && longest > kFar * extent.detail.radius)
            sorted_.push_back(extent.detail);
    std::ranges::sort(sorted_, {}, order_of);
}

std::vector<Ball> Details::beside(const MeshExtent& mesh) const {
    std::vector<Ball> out;
    const float reach = mesh.ball.radius + mesh.longest / kFar;
    for (const Ball& detail : sorted_) {
        if (!(mesh.longest > kFar * detail.radius)) break;
        if (glm::distance(detail.centre, mesh.ball.centre) <= reach) out.push_back(detail);
    }
    return out;
}

std::shared_ptr<const Mesh> graded(const Mesh& mesh, std::span<const Ball> details) {
    if (details.empty()) return nullptr;
    std::vector<WantedLength> wanted = wanted_lengths(mesh, details);
    if (wanted.empty()) return nullptr;
    EdgeBisection parts(mesh.positions, mesh.triangles);
    divide(parts, std::move(wanted));
    return std::make_shared<const Mesh>(divided(mesh, parts));
}

}  // namespace nicol
