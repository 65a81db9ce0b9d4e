// SPDX-License-Identifier: MIT
#include "render/time_budget.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "test.hpp"

using namespace nicol;

namespace {

RenderOptions wish(double budget, int pixel_samples = 8) {
    RenderOptions options;
    options.time_budget_ms = budget;
    options.pixel_samples = pixel_samples;
    options.shade_at = ShadeAt::automatic;
    options.choose_orders = true;
    return options;
}

// Made-up time of a frame: a fixed part, and one that grows with what the options ask for.
FrameTime made_up(const RenderOptions& options, double scale) {
    const bool pixels = options.shade_at != ShadeAt::vertices;
    FrameTime time{.at_pixels = pixels};
    time.relight = scale * 4 / options.order_slack;
    time.lights = scale * options.light_samples * options.pixel_samples / 16;
    time.shade = time.lights + scale * (pixels ? 10 : 1) * (1 + options.pixel_samples / 4.0);
    time.whole = 1 + time.relight + time.shade;
    return time;
}

// Steps of each frame of a series whose times are those of made_up().
std::vector<int> steps_of(TimeBudget& budget, const RenderOptions& wanted, int frames,
                          const std::function<double(int)>& scale, std::vector<double>* times = nullptr) {
    std::vector<int> steps;
    for (int f = 0; f < frames; ++f) {
        const FrameTime time = made_up(budget.afford(wanted, true), scale(f));
        steps.push_back(budget.steps());
        if (times != nullptr) times->push_back(time.whole);
        budget.spend(time);
    }
    return steps;
}

long changes(const std::vector<int>& steps) {
    long count = 0;
    for (std::size_t f = 1; f < steps.size(); ++f) count += steps[f] != steps[f - 1] ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("efforts begin with what is given and end with the cheapest picture") {
    const std::vector<Effort> all = efforts(wish(16, 64), true);
    CHECK(all.front() == Effort{.pixel_samples = 64, .light_samples = 16, .bsdf_samples = 32});
    CHECK(all.back() == Effort{.pixel_samples = 1,
                               .light_samples = 4,
                               .bsdf_samples = 8,
                               .shade_at = ShadeAt::vertices,
                               .order_slack = 8});
    CHECK(all[1].pixel_samples == 32);  // loses least
    const auto pixel_samples = [](const std::vector<Effort>& list) {
        std::set<int, std::greater<>> samples;
        for (const Effort& effort : list) samples.insert(effort.pixel_samples);
        return std::vector<int>(samples.begin(), samples.end());
    };
    // Eight and four samples are drawn together, unless there is a filter.
    CHECK(pixel_samples(all) == std::vector{64, 32, 16, 8, 4, 1});
    RenderOptions filtered = wish(16, 8);
    filtered.filter.kind = ReconstructionFilter::Kind::gaussian;
    CHECK(pixel_samples(efforts(filtered, false)) == std::vector{8, 4, 2, 1});
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) CHECK(all[a] != all[b]);
    // Few samples stay, and none do not become some.
    RenderOptions few = wish(16, 1);
    few.light_samples = 3;
    few.bsdf_samples = 0;
    for (const Effort& effort : efforts(few, true)) {
        CHECK(effort.light_samples == 3);
        CHECK(effort.bsdf_samples == 0);
    }
}

TEST_CASE("only what is automatic changes the place of shading and the orders") {
    RenderOptions given = wish(16);
    given.choose_orders = false;
    for (const Effort& effort : efforts(given, true)) CHECK(effort.order_slack == 1);
    for (const Effort& effort : efforts(wish(16), false)) CHECK(effort.shade_at == ShadeAt::automatic);
    given.shade_at = ShadeAt::pixels;
    for (const Effort& effort : efforts(given, true)) CHECK(effort.shade_at == ShadeAt::pixels);
}

TEST_CASE("without a budget, and within it, the options are the given ones") {
    TimeBudget none;
    CHECK(none.afford(wish(0), true) == wish(0));
    none.spend({.whole = 1e9});
    CHECK(none.afford(wish(0), true) == wish(0));
    TimeBudget ample;
    CHECK(ample.afford(wish(1e6), true) == wish(1e6));
    for (const int step : steps_of(ample, wish(1e6), 100, [](int) { return 1; })) CHECK(step == 0);
}

TEST_CASE("95 of 100 frames keep a budget that the cheapest picture keeps, and nothing flickers") {
    for (const double ms : {16.0, 33.0, 100.0}) {
        CAPTURE(ms);
        for (const double scale : {0.3, 1.0, 2.0, 4.0}) {
            CAPTURE(scale);
            RenderOptions cheapest = wish(ms);
            cheapest.pixel_samples = 1;
            cheapest.light_samples = 4;
            cheapest.shade_at = ShadeAt::vertices;
            cheapest.order_slack = 8;
            REQUIRE(made_up(cheapest, scale).whole < 0.9 * ms);
            TimeBudget budget;
            std::vector<double> times;
            const std::vector<int> steps = steps_of(
                budget, wish(ms), 1000, [&](int) { return scale; }, &times);
            const auto end = times.begin() + 100;
            CHECK(std::count_if(times.begin(), end, [&](double t) { return t <= 1.2 * ms; }) >= 95);
            // After the search, an effort that is too slow is tried once in a hundred frames at most.
            CHECK(changes({steps.begin() + 20, steps.end()}) <= 20);
            // Nothing is given up without need, as far as estimates are right: efforts of less loss leave no
            // room for two such frames.
            const std::vector<Effort> all = efforts(wish(ms), true);
            for (int e = 0; e < steps.back(); ++e) {
                const Effort& better = all[static_cast<std::size_t>(e)];
                RenderOptions more = wish(ms);
                more.pixel_samples = better.pixel_samples;
                more.light_samples = better.light_samples;
                more.shade_at = better.shade_at;
                more.order_slack = better.order_slack;
                CHECK(made_up(more, scale).whole > 0.45 * ms);
            }
        }
    }
}

TEST_CASE("equal times lead to equal efforts") {
    TimeBudget first, second;
    const auto scale = [](int f) { return 1 + 0.5 * (f % 7); };
    CHECK(steps_of(first, wish(25), 300, scale) == steps_of(second, wish(25), 300, scale));
}

TEST_CASE("a single slow frame changes nothing, two do") {
    const double budget_ms = made_up(wish(0), 0.5).whole;
    const auto changes_of = [&](int first, int last) {
        TimeBudget budget;
        return changes(steps_of(budget, wish(budget_ms), 100,
                                [&](int f) { return f >= first && f <= last ? 100.0 : 0.5; }));
    };
    CHECK(changes_of(50, 50) == 0);
    CHECK(changes_of(50, 51) > 0);
}

TEST_CASE("the first frame of an effort may take longer") {
    TimeBudget budget;
    CHECK(steps_of(budget, wish(40), 100, [](int f) { return f == 0 ? 1000 : 0.5; }).back() == 0);
}

TEST_CASE("eight frames in succession that leave room raise the effort, seven do not") {
    TimeBudget budget;
    const auto frames = [&](int count, double whole) {
        for (int f = 0; f < count; ++f) {
            static_cast<void>(budget.afford(wish(40), true));
            budget.spend({.whole = whole, .at_pixels = true});
        }
        return budget.steps();
    };
    const int slow = frames(2, 80);
    REQUIRE(slow > 0);
    REQUIRE(frames(3, 36) == slow);
    CHECK(frames(7, 20) == slow);
    CHECK(frames(1, 36) == slow);
    CHECK(frames(7, 20) == slow);
    CHECK(frames(1, 20) < slow);
}

TEST_CASE("what is estimated to take as long as a known effort is not tried as well") {
    // Samples of pixels take far longer than is estimated; nothing else takes time.
    TimeBudget budget;
    std::vector<int> steps;
    for (int f = 0; f < 400; ++f) {
        budget.spend({.whole = budget.afford(wish(40, 64), true).pixel_samples > 1 ? 200.0 : 10.0});
        steps.push_back(budget.steps());
    }
    CHECK(changes(steps) <= 8);
}

TEST_CASE("a budget that no effort keeps ends at the cheapest one and stays there") {
    TimeBudget budget;
    const std::vector<int> steps = steps_of(budget, wish(1e-3), 200, [](int) { return 1; });
    CHECK(steps.back() + 1 == static_cast<int>(efforts(wish(1e-3), true).size()));
    CHECK(changes({steps.begin() + 40, steps.end()}) == 0);
}

TEST_CASE("another budget begins with the given options") {
    TimeBudget budget;
    CHECK(steps_of(budget, wish(5), 50, [](int) { return 1; }).back() > 0);
    CHECK(steps_of(budget, wish(6), 1, [](int) { return 1; }).back() == 0);
    CHECK(steps_of(budget, wish(5), 50, [](int) { return 1; }).back() > 0);
    RenderOptions other_seed = wish(5);
    other_seed.seed = 7;
    CHECK(steps_of(budget, other_seed, 1, [](int) { return 1; }).back() > 0);
}
