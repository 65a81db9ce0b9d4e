// SPDX-License-Identifier: MIT
#include "connection.hpp"

#include <poll.h>

#include <algorithm>
#include <boost/asio/write.hpp>
#include <boost/beast/core/read_size.hpp>
#include <boost/beast/core/stream_traits.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/write.hpp>
#include <string_view>

#include "framing.hpp"
#include "query.hpp"
#include "upload.hpp"
#include "visitors.hpp"

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using boost::system::error_code;

namespace {

constexpr std::size_t kReadBytes = 65536;  // most bytes per read
/// Interval of checks whether the client left, used while unread bytes hide the end of the stream.
constexpr std::chrono::milliseconds kLookInterval(100);
constexpr std::chrono::seconds kLinger(2);

std::chrono::steady_clock::duration duration(Seconds seconds) {
    return std::chrono::duration_cast<std::chrono::steady_clock::duration>(seconds);
}

/// Returns the answer to a request that cannot be parsed.
Problem problem_of(const error_code& error) {
    if (error == http::error::header_limit)
        return {.status = 431, .detail = "The request's header is too long."};
    if (error == http::error::body_limit) return {.status = 413, .detail = "The request's body is too long."};
    return {.status = 400, .detail = "The request is not HTTP: " + error.message() + "."};
}

std::string text_of(beast::string_view text) {
    return {text.data(), text.size()};
}

/// Returns the address without brackets, as Host headers contain it.
std::string numeric(const asio::ip::address& address) {
    if (address.is_v4()) return address.to_string();
    asio::ip::address_v6 v6 = address.to_v6();
    if (v6.is_v4_mapped()) return asio::ip::make_address_v4(asio::ip::v4_mapped, v6).to_string();
    v6.scope_id(0);
    return v6.to_string();
}

std::string_view content_of(const beast::flat_buffer& buffer) {
    return {static_cast<const char*>(buffer.data().data()), buffer.size()};
}

}  // namespace

Connection::Connection(asio::ip::tcp::socket socket, std::string network, const Surroundings& surroundings,
                       std::shared_ptr<Crowd> crowd)
    : stream_(std::move(socket)),
      network_(std::move(network)),
      around_(surroundings),
      crowd_(std::move(crowd)),
      buffer_(surroundings.options.header_bytes),
      deadline_(stream_.get_executor()),
      next_look_(stream_.get_executor()) {
    crowd_->members.insert(this);
    error_code ignored;
    local_ = numeric(stream_.socket().local_endpoint(ignored).address());
    // Answers are sent in one piece; Nagle's algorithm would only delay their end.
    stream_.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
}

Connection::~Connection() {
    // The rest of around_ may be destroyed already, if the service ends before its answer.
    crowd_->members.erase(this);
    if (crowd_->members.empty() && crowd_->emptied) crowd_->emptied();
}

void Connection::start() {
    wait_for_request();
}

void Connection::refuse(const Problem& problem) {
    answer(around_.service.respond(problem), false);
}

void Connection::drain() {
    draining_ = true;
    if (!in_request_) close();
}

void Connection::displace() {
    // The connection leaves the crowd now, because its last handler may be called much later.
    crowd_->members.erase(this);
    close();
}

void Connection::wait_for_request() {
    parser_.emplace();
    parser_->header_limit(around_.options.header_bytes);
    parser_->body_limit(around_.options.body_bytes);
    in_request_ = false;
    waiting_since_ = std::chrono::steady_clock::now();
    if (buffer_.size() > 0) return read();
    stream_.expires_never();
    limit(around_.options.idle_limit, [this] { close(); });
    stream_.socket().async_wait(asio::ip::tcp::socket::wait_read,
                                [self = shared_from_this()](const error_code& error) {
                                    if (!error) self->read();
                                });
}

void Connection::read() {
    in_request_ = true;
    // The stream's timeout would close the connection without an answer.
    stream_.expires_never();
    late_ = false;
    limit(around_.options.read_limit, [this] {
        late_ = true;
        error_code ignored;
        stream_.socket().cancel(ignored);
    });
    read_header(0);
}

/// Reads the header; its bytes up to `searched` do not contain its end.
void Connection::read_header(std::size_t searched) {
    constexpr std::string_view end = "\r\n\r\n";
    const std::string_view bytes = content_of(buffer_);
    const std::size_t at = bytes.find(end, searched - std::min(searched, end.size() - 1));
    if (at != std::string_view::npos) return finish_header(at + end.size());
    if (bytes.size() == buffer_.max_size()) return void(failed(http::error::header_limit));
    stream_.async_read_some(
        buffer_.prepare(beast::read_size(buffer_, kReadBytes)),
        [self = shared_from_this(), searched = bytes.size()](const error_code& error, std::size_t got) {
            self->buffer_.commit(got);
            if (!self->failed(error)) self->read_header(searched);
        });
}

void Connection::finish_header(std::size_t length) {
    const bool is_upload =
        around_.options.uploads && !around_.status_alone && sends_scene(content_of(buffer_));
    // The parser compares Content-Length when it reads the header.
    if (is_upload) parser_->body_limit(around_.options.upload_bytes);
    error_code error;
    parser_->put(asio::buffer(buffer_.data(), length), error);
    if (failed(error)) return;
    const std::optional<Problem> refused =
        refused_header(content_of(buffer_).substr(0, length), parser_->get().base());
    buffer_.consume(length);
    if (refused) return answer(around_.service.respond(*refused), false);
    if (is_upload) {
        upload_room_ = around_.service.upload_room();
        // A small body is read all the same, so that the connection can continue.
        const auto size = parser_->content_length();
        const bool is_small = size && *size <= around_.options.body_bytes;
        if (const auto response = around_.service.refused_upload(request()); response && !is_small)
            return answer(*response, false);
    }
    if (parser_->is_done()) return handle();
    if (expects_continue(parser_->get().base()) && buffer_.size() == 0) return go_on();
    read_body();
}

/// Answers a client that waits before it sends its body: 100 Continue, or the final answer if no body is
/// needed.
void Connection::go_on() {
    const http::verb method = parser_->get().method();
    if (method != http::verb::get && method != http::verb::head && !upload_room_) return handle();
    static constexpr std::string_view text = "HTTP/1.1 100 Continue\r\n\r\n";
    asio::async_write(stream_, asio::buffer(text),
                      [self = shared_from_this()](const error_code& error, std::size_t) {
                          if (!self->failed(error)) self->read_body();
                      });
}

void Connection::read_body() {
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](const error_code& error, std::size_t) {
                         if (!self->failed(error)) self->handle();
                     });
}

/// Returns whether reading failed. If so, an answer states the reason if possible, and the connection ends.
bool Connection::failed(const error_code& error) {
    if (!error) return false;
    if (late_)
        answer(
            around_.service.respond(Problem{.status = 408, .detail = "The request took too long to arrive."}),
            false);
    else if (error == asio::error::eof || error == http::error::end_of_stream ||
             error == http::error::partial_message || error == asio::error::connection_reset ||
             error == asio::error::operation_aborted)
        close();
    else
        answer(around_.service.respond(problem_of(error)), false);
    return true;
}

/// Sets the time limit. Only one limit is active: another limit() and unlimit() cancel it.
void Connection::limit(Seconds time, std::function<void()> over) {
    deadline_.expires_after(duration(time));
    deadline_.async_wait(
        [self = shared_from_this(), over = std::move(over), now = ++limits_](const error_code& error) {
            // A timer that expired before its cancellation still calls this.
            if (!error && self->limits_ == now) over();
        });
}

void Connection::unlimit() {
    ++limits_;
    deadline_.cancel();
}

/// Returns the request as far as it was read.
Request Connection::request() const {
    const auto& message = parser_->get();
    return {.method = text_of(message.method_string()),
            .target = origin_form(text_of(message.target())),
            .if_none_match = text_of(message[http::field::if_none_match]),
            .range = text_of(message[http::field::range]),
            .if_range = text_of(message[http::field::if_range]),
            .accept_encoding = text_of(message[http::field::accept_encoding]),
            .host = text_of(message[http::field::host]),
            .authority = std::string(authority_of(text_of(message.target()))),
            .origin = text_of(message[http::field::origin]),
            .local = local_,
            .accept = text_of(message[http::field::accept]),
            .content_type = text_of(message[http::field::content_type]),
            .body = message.body(),
            .has_upload_room = upload_room_ != nullptr,
            .status_alone = around_.status_alone};
}

void Connection::handle() {
    unlimit();
    waiting_since_.reset();
    std::variant<Response, Render> outcome = around_.service.handle(request());
    upload_room_.reset();
    const auto& message = parser_->get();
    if (const auto* wanted = std::get_if<Render>(&outcome)) return render(*wanted);
    // An unread body must not be parsed as a request.
    const Response& response = std::get<Response>(outcome);
    answer(response, message.keep_alive() && parser_->is_done() && !response.is_last);
}

void Connection::render(const Render& render) {
    asked_ = std::chrono::steady_clock::now();
    const std::shared_ptr<EventStream> events = render.events_url.empty() ? nullptr : make_events();
    Dispatcher::Progressed progressed;
    if (events) progressed = [events](const RenderProgress& progress) { events->progress(progress); };
    ticket_ = around_.dispatcher.submit(
        render.tag, render.request,
        [self = shared_from_this(), render, events](const AnswerPtr& made) {
            self->ticket_.reset();
            self->unlimit();
            self->stop_watching();
            const Seconds waited = std::chrono::steady_clock::now() - self->asked_;
            self->around_.metrics.waited.add(waited.count());
            const Response response = self->around_.service.respond(render, made);
            if (!events) return self->answer(response, self->parser_->get().keep_alive());
            events->finish(response.status == 200 ? done_event(render.events_url)
                                                  : failed_event(response.content));
        },
        progressed);
    if (!ticket_) {
        ++around_.metrics.refused_queue;
        return answer(around_.service.respond(Problem{.status = 503,
                                                      .detail = "Too many requests wait to be rendered.",
                                                      .retry_after = around_.service.retry_after()}),
                      parser_->get().keep_alive());
    }
    around_.metrics.hits_flight += ticket_->joined ? 1 : 0;
    stream_.expires_never();
    limit(around_.options.deadline, [this, events] {
        leave();
        const Response late =
            around_.service.respond(Problem{.status = 504, .detail = "The image was not done in time."});
        if (events) return events->finish(failed_event(late.content));
        answer(late, parser_->get().keep_alive());
    });
    if (events) {
        ++around_.metrics.requests[200];
        std::string lines;
        const std::string origin = text_of(parser_->get()[http::field::origin]);
        for (const auto& [name, value] : origin_headers(origin, around_.options.allowed_origins))
            lines.append(name).append(": ").append(value).append("\r\n");
        events->begin(lines);
    }
    watch();
}

/// Returns the events of a request, after which the connection closes.
std::shared_ptr<EventStream> Connection::make_events() {
    return std::make_shared<EventStream>(stream_, around_.options.write_limit, [self = shared_from_this()] {
        if (self->ticket_) self->leave();
        self->close();
    });
}

/// Watches for the end of the stream, which means that the client left. Nothing is read while an image is
/// rendered. Bytes of a next request before the end make the socket permanently readable, so the end is
/// checked at intervals.
void Connection::watch() {
    const auto waits = [self = shared_from_this(), job = ticket_->job] {
        return self->ticket_ && self->ticket_->job == job;
    };
    stream_.socket().async_wait(asio::ip::tcp::socket::wait_read,
                                [self = shared_from_this(), waits](const error_code& error) {
                                    if (error || !waits()) return;
                                    if (self->client_left()) {
                                        ++self->around_.metrics.clients_gone;
                                        self->leave();
                                        return self->close();
                                    }
                                    self->next_look_.expires_after(kLookInterval);
                                    self->next_look_.async_wait([self, waits](const error_code& cancelled) {
                                        if (!cancelled && waits()) self->watch();
                                    });
                                });
}

bool Connection::client_left() {
    pollfd ended{.fd = stream_.socket().native_handle(), .events = POLLRDHUP, .revents = 0};
    return ::poll(&ended, 1, 0) > 0;
}

void Connection::stop_watching() {
    error_code ignored;
    stream_.socket().cancel(ignored);
    next_look_.cancel();
}

void Connection::leave() {
    around_.dispatcher.leave(*ticket_);
    ticket_.reset();
    unlimit();
    stop_watching();
}

void Connection::answer(const Response& response, bool keep_alive) {
    in_request_ = true;
    waiting_since_.reset();
    unlimit();
    keep_alive = keep_alive && !draining_;
    ++around_.metrics.requests[response.status];
    const bool head = parser_ && parser_->get().method() == http::verb::head;

    using Body = http::span_body<const char>;
    struct Outgoing {
        http::response<Body> message;
        std::shared_ptr<const void> owner;
    };
    const auto out = std::make_shared<Outgoing>();
    out->owner = response.owner;
    out->message.version(11);
    out->message.result(static_cast<unsigned>(response.status));
    out->message.keep_alive(keep_alive);
    out->message.set(http::field::server, "nicol-serve");
    if (!response.type.empty()) {
        out->message.set(http::field::content_type, response.type);
        out->message.set("X-Content-Type-Options", "nosniff");
    }
    for (const auto& [name, value] : response.headers) out->message.set(name, value);
    const std::string origin = parser_ ? text_of(parser_->get()[http::field::origin]) : "";
    for (const auto& [name, value] : origin_headers(origin, around_.options.allowed_origins))
        out->message.insert(name, value);
    // An image that was not made has unknown length, and 204 and 304 have no content.
    const bool unknown =
        response.status == 204 || response.status == 304 || (head && response.content.empty());
    if (!unknown) out->message.content_length(response.content.size());
    if (!head) out->message.body() = {response.content.data(), response.content.size()};

    stream_.expires_after(duration(around_.options.write_limit));
    http::async_write(stream_, out->message,
                      [self = shared_from_this(), out, keep_alive](const error_code& error, std::size_t) {
                          const bool unread = self->parser_ && !self->parser_->is_done();
                          if (!error && unread && !keep_alive) return self->linger();
                          if (error || !keep_alive || self->draining_) return self->close();
                          self->wait_for_request();
                      });
}

/// Ends the connection after an answer to a request that was not read to its end. A socket that closes with
/// bytes unread resets the connection, and a client that still sends may lose the answer. What comes is
/// therefore dropped until the client ends the connection or kLinger is over.
void Connection::linger() {
    error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    stream_.expires_after(kLinger);
    drop();
}

void Connection::drop() {
    buffer_.consume(buffer_.size());
    stream_.async_read_some(buffer_.prepare(beast::read_size(buffer_, kReadBytes)),
                            [self = shared_from_this()](const error_code& error, std::size_t) {
                                if (error) return self->close();
                                self->drop();
                            });
}

void Connection::close() {
    unlimit();
    error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
    stream_.close();
}
