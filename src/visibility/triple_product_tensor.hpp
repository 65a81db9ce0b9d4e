// SPDX-License-Identifier: MIT
// Integrals of triple products over mirrored visibility: from its coefficients to shadow matrices.
#pragma once

#include <cstdint>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// The matrix between the LightLayout harmonics of one group as a sparse function of visibility's
/// coefficients v_lm: each element is a sum of value * v[coefficient] (Eqs. 55 and 56). It is symmetric.
class TripleProductTensor {
public:
    enum class Group { even, odd, spin };

    TripleProductTensor(Group group, const LightLayout& layout, int visibility_order);

    /// Rows, and columns.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// Numbers that make() makes.
    [[nodiscard]] std::size_t elements() const noexcept { return first_.size() - 1; }

    /// visibility: by psh_index; matrix: [shadow_elements()]. Sixteen vertices at once.
    void make(const Lanes* visibility, Lanes* matrix) const;

private:
    std::size_t size_;
    std::vector<std::uint32_t> first_;  // of each element's terms; one more than there are elements
    std::vector<std::uint32_t> coefficient_;
    std::vector<float> value_;
};

}  // namespace nicol
