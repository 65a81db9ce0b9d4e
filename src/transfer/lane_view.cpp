// SPDX-License-Identifier: MIT
#include "transfer/lane_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "transfer/simd.hpp"

namespace nicol {
namespace {

struct alignas(64) Doubles {
    std::array<double, kLanes> value;
};

struct Points {
    Doubles x, y, z;
};

// Of a Viewpoint.
struct Camera {
    bool orthographic;
    std::array<double, 3> eye, backward, up, right;
};

// What look() finds, before powers are raised.
struct Sight {
    Doubles azimuth_cosine, azimuth_sine;
    Lanes zenith, frame_cosine, frame_sine;
};

// atan(rise / run) over pi/2 for what is not negative; 1 where both are 0.
[[gnu::always_inline]] inline float quarter_of(float rise, float run) {
    const bool steep = rise >= run;
    const float large = steep ? rise : run;
    const float ratio = (steep ? run : rise) / (large > 0 ? large : 1.0F);
    // At most tan(pi/8): the fit of atan(t) / t in t^2 is then good to 2e-8.
    const bool beyond = ratio > 0.41421356F;
    const float t = beyond ? (ratio - 1) / (ratio + 1) : ratio;
    const float z = t * t;
    float angle =
        t * (0.99999998F + z * (-0.33332786F + z * (0.19974082F + z * (-0.13848490F + z * 0.07976292F))));
    angle = angle * (2 / std::numbers::pi_v<float>)+(beyond ? 0.5F : 0.0F);
    return steep ? 1 - angle : angle;
}

NICOL_MULTIVERSION
void find_sight(const Camera& camera, const Points& position, const Points& normal, Sight& out) {
    alignas(64) std::array<float, kLanes> rise;
    alignas(64) std::array<float, kLanes> run;
    for (std::size_t i = 0; i < kLanes; ++i) {
        // The frame of the surface, as theta_phi_frame has it.
        const double nx = normal.x.value[i];
        const double ny = normal.y.value[i];
        const double nz = normal.z.value[i];
        const double around = std::sqrt(nx * nx + ny * ny);
        const double inverse_around = 1 / (around > 0 ? around : 1);
        const double cos_phi = around > 0 ? nx * inverse_around : 1;
        const double sin_phi = ny * inverse_around;

        double wx = camera.eye[0] - position.x.value[i];
        double wy = camera.eye[1] - position.y.value[i];
        double wz = camera.eye[2] - position.z.value[i];
        // A point at the camera counts as one straight ahead, as Viewpoint::towards has it.
        const double distance = std::sqrt(wx * wx + wy * wy + wz * wz);
        const bool ahead = camera.orthographic || distance == 0;
        const double inverse_distance = 1 / (ahead ? 1 : distance);
        wx = ahead ? camera.backward[0] : wx * inverse_distance;
        wy = ahead ? camera.backward[1] : wy * inverse_distance;
        wz = ahead ? camera.backward[2] : wz * inverse_distance;

        const double x = nz * (cos_phi * wx + sin_phi * wy) - around * wz;
        const double y = cos_phi * wy - sin_phi * wx;
        const double z = nx * wx + ny * wy + nz * wz;
        const double rho = std::sqrt(x * x + y * y);
        const double inverse_rho = 1 / (rho > 0 ? rho : 1);
        const double c = rho > 0 ? x * inverse_rho : 1;
        const double s = y * inverse_rho;
        out.azimuth_cosine.value[i] = c;
        out.azimuth_sine.value[i] = s;
        rise[i] = static_cast<float>(rho > 0 ? rho : 0);
        run[i] = static_cast<float>(z > 0 ? z : 0);

        // x of the camera's frame field, as Viewpoint::frame has it, but for its length.
        double ax = camera.up[1] * wz - camera.up[2] * wy;
        double ay = camera.up[2] * wx - camera.up[0] * wz;
        double az = camera.up[0] * wy - camera.up[1] * wx;
        const bool defined = ax * ax + ay * ay + az * az > 1e-12;
        ax = defined ? ax : camera.right[0];
        ay = defined ? ay : camera.right[1];
        az = defined ? az : camera.right[2];
        const double along = ax * wx + ay * wy + az * wz;
        ax -= along * wx;
        ay -= along * wy;
        az -= along * wz;
        // In the frame of the surface, then along theta-hat and phi-hat at the view direction.
        const double bx = nz * (cos_phi * ax + sin_phi * ay) - around * az;
        const double by = cos_phi * ay - sin_phi * ax;
        const double bz = nx * ax + ny * ay + nz * az;
        const double p = z * (bx * c + by * s) - bz * rho;
        const double q = by * c - bx * s;
        const double inverse = 1 / (ax * ax + ay * ay + az * az);
        out.frame_cosine.value[i] = static_cast<float>((p * p - q * q) * inverse);
        out.frame_sine.value[i] = static_cast<float>(2 * p * q * inverse);
    }
    for (std::size_t i = 0; i < kLanes; ++i) out.zenith.value[i] = quarter_of(rise[i], run[i]);
}

NICOL_MULTIVERSION
void raise(const Doubles& cosine, const Doubles& sine, std::size_t count, Lanes* cosines, Lanes* sines) {
    Doubles re;
    Doubles im{};
    re.value.fill(1);
    for (std::size_t m = 0; m < count; ++m) {
        for (std::size_t i = 0; i < kLanes; ++i) cosines[m].value[i] = static_cast<float>(re.value[i]);
        for (std::size_t i = 0; i < kLanes; ++i) sines[m].value[i] = static_cast<float>(im.value[i]);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const double next = re.value[i] * cosine.value[i] - im.value[i] * sine.value[i];
            im.value[i] = im.value[i] * cosine.value[i] + re.value[i] * sine.value[i];
            re.value[i] = next;
        }
    }
}

std::array<double, 3> components(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Points spread(std::span<const glm::vec3> from) {
    Points to;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3& v = from[i < from.size() ? i : 0];
        to.x.value[i] = static_cast<double>(v.x);
        to.y.value[i] = static_cast<double>(v.y);
        to.z.value[i] = static_cast<double>(v.z);
    }
    return to;
}

}  // namespace

LaneView::LaneView(int order)
    : cosines_(static_cast<std::size_t>(order) + 1), sines_(static_cast<std::size_t>(order) + 1) {}

void LaneView::look(const Viewpoint& view, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> normals) {
    const Camera camera{.orthographic = view.orthographic,
                        .eye = components(view.eye),
                        .backward = components(-view.forward),
                        .up = components(view.up),
                        .right = components(view.right)};
    Sight sight;
    find_sight(camera, spread(positions), spread(normals), sight);
    raise(sight.azimuth_cosine, sight.azimuth_sine, cosines_.size(), cosines_.data(), sines_.data());
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
