// SPDX-License-Identifier: MIT
#include "shading/background.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/environment_texels.hpp"
#include "polarization/lane_points.hpp"
#include "polarization/view_geometry.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
// Image positions of rays: turns about the vertical, and half turns from the zenith. cosine and sine rotate
// (s1, s2) from the image's frame, with x along growing u, to the camera's frame: cos s1 + sin s2 and cos s2
// - sin s1.
struct BackgroundPlaces {
    Lanes turn, half_turn;
    Lanes cosine, sine;
};

namespace {

[[gnu::always_inline]] inline void find_places(const LaneVectors& rays, const glm::vec3& up,
                                               BackgroundPlaces& out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = rays.x.value[i];
        const float y = rays.y.value[i];
        const float z = rays.z.value[i];
        const EquirectPlace<float> place = equirect_place(x, y, z);
        const float across = place.across;
        out.turn.value[i] = place.turn;
        out.half_turn.value[i] = place.half_turn;

        // The x axes of both frames are orthogonal to the ray: ray x up, and (-z, 0, x) or, at the poles, (1,
        // 0, 0).
        const Vector3<float> ray{x, y, z};
        const Vector3<float> to = cross(ray, Vector3<float>{up.x, up.y, up.z});
        const Vector3<float> from{across > 0 ? -z : 1.0F, 0, across > 0 ? x : 0.0F};
        float c = 0;
        dot(to, from, c);
        float s = 0;
        dot(to, cross(from, ray), s);
        const float length = std::sqrt(x * x + z * z + y * y);
        const float along = c * length;
        const float inverse = 1 / (along * along + s * s);
        out.cosine.value[i] = (along * along - s * s) * inverse;
        out.sine.value[i] = 2 * along * s * inverse;
    }
}

}  // namespace

// Up to kLanes pixels that show the environment.
struct Background::Pixels {
    std::size_t count = 0;
    std::array<std::size_t, kLanes> index;
    std::array<float, kLanes> weight;
    LaneVectors rays;
    BackgroundPlaces places;
};

Background::Background(const Environment& environment, int channels)
    : polarized_(environment.polarized()),
      texels_(texels_of(environment, polarized_, static_cast<std::size_t>(channels))) {}

void Background::add(const PixelRays& rays, float scale, std::size_t components, std::size_t first,
                     std::size_t last, std::span<const float> coverage,
                     std::span<const std::span<glm::vec4>> out) const {
    Pixels pixels;
    const auto flush = [&] {
        for (std::size_t i = pixels.count; i < kLanes; ++i) {
            pixels.rays.x[i] = pixels.rays.x[0];
            pixels.rays.y[i] = pixels.rays.y[0];
            pixels.rays.z[i] = pixels.rays.z[0];
        }
        dispatch<find_places>(pixels.rays, rays.up, pixels.places);
        add(pixels, components, out);
        pixels.count = 0;
    };
    std::size_t row = first / rays.width;
    std::size_t column = first % rays.width;
    for (std::size_t i = first; i < last; ++i) {
        const float uncovered = 1 - coverage[i - first];
        if (uncovered > 0) {
            const glm::vec3 ray =
                rays.first + static_cast<float>(column) * rays.right + static_cast<float>(row) * rays.down;
            const std::size_t lane = pixels.count++;
            pixels.index[lane] = i;
            pixels.weight[lane] = scale * uncovered;
            pixels.rays.x[lane] = ray.x;
            pixels.rays.y[lane] = ray.y;
            pixels.rays.z[lane] = ray.z;
            if (pixels.count == kLanes) flush();
        }
        if (++column == rays.width) {
            column = 0;
            ++row;
        }
    }
    if (pixels.count > 0) flush();
}

void Background::add(const Pixels& pixels, std::size_t components,
                     std::span<const std::span<glm::vec4>> out) const {
    for (std::size_t lane = 0; lane < pixels.count; ++lane) {
        const std::size_t pixel = pixels.index[lane];
        const float weight = pixels.weight[lane];
        if (!polarized_) {
            glm::vec4 s0(0);
            for (std::size_t c = 0; c < out.size(); ++c) {
                if (c % 4 == 0) s0 = weight * at(c / 4, pixels, lane);
                out[c][pixel].x += s0[static_cast<glm::length_t>(c % 4)];
            }
            continue;
        }
        const float cosine = pixels.places.cosine[lane];
        const float sine = pixels.places.sine[lane];
        for (std::size_t c = 0; c < out.size(); ++c) {
            const glm::vec4 s = weight * at(c, pixels, lane);
            const glm::vec4 rotated(s.x, cosine * s.y + sine * s.z, cosine * s.z - sine * s.y, s.w);
            for (std::size_t p = 0; p < components; ++p) {
                const auto component = static_cast<glm::length_t>(p);
                out[c][pixel][component] += rotated[component];
            }
        }
    }
}

glm::vec4 Background::at(std::size_t plane, const Pixels& pixels, std::size_t lane) const {
    return texels_.at(plane, pixels.places.turn[lane], pixels.places.half_turn[lane]);
}

}  // namespace nicol
