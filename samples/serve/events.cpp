// SPDX-License-Identifier: MIT
#include "events.hpp"

#include <algorithm>
#include <boost/asio/write.hpp>
#include <cmath>
#include <utility>

#include "field.hpp"
#include "json.hpp"

namespace {

std::string event(std::string_view name, std::string_view data) {
    return "event: " + std::string(name) + "\ndata: " + std::string(data) + "\n\n";
}

}  // namespace

bool accepts_events(std::string_view accept) {
    while (!accept.empty()) {
        std::string_view range = take_part(accept, ',');
        if (take_part(range, ';') == "text/event-stream") return true;
    }
    return false;
}

std::string done_event(std::string_view url) {
    return event("done", "{\"url\":" + json_string(url) + "}");
}

std::string failed_event(std::string_view problem) {
    return event("failed", problem.substr(0, problem.find('\n')));
}

void EventStream::begin(const std::string& lines) {
    next_ =
        "HTTP/1.1 200 OK\r\nServer: nicol-serve\r\nContent-Type: text/event-stream\r\n"
        "X-Content-Type-Options: nosniff\r\nCache-Control: no-store\r\nConnection: close\r\n" +
        lines + "\r\n";
    write();
}

void EventStream::progress(const RenderProgress& progress) {
    const Clock::time_point now = Clock::now();
    const double part = std::clamp(progress.fraction, 0.0, 1.0);
    if (progress.verb != verb_ || part < verb_from_) {
        verb_ = progress.verb;
        verb_from_ = part;
        verb_start_ = now;
    }
    std::string data = "{\"verb\":" + json_string(kVerbs.at(progress.verb)) +
                       ",\"percent\":" + json_number(std::round(1000 * part) / 10);
    // A smaller part says little about the rest.
    constexpr double enough = 0.05;
    const double done = part - verb_from_;
    if (done > enough) {
        const double left = Seconds(now - verb_start_).count() * (1 - part) / done;
        data += ",\"seconds_left\":" + json_number(std::round(10 * left) / 10);
    }
    progress_ = event("progress", data + "}");
    write();
}

void EventStream::finish(std::string event) {
    progress_.clear();
    last_ = std::move(event);
    write();
}

void EventStream::write() {
    if (!written_.empty() || !ended_) return;
    const bool is_last = !last_.empty();
    written_ = std::exchange(next_, {}) + std::exchange(progress_, {}) + std::exchange(last_, {});
    if (written_.empty()) return;
    stream_.expires_after(std::chrono::duration_cast<Clock::duration>(write_limit_));
    boost::asio::async_write(
        stream_, boost::asio::buffer(written_),
        [self = shared_from_this(), is_last](const boost::system::error_code& error, std::size_t) {
            self->written_.clear();
            self->stream_.expires_never();
            if (error || is_last) {
                if (const auto ended = std::exchange(self->ended_, nullptr)) ended();
                return;
            }
            self->write();
        });
}
