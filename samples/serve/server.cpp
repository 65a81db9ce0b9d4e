// SPDX-License-Identifier: MIT
#include "server.hpp"

#include <csignal>
#include <cstdio>

#include "common/failure.hpp"
#include "notify.hpp"
#include "sandbox.hpp"

using boost::system::error_code;

namespace {

/// Places of --status-listen, for monitors and for operators with a browser.
constexpr Listener::Places kStatusPlaces{.all = 32, .per_address = 0};

/// Reports missing features without which the service still works.
void say_what_is_missing(const Options& options) {
    if (options.sandbox && !can_confine())
        std::fputs("nicol-serve: the kernel has no Landlock; workers may open every file of their user\n",
                   stderr);
}

}  // namespace

Server::Server(const Options& options, std::vector<std::string> arguments)
    : options_(options),
      pool_(io_, options, std::move(arguments), metrics_),
      service_(options, pool_, metrics_),
      listener_(
          io_, options.listen, "--listen",
          {.all = options.connections, .per_address = options.connections_per_address},
          {.options = options, .service = service_, .dispatcher = pool_.dispatcher(), .metrics = metrics_}),
      drain_limit_(io_),
      signals_(io_, SIGTERM, SIGINT) {
    if (options.status_listen)
        status_listener_.emplace(io_, *options.status_listen, "--status-listen", kStatusPlaces,
                                 Connection::Surroundings{.options = options,
                                                          .service = service_,
                                                          .dispatcher = pool_.dispatcher(),
                                                          .metrics = metrics_,
                                                          .status_alone = true});
    service_.connections = [this] { return listener_.connections(); };
    pool_.warm = [] { notify("READY=1"); };
}

void Server::run() {
    std::printf("nicol-serve: listening on %s\n", listener_.url().c_str());
    if (status_listener_) std::printf("nicol-serve: status on %s\n", status_listener_->url().c_str());
    std::fflush(stdout);
    say_what_is_missing(options_);
    pool_.start([this](const std::string& reason) {
        failure_ = reason;
        io_.stop();
    });
    listener_.start();
    if (status_listener_) status_listener_->start();
    wait_for_signal();
    io_.run();
    pool_.stop();
    if (!failure_.empty()) throw Failure(failure_);
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
    notify("STOPPING=1");
    service_.draining = true;
    drain_limit_.expires_after(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(options_.drain_limit));
    drain_limit_.async_wait([this](const error_code& error) {
        if (!error) io_.stop();
    });
    listener_.drain([this] { io_.stop(); });
}
