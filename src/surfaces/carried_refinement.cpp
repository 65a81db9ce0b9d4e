// SPDX-License-Identifier: MIT
#include "surfaces/carried_refinement.hpp"

#include <algorithm>

namespace nicol {

CarriedRefinement carried(const Refinement& before, std::size_t given, const SceneGeometry& surfaces) {
    const SceneGeometry::Change& change = surfaces.change();
    const WorldGeometry& now = surfaces.geometry();
    const std::size_t vertices = now.positions.size();
    CarriedRefinement out;
    out.former.assign(vertices, kNoVertex);
    out.moved.assign(vertices, kNoVertex);
    // Current index of each vertex of the former refinement.
    std::vector<std::uint32_t> next(given + before.parents.size(), kNoVertex);
    const auto pair = [&](const VertexRun& run) {
        for (std::size_t v = run.first; v < run.last; ++v) {
            const std::size_t former = run.before + (v - run.first);
            out.former[v] = static_cast<std::uint32_t>(former);
            next[former] = static_cast<std::uint32_t>(v);
        }
    };
    for (const VertexRun& run : change.kept) pair(run);
    for (std::size_t r = 0; r < change.moved.size(); ++r) {
        const VertexRun& run = change.moved[r].vertices;
        pair(run);
        for (std::size_t v = run.first; v < run.last; ++v) out.moved[v] = static_cast<std::uint32_t>(r);
    }
    for (std::size_t i = 0; i < before.parents.size(); ++i) {
        const std::uint32_t a = next[before.parents[i].x];
        const std::uint32_t b = next[before.parents[i].y];
        if (a == kNoVertex || b == kNoVertex) continue;
        next[given + i] = static_cast<std::uint32_t>(out.former.size());
        out.former.push_back(static_cast<std::uint32_t>(given + i));
        out.moved.push_back(out.moved[a]);
        out.refinement.parents.emplace_back(a, b);
    }
    if (out.refinement.parents.empty()) return out;

    std::vector<std::uint32_t> sources(now.triangles.size(), kNoVertex);  // former index of each triangle
    for (const VertexRun& run : change.triangles)
        for (std::size_t t = run.first; t < run.last; ++t)
            sources[t] = static_cast<std::uint32_t>(run.before + (t - run.first));
    auto part = before.sources.begin();  // first part of the triangle that follows the last one
    std::uint64_t following = 0;
    for (std::uint32_t t = 0; t < sources.size(); ++t) {
        const std::size_t already = out.refinement.triangles.size();
        if (sources[t] != following)
            part = std::lower_bound(before.sources.begin(), before.sources.end(), sources[t]);
        following = std::uint64_t{sources[t]} + 1;
        for (; part != before.sources.end() && *part == sources[t]; ++part) {
            const glm::uvec3& corners =
                before.triangles[static_cast<std::size_t>(part - before.sources.begin())];
            out.refinement.triangles.emplace_back(next[corners.x], next[corners.y], next[corners.z]);
        }
        if (out.refinement.triangles.size() == already) out.refinement.triangles.push_back(now.triangles[t]);
        out.refinement.sources.insert(out.refinement.sources.end(), out.refinement.triangles.size() - already,
                                      t);
    }
    return out;
}

}  // namespace nicol
