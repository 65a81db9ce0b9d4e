// SPDX-License-Identifier: MIT
#include "specular/high_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "arguments.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/work_space.hpp"
#include "specular/lane_lobe.hpp"
#include "specular/lane_mirror.hpp"
#include "specular/lane_reflection.hpp"

namespace nicol {
namespace {

constexpr int kMostChannels = 16;

// Returns the visible fractions of the lobe and of the hemisphere for `count` vertices from `begin` on.
std::array<Lanes, 2> fractions(const HighOrderShadows& shadows, const LaneMirror& mirror, std::size_t begin,
                               std::size_t count) {
    std::array<Lanes, 2> out;
    for (Lanes& lanes : out) lanes.value.fill(1.0F);
    if (!shadows.fractions.empty()) {
        for (std::size_t i = 0; i < count; ++i) {
            out[0][i] = shadows.fractions[begin + i][0];
            out[1][i] = shadows.fractions[begin + i][1];
        }
    } else if (shadows.visibility != nullptr) {
        const std::int16_t* const block = shadows.seen->block(begin / kLanes);
        if (block != nullptr) shadows.visibility->filter_block(mirror, block, out);
    }
    return out;
}

}  // namespace

HighOrder::HighOrder(const HighOrderFactors& factors, const HighOrderMaps& maps,
                     const glm::dmat3& light_to_world)
    : factors_(factors), maps_(maps), world_to_light_(glm::transpose(light_to_world)) {
    require(maps.central != nullptr, "high orders need a map for the mirror direction");
    require(factors.spread() == 0 || maps.outer != nullptr, "high orders need a map for the outer taps");
    require(!factors.has_base() || maps.base != nullptr, "high orders need a map for the base");
    for (const LobeMap* map : {maps.central, maps.outer, maps.base}) {
        if (map == nullptr) continue;
        require(map->channels() == maps.central->channels() && map->channels() >= 1 &&
                    map->channels() <= kMostChannels,
                "the maps of high orders must have the same 1 to " + std::to_string(kMostChannels) +
                    " channels; one has " + std::to_string(map->channels()));
        require(map->polarized() == maps.central->polarized(),
                "the maps of high orders must be all polarized or all not");
    }
    require(factors.channels() == 1 || maps.central->channels() == 1 ||
                factors.channels() == maps.central->channels(),
            "factors of " + std::to_string(factors.channels()) + " channels cannot serve maps of " +
                std::to_string(maps.central->channels()));
}

void HighOrder::run(const Views& views, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> normals, std::span<const std::uint8_t> visible,
                    const HighOrderShadows& shadows, std::size_t first, std::size_t last,
                    std::span<const std::span<glm::vec4>> out) const {
    require(!out.empty() && out.size() <= kMostChannels,
            "high orders of " + std::to_string(out.size()) + " channels");
    const bool polarized = maps_.central->polarized();
    const bool alike = factors_.channels() == 1 && maps_.central->channels() == 1;
    // The count is rounded up because whole squares are faster to transpose.
    constexpr std::size_t few = std::max<std::size_t>(kLanes, HighOrderFactors::kUnpolarized);
    const std::size_t used = polarized ? HighOrderFactors::kElements : few;

    LaneTaps taps(maps_, factors_.spread(), factors_.has_base());
    std::array<Lanes, std::size_t{2} * HighOrderFactors::kElements> table;  // [pairing][element]
    std::array<Lanes, 4> stokes;
    for (std::size_t begin = first / kLanes * kLanes; begin < last; begin += kLanes) {
        std::array<std::uint8_t, kLanes> shown{};
        const std::size_t to = std::min(begin + kLanes, last);
        for (std::size_t v = std::max(begin, first); v < to; ++v) shown[v - begin] = visible[v];
        if (std::ranges::all_of(shown, [](std::uint8_t v) { return v == 0; })) continue;
        const std::size_t all = std::min(kLanes, positions.size() - begin);
        const LaneMirror mirror = mirror_views(views.subspan(begin, all), world_to_light_,
                                               positions.subspan(begin, all), normals.subspan(begin, all));
        taps.sample(mirror);
        const std::array<Lanes, 2> dimmed = fractions(shadows, mirror, begin, all);
        std::array<std::size_t, kLanes> angle;
        Lanes fraction;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const HighOrderFactors::Position at = HighOrderFactors::position(mirror.cosine[i]);
            angle[i] = at.angle;
            fraction[i] = at.fraction;
        }
        for (std::size_t c = 0; c < out.size(); ++c) {
            if (c == 0 || !alike) {
                for (std::size_t pairing = 0; pairing < factors_.pairings(); ++pairing) {
                    if (c > 0 && factors_.channels() == 1) break;
                    const std::size_t offset = pairing * HighOrderFactors::kElements;
                    std::array<const float*, kLanes> rows;
                    for (std::size_t i = 0; i < kLanes; ++i) rows[i] = factors_.row(angle[i], c) + offset;
                    to_lanes_between(rows, factors_.step(), fraction, used, &table[offset]);
                }
                reflect_taps(taps.channel(c), polarized, table.data(), factors_.pairings(), mirror, dimmed[0],
                             dimmed[1], stokes.data());
            }
            add_fours(stokes.data(), shown.data(), all, out[c].data() + begin);
        }
    }
}

}  // namespace nicol
