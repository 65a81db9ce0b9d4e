// SPDX-License-Identifier: MIT
// Loads of scenes by workers. Every scene is ready independently: a scene that takes long, or ends the worker
// that loads it, is set aside. Rendering workers leave slow scenes to the spare worker, which replaces one of
// them after the load. The class has no processes and no clocks.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "image_request.hpp"

class SceneLoads {
public:
    using Time = std::chrono::steady_clock::time_point;
    enum class Condition { preparing, ready, broken, vacant };
    struct Scene {
        SceneInfo info;  ///< description by the latest load; before the first one only the id, "" if vacant
        bool reported = false;  ///< a load has ended, successfully or not
        bool aside = false;     ///< left to the spare worker
        unsigned failures = 0;  ///< consecutive loads that ended their worker
        Time next_try;          ///< time after a failure
        std::string reason;     ///< cause of a failed load
        bool given_up = false;  ///< not loaded again
    };

    /// Makes the loads of `workers` workers, among them the spare one, initially the last.
    explicit SceneLoads(std::size_t workers) : spare_(workers - 1), held_(workers) {}

    /// Forgets everything and starts with these scenes, which no worker has. Empty ids are vacant places.
    void begin(const std::vector<std::string>& ids);
    /// Puts another scene into a place. No worker has it.
    void put(std::size_t scene, const std::string& id);
    /// Forgets the scenes of a worker that ended.
    void forget(std::size_t worker);
    /// Returns the scene that the worker loads next, if any.
    [[nodiscard]] std::optional<std::size_t> next(std::size_t worker, Time now) const;
    /// Records the end of a load: with a digest if the scene was loaded, else with the reason. Returns
    /// whether the scene differs from an earlier load. All other workers that have the scene must then load
    /// it again.
    bool report(std::size_t worker, std::size_t scene, const SceneInfo& info, const std::string& reason);
    /// Sets aside a scene that takes long.
    void set_aside(std::size_t scene) { scenes_[scene].aside = true; }
    /// Records that loading the scene ended its worker. The second time in a row sets it aside until
    /// `next_try`.
    void blame(std::size_t scene, Time next_try);

    /// Counts the scene as broken for this reason, and never loads it again.
    void give_up(std::size_t scene, const std::string& reason);

    [[nodiscard]] bool has(std::size_t worker, std::size_t scene) const;
    /// Returns whether the worker renders: it has a scene and is not the spare one.
    [[nodiscard]] bool serves(std::size_t worker) const;
    [[nodiscard]] Condition condition(std::size_t scene) const;
    [[nodiscard]] const std::vector<Scene>& scenes() const { return scenes_; }

    [[nodiscard]] std::size_t spare() const { return spare_; }
    /// Returns from when the spare worker has something to load that a serving one lacks, or nothing.
    [[nodiscard]] std::optional<Time> spare_due() const;
    /// Returns a serving worker that lacks a scene of the spare worker.
    [[nodiscard]] std::optional<std::size_t> replaceable() const;
    /// Makes this worker the spare one, whose place the previous spare worker takes.
    void exchange(std::size_t worker) { spare_ = worker; }

private:
    enum class Held : char { nothing, scene, failure };
    [[nodiscard]] bool is_wanted(std::size_t scene) const;
    [[nodiscard]] bool is_ready(std::size_t scene) const;

    std::size_t spare_;
    std::vector<Scene> scenes_;
    std::vector<std::vector<Held>> held_;  ///< by worker and scene
};
