// SPDX-License-Identifier: MIT
// The front process's end of a worker process.
#pragma once

#include <sys/types.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "message.hpp"

class WorkerProcess : public std::enable_shared_from_this<WorkerProcess> {
public:
    struct Events {
        std::function<void(const Head&, std::string content)> message;
        std::function<void()> lost;  ///< called when the worker's socket closes: it has ended or soon will
    };

    /// Starts this program again with its arguments and --worker. Throws Failure.
    static std::shared_ptr<WorkerProcess> start(boost::asio::io_context& io,
                                                const std::vector<std::string>& arguments, Events events);
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    [[nodiscard]] pid_t pid() const { return pid_; }
    void send(const Head& head, std::string_view content);
    /// Kills the process; no event follows. Returns the process to wait for, -1 the second time.
    pid_t kill();

private:
    WorkerProcess(boost::asio::io_context& io, Events events) : socket_(io), events_(std::move(events)) {}
    void read_head();
    void read_content();
    void write();
    void lose();

    boost::asio::local::stream_protocol::socket socket_;
    Events events_;
    pid_t pid_ = -1;
    Head head_;
    std::string content_;
    std::deque<std::string> outgoing_;
    bool over_ = false;
};

/// Returns the bytes of memory that the process uses, 0 if unknown.
std::uint64_t resident_bytes(pid_t pid);
