// SPDX-License-Identifier: MIT
#include "render/light_split.hpp"

#include "progress.hpp"

namespace nicol {

int most_extracted(const RenderOptions& options) {
    if (options.method != Method::factored) return 0;
    return options.split_lights == kSplitAutomatic ? kMaxSplitLights : options.split_lights;
}

void LightSplit::update(const EnvironmentPtr& environment, const RenderOptions& options,
                        Statistics& statistics) {
    splitting_.run(environment, most_extracted(options), [&] {
        const Stopwatch watch;
        split_ = extract_lights(environment, most_extracted(options));
        statistics.project_ms += watch.milliseconds();
    });
    statistics.lights_split = split_.extracted_lights.size();
}

}  // namespace nicol
