// SPDX-License-Identifier: MIT
// The worker processes: started one before the others, watched, replaced when they crash or hang, and a spare
// one for scenes that take long to load.
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
#include "worker_process.hpp"

class Pool {
public:
    /// arguments: those of this process, the program's name included.
    Pool(boost::asio::io_context& io, const Options& options, std::vector<std::string> arguments,
         Metrics& metrics);
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Starts the first worker, and the others once it has loaded all scenes that load quickly and has filled
    /// the cache. `failed` is called where the first worker or all scenes fail: what a later one says goes to
    /// the standard error, and it is tried again, ever more rarely.
    void start(std::function<void(const std::string& reason)> failed);
    /// Kills all workers; no event comes any more.
    void stop();

    [[nodiscard]] Dispatcher& dispatcher() { return dispatcher_; }
    /// Workers that take requests.
    [[nodiscard]] std::size_t warm_workers() const;
    /// Whether all scenes that load quickly have been loaded, and a worker takes requests.
    [[nodiscard]] bool ready() const { return through_ && warm_workers() > 0; }
    /// The folder's scenes as the newest worker found them, and which are ready; none before the first
    /// started.
    [[nodiscard]] const SceneLoads& loads() const { return loads_; }
    /// The name and version of OpenGL.
    [[nodiscard]] const std::string& renderer() const { return hello_.renderer; }
    [[nodiscard]] std::vector<WorkerState> states() const;

    /// Called when the service is ready for the first time.
    std::function<void()> warm;
    /// Called when scenes have changed on disk: earlier answers are outdated.
    std::function<void()> scenes_changed;

private:
    struct Slot {
        explicit Slot(boost::asio::io_context& io) : timer(io) {}
        std::shared_ptr<WorkerProcess> process;
        boost::asio::steady_timer timer;  ///< of start, render or pause, whichever is on
        bool greeted = false, busy = false;
        std::optional<std::size_t> loading;  ///< scene
        std::chrono::steady_clock::time_point load_since;
        bool stale = false;                           ///< knows other scenes than there are now
        unsigned failures = 0;                        ///< in a row, at its start or soon after
        std::chrono::steady_clock::time_point since;  ///< greeted
    };

    void launch(std::size_t index);
    void receive(std::size_t index, const Head& head, std::string content);
    void receive_hello(std::size_t index, const std::string& content);
    void receive_loaded(std::size_t index, std::size_t scene, const std::string& content);
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
    Hello hello_;
    bool through_ = false;  ///< the first worker has loaded all that loads quickly
    std::function<void(const std::string&)> failed_;
    boost::asio::signal_set child_ended_;
    std::vector<pid_t> ended_;  ///< killed, not reaped yet
    bool stopped_ = false;
};
