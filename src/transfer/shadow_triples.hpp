// SPDX-License-Identifier: MIT
// Integrals of triple products over mirrored visibility: from its coefficients to shadow matrices.
#pragma once

#include <cstdint>
#include <vector>

#include "transfer/lanes.hpp"
#include "transfer/mirror_basis.hpp"

namespace nicol {

/// One matrix between groups of MirrorBasis harmonics as a sparse function of visibility's coefficients
/// v_lm: element (row, column) is a sum of value * v[coefficient] (Eqs. 55 and 56).
class ShadowTriples {
public:
    enum class Group { even, odd, spin };

    /// Rows are of `out`, columns of `in`.
    ShadowTriples(Group group, const MirrorBasis& out, const MirrorBasis& in, int visibility_order);

    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
    [[nodiscard]] std::size_t terms() const noexcept { return value_.size(); }

    /// visibility: by psh_index; matrix: [row][column]. Sixteen vertices at once.
    void expand(const Lanes* visibility, Lanes* matrix) const;

private:
    std::size_t rows_;
    std::size_t columns_;
    std::vector<std::uint32_t> first_;  // of each element's terms; one more than there are elements
    std::vector<std::uint32_t> coefficient_;
    std::vector<float> value_;
};

}  // namespace nicol
