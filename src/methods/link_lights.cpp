// SPDX-License-Identifier: MIT
#include "methods/link_lights.hpp"

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Adds rows x weighted sum of lights for some numbers, `width` Lanes side by side from `lane` on. share:
// factor of the first component.
template <std::size_t components, std::size_t count, std::size_t width>
[[gnu::always_inline]] inline void add_numbers(const LinkRows& of, const float* rows, const LinkLights& link,
                                               std::size_t first, std::size_t last, float share,
                                               std::size_t lane, LaneVector* sums) {
    for (std::size_t j = first; j < last; ++j)
        for (std::size_t k = 0; k < width; ++k) {
            const std::size_t at = j * of.lanes + lane + k;
            LaneVector light;
            load(link.lights[0] + at, light);
            light *= link.weights[0];
            for (std::size_t n = 1; n < count; ++n) {
                LaneVector other;
                load(link.lights[n] + at, other);
                light += link.weights[n] * other;
            }
            for (std::size_t p = 0; p < components; ++p)
                sums[p * width + k] += (p == 0 ? share : 1.0F) * rows[p * of.row_size + j] * light;
        }
}

template <std::size_t components, std::size_t width>
[[gnu::always_inline]] inline void add_some_numbers(const LinkRows& of, const float* rows,
                                                    const LinkLights& link, std::uint32_t count,
                                                    std::size_t first, std::size_t last, float share,
                                                    std::size_t lane, LaneVector* sums) {
    if (count == 4) add_numbers<components, 4, width>(of, rows, link, first, last, share, lane, sums);
    if (count == 3) add_numbers<components, 3, width>(of, rows, link, first, last, share, lane, sums);
    if (count == 1) add_numbers<components, 1, width>(of, rows, link, first, last, share, lane, sums);
}

template <std::size_t components, std::size_t width>
[[gnu::always_inline]] inline void add_link(const LinkRows& of, const float* rows, const LinkLights& link,
                                            std::size_t lane, Lanes* stokes) {
    LaneVector sums[components * width] = {};
    add_some_numbers<components, width>(of, rows, link, link.count, 0, of.scalars, 1, lane, sums);
    if (of.numbers > of.scalars)
        add_some_numbers<components, width>(of, rows, link, link.whole, of.scalars, of.numbers, link.share,
                                            lane, sums);
    for (std::size_t p = 0; p < components; ++p)
        for (std::size_t k = 0; k < width; ++k) {
            Lanes* const to = stokes + p * of.lanes + lane + k;
            LaneVector sum;
            load(to, sum);
            sum += sums[p * width + k];
            store(to, sum);
        }
}

template <std::size_t components>
[[gnu::always_inline]] inline void add_links_of(const LinkRows& of, std::span<const LinkLights> links,
                                                Lanes* stokes) {
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (i + 1 < links.size()) links[i + 1].prefetch();
        const float* const rows = of.rows + i * components * of.row_size;
        Lanes* const to = stokes + i * components * of.lanes;
        std::size_t lane = 0;
        for (; lane + 2 <= of.lanes; lane += 2) add_link<components, 2>(of, rows, links[i], lane, to);
        if (lane < of.lanes) add_link<components, 1>(of, rows, links[i], lane, to);
    }
}

[[gnu::always_inline]] inline void add_all_links(const LinkRows& of, std::span<const LinkLights> links,
                                                 Lanes* stokes) {
    if (of.components == 1) add_links_of<1>(of, links, stokes);
    if (of.components == 3) add_links_of<3>(of, links, stokes);
    if (of.components == 4) add_links_of<4>(of, links, stokes);
}

}  // namespace

void add_links(const LinkRows& rows, std::span<const LinkLights> links, Lanes* stokes) {
    dispatch<add_all_links>(rows, links, stokes);
}

}  // namespace nicol
