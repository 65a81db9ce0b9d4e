// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "commands.hpp"
#include "frame_times.hpp"

namespace {

// One column of the comparison: light and components of a pipeline.
struct Kind {
    const char* name;
    SceneVariant variant;
    nicol_components components;
};
constexpr Kind kKinds[] = {
    {"s0 alone", SceneVariant::unpolarized_sky, NICOL_COMPONENTS_S0},
    {"polarized by surfaces", SceneVariant::unpolarized_sky, NICOL_COMPONENTS_ALL},
    {"polarized light", SceneVariant::polarized, NICOL_COMPONENTS_ALL},
};

std::vector<int> orders(const Options& options) {
    if (options.first_order < 0) return {2, 4, 6, 9};
    std::vector<int> list;
    for (int order = options.first_order; order <= options.last_order; ++order) list.push_back(order);
    return list;
}

}  // namespace

Report bench_price(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 1024 : options.size;
    const SceneSource source(options);
    const std::vector<int> list = orders(options);
    std::vector<Contestant> contestants;
    contestants.reserve(list.size() * std::size(kKinds));
    for (const int order : list)
        for (const Kind& kind : kKinds)
            contestants.emplace_back(source, Recipe{.low = order, .components = kind.components}, size,
                                     kind.variant);
    const std::vector<FrameTimes> times = time_frames(contestants, options.seconds);

    Report report({"order and light", "light rotating ms", "over s0", "relight ms", "relight over s0",
                   "relight + shade ms", "relight + shade over s0", "camera only ms", "camera over s0",
                   "kept MB", "MB over s0"});
    for (std::size_t i = 0; i < times.size(); ++i) {
        const FrameTimes& t = times[i];
        const FrameTimes& scalar = times[i - i % std::size(kKinds)];
        report.add("order " + std::to_string(list[i / std::size(kKinds)]) + ", " +
                       kKinds[i % std::size(kKinds)].name,
                   {t.light, t.light / scalar.light, t.light_relight, t.light_relight / scalar.light_relight,
                    t.light_transfer(), t.light_transfer() / scalar.light_transfer(), t.camera,
                    t.camera / scalar.camera, t.transfer_mb, t.transfer_mb / scalar.transfer_mb});
    }
    report.note(
        "Rough plastic under a clear sky, shaded at vertices. s0 alone: scalar spherical harmonics of "
        "an unpolarized sky, and no other component.");
    report.note(source.machine() + "; " + std::to_string(size) + " x " + std::to_string(size) + ".");
    return report;
}
