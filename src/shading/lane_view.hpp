// SPDX-License-Identifier: MIT
// View directions of sixteen vertices, for interpolation in a table over them.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "polarization/views.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// View angles of sixteen vertices. Holds results, so each thread needs its own object.
class LaneView {
public:
    /// Takes the highest azimuthal frequency.
    explicit LaneView(int order);
    /// Returns the object of the calling thread.
    [[nodiscard]] static LaneView& of_thread(int order);

    /// Sets at most kLanes positions and their unit normals; the other lanes repeat the first. A normal that
    /// faces away is treated as viewed at 90 degrees, because its triangle may still face the camera.
    void set(const Views& views, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);

    /// Positions of the viewer's zenith angles in a table of `angles` angles from 0 to pi/2: the element
    /// below, and the weight of the element above.
    struct TablePositions {
        std::array<int, kLanes> angle;
        Lanes fraction;
    };
    [[nodiscard]] TablePositions positions_in(int angles) const;

    /// Returns the cosines (or sines) of m phi for m = 0..order; phi is the azimuth of the viewer.
    [[nodiscard]] const Lanes* cosines() const noexcept { return cosines_.data(); }
    [[nodiscard]] const Lanes* sines() const noexcept { return sines_.data(); }

    /// Rotates Stokes vectors from the theta-phi frame about the normal to the camera's frame field.
    void into_camera_frame(std::array<Lanes, 4>& stokes) const {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float s1 = stokes[1][i];
            const float s2 = stokes[2][i];
            stokes[1][i] = frame_cosine_[i] * s1 + frame_sine_[i] * s2;
            stokes[2][i] = frame_cosine_[i] * s2 - frame_sine_[i] * s1;
        }
    }
    /// Rotates Stokes vectors back; also the transpose of into_camera_frame().
    void out_of_camera_frame(std::array<Lanes, 4>& stokes) const {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float s1 = stokes[1][i];
            const float s2 = stokes[2][i];
            stokes[1][i] = frame_cosine_[i] * s1 - frame_sine_[i] * s2;
            stokes[2][i] = frame_cosine_[i] * s2 + frame_sine_[i] * s1;
        }
    }

private:
    std::vector<Lanes> cosines_;
    std::vector<Lanes> sines_;
    Lanes zenith_;        // zenith angle over pi/2, at most 1
    Lanes frame_cosine_;  // cosine and sine of the rotation of (s1, s2)
    Lanes frame_sine_;
};

}  // namespace nicol
