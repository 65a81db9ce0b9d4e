// SPDX-License-Identifier: MIT
#include "render/light_split.hpp"

#include "progress.hpp"

namespace nicol {
namespace {

int most_lamps(const RenderOptions& options) {
    if (options.method != Method::factored) return 0;
    return options.split_lights == kSplitAutomatic ? kMaxSplitLights : options.split_lights;
}

}  // namespace

void LightSplit::update(const EnvironmentPtr& environment, const RenderOptions& options,
                        Statistics& statistics) {
    splitting_.run(environment, most_lamps(options), [&] {
        const Stopwatch watch;
        split_ = split_lamps(environment, most_lamps(options));
        statistics.project_ms += watch.milliseconds();
    });
    statistics.lights_split = split_.lamps.size();
}

}  // namespace nicol
