// SPDX-License-Identifier: MIT
// Viewpoints of points: one that all points share, or one for each point.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/lane_points.hpp"
#include "polarization/viewpoint.hpp"

namespace nicol {

/// View of Viewpoint objects, which must outlive it. Light that a ray collects is received by an orthographic
/// viewpoint that looks along the ray.
class Views {
public:
    /// One viewpoint for all points. Implicit, because most callers have one camera.
    Views(const Viewpoint& shared)
        : views_(&shared, 1), shared_(true) {}  // NOLINT(google-explicit-constructor)
    explicit Views(std::span<const Viewpoint> each) : views_(each), shared_(false) {}

    [[nodiscard]] bool shared() const noexcept { return shared_; }
    [[nodiscard]] const Viewpoint& at(std::size_t point) const { return views_[shared_ ? 0 : point]; }
    [[nodiscard]] Views subspan(std::size_t first, std::size_t count) const {
        return shared_ ? *this : Views(views_.subspan(first, count));
    }

private:
    std::span<const Viewpoint> views_;
    bool shared_;
};

/// Sixteen points with viewpoints of their own.
struct LaneSights {
    LaneVectors towards;  ///< unit vectors towards the viewers
    LaneVectors x;        ///< x axes of the viewers' frames, see Viewpoint::frame()
};

/// Returns the sights of at most kLanes points; the other lanes repeat the first. Out of line, because loops
/// over lanes take either sights or the camera's axes.
[[nodiscard]] LaneSights lane_sights(Views views, std::span<const glm::vec3> positions);

/// Returns element i of vectors side by side.
[[gnu::always_inline]] inline Vector3<double> point_at(const LanePoints& from, std::size_t i) {
    return {from.x.value[i], from.y.value[i], from.z.value[i]};
}

/// Calls loop(camera) with the CameraAxes that all points share, or with the LaneSights of the points.
template <class Loop>
void with_sights(const Views& views, std::span<const glm::vec3> positions, const Loop& loop) {
    if (views.shared())
        loop(views.at(0).axes());
    else
        loop(lane_sights(views, positions));
}

/// Returns the unit vector from point i towards its viewer, in single precision.
[[gnu::always_inline]] inline Vector3<float> sight_at(const CameraAxes& camera, const LanePoints& positions,
                                                      std::size_t i) {
    return in_floats(towards_camera(camera, point_at(positions, i)));
}
[[gnu::always_inline]] inline Vector3<float> sight_at(const LaneSights& sights, const LanePoints& /*points*/,
                                                      std::size_t i) {
    return {sights.towards.x.value[i], sights.towards.y.value[i], sights.towards.z.value[i]};
}

/// x axes of the viewers' frames, for loops over lanes.
struct SharedFrameX {
    Vector3<float> up, right;

    /// Returns the axes of the lanes from `first` on, whose unit vectors towards the viewer are w.
    template <class Number>
    [[gnu::always_inline]] Vector3<Number> at(std::size_t /*first*/, const Vector3<Number>& w) const {
        return camera_x(up, right, w);
    }
};
struct LaneFrameX {
    const LaneVectors& x;

    [[gnu::always_inline]] Vector3<float> at(std::size_t i, const Vector3<float>& /*w*/) const {
        return {x.x.value[i], x.y.value[i], x.z.value[i]};
    }
    template <class Number>
    [[gnu::always_inline]] Vector3<Number> at(std::size_t first, const Vector3<Number>& /*w*/) const {
        Vector3<Number> out;
        load_part(x, first, out);
        return out;
    }
};
[[gnu::always_inline]] inline SharedFrameX frame_x(const CameraAxes& camera) {
    return {.up = in_floats(camera.up), .right = in_floats(camera.right)};
}
[[gnu::always_inline]] inline LaneFrameX frame_x(const LaneSights& sights) {
    return {sights.x};
}

}  // namespace nicol
