// SPDX-License-Identifier: MIT
#include "shading/lane_view.hpp"

#include <algorithm>
#include <cmath>

#include "polarization/lane_points.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_angle.hpp"
#include "simd/lane_phases.hpp"

namespace nicol {
namespace {

// Results of find_view(), before the multiples of the azimuth.
struct ViewAngles {
    DoubleLanes azimuth_cosine, azimuth_sine;
    Lanes zenith, frame_cosine, frame_sine;
};

// Finds the view angles. Differences and the directions of tiny vectors are computed in double precision, in
// loops of their own, which GCC vectorises.
template <class Sights>
[[gnu::always_inline]] inline void find_view(const Sights& sights, const LanePoints& position,
                                             const LanePoints& normal, ViewAngles& out) {
    LaneVectors towards;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Vector3<float> w = sight_at(sights, position, i);
        towards.x.value[i] = w.x;
        towards.y.value[i] = w.y;
        towards.z.value[i] = w.z;
    }
    LaneVectors surface;  // cos phi, sin phi and rho of the frame about the normal
    for (std::size_t i = 0; i < kLanes; ++i) {
        const ThetaPhiFrame<double> f = theta_phi_axes(point_at(normal, i));
        surface.x.value[i] = static_cast<float>(f.cos_phi);
        surface.y.value[i] = static_cast<float>(f.sin_phi);
        surface.z.value[i] = static_cast<float>(f.rho);
    }
    const auto x_axes = frame_x(sights);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const ThetaPhiFrame<float> about_normal{surface.x.value[i], surface.y.value[i], surface.z.value[i],
                                                in_floats(point_at(normal, i))};
        const Vector3<float> w{towards.x.value[i], towards.y.value[i], towards.z.value[i]};
        const Vector3<float> local = in_frame(about_normal, w);
        // Any azimuth is valid at the zenith, because the table's values there rotate with the frame.
        // This variable is not const, because GCC 12 then does not vectorise the loop.
        ThetaPhiFrame<float> about_view = theta_phi_axes(local);
        out.azimuth_cosine.value[i] = static_cast<double>(about_view.cos_phi);
        out.azimuth_sine.value[i] = static_cast<double>(about_view.sin_phi);
        quarter_turns(about_view.rho, local.z > 0 ? local.z : 0, out.zenith.value[i]);

        const Vector3<float> x = in_frame(about_view, in_frame(about_normal, x_axes.at(i, w)));
        const float inverse = 1 / (x.x * x.x + x.y * x.y);
        out.frame_cosine.value[i] = (x.x * x.x - x.y * x.y) * inverse;
        out.frame_sine.value[i] = 2 * x.x * x.y * inverse;
    }
}

}  // namespace

LaneView& LaneView::of_thread(int order) {
    thread_local LaneView kept(order);
    if (kept.cosines_.size() != static_cast<std::size_t>(order) + 1) kept = LaneView(order);
    return kept;
}

LaneView::LaneView(int order)
    : cosines_(static_cast<std::size_t>(order) + 1), sines_(static_cast<std::size_t>(order) + 1) {}

void LaneView::set(const Views& views, std::span<const glm::vec3> positions,
                   std::span<const glm::vec3> normals) {
    ViewAngles found;
    with_sights(views, positions, [&]<class Sights>(const Sights& sights) {
        dispatch<find_view<Sights>>(sights, lane_points(positions), lane_points(normals), found);
    });
    raise_phases(found.azimuth_cosine, found.azimuth_sine, cosines_.size(), cosines_.data(), sines_.data());
    zenith_ = found.zenith;
    frame_cosine_ = found.frame_cosine;
    frame_sine_ = found.frame_sine;
}

LaneView::TablePositions LaneView::positions_in(int angles) const {
    TablePositions out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = (zenith_[i] > 0 ? zenith_[i] : 0) * static_cast<float>(angles - 1);
        const int angle = std::clamp(static_cast<int>(x), 0, angles - 2);
        out.angle[i] = angle;
        out.fraction[i] = x - static_cast<float>(angle);
    }
    return out;
}

}  // namespace nicol
