// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "median.hpp"
#include "stage.hpp"

namespace {

constexpr std::uint32_t kImageSize = 8;

nicol_statistics bake(Options options, const std::string& cache, std::uint32_t directions) {
    options.cache = cache;
    const SceneSource source(options);
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(kImageSize, kImageSize);
    const Recipe recipe{.directions = directions};
    return stage.render(recipe.options(), framebuffer.get());
}

double megabytes(std::uint64_t bytes) {
    return 1e-6 * static_cast<double>(bytes);
}

}  // namespace

Report bench_bake(const Options& options) {
    constexpr int repetitions = 3;
    Report report({"directions a vertex", "million rays/s", "bake ms", "of it rays ms", "from cache ms",
                   "visibility MB", "vertices", "of them added", "unoccluded"});
    for (const std::uint32_t directions : {512U, 2048U, 8192U}) {
        std::vector<double> whole, traced, cached;
        nicol_statistics last = NICOL_STATISTICS_INIT;
        for (int i = 0; i < repetitions; ++i) {
            const TemporaryFolder folder;
            last = bake(options, folder.path().string(), directions);
            whole.push_back(last.bake_ms);
            traced.push_back(last.bake_trace_ms);
            cached.push_back(bake(options, folder.path().string(), directions).bake_ms);
        }
        const double trace_ms = median(traced);
        report.add(std::to_string(directions),
                   {static_cast<double>(last.bake_rays) / trace_ms * 1e-3, median(whole), trace_ms,
                    median(cached), megabytes(last.visibility_bytes), static_cast<double>(last.vertices),
                    static_cast<double>(last.vertices_added), static_cast<double>(last.vertices_unoccluded)});
    }
    report.note("Medians of " + std::to_string(repetitions) +
                " bakes; each is then loaded from its cache by another context.");
    return report;
}
