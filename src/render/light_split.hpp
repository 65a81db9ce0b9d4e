// SPDX-License-Identifier: MIT
// Split of a scene's environment into extracted lights and a rest that becomes coefficients.
#pragma once

#include "light/extract_lights.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "versioned.hpp"

namespace nicol {

/// Returns the largest number of lights that are extracted.
[[nodiscard]] int most_extracted(const RenderOptions& options);

class LightSplit {
public:
    /// Splits the environment (the first step of project) if the environment or the options have changed. A
    /// null environment is dark. Adds times and counts to `statistics`.
    void update(const EnvironmentPtr& environment, const RenderOptions& options, Statistics& statistics);

    /// Returns the rest. This pointer and the lights' pointers stay the same as long as update() has nothing
    /// to do.
    [[nodiscard]] const EnvironmentPtr& rest() const noexcept { return split_.rest; }
    [[nodiscard]] const std::vector<std::shared_ptr<const ExtractedLight>>& extracted_lights()
        const noexcept {
        return split_.extracted_lights;
    }

private:
    Stage<EnvironmentPtr, int> splitting_;  // environment, largest number of extracted lights
    SplitLight split_;
};

}  // namespace nicol
