// SPDX-License-Identifier: MIT
#include "shading/outgoing_shade.hpp"

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "harmonics/spin_harmonics.hpp"
#include "shading/lane_view.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// parts[p] = the sum over the entries of part p of row z exp(i k phi).
[[gnu::always_inline]] inline void evaluate(const std::vector<OutgoingShade::Run>& runs, const Lanes* row,
                                            const Lanes* z_re, const Lanes* z_im, const Lanes* cosine,
                                            const Lanes* sine, Lanes* re_out, Lanes* im_out) {
    LaneVector re[3] = {};
    LaneVector im[3] = {};
    for (const OutgoingShade::Run& run : runs) {
        LaneVector a{};
        LaneVector b{};
        for (std::size_t j = run.first; j < run.last; ++j) {
            LaneVector r;
            LaneVector x;
            LaneVector y;
            load(row + j, r);
            load(z_re + j, x);
            load(z_im + j, y);
            a += r * x;
            b += r * y;
        }
        LaneVector c;
        LaneVector s;
        load(cosine + run.degree, c);
        load(sine + run.degree, s);
        s *= run.sign;
        re[run.part] += a * c - b * s;
        im[run.part] += b * c + a * s;
    }
    for (std::size_t p = 0; p < 3; ++p) {
        store(re_out + p, re[p]);
        store(im_out + p, im[p]);
    }
}

}  // namespace

OutgoingShade::OutgoingShade(const LightLayout& layout) : layout_(layout) {
    const std::size_t n = layout.size();
    for (std::size_t j = 0; j < n; ++j) {
        const LightLayout::Entry& e = layout.entries()[j];
        const std::size_t part = e.part == LightKind::unpolarized ? 0 : e.part == LightKind::linear ? 1 : 2;
        const int k = e.azimuthal_frequency();
        const auto degree = static_cast<std::size_t>(std::abs(k));
        const float sign = k < 0 ? -1.0F : 1.0F;
        if (runs_.empty() || runs_.back().part != part || runs_.back().degree != degree ||
            runs_.back().sign != sign) {
            runs_.push_back({.part = part, .degree = degree, .sign = sign, .first = j, .last = j});
        }
        runs_.back().last = j + 1;
    }

    std::vector<double> scalar(psh_count(layout.order()));
    std::vector<double> spin2(psh_count(layout.order()));
    table_.resize(kAngles * n);
    for (int angle = 0; angle < kAngles; ++angle) {
        const double theta = angle * std::numbers::pi / 2 / (kAngles - 1);
        spin_harmonics(0, layout.order(), theta, scalar);
        spin_harmonics(2, layout.order(), theta, spin2);
        for (std::size_t j = 0; j < n; ++j) {
            const LightLayout::Entry& e = layout.entries()[j];
            const std::size_t index = psh_index(e.l, e.m);
            // Real harmonics of m > 0 are sqrt2 times the parts of the complex ones.
            const double real = e.m > 0 ? std::numbers::sqrt2 * scalar[index] : scalar[index];
            table_[static_cast<std::size_t>(angle) * n + j] =
                static_cast<float>(e.part == LightKind::linear ? spin2[index] : real);
        }
    }
}

void OutgoingShade::run(const OutgoingLight& light, const Viewpoint& view,
                        std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                        std::span<const std::uint8_t> visible, std::size_t first, std::size_t last,
                        std::span<const std::span<glm::vec4>> out) const {
    const std::size_t n = layout_.size();
    LaneView& seen = LaneView::of_thread(layout_.order());
    const std::span<Lanes> both = work_space<OutgoingShade, Lanes>(n + light.stride());
    const std::span<Lanes> row = both.first(n);
    const std::span<Lanes> z = both.subspan(n);
    for (std::size_t begin = first; begin < last; begin += kLanes) {
        const std::size_t count = std::min(kLanes, last - begin);
        if (std::ranges::none_of(visible.subspan(begin, count), [](std::uint8_t v) { return v != 0; }))
            continue;
        seen.set(view, positions.subspan(begin, count), normals.subspan(begin, count));
        const LaneView::TablePositions at = seen.positions_in(kAngles);
        std::array<const float*, kLanes> from;
        for (std::size_t i = 0; i < kLanes; ++i) {
            from[i] = table_.data() + static_cast<std::size_t>(at.angle[i]) * n;
        }
        to_lanes_between(from, n, at.fraction, n, row.data());
        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            const bool repeated = light.channels() == 1 && channel > 0;
            std::array<Lanes, 3> re;
            std::array<Lanes, 3> im;
            if (!repeated) {
                for (std::size_t i = 0; i < kLanes; ++i) {
                    from[i] = light.at(begin + (i < count ? i : 0), static_cast<int>(channel)).data();
                }
                to_lanes(from, light.stride(), z.data());
                dispatch<evaluate>(runs_, row.data(), z.data(), z.data() + n, seen.cosines(), seen.sines(),
                                   re.data(), im.data());
            }
            for (std::size_t i = 0; i < count; ++i) {
                if (visible[begin + i] == 0) continue;
                glm::vec4& stokes = out[channel][begin + i];
                if (repeated) {
                    stokes = out[0][begin + i];
                    continue;
                }
                const float c = seen.frame_cosine()[i];
                const float s = seen.frame_sine()[i];
                stokes = {re[0][i], c * re[1][i] + s * im[1][i], c * im[1][i] - s * re[1][i], im[2][i]};
            }
        }
    }
}

}  // namespace nicol
