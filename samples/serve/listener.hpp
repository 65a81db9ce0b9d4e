// SPDX-License-Identifier: MIT
// A listening address, and the connections that hold a place there.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>

#include "connection.hpp"
#include "options.hpp"

class Listener {
public:
    struct Places {
        std::size_t all = 0;
        std::size_t per_address = 0;  ///< 0: unlimited
    };

    /// Binds the address. Throws Failure naming the option if that fails.
    Listener(boost::asio::io_context& io, const Endpoint& endpoint, const char* option, const Places& places,
             const Connection::Surroundings& surroundings);

    ~Listener() { crowd_->emptied = nullptr; }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    void start() { accept(); }
    /// Accepts no more connections. `ended` is called once all connections are closed, which may be now.
    void drain(std::function<void()> ended);
    [[nodiscard]] std::size_t connections() const { return crowd_->members.size(); }
    /// Returns the URL, such as "http://127.0.0.1:8080".
    [[nodiscard]] std::string url() const;

private:
    void accept();
    void admit(boost::asio::ip::tcp::socket socket);

    Places places_;
    Connection::Surroundings around_;
    std::shared_ptr<Connection::Crowd> crowd_ = std::make_shared<Connection::Crowd>();
    boost::asio::ip::tcp::acceptor acceptor_;
    boost::asio::steady_timer pause_;
};
