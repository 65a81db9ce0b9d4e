// SPDX-License-Identifier: MIT
// One object for materials that reflect alike, as files repeat them for each shape.
#pragma once

#include <map>
#include <string>

#include "material/material.hpp"

namespace nicol {

/// Finds materials with equal values, so that they are projected once.
class EqualMaterials {
public:
    /// Returns the first material since the last forget_unused() but one that equals this material, which may
    /// be itself. Materials that vary over a surface, or whose values have no key, equal no other.
    [[nodiscard]] MaterialPtr first_of(const MaterialPtr& material);

    /// Forgets materials that were not asked for since the last call.
    void forget_unused();

private:
    struct Equals {
        MaterialPtr first;
        bool used = false;
    };
    struct Known {
        Equals* equals = nullptr;  // in by_content_; null: the material equals no other
        bool used = false;
    };
    std::map<std::string, Equals> by_content_;
    std::map<MaterialPtr, Known> known_;  // so that the content of each material is read once
};

}  // namespace nicol
