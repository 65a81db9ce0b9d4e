// SPDX-License-Identifier: MIT
#include "specular/high_order_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "error.hpp"
#include "harmonics/order_gains.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
constexpr int kMostOrder = 64;

struct Tables {
    int order;
    const float* lobe;
    const float* cosine;
    const float* recurrence;
};

[[gnu::always_inline]] inline void store_fraction(const LaneVector& seen, Lanes* out) {
    const LaneVector part = seen > 0.0F ? seen : LaneVector{};
    store(out, part < 1.0F ? part : LaneVector{} + 1.0F);
}

// Computes both fractions of sixteen vertices. Y_lm = P_lm(z) times the real or imaginary part of (x + i
// y)^m, which includes the powers of the sine. Odd l + m are skipped because visibility has no such
// coefficients.
[[gnu::always_inline]] inline void filter(const Tables& tables, const std::int16_t* visibility,
                                          const LaneVectors& d, Lanes* fractions) {
    LaneVector x;
    LaneVector y;
    LaneVector z;
    load(&d.x, x);
    load(&d.y, y);
    load(&d.z, z);
    LaneVector seen{};
    LaneVector base_seen{};
    const float* recurrence = tables.recurrence;
    auto start = static_cast<float>(1 / std::sqrt(4 * pi));
    LaneVector cosine = LaneVector{} + 1.0F;
    LaneVector sine{};
    for (int m = 0; m <= tables.order; ++m) {
        LaneVector value = LaneVector{} + start;
        LaneVector before{};
        for (int l = m; l <= tables.order; ++l) {
            if (l > m) {
                const LaneVector next = recurrence[0] * z * value - recurrence[1] * before;
                before = value;
                value = next;
                recurrence += 2;
            }
            if ((l + m) % 2 != 0) continue;
            const LaneVector scaled = tables.lobe[l] * value;
            LaneVector v;
            load(visibility, v);
            visibility += kLanes;
            if (m == 0) {
                seen += scaled * v;
                base_seen += tables.cosine[l] * v;
            } else {
                LaneVector w;
                load(visibility, w);
                visibility += kLanes;
                seen += scaled * (cosine * v + sine * w);
            }
        }
        const auto next = static_cast<float>(m + 1);
        start *= -std::sqrt((2 * next + 1) / (2 * next));
        if (m == 0) start *= std::numbers::sqrt2_v<float>;
        const LaneVector rotated = cosine * x - sine * y;
        sine = sine * x + cosine * y;
        cosine = rotated;
    }
    constexpr float one = VisibilityBlocks::kOne;
    store_fraction(seen * (1 / one), fractions);
    store_fraction(base_seen * (1 / one), fractions + 1);
}

}  // namespace

HighOrderVisibility::HighOrderVisibility(int order, double width) : order_(order) {
    if (order < 0 || order > kMostOrder) {
        throw Error(ErrorCode::invalid_argument, "the order of visibility is " + std::to_string(order) +
                                                     "; it must lie in 0 to " + std::to_string(kMostOrder));
    }
    if (!(width >= 0 && width <= 4)) {
        throw Error(ErrorCode::invalid_argument,
                    "the width of a lobe is " + std::to_string(width) + "; it must lie in 0 to 4 radians");
    }
    // The minimum width leaves a gain of about 1/4 at the last order, so that the lobe hardly rings.
    const OrderGains lobe = gaussian_gains(std::max(width, 1.7 / (order + 1)), 0, order);
    lobe_.assign(lobe.begin(), lobe.end());
    const OrderGains cosine = cosine_gains(0, order);
    for (int l = 0; l <= order; ++l) {
        const double norm = std::sqrt((2 * l + 1) / (4 * pi));
        cosine_.push_back(
            static_cast<float>(cosine[static_cast<std::size_t>(l)] * norm * (l % 2 == 0 ? 1 : -1)));
    }
    for (int m = 0; m <= order; ++m) {
        for (int l = m + 1; l <= order; ++l) {
            const double l2 = l * l;
            const double m2 = m * m;
            const double before = (l - 1.0) * (l - 1.0);
            recurrence_.push_back(static_cast<float>(std::sqrt((4 * l2 - 1) / (l2 - m2))));
            recurrence_.push_back(
                static_cast<float>(std::sqrt((2 * l + 1) * (before - m2) / ((2 * l - 3) * (l2 - m2)))));
        }
    }
}

std::vector<float> HighOrderVisibility::constants() const {
    std::vector<float> all;
    for (const std::vector<float>* table : {&lobe_, &cosine_, &recurrence_}) {
        all.insert(all.end(), table->begin(), table->end());
    }
    return all;
}

void HighOrderVisibility::run(const Viewpoint& view, std::span<const glm::vec3> positions,
                              std::span<const glm::vec3> normals, std::span<const std::uint8_t> visible,
                              const VisibilityBlocks& seen, std::size_t first, std::size_t last,
                              std::span<glm::vec2> out) const {
    std::array<Lanes, 2> fractions;
    for (std::size_t begin = first / kLanes * kLanes; begin < last; begin += kLanes) {
        const std::size_t from = std::max(begin, first);
        const std::size_t to = std::min(begin + kLanes, last);
        if (std::ranges::none_of(visible.subspan(from, to - from), [](std::uint8_t v) { return v != 0; }))
            continue;
        if (const std::int16_t* const block = seen.block(begin / kLanes)) {
            const std::size_t all = std::min(kLanes, positions.size() - begin);
            filter_block(mirror_views(view, glm::dmat3(1.0), positions.subspan(begin, all),
                                      normals.subspan(begin, all)),
                         block, fractions);
        } else {
            for (Lanes& lanes : fractions) lanes.value.fill(1.0F);
        }
        for (std::size_t v = from; v < to; ++v) {
            if (visible[v] != 0) out[v] = {fractions[0][v - begin], fractions[1][v - begin]};
        }
    }
}

void HighOrderVisibility::filter_block(const LaneMirror& mirror, const std::int16_t* block,
                                       std::array<Lanes, 2>& fractions) const {
    const Tables tables{
        .order = order_, .lobe = lobe_.data(), .cosine = cosine_.data(), .recurrence = recurrence_.data()};
    dispatch<filter>(tables, block, mirror.local, fractions.data());
}

}  // namespace nicol
