// SPDX-License-Identifier: MIT
// The view directions of sixteen vertices: what interpolation in a table over them needs.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "polarization/viewpoint.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Holds results; one object a thread.
class LaneView {
public:
    /// order: the highest azimuthal frequency.
    explicit LaneView(int order);
    /// An object that belongs to the calling thread.
    [[nodiscard]] static LaneView& of_thread(int order);

    /// At most kLanes positions and their unit normals; the other lanes repeat the first. A normal that faces
    /// away is treated as viewed at 90 degrees: the triangle may face the camera all the same.
    void set(const Viewpoint& view, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);

    /// Zenith angles of the viewer as positions in a table of `angles` from 0 to pi/2: the elements below,
    /// and the weights of those above.
    struct TablePositions {
        std::array<int, kLanes> angle;
        Lanes fraction;
    };
    [[nodiscard]] TablePositions positions_in(int angles) const;

    /// cos and sin of m phi for m = 0..order, phi the azimuth of the viewer.
    [[nodiscard]] const Lanes* cosines() const noexcept { return cosines_.data(); }
    [[nodiscard]] const Lanes* sines() const noexcept { return sines_.data(); }

    /// Stokes vectors from the theta-phi frame about the normal to the camera's frame field.
    void into_camera_frame(std::array<Lanes, 4>& stokes) const {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float s1 = stokes[1][i];
            const float s2 = stokes[2][i];
            stokes[1][i] = frame_cosine_[i] * s1 + frame_sine_[i] * s2;
            stokes[2][i] = frame_cosine_[i] * s2 - frame_sine_[i] * s1;
        }
    }

private:
    std::vector<Lanes> cosines_;
    std::vector<Lanes> sines_;
    Lanes zenith_;        // over pi/2, at most 1
    Lanes frame_cosine_;  // cos and sin of the rotation of (s1, s2)
    Lanes frame_sine_;
};

}  // namespace nicol
