// SPDX-License-Identifier: MIT
#include "worker_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>

#include "common/failure.hpp"

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

constexpr int kChildSocket = 3;

[[noreturn]] void fail(int reason) {
    throw Failure(std::string("a worker process cannot be started: ") + std::strerror(reason));
}

pid_t spawn(const std::vector<std::string>& arguments, int socket) {
    std::vector<std::string> words = arguments;
    words.insert(words.end(), {"--worker", std::to_string(kChildSocket)});
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, socket, kChildSocket);
    // A worker must not inherit the listening socket or sockets of clients.
    posix_spawn_file_actions_addclosefrom_np(&actions, kChildSocket + 1);
    pid_t pid = -1;
    const int error = posix_spawn(&pid, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) fail(error);
    return pid;
}

}  // namespace

std::shared_ptr<WorkerProcess> WorkerProcess::start(asio::io_context& io,
                                                    const std::vector<std::string>& arguments,
                                                    Events events) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail(errno);
    std::shared_ptr<WorkerProcess> worker(new WorkerProcess(io, std::move(events)));
    worker->socket_.assign(asio::local::stream_protocol(), ends[0]);
    try {
        worker->pid_ = spawn(arguments, ends[1]);
    } catch (...) {
        ::close(ends[1]);
        throw;
    }
    ::close(ends[1]);
    worker->read_head();
    return worker;
}

WorkerProcess::~WorkerProcess() {
    kill();
}

void WorkerProcess::send(const Head& head, std::string_view content) {
    if (over_) return;
    std::string bytes(bytes_of(head));
    bytes += content;
    outgoing_.push_back(std::move(bytes));
    if (outgoing_.size() == 1) write();
}

pid_t WorkerProcess::kill() {
    over_ = true;
    error_code ignored;
    socket_.close(ignored);
    if (pid_ > 0) ::kill(pid_, SIGKILL);
    return std::exchange(pid_, -1);
}

void WorkerProcess::read_head() {
    asio::async_read(socket_, asio::buffer(&head_, sizeof head_),
                     [self = shared_from_this()](const error_code& error, std::size_t) {
                         if (error || self->head_.length > kMaxMessageBytes) return self->lose();
                         self->read_content();
                     });
}

void WorkerProcess::read_content() {
    content_.resize(head_.length);
    asio::async_read(socket_, asio::buffer(content_),
                     [self = shared_from_this()](const error_code& error, std::size_t) {
                         if (error) return self->lose();
                         if (self->over_) return;
                         self->events_.message(self->head_, std::move(self->content_));
                         if (!self->over_) self->read_head();
                     });
}

void WorkerProcess::write() {
    asio::async_write(socket_, asio::buffer(outgoing_.front()),
                      [self = shared_from_this()](const error_code& error, std::size_t) {
                          if (error) return self->lose();
                          self->outgoing_.pop_front();
                          if (!self->outgoing_.empty()) self->write();
                      });
}

void WorkerProcess::lose() {
    if (std::exchange(over_, true)) return;
    events_.lost();
}

std::uint64_t resident_bytes(pid_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/statm");
    std::uint64_t total = 0, resident = 0;
    file >> total >> resident;
    return file ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}
