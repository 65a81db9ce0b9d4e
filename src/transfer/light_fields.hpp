// SPDX-License-Identifier: MIT
// Conversion between the coefficients of LightLayout and the fields that LaneRotation rotates.
#pragma once

#include <cstddef>
#include <vector>

#include "harmonics/lane_rotation.hpp"
#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Fields of one light: s0, s1 + i s2 and s3, as far as the layout has them.
class LightFields {
public:
    /// Content of the fields.
    enum class Form {
        coefficients,  ///< f_lm
        rotated,       ///< v_lm with f_lm = (-i)^m v_lm, as after a rotation
    };
    LightFields(const LightLayout& layout, Form form);

    /// Sum of two numbers, each times a factor.
    struct Term {
        std::size_t first;
        std::size_t second;
        float first_factor;
        float second_factor;  ///< 0 if there is no second number
    };
    struct Part {
        LightKind component;  ///< unpolarized: s0, linear: s1 + i s2, full: s3
        LaneRotation::Field kind;
        std::size_t begin;             ///< index of the part's first number in the light
        std::vector<Term> to_light;    ///< the light's numbers from real and imaginary parts of the field
        std::vector<Term> from_light;  ///< real and imaginary parts of the field from the light's numbers
    };
    [[nodiscard]] const std::vector<Part>& parts() const noexcept { return parts_; }

    /// Computes the light's numbers from field `field` of `fields` fields that stand side by side.
    static void to_light(const Part& part, const Lanes* all, std::size_t fields, std::size_t field,
                         Lanes* light);
    static void from_light(const Part& part, const Lanes* light, std::size_t fields, std::size_t field,
                           Lanes* all);

private:
    std::vector<Part> parts_;
};

}  // namespace nicol
