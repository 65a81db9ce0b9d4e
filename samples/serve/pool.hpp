// SPDX-License-Identifier: MIT
// The worker processes: started one before the others, watched, replaced when they crash or hang.
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
#include "worker_process.hpp"

class Pool {
public:
    /// arguments: those of this process, the program's name included.
    Pool(boost::asio::io_context& io, const Options& options, std::vector<std::string> arguments,
         Metrics& metrics);
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Starts the first worker, and the others once it is warm and has filled the cache. `failed` is called
    /// where the first can never be: what a later one says goes to the standard error, and it is tried again,
    /// ever more rarely.
    void start(std::function<void(const std::string& reason)> failed);
    /// Kills all workers; no event comes any more.
    void stop();

    [[nodiscard]] Dispatcher& dispatcher() { return dispatcher_; }
    /// That take requests.
    [[nodiscard]] std::size_t warm_workers() const;
    /// The scenes as the newest worker found them; none before the first was warm.
    [[nodiscard]] const Hello* hello() const { return hello_ ? &*hello_ : nullptr; }
    [[nodiscard]] std::vector<WorkerState> states() const;

    /// Called when the first worker takes requests.
    std::function<void()> warm;
    /// Called when scenes have changed on disk: earlier answers are outdated.
    std::function<void()> scenes_changed;

private:
    struct Slot {
        explicit Slot(boost::asio::io_context& io) : timer(io) {}
        std::shared_ptr<WorkerProcess> process;
        boost::asio::steady_timer timer;  ///< of start, render or pause, whichever is on
        bool warm = false, busy = false;
        bool stale = false;     ///< holds scenes that are no more
        unsigned failures = 0;  ///< in a row, before being warm or soon after
        std::chrono::steady_clock::time_point warm_since;
    };

    void launch(std::size_t index);
    void receive(std::size_t index, const Head& head, std::string content);
    void receive_hello(std::size_t index, const std::string& content);
    void receive_result(std::size_t index, const Head& head, std::string content);
    void lose(std::size_t index, bool hung);
    void pause(std::size_t index);
    void limit(std::size_t index, Seconds time);
    void begin_job(std::size_t index, std::uint64_t job, const ImageRequest& request);
    void reap();
    void wait_for_children();

    boost::asio::io_context& io_;
    const Options& options_;
    std::vector<std::string> arguments_;
    Metrics& metrics_;
    Dispatcher dispatcher_;
    std::vector<std::unique_ptr<Slot>> slots_;
    std::optional<Hello> hello_;
    std::function<void(const std::string&)> failed_;
    boost::asio::signal_set child_ended_;
    std::vector<pid_t> ended_;  ///< killed, not reaped yet
    bool stopped_ = false;
};
