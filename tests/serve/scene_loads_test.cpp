// SPDX-License-Identifier: MIT
#include "scene_loads.hpp"

#include <doctest/doctest.h>

namespace {

using Condition = SceneLoads::Condition;
constexpr std::size_t kSlow = 0, kQuick = 1;

SceneInfo info_of(const std::string& id, const std::string& digest) {
    return {.id = id, .digest = digest, .orbit = {}};
}

/// Loads of two scenes by two serving workers and a spare one.
struct Fixture {
    SceneLoads loads{3};
    SceneLoads::Time now;
    std::size_t first = 0, second = 1, spare = 2;

    Fixture() { loads.begin({"slow", "quick"}); }
    bool loaded(std::size_t worker, std::size_t scene, const std::string& digest = "1") {
        return loads.report(worker, scene, info_of(loads.scenes()[scene].info.id, digest),
                            digest.empty() ? "why" : "");
    }
    [[nodiscard]] std::optional<std::size_t> next(std::size_t worker) const {
        return loads.next(worker, now);
    }
};

}  // namespace

TEST_CASE("each scene is ready by itself") {
    Fixture f;
    CHECK(f.next(f.first) == kSlow);
    CHECK(f.loads.condition(kSlow) == Condition::preparing);
    f.loaded(f.first, kSlow);
    CHECK(f.loads.condition(kSlow) == Condition::ready);
    CHECK(f.loads.condition(kQuick) == Condition::preparing);
    CHECK(f.next(f.first) == kQuick);
    f.loaded(f.first, kQuick, "");
    CHECK(f.loads.condition(kQuick) == Condition::broken);
    CHECK(!f.next(f.first));
    CHECK(f.next(f.second) == kSlow);
}

TEST_CASE("a slow scene is left to the spare worker, which then serves") {
    Fixture f;
    // The first worker was loading the scene and becomes the spare worker.
    f.loads.set_aside(kSlow);
    f.loads.exchange(f.first);
    CHECK(f.next(f.spare) == kQuick);
    f.loaded(f.spare, kQuick);
    CHECK(!f.next(f.spare));
    CHECK(f.loads.condition(kQuick) == Condition::ready);
    CHECK(f.loads.condition(kSlow) == Condition::preparing);
    f.loaded(f.first, kSlow);
    // The worker serves no scene before it has loaded the others, too.
    CHECK(f.loads.condition(kSlow) == Condition::preparing);
    CHECK(f.next(f.first) == kQuick);
    f.loaded(f.first, kQuick);
    CHECK(!f.next(f.first));
    REQUIRE(f.loads.replaceable());
    const std::size_t place = *f.loads.replaceable();
    f.loads.forget(place);
    f.loads.exchange(place);
    CHECK(f.loads.condition(kSlow) == Condition::ready);
    CHECK(f.loads.spare_due());  // another worker still lacks the scene
}

TEST_CASE("a scene that ends its worker twice is set aside, and tried again later") {
    Fixture f;
    const SceneLoads::Time later = f.now + std::chrono::seconds(1);
    f.loads.blame(kSlow, later);
    CHECK(f.next(f.first) == kSlow);
    f.loads.blame(kSlow, later);
    CHECK(f.next(f.first) == kQuick);
    CHECK(f.loads.condition(kSlow) == Condition::broken);
    for (const std::size_t worker : {f.first, f.second, f.spare}) f.loaded(worker, kQuick);
    CHECK(f.loads.spare_due() == later);
    CHECK(!f.next(f.spare));
    f.now = later;
    CHECK(f.next(f.spare) == kSlow);
}

TEST_CASE("a scene that has changed is loaded again by all") {
    Fixture f;
    for (const std::size_t worker : {f.first, f.second}) {
        CHECK(!f.loaded(worker, kSlow));
        CHECK(!f.loaded(worker, kQuick));
    }
    f.loads.forget(f.first);
    CHECK(f.loads.condition(kSlow) == Condition::ready);
    CHECK(f.loaded(f.first, kSlow, "2"));
    CHECK(f.next(f.second) == kSlow);
    CHECK(!f.loads.has(f.second, kSlow));
    CHECK(f.loaded(f.first, kQuick, ""));
    CHECK(f.loads.condition(kQuick) == Condition::broken);
    // Only a restarted worker tries the broken scene again.
    f.loaded(f.second, kSlow, "2");
    CHECK(!f.next(f.second));
    f.loads.forget(f.second);
    f.loaded(f.second, kSlow, "2");
    CHECK(f.next(f.second) == kQuick);
}

TEST_CASE("another scene may take a place, and a vacant one is never loaded") {
    SceneLoads loads(2);
    loads.begin({"a", ""});
    const SceneLoads::Time now;
    CHECK(loads.condition(1) == Condition::vacant);
    CHECK(loads.next(0, now) == std::size_t{0});
    loads.report(0, 0, info_of("a", "1"), "");
    CHECK(!loads.next(0, now));
    loads.put(1, "b");
    CHECK(loads.condition(1) == Condition::preparing);
    CHECK(loads.next(0, now) == std::size_t{1});
    CHECK(!loads.report(0, 1, info_of("b", "1"), ""));
    CHECK(loads.condition(1) == Condition::ready);
    loads.put(1, "c");
    CHECK(!loads.has(0, 1));
    CHECK(!loads.report(0, 1, info_of("c", "2"), ""));
    loads.give_up(1, "why");
    CHECK(loads.condition(1) == Condition::broken);
    CHECK(loads.scenes()[1].reason == "why");
    CHECK(loads.scenes()[1].info.id == "c");
    loads.forget(0);
    CHECK(loads.next(0, now) == std::size_t{0});
    loads.report(0, 0, info_of("a", "1"), "");
    CHECK(!loads.next(0, now));
}
