// SPDX-License-Identifier: MIT
#include "listener.hpp"

#include <boost/asio/ip/address.hpp>
#include <optional>

#include "common/failure.hpp"

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

tcp::acceptor listen(asio::io_context& io, const Endpoint& endpoint, const char* option) {
    const std::string where =
        std::string(option) + ": " + endpoint.address + ":" + std::to_string(endpoint.port) + ": ";
    error_code error;
    const asio::ip::address address = asio::ip::make_address(endpoint.address, error);
    if (error) throw Failure(where + "the address must be numeric, like 127.0.0.1 or ::1");
    tcp::acceptor acceptor(io);
    acceptor.open(address.is_v6() ? tcp::v6() : tcp::v4(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind({address, endpoint.port}, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) throw Failure(where + error.message());
    return acceptor;
}

/// Returns the part of an address that identifies a client: for IPv6 the first half, because clients choose
/// the second half.
std::string network_of(const tcp::socket& socket) {
    error_code error;
    const asio::ip::address address = socket.remote_endpoint(error).address();
    if (error) return "";
    if (address.is_v4()) return address.to_string();
    const asio::ip::address_v6 v6 = address.to_v6();
    if (v6.is_v4_mapped()) return asio::ip::make_address_v4(asio::ip::v4_mapped, v6).to_string();
    const auto bytes = v6.to_bytes();
    return {bytes.begin(), bytes.begin() + 8};
}

}  // namespace

Listener::Listener(asio::io_context& io, const Endpoint& endpoint, const char* option, const Places& places,
                   const Connection::Surroundings& surroundings)
    : places_(places), around_(surroundings), acceptor_(listen(io, endpoint, option)), pause_(io) {}

std::string Listener::url() const {
    const tcp::endpoint place = acceptor_.local_endpoint();
    const std::string address = place.address().to_string();
    return "http://" + (place.address().is_v6() ? "[" + address + "]" : address) + ":" +
           std::to_string(place.port());
}

void Listener::accept() {
    acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
        if (!acceptor_.is_open()) return;
        if (!error) {
            admit(std::move(socket));
            return accept();
        }
        // The process probably has no file descriptors left, so some connection must end first.
        constexpr auto retry_delay = std::chrono::milliseconds(100);
        pause_.expires_after(retry_delay);
        pause_.async_wait([this](const error_code& cancelled) {
            if (!cancelled) accept();
        });
    });
}

/// Admits a connection. If there is no place, the new connection replaces the one that has waited longest for
/// a complete request, preferably one of its own address. Clients that hold places without requests, or send
/// them slowly, thus cannot keep others out.
void Listener::admit(tcp::socket socket) {
    const std::string network = network_of(socket);
    std::size_t neighbours = 0;
    Connection *idlest = nullptr, *idlest_neighbour = nullptr;
    const auto consider = [](Connection*& best, Connection* other) {
        if (other->waiting_since() && (!best || *other->waiting_since() < *best->waiting_since()))
            best = other;
    };
    for (Connection* member : crowd_->members) {
        consider(idlest, member);
        if (member->network() != network) continue;
        ++neighbours;
        consider(idlest_neighbour, member);
    }
    const bool many = places_.per_address > 0 && neighbours >= places_.per_address;
    const bool full = many || crowd_->members.size() >= places_.all;
    Connection* const leaving = many ? idlest_neighbour : idlest;
    const auto connection = std::make_shared<Connection>(std::move(socket), network, around_, crowd_);
    if (!full) return connection->start();
    if (leaving == nullptr)
        return connection->refuse({.status = many ? 429 : 503,
                                   .detail = many ? "Too many connections of this address are open."
                                                  : "Too many connections are open.",
                                   .retry_after = around_.service.retry_after()});
    ++around_.metrics.displaced;
    leaving->displace();
    connection->start();
}

void Listener::drain(std::function<void()> ended) {
    error_code ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    // Draining may end a connection and remove it from the set.
    const std::set<Connection*> now = crowd_->members;
    for (Connection* connection : now) connection->drain();
    if (crowd_->members.empty()) return ended();
    crowd_->emptied = std::move(ended);
}
