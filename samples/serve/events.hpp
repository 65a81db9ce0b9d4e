// SPDX-License-Identifier: MIT
// Server-sent events: the progress of a render, and its end.
#pragma once

#include <boost/beast/core/tcp_stream.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "message.hpp"
#include "options.hpp"

/// Returns whether the client asks for events instead of an image: Accept names text/event-stream.
bool accepts_events(std::string_view accept);

/// Returns the last event of a successful render: the image's address.
std::string done_event(std::string_view url);
/// Returns the last event of a failed render: problem details as JSON.
std::string failed_event(std::string_view problem);

/// Events of one request, written to its connection one after another. Of several reports of progress that
/// come during a write, only the last one is sent.
class EventStream : public std::enable_shared_from_this<EventStream> {
public:
    /// `ended` is called once, when the last event is written or the client cannot be reached.
    EventStream(boost::beast::tcp_stream& stream, Seconds write_limit, std::function<void()> ended)
        : stream_(stream), write_limit_(write_limit), ended_(std::move(ended)) {}

    /// Sends the answer's head with these further lines.
    void begin(const std::string& lines);
    void progress(const RenderProgress& progress);
    void finish(std::string event);

private:
    using Clock = std::chrono::steady_clock;
    void write();

    boost::beast::tcp_stream& stream_;
    Seconds write_limit_;
    std::function<void()> ended_;
    std::string written_;                 ///< bytes under way; empty: none
    std::string next_, progress_, last_;  ///< bytes to send, in this order
    std::uint32_t verb_ = ~0u;            ///< verb of the last report
    double verb_from_ = 0;                ///< fraction at its first report
    Clock::time_point verb_start_;
};
