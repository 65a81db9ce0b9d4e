// SPDX-License-Identifier: MIT
#include "visibility/extent_of_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <vector>

namespace nicol {

namespace {

// Returns whether a triangle has a vertex that counts.
bool any_counts(const glm::uvec3& t, const IsVertex& counts) {
    return counts(t.x) || counts(t.y) || counts(t.z);
}

// Returns the triangles of a mesh with a vertex that counts, both sides of a sheet as one. Empty `counts`:
// all triangles.
std::vector<std::size_t> distinct_triangles(const EdgeBisection& mesh, const IsVertex& counts) {
    using Corners = std::array<std::uint32_t, 3>;
    using Counted = std::pair<Corners, std::size_t>;
    const auto corners_of = [](const glm::uvec3& t) {
        Corners corners{t.x, t.y, t.z};
        std::ranges::sort(corners);
        return corners;
    };
    // Sorted by the first corner, of which few triangles have the same, then by the others.
    std::vector<std::size_t> ends(mesh.positions().size() + 1, 0);
    std::vector<std::size_t> chosen;
    chosen.reserve(mesh.triangles().size());
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        const glm::uvec3& t = mesh.triangles()[i];
        if (counts && !any_counts(t, counts)) continue;
        chosen.push_back(i);
        ++ends[std::min({t.x, t.y, t.z}) + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Counted> counted(chosen.size());
    for (const std::size_t i : chosen) {
        const Corners corners = corners_of(mesh.triangles()[i]);
        counted[ends[corners[0]]++] = {corners, i};
    }
    auto first = counted.begin();
    for (auto last = first; first != counted.end(); first = last) {
        last = std::find_if(first, counted.end(),
                            [first](const Counted& other) { return other.first[0] != first->first[0]; });
        std::sort(first, last);
    }
    std::vector<std::size_t> out;
    out.reserve(counted.size());
    for (std::size_t k = 0; k < counted.size(); ++k)
        if (k == 0 || counted[k].first != counted[k - 1].first) out.push_back(counted[k].second);
    return out;
}

}  // namespace

double extent_of_triangles(const EdgeBisection& mesh, const IsVertex& counts, const IsVertex& known) {
    double area = 0, all = 0, of_known = 0;
    for (const std::size_t i : distinct_triangles(mesh, known ? IsVertex() : counts)) {
        const glm::uvec3& t = mesh.triangles()[i];
        const glm::dvec3 a(mesh.positions()[t.x]);
        const double here = glm::length(glm::cross(glm::dvec3(mesh.positions()[t.y]) - a,
                                                   glm::dvec3(mesh.positions()[t.z]) - a)) /
                            2;
        all += here;
        if (!known || any_counts(t, counts)) area += here;
        if (known && any_counts(t, known)) of_known += here;
    }
    if (known && area > 0) area *= all / of_known;
    return std::sqrt(area);
}

}  // namespace nicol
