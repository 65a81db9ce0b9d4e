// SPDX-License-Identifier: MIT
#include "worker.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>

#include "common/failure.hpp"
#include "common/handles.hpp"
#include "message.hpp"
#include "sandbox.hpp"
#include "scene_files.hpp"
#include "stage.hpp"

namespace {

constexpr int kCancelled = 499;

/// Exception for the end of the front process.
struct Gone {};

class Channel {
public:
    explicit Channel(int socket) : socket_(socket) {}

    void send(Head head, std::string_view first, std::string_view second = {}) const {
        head.length = static_cast<std::uint32_t>(first.size() + second.size());
        for (const std::string_view part : {bytes_of(head), first, second})
            for (std::string_view rest = part; !rest.empty();) {
                const ssize_t sent = ::send(socket_, rest.data(), rest.size(), MSG_NOSIGNAL);
                if (sent < 0 && errno == EINTR) continue;
                if (sent <= 0) throw Gone();
                rest.remove_prefix(static_cast<std::size_t>(sent));
            }
    }

    template <typename T>
    [[nodiscard]] T receive() const {
        T value{};
        receive(reinterpret_cast<char*>(&value), sizeof value);
        return value;
    }

    [[nodiscard]] std::string receive(std::uint32_t size) const {
        std::string bytes(size, '\0');
        receive(bytes.data(), bytes.size());
        return bytes;
    }

    [[nodiscard]] bool readable() const {
        pollfd wanted{.fd = socket_, .events = POLLIN, .revents = 0};
        return ::poll(&wanted, 1, 0) > 0;
    }

private:
    void receive(char* at, std::size_t left) const {
        while (left > 0) {
            const ssize_t got = ::recv(socket_, at, left, 0);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) throw Gone();
            at += got;
            left -= static_cast<std::size_t>(got);
        }
    }

    int socket_;
};

/// Reports a render's progress, and checks whether its job was cancelled or the front process ended.
struct Watch {
    const Channel& channel;
    std::uint64_t job;

    static std::int32_t poll(void* user, const char* verb, double fraction) {
        const auto& watch = *static_cast<const Watch*>(user);
        while (watch.channel.readable()) {
            // Exceptions must not pass through the library. The main loop finds the end of the stream again.
            try {
                if (watch.channel.receive<Head>().job == watch.job) return 0;
            } catch (const Gone&) {
                return 0;
            }
        }
        return watch.report(verb, fraction) ? 1 : 0;
    }

    [[nodiscard]] bool report(std::string_view verb, double fraction) const {
        const auto known = std::ranges::find(kVerbs, verb);
        if (known == kVerbs.end()) return true;
        const RenderProgress progress{.verb = static_cast<std::uint32_t>(known - kVerbs.begin()),
                                      .fraction = fraction};
        try {
            channel.send({.kind = MessageKind::progress, .length = 0, .job = job}, bytes_of(progress));
            return true;
        } catch (const Gone&) {
            return false;
        }
    }
};

int status_of(nicol_result result) {
    switch (result) {
        case NICOL_ERROR_INVALID_ARGUMENT:
        case NICOL_ERROR_UNSUPPORTED:
            return 400;
        case NICOL_ERROR_CANCELLED:
            return kCancelled;
        case NICOL_ERROR_OUT_OF_MEMORY:
            return 503;
        default:
            return 500;
    }
}

void log(void*, std::uint32_t severity, nicol_result, const char* message) {
    if (severity >= NICOL_LOG_NOTICE)
        std::fprintf(stderr, "nicol-serve: worker %d: %s\n", getpid(), one_line(message).c_str());
}

Context make_context(const Options& options) {
    nicol_context_options wanted = options.load_limits;
    wanted.backend = options.backend;
    wanted.threads = options.threads;
    wanted.log = log;
    wanted.cache_folder = options.cache.c_str();
    nicol_context context = nullptr;
    check(nicol_context_create(&wanted, &context));
    return Context(context);
}

void render(const Channel& channel, std::uint64_t id, const ImageRequest& request,
            std::vector<std::optional<Stage>>& stages) {
    Watch watch{.channel = channel, .job = id};
    ResultHead result;
    std::string content;
    try {
        content = stages.at(request.view.scene)
                      .value()
                      .render(request, {.callback = Watch::poll, .user = &watch}, result);
        result.status = 200;
    } catch (const nicol::Error& error) {
        result.status = status_of(error.result());
        content = error.what();
    } catch (const std::bad_alloc&) {
        result.status = 503;
        content = "out of memory";
    } catch (const std::exception& error) {
        content = error.what();
    }
    if (result.status >= 500) log(nullptr, NICOL_LOG_WARNING, NICOL_OK, content.c_str());
    channel.send({.kind = MessageKind::result, .length = 0, .job = id}, bytes_of(result), content);
}

/// Limits the address space, so that large scenes or requests fail instead of the machine.
void limit_memory(std::uint64_t bytes) {
#if !defined(NICOL_SANITIZED)  // the sanitizers reserve terabytes
    if (bytes == 0) return;
    const rlimit limit{.rlim_cur = bytes, .rlim_max = bytes};
    if (setrlimit(RLIMIT_AS, &limit) != 0)
        log(nullptr, NICOL_LOG_WARNING, NICOL_OK, "--memory-limit cannot be set; without it");
#else
    static_cast<void>(bytes);
#endif
}

/// Loads a scene from a path or an Upload.
template <class Source>
void load(const Channel& channel, nicol_context context, const std::string& id, const Source& source,
          std::uint64_t index, std::optional<Stage>& stage) {
    Loaded loaded;
    stage.reset();
    try {
        stage.emplace(context, source);
        loaded.info = stage->info();
    } catch (const std::exception& error) {
        loaded.info.id = id;
        loaded.reason = one_line(error.what());
    }
    channel.send({.kind = MessageKind::loaded, .length = 0, .job = index}, pack(loaded));
}

void serve(const Channel& channel, const Options& options) {
    const Context context = make_context(options);
    const std::vector<std::filesystem::path> paths = find_scenes(options.scenes);
    std::vector<std::optional<Stage>> stages(paths.size() + options.upload_places);
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    check(nicol_context_get_info(context.get(), &info));
    Hello hello{.renderer = std::string(info.renderer) + ", " + info.version, .scenes = {}};
    for (const std::filesystem::path& path : paths) hello.scenes.push_back(path.stem());
    channel.send({.kind = MessageKind::hello, .length = 0, .job = 0}, pack(hello));
    for (;;) {
        const Head head = channel.receive<Head>();
        if (head.kind == MessageKind::load && head.length == 0) {
            const std::filesystem::path& path = paths.at(head.job);
            load(channel, context.get(), path.stem(), path, head.job, stages.at(head.job));
        } else if (head.kind == MessageKind::load) {
            Upload upload;
            if (!unpack(channel.receive(head.length), upload)) throw Failure("an upload is not whole");
            load(channel, context.get(), upload.id, upload, head.job, stages.at(head.job));
        }
        // A cancel received here belongs to a finished job.
        if (head.kind == MessageKind::job) render(channel, head.job, channel.receive<ImageRequest>(), stages);
    }
}

}  // namespace

int run_worker(int socket, const Options& options) {
    // The front process alone ends workers, even if a terminal sends signals to both.
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Mesa's software renderer would otherwise start one thread per core in every worker.
    if (options.threads > 0) setenv("LP_NUM_THREADS", std::to_string(options.threads).c_str(), 0);
    limit_memory(options.memory_bytes);
    const Channel channel(socket);
    try {
        try {
            if (options.sandbox) confine(options);
            serve(channel, options);
        } catch (const std::exception& error) {
            channel.send({.kind = MessageKind::failed, .length = 0, .job = 0}, one_line(error.what()));
        }
    } catch (const Gone&) {
        return 0;
    }
    return 2;
}
