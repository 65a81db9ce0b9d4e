// SPDX-License-Identifier: MIT
// project, first of all: the extracted lights of a scene's environment, and the rest that becomes
// coefficients.
#pragma once

#include "light/extract_lights.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "versioned.hpp"

namespace nicol {

class LightSplit {
public:
    /// As far as changes make it necessary. Null is darkness. Adds its times and counts to `statistics`.
    void update(const EnvironmentPtr& environment, const RenderOptions& options, Statistics& statistics);

    /// The same pointers as long as update() has nothing to do.
    [[nodiscard]] const EnvironmentPtr& rest() const noexcept { return split_.rest; }
    [[nodiscard]] const std::vector<std::shared_ptr<const ExtractedLight>>& extracted_lights()
        const noexcept {
        return split_.extracted_lights;
    }

private:
    Stage<EnvironmentPtr, int> splitting_;  // environment, extracted lights at most
    SplitLight split_;
};

}  // namespace nicol
