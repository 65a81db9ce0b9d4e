// SPDX-License-Identifier: MIT
// Triple product integrals with mirrored visibility: shadow matrices from the coefficients of visibility.
#pragma once

#include <cstdint>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// The matrix between the LightLayout harmonics of one group as a sparse function of visibility's
/// coefficients v_lm: each element is a sum of value * v[coefficient] (Eqs. 55 and 56). The matrix is
/// symmetric.
class TripleProductTensor {
public:
    enum class Group { even, odd, spin };

    TripleProductTensor(Group group, const LightLayout& layout, int visibility_order);

    /// Returns the number of rows, which equals the number of columns.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// Returns the count of numbers that make() computes.
    [[nodiscard]] std::size_t elements() const noexcept { return first_.size() - 1; }

    /// Computes `matrix` [shadow_elements()] from the coefficients `visibility` (by psh_index), for sixteen
    /// vertices at once.
    void make(const Lanes* visibility, Lanes* matrix) const;

private:
    std::size_t size_;
    std::vector<std::uint32_t> first_;  // first term of each element, and the end
    std::vector<std::uint32_t> coefficient_;
    std::vector<float> value_;
};

}  // namespace nicol
