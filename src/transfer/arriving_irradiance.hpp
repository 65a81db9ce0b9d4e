// SPDX-License-Identifier: MIT
// Correction of light that is cut at an order by the irradiance of all its orders.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Changes light of few orders so that a matt surface reflects exactly what arrives. Cut at order 3, light
/// from 60 degrees beside the normal would have .84 of its irradiance, light from 85 degrees twice of it.
class ArrivingIrradiance {
public:
    explicit ArrivingIrradiance(const LightLayout& layout);

    /// Changes the numbers of s0 as little as possible, by the sum of squares, so that their irradiance over
    /// pi is this one. numbers: of lights in their surfaces' frames after add_mirror_image(), in the
    /// layout's order.
    void set(const Lanes& irradiance, std::span<Lanes> numbers) const;

private:
    struct Part {
        std::size_t number;
        float irradiance;  // over pi, of a number of 1
    };
    std::vector<Part> parts_;
    float square_ = 0;
};

}  // namespace nicol
