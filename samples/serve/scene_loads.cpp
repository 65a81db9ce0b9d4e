// SPDX-License-Identifier: MIT
#include "scene_loads.hpp"

#include <algorithm>

void SceneLoads::begin(const std::vector<std::string>& ids) {
    scenes_.assign(ids.size(), {});
    for (std::size_t i = 0; i < ids.size(); ++i) scenes_[i].info.id = ids[i];
    for (auto& held : held_) held.assign(ids.size(), Held::nothing);
}

void SceneLoads::put(std::size_t scene, const std::string& id) {
    scenes_[scene] = {};
    scenes_[scene].info.id = id;
    for (auto& held : held_) held[scene] = Held::nothing;
}

void SceneLoads::give_up(std::size_t scene, const std::string& reason) {
    put(scene, std::string(scenes_[scene].info.id));
    scenes_[scene].reported = scenes_[scene].given_up = true;
    scenes_[scene].reason = reason;
}

void SceneLoads::forget(std::size_t worker) {
    held_[worker].assign(scenes_.size(), Held::nothing);
}

std::optional<std::size_t> SceneLoads::next(std::size_t worker, Time now) const {
    const bool spare = worker == spare_;
    const auto wanted = [&](std::size_t scene, bool aside) {
        return held_[worker][scene] == Held::nothing && scenes_[scene].aside == aside && is_wanted(scene);
    };
    for (std::size_t i = 0; i < scenes_.size(); ++i)
        if (wanted(i, false) || (spare && wanted(i, true) && is_ready(i))) return i;
    // The spare worker loads one slow scene at a time, so that each is served as soon as possible.
    if (!spare || replaceable()) return {};
    for (std::size_t i = 0; i < scenes_.size(); ++i)
        if (wanted(i, true) && scenes_[i].next_try <= now) return i;
    return {};
}

bool SceneLoads::report(std::size_t worker, std::size_t scene, const SceneInfo& info,
                        const std::string& reason) {
    Scene& known = scenes_[scene];
    const bool changed = known.reported && known.info != info;
    const bool failed = info.digest.empty();
    if (changed)
        for (auto& held : held_) held[scene] = Held::nothing;
    held_[worker][scene] = failed ? Held::failure : Held::scene;
    if (failed) {
        // Only newly started workers retry a failed scene.
        known.aside = false;
        for (auto& held : held_) held[scene] = Held::failure;
    }
    known.info = info;
    known.reported = true;
    known.failures = 0;
    known.reason = reason;
    return changed;
}

void SceneLoads::blame(std::size_t scene, Time next_try) {
    Scene& failing = scenes_[scene];
    failing.next_try = next_try;
    failing.aside = ++failing.failures > 1 || failing.aside;
}

bool SceneLoads::has(std::size_t worker, std::size_t scene) const {
    return scene < held_[worker].size() && held_[worker][scene] == Held::scene;
}

bool SceneLoads::serves(std::size_t worker) const {
    return worker != spare_ && std::ranges::count(held_[worker], Held::scene) > 0;
}

bool SceneLoads::is_wanted(std::size_t scene) const {
    return !scenes_[scene].info.id.empty() && !scenes_[scene].given_up;
}

bool SceneLoads::is_ready(std::size_t scene) const {
    for (std::size_t worker = 0; worker < held_.size(); ++worker)
        if (worker != spare_ && has(worker, scene)) return true;
    return false;
}

SceneLoads::Condition SceneLoads::condition(std::size_t scene) const {
    const Scene& known = scenes_[scene];
    if (known.info.id.empty()) return Condition::vacant;
    const bool loaded = known.reported && !known.info.digest.empty();
    // While a worker is replaced, requests for scenes that load quickly may wait.
    if (is_ready(scene) || (loaded && !known.aside)) return Condition::ready;
    return (known.reported && !loaded) || known.failures > 1 ? Condition::broken : Condition::preparing;
}

std::optional<SceneLoads::Time> SceneLoads::spare_due() const {
    std::optional<Time> due;
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
        if (!scenes_[i].aside) continue;
        for (std::size_t worker = 0; worker < held_.size(); ++worker)
            if (worker != spare_ && held_[worker][i] == Held::nothing)
                due = std::min(due.value_or(scenes_[i].next_try), scenes_[i].next_try);
    }
    return due;
}

std::optional<std::size_t> SceneLoads::replaceable() const {
    for (std::size_t worker = 0; worker < held_.size(); ++worker)
        for (std::size_t i = 0; worker != spare_ && i < scenes_.size(); ++i)
            if (has(spare_, i) && !has(worker, i)) return worker;
    return {};
}
