// SPDX-License-Identifier: MIT
// The worker processes. One starts before the others, all are watched and replaced if they crash or hang, and
// a spare one loads scenes that take long.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dispatcher.hpp"
#include "metrics.hpp"
#include "options.hpp"
#include "scene_loads.hpp"
#include "upload.hpp"
#include "worker_process.hpp"

class Pool {
public:
    /// Makes a pool. `arguments` are those of this process, with the program's name.
    Pool(boost::asio::io_context& io, const Options& options, std::vector<std::string> arguments,
         Metrics& metrics);
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Starts the first worker, and the others once it has loaded all scenes that load quickly and has filled
    /// the cache. `failed` is called if the first worker or all scenes fail. Failures of later workers go to
    /// the standard error; these workers are retried at increasing intervals.
    void start(std::function<void(const std::string& reason)> failed);
    /// Kills all workers; no event follows.
    void stop();

    [[nodiscard]] Dispatcher& dispatcher() { return dispatcher_; }
    /// Returns the number of workers that take requests.
    [[nodiscard]] std::size_t warm_workers() const;
    /// Returns whether all scenes that load quickly are loaded and a worker takes requests.
    [[nodiscard]] bool ready() const { return through_ && warm_workers() > 0; }
    /// Returns the folder's scenes as the newest worker found them, and which are ready; empty before a
    /// worker has started.
    [[nodiscard]] const SceneLoads& loads() const { return loads_; }
    /// Returns the name and version of OpenGL.
    [[nodiscard]] const std::string& renderer() const { return hello_.renderer; }
    [[nodiscard]] std::vector<WorkerState> states() const;

    /// Lets the workers load an uploaded scene, in the place of the one that was asked for least recently if
    /// all places are taken. Returns false if the scenes in all places are still being loaded.
    bool keep_upload(const Upload& upload);
    /// Notes that a scene was asked for.
    void touch(std::size_t scene);
    [[nodiscard]] bool is_upload(std::size_t scene) const { return scene >= hello_.scenes.size(); }

    /// Callback for the first time that the service is ready.
    std::function<void()> warm;
    /// Callback for changed scenes on disk, which outdate earlier answers.
    std::function<void()> scenes_changed;

private:
    struct Slot {
        explicit Slot(boost::asio::io_context& io) : timer(io) {}
        std::shared_ptr<WorkerProcess> process;
        boost::asio::steady_timer timer;  ///< timer of the start, load, render or pause under way
        bool greeted = false, busy = false;
        std::optional<std::size_t> loading;  ///< scene under way
        std::chrono::steady_clock::time_point load_since;
        bool stale = false;                           ///< does not know the present scenes
        unsigned failures = 0;                        ///< consecutive failures at the start or soon after
        std::chrono::steady_clock::time_point since;  ///< time of its hello
    };

    /// A place of an uploaded scene.
    struct Place {
        std::string id, content;  ///< id and pack() of the upload; empty: free
        std::uint64_t asked = 0;  ///< increases with each request for any place
    };

    [[nodiscard]] bool is_loading(std::size_t scene) const;
    void begin_scenes();
    void launch(std::size_t index);
    void receive(std::size_t index, const Head& head, std::string content);
    void receive_hello(std::size_t index, const std::string& content);
    void receive_loaded(std::size_t index, std::size_t scene, const std::string& content);
    void receive_progress(std::size_t index, std::uint64_t job, const std::string& content);
    void receive_result(std::size_t index, const Head& head, std::string content);
    void go_on(std::size_t index, bool rendered = false);
    void go_on_all();
    void settle();
    void promote();
    void tend_spare();
    void overdue(std::size_t index);
    void lose(std::size_t index, bool hung);
    void end(std::size_t index);
    void pause(std::size_t index);
    void limit(std::size_t index, Seconds time);
    void begin_load(std::size_t index, std::size_t scene);
    void begin_job(std::size_t index, std::uint64_t job, const ImageRequest& request);
    void reap();
    void wait_for_children();

    boost::asio::io_context& io_;
    const Options& options_;
    std::vector<std::string> arguments_;
    Metrics& metrics_;
    Dispatcher dispatcher_;
    std::vector<std::unique_ptr<Slot>> slots_;
    SceneLoads loads_;
    std::vector<Place> places_;  ///< their scenes come after those of the folder
    std::uint64_t asked_ = 0;
    Hello hello_;
    bool through_ = false;  ///< the first worker has loaded all scenes that load quickly
    std::function<void(const std::string&)> failed_;
    boost::asio::signal_set child_ended_;
    std::vector<pid_t> ended_;  ///< killed processes, not yet reaped
    bool stopped_ = false;
};
