// SPDX-License-Identifier: MIT
#include "specular/high_order_layers.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/matrix.hpp>
#include <iterator>

#include "simd/lane_transpose.hpp"
#include "specular/lane_mirror.hpp"
#include "specular/lane_reflection.hpp"

namespace nicol {
struct HighOrderLayers::Block {
    std::size_t index;
    std::size_t count;  // number of vertices in the block
    LaneMirror mirror;
    std::array<std::size_t, kLanes> angle;
    Lanes fraction;  // weight of the next angle
    std::array<Lanes, 2> visible;
};

HighOrderLayers::HighOrderLayers(const std::vector<Layer>& layers, const glm::dmat3& light_to_world)
    : layers_(layers.size()), world_to_light_(glm::transpose(light_to_world)) {
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const Layer& layer = layers[l];
        const auto same = [&](const Group& group) {
            return group.maps.central == layer.maps.central && group.maps.outer == layer.maps.outer &&
                   group.spread == layer.factors->spread();
        };
        auto group = std::ranges::find_if(groups_, same);
        if (group == groups_.end()) {
            groups_.push_back({.maps = layer.maps, .spread = layer.factors->spread(), .members = {}});
            group = std::prev(groups_.end());
        }
        if (group->maps.base == nullptr) group->maps.base = layer.maps.base;
        group->members.push_back({.layer = l, .factors = layer.factors});
    }
}

void HighOrderLayers::run(const Views& views, std::span<const glm::vec3> positions,
                          std::span<const glm::vec3> normals, std::span<const LayerWeights> weights,
                          std::span<const glm::vec2> fractions,
                          std::span<const std::span<glm::vec4>> out) const {
    Block block;
    for (std::size_t begin = 0; begin < positions.size(); begin += kLanes) {
        block.index = begin / kLanes;
        block.count = std::min(kLanes, positions.size() - begin);
        block.mirror =
            mirror_views(views.subspan(begin, block.count), world_to_light_,
                         positions.subspan(begin, block.count), normals.subspan(begin, block.count));
        for (std::size_t i = 0; i < kLanes; ++i) {
            const HighOrderFactors::Position at = HighOrderFactors::position(block.mirror.cosine[i]);
            block.angle[i] = at.angle;
            block.fraction[i] = at.fraction;
        }
        for (glm::length_t k = 0; k < 2; ++k) {
            Lanes& visible = block.visible[static_cast<std::size_t>(k)];
            visible.value.fill(1.0F);
            for (std::size_t i = 0; !fractions.empty() && i < block.count; ++i)
                visible[i] = fractions[begin + i][k];
        }
        for (const Group& group : groups_)
            add_group(group, weights.subspan(block.index * layers_, layers_), block, out);
    }
}

void HighOrderLayers::add_group(const Group& group, std::span<const LayerWeights> weights, const Block& block,
                                std::span<const std::span<glm::vec4>> out) const {
    constexpr std::size_t elements = HighOrderFactors::kElements;
    const bool polarized = group.maps.central->polarized();
    std::size_t pairings = 1;
    thread_local MixtureRows rows;
    rows.begin(2 * elements, out.size());
    for (const Member& member : group.members) {
        const LayerWeights& weight = weights[member.layer];
        if (weight.points == 0) continue;
        const HighOrderFactors& factors = *member.factors;
        pairings = std::max(pairings, factors.pairings());
        const std::size_t size = factors.pairings() * elements;
        MixtureRow row{.rows = {},
                       .step = factors.step(),
                       .channel_step = factors.channels() == 1 ? 0 : size,
                       .size = size,
                       .weights = &weight};
        for (std::size_t i = 0; i < kLanes; ++i) row.rows[i] = factors.row(block.angle[i], 0);
        rows.add(row);
    }
    if (rows.empty()) return;
    // The count is rounded up because whole squares are faster to transpose.
    const std::size_t used = polarized ? elements : kLanes;
    for (std::size_t pairing = 0; pairing < pairings; ++pairing)
        rows.sum(block.fraction, pairing * elements, used);
    LaneTaps taps(group.maps, group.spread, group.maps.base != nullptr);
    taps.sample(block.mirror);
    std::array<Lanes, 4> stokes;
    const bool alike = rows.alike() && group.maps.central->channels() == 1;
    for (std::size_t c = 0; c < out.size(); ++c) {
        if (c == 0 || !alike)
            reflect_taps(taps.channel(c), polarized, rows.of(c), pairings, block.mirror, block.visible[0],
                         block.visible[1], stokes.data());
        add_fours(stokes.data(), block.count, out[c].data() + block.index * kLanes);
    }
}

}  // namespace nicol
