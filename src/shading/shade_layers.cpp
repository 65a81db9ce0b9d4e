// SPDX-License-Identifier: MIT
// Shading of several layers at once.
#include <algorithm>
#include <array>

#include "shading/lane_view.hpp"
#include "shading/layer_rows.hpp"
#include "shading/shade.hpp"
#include "simd/lane_transpose.hpp"

namespace nicol {
void Shade::run(std::span<const ResponseTable* const> layers, std::span<const LayerWeights> all_weights,
                const VertexLight& light, const Views& views, std::span<const glm::vec3> positions,
                std::span<const glm::vec3> normals, std::span<const std::span<glm::vec4>> out) const {
    LaneView& seen = LaneView::of_thread(layout_.order());
    thread_local MixtureRows rows;
    for (const std::span<glm::vec4> channel : out)
        std::ranges::fill(channel.first(positions.size()), glm::vec4(0));
    std::array<Lanes, 4> stokes{};
    for (std::size_t begin = 0; begin < positions.size(); begin += kLanes) {
        const std::size_t block = begin / kLanes;
        const std::span weights = all_weights.subspan(block * layers.size(), layers.size());
        const std::size_t count = std::min(kLanes, positions.size() - begin);
        seen.set(views.subspan(begin, count), positions.subspan(begin, count), normals.subspan(begin, count));
        const LaneView::TablePositions at = seen.positions_in(ResponseTable::kAngles);
        // Tables of one pairing and of two pairings are summed separately because their rows differ.
        for (const std::size_t pairings : {std::size_t{1}, std::size_t{2}}) {
            const std::size_t made = sum_layers(layers, weights, at, pairings, out.size(), components_, rows);
            if (made == 0) continue;
            const bool alike = rows.alike() && light.channels() == 1;
            for (std::size_t c = 0; c < out.size(); ++c) {
                if (c == 0 || !alike) {
                    stokes = {};
                    respond(layout_, made, pairings, rows.of(c),
                            light.block(block, light.channels() == 1 ? 0 : static_cast<int>(c)).data(),
                            seen.cosines(), seen.sines(), stokes.data());
                    seen.into_camera_frame(stokes);
                }
                add_fours(stokes.data(), count, out[c].data() + begin);
            }
        }
    }
}

}  // namespace nicol
