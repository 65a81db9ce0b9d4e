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
#include "specular/high_order_kernel.hpp"
#include "specular/lane_lobe.hpp"
#include "specular/lane_mirror.hpp"

namespace nicol {
namespace {

constexpr int most_channels = 16;

// A direction rotated by an angle towards another, orthogonal one.
LaneVectors rotated(const LaneVectors& from, const LaneVectors& towards, float cosine, float sine) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        out.x[i] = cosine * from.x[i] + sine * towards.x[i];
        out.y[i] = cosine * from.y[i] + sine * towards.y[i];
        out.z[i] = cosine * from.z[i] + sine * towards.z[i];
    }
    return out;
}

// Of the lobe and of the hemisphere, for `count` vertices from `begin` on.
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

// What the probes of a block of vertices find.
struct Probes {
    // Numbers of all channels, and those to spare.
    explicit Probes(std::size_t numbers) {
        const std::span<Lanes> all = work_space<Probes, Lanes>(6 * numbers);
        std::ranges::fill(all, Lanes{});
        std::size_t begin = 0;
        for (std::span<Lanes>* some : {&centre, &up, &down, &right, &left, &normal}) {
            *some = all.subspan(begin, numbers);
            begin += numbers;
        }
    }

    std::span<Lanes> centre, up, down, right, left, normal;
};

}  // namespace

HighOrder::HighOrder(const HighOrderFactors& factors, const HighOrderMaps& maps,
                     const glm::dmat3& light_to_world)
    : factors_(factors), maps_(maps), world_to_light_(glm::transpose(light_to_world)) {
    require(maps.centre != nullptr, "high orders need a map for the mirror direction");
    require(factors.spread() == 0 || maps.around != nullptr,
            "high orders need a map around the mirror direction");
    require(!factors.normal() || maps.normal != nullptr, "high orders need a map for the normal");
    for (const LobeMap* map : {maps.centre, maps.around, maps.normal}) {
        if (map == nullptr) continue;
        require(map->channels() == maps.centre->channels() && map->channels() >= 1 &&
                    map->channels() <= most_channels,
                "the maps of high orders must have the same 1 to " + std::to_string(most_channels) +
                    " channels; one has " + std::to_string(map->channels()));
        require(map->polarized() == maps.centre->polarized(),
                "the maps of high orders must be all polarized or all not");
    }
    require(factors.channels() == 1 || maps.centre->channels() == 1 ||
                factors.channels() == maps.centre->channels(),
            "factors of " + std::to_string(factors.channels()) + " channels cannot serve maps of " +
                std::to_string(maps.centre->channels()));
}

void HighOrder::run(const Viewpoint& view, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> normals, std::span<const std::uint8_t> visible,
                    const HighOrderShadows& shadows, std::size_t first, std::size_t last,
                    std::span<const std::span<glm::vec4>> out) const {
    require(out.size() >= 1 && out.size() <= most_channels,
            "high orders of " + std::to_string(out.size()) + " channels");
    const bool polarized = maps_.centre->polarized();
    const bool around = factors_.spread() > 0;
    const auto cosine = static_cast<float>(std::cos(factors_.spread()));
    const auto sine = static_cast<float>(std::sin(factors_.spread()));
    const std::size_t components = polarized ? 4 : 1;
    const bool alike = factors_.channels() == 1 && maps_.centre->channels() == 1;
    const std::size_t step = HighOrderFactors::kElements * static_cast<std::size_t>(factors_.channels());
    // Whole squares are faster to transpose.
    constexpr std::size_t few = std::max<std::size_t>(kLanes, HighOrderFactors::kUnpolarized);
    const std::size_t used = polarized ? HighOrderFactors::kElements : few;

    Probes probes(4 * static_cast<std::size_t>(maps_.centre->layers()));
    std::array<Lanes, HighOrderFactors::kElements> table;
    std::array<Lanes, 4> stokes;
    for (std::size_t begin = first / kLanes * kLanes; begin < last; begin += kLanes) {
        std::array<std::uint8_t, kLanes> shown{};
        const std::size_t to = std::min(begin + kLanes, last);
        for (std::size_t v = std::max(begin, first); v < to; ++v) shown[v - begin] = visible[v];
        if (std::ranges::all_of(shown, [](std::uint8_t v) { return v == 0; })) continue;
        const std::size_t all = std::min(kLanes, positions.size() - begin);
        const LaneMirror mirror =
            mirror_views(view, world_to_light_, positions.subspan(begin, all), normals.subspan(begin, all));
        probe_lobe(*maps_.centre, mirror.d, mirror.x, probes.centre.data());
        if (around) {
            const LobeMap& map = *maps_.around;
            const LaneVectors& d = mirror.d;
            const LaneVectors& x = mirror.x;
            probe_lobe(map, rotated(d, mirror.y, cosine, sine), x, probes.up.data());
            probe_lobe(map, rotated(d, mirror.y, cosine, -sine), x, probes.down.data());
            probe_lobe(map, rotated(d, x, cosine, sine), rotated(x, d, cosine, -sine), probes.right.data());
            probe_lobe(map, rotated(d, x, cosine, -sine), rotated(x, d, cosine, sine), probes.left.data());
        }
        if (factors_.normal()) probe_lobe(*maps_.normal, mirror.inward, mirror.x, probes.normal.data());

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
                if (c == 0 || factors_.channels() > 1) {
                    std::array<const float*, kLanes> rows;
                    for (std::size_t i = 0; i < kLanes; ++i)
                        rows[i] = factors_.row(angle[i], factors_.channels() > 1 ? c : 0);
                    to_lanes_between(rows, step, fraction, used, table.data());
                }
                const std::size_t own = maps_.centre->channels() == 1 ? 0 : c * components;
                reflect_probes({.centre = &probes.centre[own],
                                .up = around ? &probes.up[own] : nullptr,
                                .down = &probes.down[own],
                                .right = &probes.right[own],
                                .left = &probes.left[own],
                                .normal = factors_.normal() ? &probes.normal[own] : nullptr},
                               polarized, table.data(), mirror, dimmed[0], dimmed[1], stokes.data());
            }
            add_fours(stokes.data(), shown.data(), all, out[c].data() + begin);
        }
    }
}

}  // namespace nicol
