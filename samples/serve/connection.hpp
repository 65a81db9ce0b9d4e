// SPDX-License-Identifier: MIT
// One client's connection, which reads requests within limits and answers them one after another.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "events.hpp"
#include "options.hpp"
#include "service.hpp"

class Connection : public std::enable_shared_from_this<Connection> {
public:
    struct Surroundings {
        const Options& options;
        Service& service;
        Dispatcher& dispatcher;
        Metrics& metrics;
        bool status_alone = false;  ///< answers only requests for the service's status
    };
    /// The open connections of one listener. Connections enter and leave by themselves.
    struct Crowd {
        std::set<Connection*> members;
        std::function<void()> emptied;
    };

    /// Makes a connection. `network` is equal for all connections of one client.
    Connection(boost::asio::ip::tcp::socket socket, std::string network, const Surroundings& surroundings,
               std::shared_ptr<Crowd> crowd);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Serves requests until the client or a limit ends the connection, which keeps itself alive.
    void start();
    /// Answers with this problem and closes, without reading a request.
    void refuse(const Problem& problem);
    /// Closes now, or after the answer to a request under way.
    void drain();
    /// Closes now to make room for another connection.
    void displace();

    [[nodiscard]] const std::string& network() const { return network_; }
    /// Returns since when there has been no complete request to answer, or nothing while there is one.
    [[nodiscard]] std::optional<std::chrono::steady_clock::time_point> waiting_since() const {
        return waiting_since_;
    }

private:
    using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;

    void wait_for_request();
    void read();
    void read_header(std::size_t searched);
    void finish_header(std::size_t length);
    void go_on();
    void read_body();
    bool failed(const boost::system::error_code& error);
    [[nodiscard]] Request request() const;
    void handle();
    void render(const Render& render);
    std::shared_ptr<EventStream> make_events();
    void watch();
    bool client_left();
    void stop_watching();
    void leave();
    void answer(const Response& response, bool keep_alive);
    void limit(Seconds time, std::function<void()> over);
    void unlimit();
    void close();
    void linger();
    void drop();

    boost::beast::tcp_stream stream_;
    const std::string network_;
    std::string local_;  ///< address that the client connected to
    const Surroundings& around_;
    const std::shared_ptr<Crowd> crowd_;
    boost::beast::flat_buffer buffer_;
    std::optional<Parser> parser_;
    boost::asio::steady_timer deadline_;        ///< timer of limit()
    boost::asio::steady_timer next_look_;       ///< timer of watch()
    std::uint64_t limits_ = 0;                  ///< number of limits set so far
    std::optional<Dispatcher::Ticket> ticket_;  ///< set while an image is under way
    std::chrono::steady_clock::time_point asked_;
    std::optional<std::chrono::steady_clock::time_point> waiting_since_;
    std::shared_ptr<void> upload_room_;  ///< set while an uploaded scene is read
    bool late_ = false;                  ///< the request took too long to arrive
    bool in_request_ = false, draining_ = false;
};
