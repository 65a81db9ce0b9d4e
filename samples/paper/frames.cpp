// SPDX-License-Identifier: MIT
#include "frames.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

namespace {

struct Contestant {
    nicol_scene scene;
    Recipe recipe;
    std::vector<double> light_ms, camera_ms;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

template <class Work>
double milliseconds(Work work) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

nicol_statistics statistics_of(nicol_framebuffer target) {
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    check(nicol_framebuffer_get_statistics(target, &statistics));
    return statistics;
}

}  // namespace

Cost measure(const Stage& stage, nicol_scene dense, nicol_scene factored, const Recipe& recipe,
             std::uint32_t frames, nicol_framebuffer target) {
    std::array<Contestant, 4> contestants;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        contestants[i].scene = i % 2 == 0 ? dense : factored;
        contestants[i].recipe = recipe;
        contestants[i].recipe.method = i % 2 == 0 ? NICOL_METHOD_DENSE : NICOL_METHOD_FACTORED;
        contestants[i].recipe.physical = i >= 2;
    }
    Cost cost;
    for (std::size_t i = 0; i < 2; ++i) {
        stage.render(contestants[i].scene, View::front, contestants[i].recipe, target);
        const nicol_statistics statistics = statistics_of(target);
        cost.vertices = statistics.vertices;
        (i == 0 ? cost.dense : cost.factored).bytes =
            static_cast<double>(statistics.transfer_bytes + statistics.visibility_bytes) /
            static_cast<double>(statistics.vertices);
    }
    double degrees = 0;
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
        for (Contestant& c : contestants) {
            degrees += 0.25;
            stage.rotate_light(c.scene, degrees);
            c.light_ms.push_back(
                milliseconds([&] { stage.render(c.scene, View::front, degrees, c.recipe, target); }));
            c.camera_ms.push_back(
                milliseconds([&] { stage.render(c.scene, View::front, degrees + 0.125, c.recipe, target); }));
        }
    }
    stage.rotate_light(dense, 0);
    stage.rotate_light(factored, 0);
    cost.dense.light_ms = median(contestants[0].light_ms);
    cost.dense.camera_ms = median(contestants[0].camera_ms);
    cost.dense.light_physical_ms = median(contestants[2].light_ms);
    cost.factored.light_ms = median(contestants[1].light_ms);
    cost.factored.camera_ms = median(contestants[1].camera_ms);
    cost.factored.light_physical_ms = median(contestants[3].light_ms);
    return cost;
}
