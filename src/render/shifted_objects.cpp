// SPDX-License-Identifier: MIT
#include "render/shifted_objects.hpp"

namespace nicol {

bool traces_all(const RenderOptions& options) {
    return (options.disabled_optimisations & skip_rays) != 0 || options.max_depth > kDirectLightDepth;
}

std::vector<ShiftedObject> shifted_objects(const SceneGeometry::Change& change, bool every_ray) {
    std::vector<ShiftedObject> out;
    if (every_ray) return out;
    for (const SceneGeometry::MovedRun& run : change.moved) {
        if (!run.others) continue;
        const auto& [now, before] = *run.others;
        out.push_back({.vertices = run.vertices,
                       .shift = run.shift,
                       .others = {.added = now.balls,
                                  .removed = before.balls,
                                  .added_boxes = now.boxes,
                                  .removed_boxes = before.boxes}});
    }
    return out;
}

}  // namespace nicol
