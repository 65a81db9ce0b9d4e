// SPDX-License-Identifier: MIT
// Which worker has loaded which scene, and what each loads next. Every scene is ready or not by itself: one
// that takes long, or ends the worker that loads it, is set aside. Workers that render leave it to the spare
// worker, which takes the place of one of them once it has loaded the scene. No processes, no clocks.
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
    enum class Condition { preparing, ready, broken };
    struct Scene {
        SceneInfo info;         ///< of the latest load; before the first one the id alone
        bool reported = false;  ///< a load has ended, well or not
        bool aside = false;     ///< left to the spare worker
        unsigned failures = 0;  ///< loads in a row that ended their worker
        Time next_try;          ///< after a failure
        std::string reason;     ///< why it cannot be loaded
    };

    /// workers: the spare one included, which is the last at first.
    explicit SceneLoads(std::size_t workers) : spare_(workers - 1), held_(workers) {}

    /// Forgets everything: these are the scenes from now on, and no worker has any.
    void begin(const std::vector<std::string>& ids);
    /// The worker ended.
    void forget(std::size_t worker);
    /// The scene that the worker loads next, if there is one.
    [[nodiscard]] std::optional<std::size_t> next(std::size_t worker, Time now) const;
    /// A load ended: with a digest where the scene was loaded, else with the reason. Returns whether the
    /// scene is another one than an earlier load found; all other workers that have it must then load it
    /// again.
    bool report(std::size_t worker, std::size_t scene, const SceneInfo& info, const std::string& reason);
    /// The scene takes long.
    void set_aside(std::size_t scene) { scenes_[scene].aside = true; }
    /// Loading the scene ended its worker. The second time in a row sets it aside until `next_try`.
    void blame(std::size_t scene, Time next_try);

    [[nodiscard]] bool has(std::size_t worker, std::size_t scene) const;
    /// Whether the worker renders: it has a scene and is not the spare one.
    [[nodiscard]] bool serves(std::size_t worker) const;
    [[nodiscard]] Condition condition(std::size_t scene) const;
    [[nodiscard]] const std::vector<Scene>& scenes() const { return scenes_; }

    [[nodiscard]] std::size_t spare() const { return spare_; }
    /// From when on the spare worker has something to load that a serving one lacks; none where it has
    /// nothing.
    [[nodiscard]] std::optional<Time> spare_due() const;
    /// A serving worker that lacks a scene which the spare one has.
    [[nodiscard]] std::optional<std::size_t> replaceable() const;
    /// The spare worker serves, and this one becomes the spare one.
    void exchange(std::size_t worker) { spare_ = worker; }

private:
    enum class Held : char { nothing, scene, failure };
    [[nodiscard]] bool is_ready(std::size_t scene) const;

    std::size_t spare_;
    std::vector<Scene> scenes_;
    std::vector<std::vector<Held>> held_;  ///< by worker and scene
};
