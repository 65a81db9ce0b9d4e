// SPDX-License-Identifier: MIT
#include "shading/reflection_rows.hpp"

#include <algorithm>
#include <array>

#include "shading/lane_view.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

[[gnu::always_inline]] inline void add_to(Lanes* sum, const LaneVector& term) {
    LaneVector both;
    load(sum, both);
    both += term;
    store(sum, both);
}

// Adds the factors of a light's numbers in one component of respond(). numbers: size of the light.
[[gnu::always_inline]] inline void add_row(const LightLayout& tables, std::size_t numbers, bool of_even,
                                           const Lanes* table, const Lanes* cosine, const Lanes* sine,
                                           Lanes* out) {
    for (const LightLayout::Run& run : tables.runs()) {
        if (run.even < numbers) {
            const std::size_t same = of_even ? run.even : run.odd;
            const std::size_t other = of_even ? run.odd : run.even;
            const float sign = of_even ? run.sign : -run.sign;
            LaneVector c, s;
            load(cosine + run.m, c);
            load(sine + run.m, s);
            for (std::size_t i = 0; i < run.count; ++i) {
                LaneVector row;
                load(table + i, row);
                add_to(out + same + i, c * row);
                if (run.m > 0) add_to(out + other + i, sign * s * row);
            }
        }
        table += run.count;
    }
}

}  // namespace

ReflectionRows::ReflectionRows(const LightLayout& tables, LightKind light, std::size_t components)
    : tables_(tables), light_(tables.order(), light), components_(components), rotation_(light_) {}

void ReflectionRows::run(std::span<const ResponseTable* const> layers, std::span<const LayerWeights> weights,
                         std::size_t channel, const Views& views, std::span<const glm::vec3> positions,
                         std::span<const glm::vec3> normals, VertexLight& out) const {
    out.resize(light_, static_cast<int>(components_), kLanes);
    LaneView& seen = LaneView::of_thread(tables_.order());
    seen.set(views, positions, normals);
    const LaneView::TablePositions at = seen.positions_in(ResponseTable::kAngles);
    const auto of = [&out](std::size_t p) { return out.block(0, static_cast<int>(p)); };
    for (std::size_t p = 0; p < components_; ++p) std::ranges::fill(of(p), Lanes{});
    for (std::size_t l = 0; l < layers.size(); ++l) {
        if (!weights.empty() && weights[l].points == 0) continue;
        const ResponseTable& table = *layers[l];
        const std::size_t row_size = table.row_size();
        // The count is rounded up because whole squares are faster to transpose.
        const std::size_t count = std::max(components_ * row_size, std::min(kLanes, 4 * row_size));
        const std::span<Lanes> rows = work_space<ReflectionRows, Lanes>(count);
        const std::size_t set = table.channels() == 1 ? 0 : channel;
        std::array<const float*, kLanes> low;
        for (std::size_t i = 0; i < kLanes; ++i)
            low[i] = table.rows(at.angle[i], static_cast<int>(set)).data();
        to_lanes_between(low, 4 * row_size * static_cast<std::size_t>(table.channels()), at.fraction, count,
                         rows.data());
        if (!weights.empty())
            for (Lanes& row : rows)
                for (std::size_t i = 0; i < kLanes; ++i) row[i] *= weights[l].of(channel)[i];
        for (std::size_t p = 0; p < components_; ++p) {
            if (!table.makes(p)) continue;
            for (std::size_t pairing = 0; pairing < table.pairings(); ++pairing)
                dispatch<add_row>(tables_, light_.size(), (p < 2) == (pairing == 0),
                                  rows.data() + p * row_size + pairing * tables_.row_size(), seen.cosines(),
                                  seen.sines(), of(p).data());
        }
    }
    if (components_ > 1) {
        for (std::size_t j = 0; j < light_.size(); ++j) {
            std::array<Lanes, 4> stokes{Lanes{}, of(1)[j], of(2)[j], Lanes{}};
            seen.into_camera_frame(stokes);
            of(1)[j] = stokes[1];
            of(2)[j] = stokes[2];
        }
    }
    // A rotation is orthogonal, so its transpose, which rows need, is its inverse.
    rotation_.into_world(normals, out, 0);
    out.to_rows(0);
}

}  // namespace nicol
