// SPDX-License-Identifier: MIT
#include "shading/lane_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "polarization/lane_camera.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_angle.hpp"
#include "simd/lane_phases.hpp"

namespace nicol {
namespace {

// What look() finds, before powers are raised.
struct Sight {
    DoubleLanes azimuth_cosine, azimuth_sine;
    Lanes zenith, frame_cosine, frame_sine;
};

// atan(rise / run) over pi/2 for what is not negative; 1 where both are 0.
[[gnu::always_inline]] inline float quarter_of(float rise, float run) {
    const bool steep = rise >= run;
    const float large = steep ? rise : run;
    const float ratio = (steep ? run : rise) / (large > 0 ? large : 1.0F);
    float angle = arctangent_rest(ratio);
    angle = angle * (2 / std::numbers::pi_v<float>)+(beyond_eighth(ratio) ? 0.5F : 0.0F);
    return steep ? 1 - angle : angle;
}

// Double precision where a difference or the direction of something tiny is at stake.
[[gnu::always_inline]] inline void find_sight(const LaneCamera& camera, const LanePoints& position,
                                              const LanePoints& normal, Sight& out) {
    struct Floats {
        alignas(64) std::array<float, kLanes> x, y, z;
    };
    Floats normals;
    Floats towards;
    alignas(64) std::array<float, kLanes> cos_phi;
    alignas(64) std::array<float, kLanes> sin_phi;
    alignas(64) std::array<float, kLanes> around;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double wx = camera.eye[0] - position.x.value[i];
        const double wy = camera.eye[1] - position.y.value[i];
        const double wz = camera.eye[2] - position.z.value[i];
        // A point at the camera counts as one straight ahead, as Viewpoint::towards has it.
        const double distance = std::sqrt(wx * wx + wy * wy + wz * wz);
        const bool ahead = camera.orthographic || distance == 0;
        const double nearness = 1 / (ahead ? 1 : distance);
        towards.x[i] = static_cast<float>(ahead ? camera.backward[0] : wx * nearness);
        towards.y[i] = static_cast<float>(ahead ? camera.backward[1] : wy * nearness);
        towards.z[i] = static_cast<float>(ahead ? camera.backward[2] : wz * nearness);
    }
    // The frame of the surface, as theta_phi_frame has it.
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double nx = normal.x.value[i];
        const double ny = normal.y.value[i];
        const double rho = std::sqrt(nx * nx + ny * ny);
        const double inverse = 1 / (rho > 0 ? rho : 1);
        cos_phi[i] = static_cast<float>(rho > 0 ? nx * inverse : 1);
        sin_phi[i] = static_cast<float>(ny * inverse);
        around[i] = static_cast<float>(rho);
        normals.x[i] = static_cast<float>(nx);
        normals.y[i] = static_cast<float>(ny);
        normals.z[i] = static_cast<float>(normal.z.value[i]);
    }
    const auto up_x = static_cast<float>(camera.up[0]);
    const auto up_y = static_cast<float>(camera.up[1]);
    const auto up_z = static_cast<float>(camera.up[2]);
    const auto right_x = static_cast<float>(camera.right[0]);
    const auto right_y = static_cast<float>(camera.right[1]);
    const auto right_z = static_cast<float>(camera.right[2]);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float wx = towards.x[i];
        const float wy = towards.y[i];
        const float wz = towards.z[i];
        const float nz = normals.z[i];
        const float x = nz * (cos_phi[i] * wx + sin_phi[i] * wy) - around[i] * wz;
        const float y = cos_phi[i] * wy - sin_phi[i] * wx;
        const float z = normals.x[i] * wx + normals.y[i] * wy + nz * wz;
        const float rho = std::sqrt(x * x + y * y);
        // What a table has at the zenith turns with the frame there, so that any azimuth will do.
        const float inverse_rho = 1 / (rho > 0 ? rho : 1);
        const float c = rho > 0 ? x * inverse_rho : 1;
        const float s = y * inverse_rho;
        out.azimuth_cosine.value[i] = static_cast<double>(c);
        out.azimuth_sine.value[i] = static_cast<double>(s);
        out.zenith.value[i] = quarter_of(rho > 0 ? rho : 0, z > 0 ? z : 0);

        // x of the camera's frame field, as Viewpoint::frame has it, but for its length.
        float ax = up_y * wz - up_z * wy;
        float ay = up_z * wx - up_x * wz;
        float az = up_x * wy - up_y * wx;
        const bool defined = ax * ax + ay * ay + az * az > 1e-12F;
        ax = defined ? ax : right_x;
        ay = defined ? ay : right_y;
        az = defined ? az : right_z;
        const float along = ax * wx + ay * wy + az * wz;
        ax -= along * wx;
        ay -= along * wy;
        az -= along * wz;
        // In the frame of the surface, then along theta-hat and phi-hat at the view direction.
        const float bx = nz * (cos_phi[i] * ax + sin_phi[i] * ay) - around[i] * az;
        const float by = cos_phi[i] * ay - sin_phi[i] * ax;
        const float bz = normals.x[i] * ax + normals.y[i] * ay + nz * az;
        const float p = z * (bx * c + by * s) - bz * rho;
        const float q = by * c - bx * s;
        const float inverse = 1 / (p * p + q * q);
        out.frame_cosine.value[i] = (p * p - q * q) * inverse;
        out.frame_sine.value[i] = 2 * p * q * inverse;
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

void LaneView::look(const Viewpoint& view, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> normals) {
    Sight sight;
    dispatch<find_sight>(lane_camera(view), lane_points(positions), lane_points(normals), sight);
    raise_phases(sight.azimuth_cosine, sight.azimuth_sine, cosines_.size(), cosines_.data(), sines_.data());
    zenith_ = sight.zenith;
    frame_cosine_ = sight.frame_cosine;
    frame_sine_ = sight.frame_sine;
}

LaneView::TablePositions LaneView::positions_in(int angles) const {
    TablePositions out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = zenith_[i] * static_cast<float>(angles - 1);
        const int angle = std::clamp(static_cast<int>(x), 0, angles - 2);
        out.angle[i] = angle;
        out.fraction[i] = x - static_cast<float>(angle);
    }
    return out;
}

}  // namespace nicol
