// SPDX-License-Identifier: MIT
// Terms of materials that reflect light beside their lobes, too, such as the diffuse light of measured
// plastics.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Material with terms that may reflect much light beside the lobe that Material::lobe() describes.
class MixedTerms {
public:
    /// Returns whether a term may.
    [[nodiscard]] virtual bool mixed(int term) const = 0;

protected:
    MixedTerms() = default;
    ~MixedTerms() = default;
};

/// Returns whether a term of a material may reflect much light beside its lobe. Terms of facets do not.
[[nodiscard]] inline bool is_mixed(const Material& material, int term) {
    const auto* mixed = dynamic_cast<const MixedTerms*>(&material);
    return mixed != nullptr && mixed->mixed(term);
}

}  // namespace nicol
