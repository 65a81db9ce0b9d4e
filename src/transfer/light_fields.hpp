// SPDX-License-Identifier: MIT
// Between the coefficients of LightLayout and the fields that LaneRotation rotates.
#pragma once

#include <cstddef>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"
#include "transfer/lane_rotation.hpp"

namespace nicol {

/// The fields of one light: s0, s1 + i s2 and s3, as far as the layout has them.
class LightFields {
public:
    /// What the fields hold.
    enum class Form {
        coefficients,  ///< f_lm
        rotated,       ///< v_lm with f_lm = (-i)^m v_lm, as a rotation leaves them
    };
    LightFields(const LightLayout& layout, Form form);

    /// A sum of two factors times numbers.
    struct Term {
        std::size_t first;
        std::size_t second;
        float first_factor;
        float second_factor;  ///< 0: there is no second
    };
    struct Part {
        LightKind component;  ///< unpolarized: s0, linear: s1 + i s2, full: s3
        LaneRotation::Field kind;
        std::size_t begin;             ///< the first of the light's numbers that it has
        std::vector<Term> to_light;    ///< its numbers, from real and imaginary parts of the field
        std::vector<Term> from_light;  ///< the reverse
    };
    [[nodiscard]] const std::vector<Part>& parts() const noexcept { return parts_; }

    /// light = the numbers of field `field` of `fields` ones that stand side by side.
    static void to_light(const Part& part, const Lanes* all, std::size_t fields, std::size_t field,
                         Lanes* light);
    static void from_light(const Part& part, const Lanes* light, std::size_t fields, std::size_t field,
                           Lanes* all);

private:
    std::vector<Part> parts_;
};

}  // namespace nicol
