// SPDX-License-Identifier: MIT
#include "shading/shade.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "shading/lane_view.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/work_space.hpp"

namespace nicol {

Shade::Shade(LightLayout layout, std::size_t least, std::size_t most)
    : components_{.least = least, .most = most}, layout_(std::move(layout)) {}

void Shade::run(const ResponseTable& response, const VertexLight& light, const Views& views,
                std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                std::span<const std::uint8_t> visible, std::size_t first, std::size_t last,
                std::span<const std::span<glm::vec4>> out) const {
    // Channels that equal the first channel are not computed.
    const std::size_t rows = components_of(response, components_);
    const bool alike = response.channels() == 1 && light.channels() == 1;
    const std::size_t step = response.rows(0, 0).size() * static_cast<std::size_t>(response.channels());

    // The count is rounded up because whole squares are faster to transpose; even the rows of a few orders
    // together have as many numbers.
    const std::size_t row_size = response.row_size();
    const std::size_t numbers = std::max(rows * row_size, std::min(kLanes, 4 * row_size));

    LaneView& seen = LaneView::of_thread(layout_.order());
    const std::span<Lanes> table = work_space<Shade, Lanes>(4 * row_size);
    std::ranges::fill(table, Lanes{});
    std::array<Lanes, 4> stokes{};
    for (std::size_t begin = first / kLanes * kLanes; begin < last; begin += kLanes) {
        const std::size_t from = std::max(begin, first);
        const std::size_t to = std::min(begin + kLanes, last);
        std::array<std::size_t, kLanes> shown{};
        std::array<std::uint8_t, kLanes> show{};
        std::size_t count = 0;
        for (std::size_t v = from; v < to; ++v) {
            show[v - begin] = visible[v];
            if (visible[v] != 0) shown[count++] = v;
        }
        if (count == 0) continue;
        const std::size_t all = std::min(kLanes, positions.size() - begin);
        seen.set(views.subspan(begin, all), positions.subspan(begin, all), normals.subspan(begin, all));
        const LaneView::TablePositions at = seen.positions_in(response.angles());
        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            if (alike && channel > 0) {
                put_fours(stokes.data(), show.data(), all, out[channel].data() + begin);
                continue;
            }
            if (channel == 0 || response.channels() > 1) {
                const int row_channel = response.channels() == 1 ? 0 : static_cast<int>(channel);
                std::array<const float*, kLanes> low;
                low.fill(response.rows(at.angle[shown[0] - begin], row_channel).data());
                for (std::size_t i = 1; i < count; ++i) {
                    const std::size_t lane = shown[i] - begin;
                    low[lane] = response.rows(at.angle[lane], row_channel).data();
                }
                to_lanes_between(low, step, at.fraction, numbers, table.data());
            }
            const int light_channel = light.channels() == 1 ? 0 : static_cast<int>(channel);
            stokes = {};
            respond(layout_, rows, response.pairings(), table.data(),
                    light.block(begin / kLanes, light_channel).data(), seen.cosines(), seen.sines(),
                    stokes.data());
            seen.into_camera_frame(stokes);
            put_fours(stokes.data(), show.data(), all, out[channel].data() + begin);
        }
    }
}

}  // namespace nicol
