// SPDX-License-Identifier: MIT
// The front process: its listeners, its workers, and its orderly end.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <optional>
#include <string>
#include <vector>

#include "listener.hpp"
#include "options.hpp"
#include "pool.hpp"
#include "service.hpp"

class Server {
public:
    /// Binds the addresses. Throws Failure if that fails. `arguments` are those of this process.
    Server(const Options& options, std::vector<std::string> arguments);

    /// Serves until SIGTERM or SIGINT, and then until open requests are answered or the drain limit has
    /// passed. A second signal ends the service now. Throws Failure if no worker can start.
    void run();

private:
    void wait_for_signal();
    void drain();

    const Options& options_;
    boost::asio::io_context io_;
    Metrics metrics_;
    Pool pool_;
    Service service_;
    Listener listener_;
    std::optional<Listener> status_listener_;
    boost::asio::steady_timer drain_limit_;
    boost::asio::signal_set signals_;
    std::string failure_;
};
