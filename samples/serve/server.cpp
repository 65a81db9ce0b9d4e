// SPDX-License-Identifier: MIT
#include "server.hpp"

#include <boost/asio/ip/address.hpp>
#include <csignal>
#include <cstdio>

#include "common/failure.hpp"

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

tcp::acceptor listen(asio::io_context& io, const Options& options) {
    const std::string where = "--listen: " + options.address + ":" + std::to_string(options.port) + ": ";
    error_code error;
    const asio::ip::address address = asio::ip::make_address(options.address, error);
    if (error) throw Failure(where + "the address must be numeric, like 127.0.0.1 or ::1");
    tcp::acceptor acceptor(io);
    acceptor.open(address.is_v6() ? tcp::v6() : tcp::v4(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind({address, options.port}, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) throw Failure(where + error.message());
    return acceptor;
}

}  // namespace

Server::Server(const Options& options, std::vector<std::string> arguments)
    : options_(options),
      pool_(io_, options, std::move(arguments), metrics_),
      service_(options, pool_, metrics_),
      surroundings_{.options = options,
                    .service = service_,
                    .dispatcher = pool_.dispatcher(),
                    .metrics = metrics_,
                    .ended =
                        [this](Connection* connection) {
                            connections_.erase(connection);
                            end_when_empty();
                        }},
      acceptor_(listen(io_, options)),
      pause_(io_),
      signals_(io_, SIGTERM, SIGINT) {
    service_.connections = [this] { return connections_.size(); };
}

void Server::run() {
    const tcp::endpoint place = acceptor_.local_endpoint();
    const std::string host =
        place.address().is_v6() ? "[" + place.address().to_string() + "]" : place.address().to_string();
    std::printf("nicol-serve: listening on http://%s:%u\n", host.c_str(),
                static_cast<unsigned>(place.port()));
    std::fflush(stdout);
    pool_.start([this](const std::string& reason) {
        failure_ = reason;
        io_.stop();
    });
    accept();
    wait_for_signal();
    io_.run();
    pool_.stop();
    if (!failure_.empty()) throw Failure(failure_);
}

void Server::accept() {
    acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
        if (!acceptor_.is_open()) return;
        if (error) {
            // Out of file descriptors, most likely: some connection must end first.
            constexpr auto retry_delay = std::chrono::milliseconds(100);
            pause_.expires_after(retry_delay);
            pause_.async_wait([this](const error_code& cancelled) {
                if (!cancelled) accept();
            });
            return;
        }
        const auto connection = std::make_shared<Connection>(std::move(socket), surroundings_);
        connections_.insert(connection.get());
        if (connections_.size() > options_.connections)
            connection->refuse({.status = 503,
                                .detail = "Too many connections are open.",
                                .retry_after = service_.retry_after()});
        else
            connection->start();
        accept();
    });
}

void Server::wait_for_signal() {
    signals_.async_wait([this](const error_code& error, int) {
        if (error) return;
        if (service_.draining) return io_.stop();
        drain();
        wait_for_signal();
    });
}

void Server::drain() {
    service_.draining = true;
    acceptor_.close();
    pause_.expires_after(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(options_.drain_limit));
    pause_.async_wait([this](const error_code& error) {
        if (!error) io_.stop();
    });
    // Draining may end a connection and take it out of the set.
    const std::set<Connection*> now = connections_;
    for (Connection* connection : now) connection->drain();
    end_when_empty();
}

void Server::end_when_empty() {
    if (service_.draining && connections_.empty()) io_.stop();
}
