// SPDX-License-Identifier: MIT
#include "methods/lit_receivers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "shading/channel_spans.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/local_lights.hpp"
#include "visibility/bake_origins.hpp"

namespace nicol {
namespace {

// Samples of wide lights. The light serves a prediction alone, which is a mean over receivers.
constexpr std::uint32_t kSamples = 4;

}  // namespace

std::vector<float> local_light_at_receivers(const TransferInput& input, const LinkedSurfaces& surfaces,
                                            RenderRun& run) {
    const WorldGeometry& geometry = input.geometry;
    const auto all_channels = static_cast<std::size_t>(input.channels);
    std::vector<float> out(surfaces.receivers() * all_channels);
    std::vector<glm::vec3> unit_normals;
    unit_normals.reserve(geometry.normals.size());
    for (const glm::vec3& normal : geometry.normals) unit_normals.push_back(glm::normalize(normal));
    // A vertex at the border of a lamp lies in the lamp's plane, from which it gets no light.
    const std::vector<glm::vec3> origins = bake_origins(
        {.positions = geometry.positions, .normals = geometry.normals, .triangles = geometry.triangles},
        unit_normals);
    // Such a surface reflects even light as it is, whose first number is the square root of 4 pi.
    const MaterialPtr white = diffuse({1});
    const std::array<const Material*, 1> layers{white.get()};
    const auto first_number = static_cast<float>(std::sqrt(4 * std::numbers::pi));
    run.workers.for_blocks(
        surfaces.blocks(), "relight", run.progress, [&](std::size_t first, std::size_t last) {
            std::array<glm::vec3, kLanes> positions, normals;
            std::array<std::uint32_t, kLanes> seeds;
            std::array<Viewpoint, kLanes> views;
            std::vector<glm::vec4> sums;
            for (std::size_t block = first; block < last; ++block) {
                const std::size_t begin = block * kLanes;
                const std::size_t count = std::min(kLanes, surfaces.receivers() - begin);
                for (std::size_t i = 0; i < count; ++i) {
                    const std::uint32_t v = surfaces.vertices()[begin + i];
                    positions[i] = origins[v];
                    normals[i] = unit_normals[v];
                    seeds[i] = sample_seed(static_cast<std::uint32_t>(begin + i), 0);
                    views[i] = link_frames();
                    views[i].orthographic = true;
                    views[i].forward = glm::dvec3(-unit_normals[v]);
                }
                sums.clear();
                const std::vector<std::span<glm::vec4>> channels = channel_spans(sums, all_channels, count);
                input.local_lights->lighting().add_lights(Views(std::span(views).first(count)),
                                                          {.positions = std::span(positions).first(count),
                                                           .normals = std::span(normals).first(count),
                                                           .tangents = {},
                                                           .facets = {},
                                                           .unperturbed = {},
                                                           .origins = std::span(positions).first(count),
                                                           .mirrored = nullptr,
                                                           .parts = {},
                                                           .seeds = std::span(seeds).first(count),
                                                           .shadowed = true},
                                                          {.layers = layers, .weights = {}}, kSamples,
                                                          channels);
                for (std::size_t c = 0; c < all_channels; ++c)
                    for (std::size_t i = 0; i < count; ++i)
                        out[(begin + i) * all_channels + c] = first_number * channels[c][i].x;
            }
        });
    return out;
}

}  // namespace nicol
