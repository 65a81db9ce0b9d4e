// SPDX-License-Identifier: MIT
#include "shading/shade_gradient.hpp"

#include <algorithm>
#include <array>

#include "shading/lane_view.hpp"
#include "shading/layer_rows.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using Run = LightLayout::Run;

[[gnu::always_inline]] inline const LaneVector& vector_at(const Lanes* from) {
    return *reinterpret_cast<const LaneVector*>(from);
}

// Adds the gradient of one run of the light. cosine, sine: gradients of the Stokes components times cos m phi
// and times sin m phi, with the run's sign.
template <int Rows, int Pairings>
[[gnu::always_inline]] inline void add_run(const Run& run, std::size_t row_size, const Lanes* table,
                                           const LaneVector* cosine, const LaneVector* sine, Lanes* light) {
    for (std::size_t i = 0; i < run.count; ++i) {
        LaneVector even{}, odd{};
        for (int r = 0; r < Rows * Pairings; ++r) {
            const int p = r / Pairings;
            const LaneVector row = vector_at(table + static_cast<std::size_t>(r) * row_size + i);
            if ((p < 2) == (r % Pairings == 0)) {
                even += row * cosine[p];
                odd += row * sine[p];
            } else {
                odd += row * cosine[p];
                even -= row * sine[p];
            }
        }
        // A pair of one number has two equal indices, so the first sum is stored before the second is read.
        store(light + run.even + i, vector_at(light + run.even + i) + even);
        store(light + run.odd + i, vector_at(light + run.odd + i) + odd);
    }
}

template <int Rows, int Pairings>
[[gnu::always_inline]] inline void add_runs(const LightLayout& layout, const Lanes* table,
                                            const Lanes* stokes, const Lanes* cosines, const Lanes* sines,
                                            Lanes* light) {
    for (const Run& run : layout.runs()) {
        LaneVector cosine[Rows], sine[Rows];
        const float sign = run.m == 0 ? 0 : run.sign;
        for (int p = 0; p < Rows; ++p) {
            cosine[p] = vector_at(stokes + p) * vector_at(cosines + run.m);
            sine[p] = sign * vector_at(stokes + p) * vector_at(sines + run.m);
        }
        add_run<Rows, Pairings>(run, layout.row_size(), table, cosine, sine, light);
        table += run.count;
    }
}

template <int Pairings>
[[gnu::always_inline]] inline void add_rows(const LightLayout& layout, std::size_t rows, const Lanes* table,
                                            const Lanes* stokes, const Lanes* cosines, const Lanes* sines,
                                            Lanes* light) {
    if (rows == 1)
        add_runs<1, Pairings>(layout, table, stokes, cosines, sines, light);
    else if (rows == 3)
        add_runs<3, Pairings>(layout, table, stokes, cosines, sines, light);
    else
        add_runs<4, Pairings>(layout, table, stokes, cosines, sines, light);
}

// Adds the transpose of respond().
[[gnu::always_inline]] inline void add_gradient(const LightLayout& layout, std::size_t rows,
                                                std::size_t pairings, const Lanes* table, const Lanes* stokes,
                                                const Lanes* cosines, const Lanes* sines, Lanes* light) {
    if (pairings == 1)
        add_rows<1>(layout, rows, table, stokes, cosines, sines, light);
    else
        add_rows<2>(layout, rows, table, stokes, cosines, sines, light);
}

// Gradients of up to sixteen Stokes vectors, in the theta-phi frames about the normals.
std::array<Lanes, 4> gradient_at(std::span<const glm::vec4> stokes, const LaneView& seen) {
    std::array<Lanes, 4> out{};
    for (std::size_t i = 0; i < stokes.size(); ++i)
        for (std::size_t p = 0; p < out.size(); ++p) out[p][i] = stokes[i][static_cast<glm::length_t>(p)];
    seen.out_of_camera_frame(out);
    return out;
}

}  // namespace

void shade_gradient(const LightLayout& layout, std::span<const ResponseTable* const> layers,
                    std::span<const LayerWeights> all_weights, const Views& views,
                    std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                    std::span<const std::span<glm::vec4>> stokes, VertexLight& light) {
    LaneView& seen = LaneView::of_thread(layout.order());
    thread_local MixtureRows rows;
    for (std::size_t begin = 0; begin < positions.size(); begin += kLanes) {
        const std::size_t block = begin / kLanes;
        const std::span weights = all_weights.subspan(block * layers.size(), layers.size());
        const std::size_t count = std::min(kLanes, positions.size() - begin);
        seen.set(views.subspan(begin, count), positions.subspan(begin, count), normals.subspan(begin, count));
        const LaneView::TablePositions at = seen.positions_in(ResponseTable::kAngles);
        for (std::size_t c = 0; c < stokes.size(); ++c)
            std::ranges::fill(light.block(block, static_cast<int>(c)), Lanes{});
        for (const std::size_t pairings : {std::size_t{1}, std::size_t{2}}) {
            const std::size_t made = sum_layers(layers, weights, at, pairings, stokes.size(), {}, rows);
            if (made == 0) continue;
            for (std::size_t c = 0; c < stokes.size(); ++c) {
                const std::array<Lanes, 4> gradient = gradient_at(stokes[c].subspan(begin, count), seen);
                dispatch<add_gradient>(layout, made, pairings, rows.of(c), gradient.data(), seen.cosines(),
                                       seen.sines(), light.block(block, static_cast<int>(c)).data());
            }
        }
    }
}

}  // namespace nicol
