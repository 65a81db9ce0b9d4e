// SPDX-License-Identifier: MIT
#include "visibility/possible_blockers.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

constexpr std::size_t kLeafTriangles = 8;           // most triangles of a leaf
constexpr std::size_t kSerialTriangles = 1U << 12;  // triangles that one thread divides
constexpr double kSmallNode = 0.35;                 // sine of the angle of nodes that are not looked into
// Sine of elevation of what cannot block: half of what the lowest traced rays have.
constexpr double kBlockerGrazing = 0x1p-18;
// Nodes and cones of a point from which on tracing its rays is cheaper than finding the blocked ones.
constexpr int kMostBlockerNodes = 2048;
constexpr int kMostBlockerCones = 48;
// Margin of radii against rounding, relative to the distance.
constexpr double kRadiusSlack = 1e-4;

// Depth from which on nodes are halved by number, which bounds the depth of the tree.
constexpr int kDeep = 30;

FlatBlockers flat_blockers(const BakeGeometry& geometry) {
    const std::span triangles = geometry.blocking.empty() ? geometry.triangles : geometry.blocking;
    return geometry.every_ray || geometry.present ? FlatBlockers(triangles)
                                                  : FlatBlockers(geometry.positions, triangles);
}

}  // namespace

PossibleBlockers::PossibleBlockers(const BakeGeometry& geometry, const DirectionSet& directions, bool find)
    : directions_(directions), finds_(find), flat_(flat_blockers(geometry)), cones_(directions) {
    if (!finds_) return;
    positions_.assign(geometry.positions.begin(), geometry.positions.end());
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : flat_.other_triangles())
        if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(t);
    if (geometry.glass)
        triangles.insert(triangles.end(), geometry.glass->triangles.begin(), geometry.glass->triangles.end());
    if (triangles.empty()) return;
    corners_.resize(3 * triangles.size());
    build(triangles, 0, 0, nodes_);
}

void PossibleBlockers::build(std::span<glm::uvec3> triangles, std::size_t first, int depth,
                             std::vector<Node>& nodes) {
    const std::size_t place = nodes.size();
    nodes.push_back(bound(triangles));
    if (triangles.size() <= kLeafTriangles) {
        const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(first);
        auto end = begin;
        for (const glm::uvec3& t : triangles)
            for (glm::length_t k = 0; k < 3; ++k) *end++ = t[k];
        std::sort(begin, end);
        nodes[place].first = static_cast<std::uint32_t>(first);
        nodes[place].last = static_cast<std::uint32_t>(std::unique(begin, end) - corners_.begin());
        return;
    }
    const std::size_t half = divide(triangles, depth);
    const auto build_left = [&](std::vector<Node>& to) {
        build(triangles.first(half), first, depth + 1, to);
    };
    const auto build_right = [&](std::vector<Node>& to) {
        build(triangles.subspan(half), first + 3 * half, depth + 1, to);
    };
    if (triangles.size() < kSerialTriangles) {
        build_left(nodes);
        nodes[place].right = static_cast<std::uint32_t>(nodes.size() - place);
        build_right(nodes);
        return;
    }
    std::vector<Node> left, right;
    tbb::parallel_invoke([&] { build_left(left); }, [&] { build_right(right); });
    nodes[place].right = static_cast<std::uint32_t>(1 + left.size());
    nodes.insert(nodes.end(), left.begin(), left.end());
    nodes.insert(nodes.end(), right.begin(), right.end());
}

std::size_t PossibleBlockers::divide(std::span<glm::uvec3> triangles, int depth) const {
    const auto middle_of = [this](const glm::uvec3& t) {
        return positions_[t.x] + positions_[t.y] + positions_[t.z];
    };
    glm::dvec3 least(middle_of(triangles[0]));
    glm::dvec3 most = least;
    for (const glm::uvec3& t : triangles) {
        least = glm::min(least, middle_of(t));
        most = glm::max(most, middle_of(t));
    }
    const glm::dvec3 size = most - least;
    const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    // Halves of space keep objects that are far from each other apart.
    const double border = 0.5 * (least[axis] + most[axis]);
    const auto lower = [&](const glm::uvec3& t) { return middle_of(t)[axis] < border; };
    const auto upper = std::partition(triangles.begin(), triangles.end(), lower);
    const auto count = static_cast<std::size_t>(upper - triangles.begin());
    if (depth < kDeep && count > 0 && count < triangles.size()) return count;
    const std::size_t half = triangles.size() / 2;
    std::nth_element(
        triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
        [&](const glm::uvec3& a, const glm::uvec3& b) { return middle_of(a)[axis] < middle_of(b)[axis]; });
    return half;
}

PossibleBlockers::Node PossibleBlockers::bound(std::span<const glm::uvec3> triangles) const {
    glm::dvec3 least(positions_[triangles[0].x]);
    glm::dvec3 most = least;
    glm::dvec3 normals(0);
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 normal =
            glm::cross(positions_[t.y] - positions_[t.x], positions_[t.z] - positions_[t.x]);
        // The second sides of two-sided triangles have the opposite normal.
        normals += glm::dot(normals, normal) < 0 ? -normal : normal;
        for (glm::length_t k = 0; k < 3; ++k) {
            least = glm::min(least, positions_[t[k]]);
            most = glm::max(most, positions_[t[k]]);
        }
    }
    const double length = glm::length(normals);
    Node node{.centre = 0.5 * (least + most), .axis = length > 0 ? normals / length : glm::dvec3(0, 0, 1)};
    double square = 0;  // of the radius
    for (const glm::uvec3& t : triangles)
        for (glm::length_t k = 0; k < 3; ++k) {
            const glm::dvec3 from = positions_[t[k]] - node.centre;
            const double along = glm::dot(from, node.axis);
            square = std::max(square, glm::dot(from, from));
            node.lowest = std::min(node.lowest, along);
            node.highest = std::max(node.highest, along);
        }
    node.radius = std::sqrt(square);
    return node;
}

bool PossibleBlockers::above(const Node& node, const glm::dvec3& origin, const glm::dvec3& normal) const {
    const glm::dvec3 to = node.centre - origin;
    // Directions up to this height above the horizon have too little elevation, or lie below it.
    const double most = kBlockerGrazing * std::max(0.0, glm::length(to) - node.radius);
    const double cosine = glm::dot(normal, node.axis);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double height = glm::dot(normal, to);
    if (height + cosine * (cosine < 0 ? node.lowest : node.highest) + sine * node.radius <= most)
        return false;
    if (node.right != 0) return true;
    for (std::uint32_t i = node.first; i < node.last; ++i)
        if (glm::dot(normal, positions_[corners_[i]] - origin) > most) return true;
    return false;
}

bool PossibleBlockers::find(const glm::vec3& origin, const glm::vec3& normal,
                            std::span<const FlatBlockers::Cone> faces,
                            std::vector<std::uint16_t>& bits) const {
    bits.assign(cones_.bundles(), 0);
    for (std::size_t b = 0; b < bits.size() && !faces.empty(); ++b)
        bits[b] = FlatBlockers::reaching(faces, directions_.bundles()[b]);
    if (nodes_.empty()) return true;
    const glm::dvec3 from(origin);
    const glm::dvec3 up = glm::normalize(glm::dvec3(normal));
    std::array<std::uint32_t, 64> stack{};  // a balanced tree of 2^32 triangles is no deeper
    std::size_t left = 1;
    int nodes = 0;
    int cones = 0;
    while (left > 0) {
        const std::uint32_t place = stack[--left];
        const Node& node = nodes_[place];
        if (++nodes > kMostBlockerNodes) return false;
        if (!above(node, from, up)) continue;
        const glm::dvec3 to = node.centre - from;
        const double distance = glm::length(to);
        const double radius = node.radius + kRadiusSlack * (distance + node.radius);
        // A node whose middle is below the horizon may be there as a whole.
        if (node.right != 0 && (!(radius < kSmallNode * distance) || glm::dot(up, to) <= 0)) {
            // The nearer half comes first, because most rays of a point beside what is above it may be
            // blocked.
            const std::array halves{place + 1, place + node.right};
            const bool second =
                glm::distance(nodes_[halves[1]].centre, from) < glm::distance(nodes_[halves[0]].centre, from);
            stack[left++] = halves[second ? 0 : 1];
            stack[left++] = halves[second ? 1 : 0];
            continue;
        }
        if (!(radius < distance) || ++cones > kMostBlockerCones) return false;
        cones_.add(glm::vec3(to / distance), static_cast<float>(radius / distance), bits);
    }
    return true;
}

RayCounts PossibleBlockers::trace(const BakeRays& scene, const glm::vec3& origin, const glm::vec3& normal,
                                  std::size_t vertex, const std::optional<FormerBits>& former,
                                  Visibility& visibility) const {
    DisturbedBundles possible;
    thread_local std::vector<FlatBlockers::Cone> faces;
    const bool all_faces = flat_.find(origin, normal, faces);
    if (former || !finds_ || !all_faces || !find(origin, normal, faces, possible.may_close))
        return trace_vertex(scene, directions_, origin, normal, vertex, former, faces, visibility);
    const std::uint64_t above = set_open(directions_, normal, vertex, visibility);
    if (std::ranges::all_of(possible.may_close, [](std::uint16_t rays) { return rays == 0; }))
        return {.skipped = above};
    const std::span words = visibility.at(vertex);
    const std::vector<std::uint64_t> open(words.begin(), words.end());
    std::ranges::fill(words, 0U);
    possible.may_open.resize(possible.may_close.size());
    const FormerBits known{.bits = open, .disturbed = &possible, .unoccluded = true};
    const std::uint64_t traced =
        trace_vertex(scene, directions_, origin, normal, vertex, known, faces, visibility).traced;
    return {.traced = traced, .skipped = above - traced};
}

std::shared_ptr<const PossibleBlockers> possible_blockers_of(const BakeGeometry& geometry,
                                                             const DirectionSet& directions, bool find) {
    if (find && geometry.possible_blockers) return geometry.possible_blockers();
    return std::make_shared<const PossibleBlockers>(geometry, directions, find);
}

}  // namespace nicol
