// SPDX-License-Identifier: MIT
#include "devices/vertex_lights.hpp"

#include <tbb/combinable.h>

#include <array>
#include <vector>

#include "shading/channel_spans.hpp"
#include "shading/emission.hpp"

namespace nicol {

void VertexLights::add(RenderRun& run, std::span<const std::span<glm::vec4>> out) const {
    tbb::combinable<LightingTally> tallies;
    for (const VertexRange& range : input_.geometry.ranges) {
        run.workers.for_vertices(
            range.first, range.last, input_.geometry.positions.size(), "shade", run.progress,
            [&](std::size_t begin, std::size_t end) { tallies.local() += add(range, begin, end, out); });
    }
    tallies.combine_each([&](const LightingTally& tally) { run.add(tally); });
}

LightingTally VertexLights::add(const VertexRange& range, std::size_t first, std::size_t last,
                                std::span<const std::span<glm::vec4>> out) const {
    LightingTally tally;
    std::array<std::uint32_t, kLanes> vertices;
    std::size_t count = 0;
    for (std::size_t v = first; v < last; ++v) {
        if (input_.chosen[v] != 0) vertices[count++] = static_cast<std::uint32_t>(v);
        if (count < kLanes && v + 1 < last) continue;
        if (count > 0) tally += add(range, std::span(vertices).first(count), out);
        count = 0;
    }
    return tally;
}

LightingTally VertexLights::add(const VertexRange& range, std::span<const std::uint32_t> vertices,
                                std::span<const std::span<glm::vec4>> out) const {
    const std::size_t count = vertices.size();
    const WorldGeometry& geometry = input_.geometry;
    const std::span origins_of_all = lights_.vertex_origins();
    const std::span tangents_of_all = lights_.vertex_tangents();
    const bool anisotropic = range.material->anisotropic() && !tangents_of_all.empty();
    std::array<glm::vec3, kLanes> positions, normals, tangents, origins;
    bool shadowed = false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t v = vertices[i];
        positions[i] = geometry.positions[v];
        normals[i] = geometry.normals[v];
        if (anisotropic) tangents[i] = tangents_of_all[v];
        origins[i] = origins_of_all.empty() ? positions[i] : origins_of_all[v];
        shadowed = shadowed || input_.visibility == nullptr || !input_.visibility->unoccluded(v);
    }
    thread_local std::vector<glm::vec4> sums;
    sums.clear();
    const std::vector<std::span<glm::vec4>> channels = channel_spans(sums, out.size(), count);

    const Material* const material = range.material.get();
    const bool receives = range.roles.receives_shadows;
    const LightingTally tally =
        lights_.lighting().add(input_.view,
                               {.positions = std::span(positions).first(count),
                                .normals = std::span(normals).first(count),
                                .tangents = std::span(tangents).first(anisotropic ? count : 0),
                                .origins = std::span(origins).first(count),
                                .seeds = vertices,
                                .shadowed = shadowed && receives,
                                .receives_shadows = receives},
                               {.layers = {&material, 1}, .weights = {}}, channels);
    if (range.emission != nullptr) {
        add_emitted(*range.emission, lights_.axis_of(range.instance), input_.view,
                    std::span(positions).first(count), std::span(normals).first(count), {}, channels);
    }
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t p = 0; p < input_.most_components; ++p)
                out[c][vertices[i]][static_cast<glm::length_t>(p)] +=
                    channels[c][i][static_cast<glm::length_t>(p)];
        }
    return tally;
}

}  // namespace nicol
