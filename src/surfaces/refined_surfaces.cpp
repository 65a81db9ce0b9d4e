// SPDX-License-Identifier: MIT
#include "surfaces/refined_surfaces.hpp"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "geometry/key_table.hpp"
#include "geometry/position_hash.hpp"

namespace nicol {
namespace {

template <class Value>
std::vector<std::array<Value, 3>> of_parts(const std::vector<std::array<Value, 3>>& given,
                                           std::span<const TrianglePart> parts) {
    std::vector<std::array<Value, 3>> out;
    if (given.empty()) return out;
    out.reserve(parts.size());
    for (const TrianglePart& part : parts) {
        const std::array<Value, 3>& from = given[part.source];
        const auto at = [&](const glm::vec3& w) { return w.x * from[0] + w.y * from[1] + w.z * from[2]; };
        out.push_back({at(part.corners[0]), at(part.corners[1]), at(part.corners[2])});
    }
    return out;
}

// Returns the number of vertices in reserve for a range with this many added vertices: at most fifteen, or a
// part in 32.
std::uint32_t reserve(std::uint32_t added) {
    const std::uint32_t step = std::max(16U, std::bit_floor(added) / 32);
    return (step - added % step) % step;
}

}  // namespace

RefinedGeometry refined(const WorldGeometry& geometry, const Refinement& refinement,
                        std::uint64_t most_vertices) {
    // Vertices in the refinement's order: the given vertices, then the added vertices.
    std::vector<glm::vec3> positions = geometry.positions;
    std::vector<glm::vec3> normals = geometry.normals;
    std::vector<std::uint32_t> range_of(positions.size());
    for (std::uint32_t r = 0; r < geometry.ranges.size(); ++r) {
        const VertexRange& range = geometry.ranges[r];
        std::fill(range_of.begin() + static_cast<std::ptrdiff_t>(range.first),
                  range_of.begin() + static_cast<std::ptrdiff_t>(range.last), r);
    }
    for (const glm::uvec2& parents : refinement.parents) {
        positions.push_back(0.5F * positions[parents.x] + 0.5F * positions[parents.y]);
        const glm::vec3 normal = 0.5F * normals[parents.x] + 0.5F * normals[parents.y];
        normals.push_back(glm::dot(normal, normal) > 1e-12F ? normal : normals[parents.x]);
        range_of.push_back(range_of[parents.x]);
    }
    for (std::size_t v = geometry.normals.size(); v < normals.size(); ++v)
        normals[v] = glm::normalize(normals[v]);

    // Vertices are sorted by range.
    std::vector<std::uint32_t> counts(geometry.ranges.size(), 0);
    for (const std::uint32_t r : range_of) ++counts[r];
    std::vector<std::uint32_t> reserves;
    for (std::size_t r = 0; r < counts.size(); ++r) {
        const VertexRange& range = geometry.ranges[r];
        reserves.push_back(reserve(counts[r] - static_cast<std::uint32_t>(range.last - range.first)));
    }
    const std::uint64_t wanted =
        std::accumulate(reserves.begin(), reserves.end(), std::uint64_t{positions.size()});
    if (wanted > most_vertices) std::ranges::fill(reserves, 0U);
    std::vector<std::uint32_t> next{0};  // number of a range's next vertex
    for (std::size_t r = 0; r < counts.size(); ++r) next.push_back(next[r] + counts[r] + reserves[r]);
    const std::size_t vertices = next.back();
    WorldGeometry out;
    for (std::size_t r = 0; r < geometry.ranges.size(); ++r) {
        VertexRange range = geometry.ranges[r];
        range.first = next[r];
        range.last = next[r + 1];
        out.ranges.push_back(std::move(range));
    }
    std::vector<std::uint32_t> number(positions.size());
    std::vector<std::uint32_t> sources(vertices);
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        number[v] = next[range_of[v]]++;
        sources[number[v]] = v;
    }
    for (std::size_t r = 0; r < counts.size(); ++r) {
        for (std::uint32_t i = 0; i < reserves[r]; ++i) sources[next[r] + i] = sources[next[r] - 1];
    }
    for (const std::uint32_t source : sources) {
        out.positions.push_back(positions[source]);
        out.normals.push_back(normals[source]);
    }
    out.triangles.reserve(refinement.triangles.size());
    for (const glm::uvec3& t : refinement.triangles)
        out.triangles.emplace_back(number[t.x], number[t.y], number[t.z]);
    const auto two_sided = std::ranges::lower_bound(refinement.sources, geometry.one_sided);
    out.one_sided = static_cast<std::size_t>(two_sided - refinement.sources.begin());
    return {.geometry = std::move(out),
            .visibility =
                refinement.visibility.vertices() > 0 ? refinement.visibility.selected(sources) : Visibility(),
            .parts = triangle_parts(geometry.triangles, geometry.positions.size(), refinement.parents,
                                    refinement.triangles, refinement.sources),
            .numbers = {.numbers = std::move(number), .sources = std::move(sources)}};
}

RefinedSurfaces::Change RefinedSurfaces::change_to(const SceneGeometry& surfaces, const WorldGeometry& next,
                                                   std::span<const std::uint32_t> numbers) const {
    const WorldGeometry& last = *geometry_;
    const std::size_t vertices = next.normals.size();
    Change out{.before = version_,
               .former = std::vector<std::uint32_t>(vertices, kNoVertex),
               .same_places = std::vector<std::uint8_t>(vertices, 0)};
    const auto pair = [&](std::size_t v, std::size_t former) {
        if (out.former[v] != kNoVertex || former >= last.normals.size()) return;
        if (last.normals[former] != next.normals[v]) return;
        out.former[v] = static_cast<std::uint32_t>(former);
        out.same_places[v] = last.positions[former] == next.positions[v] ? 1 : 0;
    };
    const auto numbered = [](std::span<const std::uint32_t> as, std::size_t v) {
        return as.empty() ? v : std::size_t{as[v]};
    };
    const std::size_t given = surfaces.geometry().normals.size();
    const VertexRun all{.first = 0, .last = given, .before = 0};
    std::span<const VertexRun> kept;
    if (surfaces.version() == given_version_)
        kept = {&all, 1};
    else if (surfaces.change().before == given_version_)
        kept = surfaces.change().kept;
    for (const VertexRun& run : kept) {
        for (std::size_t v = run.first; v < run.last; ++v)
            pair(numbered(numbers, v), numbered(numbers_, run.before + (v - run.first)));
    }
    KeyTable<std::uint32_t> added;  // by hash of position and normal
    const auto hash = [](const WorldGeometry& geometry, std::uint32_t v) {
        return geometry::hash_of(geometry.positions[v], geometry.normals[v]);
    };
    for (std::size_t i = given_; i < numbers_.size(); ++i)
        added.try_emplace(hash(last, numbers_[i]), numbers_[i]);
    for (std::size_t i = given; i < numbers.size(); ++i) {
        const std::uint32_t* const former = added.find(hash(next, numbers[i]));
        if (former != nullptr && last.positions[*former] == next.positions[numbers[i]])
            pair(numbers[i], *former);
    }
    // A vertex in reserve equals the vertex before it.
    const auto equal = [&next](const WorldGeometry& geometry, std::size_t v, std::size_t other) {
        return geometry.positions[v] == next.positions[other] && geometry.normals[v] == next.normals[other];
    };
    for (std::size_t v = 1; v < vertices; ++v) {
        const std::uint32_t former = out.former[v - 1];
        if (former == kNoVertex || !equal(next, v, v - 1)) continue;
        const std::uint32_t following = former + 1;
        pair(v, following < last.positions.size() && equal(last, following, v) ? following : former);
    }
    for (std::size_t v = 0; v < vertices; ++v) pair(v, v);
    return out;
}

void RefinedSurfaces::update(const SceneGeometry& surfaces, const std::shared_ptr<WorldGeometry>& refined,
                             std::span<const TrianglePart> parts, std::span<const std::uint32_t> numbers) {
    to_world_ = surfaces.to_world();
    const WorldGeometry& given = surfaces.geometry();
    if (refined && (refined != geometry_ || corners_ != surfaces.material_version())) {
        for (std::size_t r = 0; r < refined->ranges.size(); ++r) {
            refined->ranges[r].material = given.ranges[r].material;
            refined->ranges[r].emission = given.ranges[r].emission;
        }
        refined->texcoords = of_parts(given.texcoords, parts);
        refined->colors = of_parts(given.colors, parts);
        refined->tangents = of_parts(given.tangents, parts);
        corners_ = surfaces.material_version();
    }
    const std::shared_ptr<const WorldGeometry> next = refined ? refined : surfaces.shared_geometry();
    if (next != geometry_) {
        change_ = change_to(surfaces, *next, refined ? numbers : std::span<const std::uint32_t>());
        given_version_ = surfaces.version();
        given_ = given.normals.size();
        numbers_.clear();
        if (refined) numbers_.assign(numbers.begin(), numbers.end());
        geometry_ = next;
        version_ = new_version();
    }
    if (ranges_ != geometry_->ranges) {
        ranges_ = geometry_->ranges;
        material_version_ = new_version();
    }
}

}  // namespace nicol
