// SPDX-License-Identifier: MIT
#include "methods/response_tables.hpp"

#include <utility>

#include "surfaces/plain_materials.hpp"

namespace nicol {

void ResponseTables::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

std::size_t ResponseTables::project(const TransferInput& input, SampledTerms sampled,
                                    const LightLayout& layout, RenderRun& run) {
    std::size_t projected = 0;
    const int order = layout.order();
    projecting_.run(input.materials, sampled, input.channels, order, layout.kind(), [&] {
        const Stopwatch watch;
        Map& known = tables_.change();
        sizing_.run(sampled, input.channels, order, layout.kind(), [&] { known.clear(); });
        Map tables;
        const std::vector<MaterialPtr> materials = plain_materials(input.geometry.ranges);
        for (const MaterialPtr& material : materials) {
            if (auto kept = known.extract(material)) {
                tables.insert(std::move(kept));
                continue;
            }
            run.progress.report("project",
                                static_cast<double>(tables.size()) / static_cast<double>(materials.size()));
            ++projected;
            run.workers.run([&] {
                tables.emplace(material, load_or_build(*in_harmonics(material, sampled), layout,
                                                       input.channels, folder_, notice_));
            });
        }
        known = std::move(tables);
        run.statistics.project_ms += watch.milliseconds();
    });
    return projected;
}

}  // namespace nicol
