// SPDX-License-Identifier: MIT
// The front process: listens, holds the connections, ends in order.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <set>
#include <string>
#include <vector>

#include "connection.hpp"
#include "options.hpp"
#include "pool.hpp"
#include "service.hpp"

class Server {
public:
    /// Binds the address. Throws Failure where that cannot be had. arguments: those of this process.
    Server(const Options& options, std::vector<std::string> arguments);

    /// Serves until SIGTERM or SIGINT, and then until open requests are answered or the drain limit is over;
    /// a second signal ends at once. Throws Failure where no worker can start.
    void run();

private:
    void accept();
    void wait_for_signal();
    void drain();
    void end_when_empty();

    const Options& options_;
    boost::asio::io_context io_;
    Metrics metrics_;
    Pool pool_;
    Service service_;
    std::set<Connection*> connections_;
    Connection::Surroundings surroundings_;
    boost::asio::ip::tcp::acceptor acceptor_;
    boost::asio::steady_timer pause_;  ///< of accepting, and of draining
    boost::asio::signal_set signals_;
    std::string failure_;
};
