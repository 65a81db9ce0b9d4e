// SPDX-License-Identifier: MIT
// Materials whose terms depend on few of their parameters, so that many materials share integrals.
#pragma once

#include <string>

#include "material/material.hpp"

namespace nicol {

/// Material whose weights are parameters that its terms do not depend on.
class SharedTerms {
public:
    /// Returns the parameters that Material::evaluate() depends on, as text. Materials with equal texts have
    /// equal terms.
    [[nodiscard]] virtual std::string own_terms_key() const = 0;

protected:
    SharedTerms() = default;
    ~SharedTerms() = default;
};

/// Returns a text that is equal for materials with equal terms, of which the same are black. Empty if the
/// material is no SharedTerms.
[[nodiscard]] inline std::string terms_key(const Material& material) {
    const auto* shared = dynamic_cast<const SharedTerms*>(&material);
    if (shared == nullptr) return {};
    std::string key = shared->own_terms_key();
    // Material::evaluate_lanes() may leave out black terms.
    for (int term = 0; term < material.terms(); ++term) {
        bool black = true;
        for (int c = 0; c < material.channels(); ++c) black = black && material.weight(term, c) == 0;
        key += black ? " black" : " lit";
    }
    return key;
}

}  // namespace nicol
