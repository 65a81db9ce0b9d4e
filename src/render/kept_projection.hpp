// SPDX-License-Identifier: MIT
// Coefficients of an environment, shared by the steps that need different orders of them.
#pragma once

#include "harmonics/psh.hpp"
#include "light/environment.hpp"

namespace nicol {

class KeptProjection {
public:
    /// Returns the coefficients of an environment (null: none) up to `order`. Projects the environment if the
    /// last call was for another one or for a lower order; otherwise the coefficients of a lower order are
    /// those of the higher order, to the last bit.
    [[nodiscard]] PshVector project(const EnvironmentPtr& environment, int order);

private:
    EnvironmentPtr environment_;
    PshVector light_;
};

}  // namespace nicol
