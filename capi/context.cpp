// SPDX-License-Identifier: MIT
// Version, results and contexts.
#include <array>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "forked.hpp"
#include "gl/program_cache.hpp"
#include "handles.hpp"
#include "initialiser.hpp"
#include "material/response_table.hpp"
#include "worker_count.hpp"

namespace nicol::capi {
namespace {

// The memory has fixed size, so that reporting a lack of memory needs none.
thread_local std::array<char, 2048> last_error{};

gl::Backend backend_of(nicol_backend backend) {
    switch (backend) {
        case NICOL_BACKEND_AUTOMATIC:
            return gl::Backend::automatic;
        case NICOL_BACKEND_EGL:
            return gl::Backend::egl;
        case NICOL_BACKEND_OSMESA:
            return gl::Backend::osmesa;
        case NICOL_BACKEND_HOST:
            refuse("backend is NICOL_BACKEND_HOST; nicol_context_create_host makes those contexts");
        default:
            refuse("backend is " + std::to_string(backend) + "; it must be one of NICOL_BACKEND_...");
    }
}

nicol_backend backend_of(gl::Backend backend) {
    switch (backend) {
        case gl::Backend::egl:
            return NICOL_BACKEND_EGL;
        case gl::Backend::osmesa:
            return NICOL_BACKEND_OSMESA;
        case gl::Backend::host:
            return NICOL_BACKEND_HOST;
        case gl::Backend::automatic:
            break;
    }
    return NICOL_BACKEND_AUTOMATIC;
}

void log_what_opened(const Session& session) {
    const gl::ContextInfo& info = session.gl->info();
    session.log_message(NICOL_LOG_INFO,
                        info.device + ": OpenGL " + info.version + ", " + info.renderer + ", " + info.vendor);
    if (!info.software) return;
    for (const gl::FailedAttempt& attempt : session.gl->failed_attempts())
        session.log_message(
            NICOL_LOG_WARNING,
            attempt.what + " could not be used, so OpenGL runs on the CPU. A graphics processor needs it: " +
                attempt.reason);
}

/// Returns the host's task system in the library's form.
TaskSystem tasks_from(const nicol_context_options& options) {
    if (options.start_tasks == nullptr) return {};
    return {.start =
                [start = options.start_tasks, user = options.tasks_user](int count,
                                                                         const std::function<void()>& task) {
                    return start(
                        user, static_cast<uint32_t>(count),
                        [](void* data) { (*static_cast<const std::function<void()>*>(data))(); },
                        const_cast<std::function<void()>*>(&task));
                },
            .finish = [finish = options.finish_tasks,
                       user = options.tasks_user](void* started) { finish(user, started); }};
}

MemoryMonitor monitor_from(nicol_memory_callback callback, void* user) {
    if (callback == nullptr) return {};
    return [callback, user](std::int64_t bytes) { return callback(user, bytes) != 0; };
}

const char* cache_folder(const char* chosen) {
    if (chosen != nullptr && *chosen != '\0') return chosen;
    const char* environment = std::getenv("NICOL_CACHE");
    return environment != nullptr ? environment : "";
}

}  // namespace

nicol_context_options context_options(const nicol_context_options* options) {
    const auto chosen = read_options(options, nicol_context_options NICOL_CONTEXT_OPTIONS_INIT);
    if (chosen.threads > 1024) {
        refuse("threads is " + std::to_string(chosen.threads) + "; it must lie in 0 (one a core) to 1024");
    }
    for (const auto& [limit, name] :
         {std::pair(chosen.load_bytes_limit, "load_bytes_limit"),
          std::pair(chosen.vertex_limit, "vertex_limit"), std::pair(chosen.triangle_limit, "triangle_limit")})
        if (limit == 0) refuse(std::string(name) + " is 0; it must be 1 or more, or NICOL_NO_LIMIT");
    if ((chosen.start_tasks == nullptr) != (chosen.finish_tasks == nullptr))
        refuse("start_tasks and finish_tasks must both be set, or neither");
    if (!(chosen.load_seconds_limit > 0)) refuse("load_seconds_limit must be above 0");
    return chosen;
}

nicol_context make_context(std::shared_ptr<gl::Context> context, const nicol_context_options& options) {
    auto session = std::make_shared<Session>();
    session->gl = std::move(context);
    session->workers = {.threads = static_cast<int>(options.threads), .tasks = tasks_from(options)};
    session->log.set(options.log, options.log_user);
    session->error = options.error;
    session->error_user = options.error_user;
    session->memory_limit = options.memory_limit;
    session->memory = monitor_from(options.memory, options.memory_user);
    session->gl->set_memory_monitor(session->memory);
    session->load_limits = {.bytes = options.load_bytes_limit,
                            .vertices = options.vertex_limit,
                            .triangles = options.triangle_limit,
                            .seconds = options.load_seconds_limit,
                            .progress = progress_from(options.load_progress, options.load_progress_user)};
    session->cache = cache_folder(options.cache_folder);
    session->gl->run([&] {
        gl::keep_programs(*session->gl, session->cache,
                          [weak = std::weak_ptr(session)](const std::string& message) {
                              if (const SessionPtr kept = weak.lock()) kept->notice(message);
                          });
    });
    log_what_opened(*session);
    // The information lives as long as its context.
    std::shared_ptr<const gl::ContextInfo> info(session->gl, &session->gl->info());
    return make_handle<nicol_context_impl>(session, info);
}

void refuse_after_fork() {
    if (forked())
        throw Error(ErrorCode::unsupported,
                    "the process was forked after it had used Nicol, whose threads are those of the parent "
                    "alone; fork before the first call, or start a new process instead (in Python: "
                    "multiprocessing with the method spawn)");
}

ErrorCode code_of(const std::exception& error) noexcept {
    bool shortage = std::string_view(error.what()).starts_with("pthread_create has failed");  // TBB's message
    if (const auto* system = dynamic_cast<const std::system_error*>(&error))
        shortage = system->code() == std::errc::resource_unavailable_try_again ||
                   system->code() == std::errc::not_enough_memory;
    return shortage ? ErrorCode::out_of_memory : ErrorCode::internal;
}

nicol_result Call::fail(ErrorCode code, const char* message) noexcept {
    const nicol_result result = capi::fail(code, message);
    if (!session_ || session_->error == nullptr) return result;
    for (const Call* call = outer_; call != nullptr; call = call->outer_)
        if (call->reports_) return result;
    reports_ = true;
    session_->error(session_->error_user, result, last_error.data(), function_);
    return result;
}

nicol_result fail(ErrorCode code, const char* message) noexcept {
    std::size_t length = std::strlen(message);
    if (length >= last_error.size()) {
        length = last_error.size() - 1;
        // The message must not end within a UTF-8 character.
        while (length > 0 && (static_cast<unsigned char>(message[length]) & 0xC0) == 0x80) --length;
    }
    std::replace_copy_if(message, message + length, last_error.begin(), is_control, ' ');
    last_error[length] = '\0';
    return static_cast<nicol_result>(code);
}

}  // namespace nicol::capi

using namespace nicol;
using namespace nicol::capi;

uint32_t nicol_version(void) {
    return NICOL_VERSION;
}

const char* nicol_version_string(void) {
    return NICOL_VERSION_STRING;
}

const char* nicol_build_info(uint32_t index) {
    static constexpr std::array facts{
        "version=" NICOL_VERSION_STRING,
        "source=" NICOL_SOURCE_ID,
        "build_type=" NICOL_BUILD_TYPE,
        "compiler=" __VERSION__,
        "backends=egl,osmesa,host",
        "files=" NICOL_FILE_KINDS,
        "methods=factored,dense,reference",
        "high_orders=split,convolution,none",
        "max_order=32",
        "max_channels=16",
    };
    return index < facts.size() ? facts[index] : nullptr;
}

const char* nicol_last_error(void) {
    return last_error.data();
}

const char* nicol_result_name(nicol_result result) {
    switch (result) {
        case NICOL_OK:
            return "success";
        case NICOL_ERROR_INVALID_ARGUMENT:
            return "invalid argument";
        case NICOL_ERROR_INVALID_HANDLE:
            return "invalid handle";
        case NICOL_ERROR_OUT_OF_MEMORY:
            return "out of memory";
        case NICOL_ERROR_FILE_NOT_FOUND:
            return "file not found";
        case NICOL_ERROR_INVALID_FILE:
            return "invalid file";
        case NICOL_ERROR_WRITE_FAILED:
            return "write failed";
        case NICOL_ERROR_UNSUPPORTED:
            return "unsupported";
        case NICOL_ERROR_NO_BACKEND:
            return "no backend";
        case NICOL_ERROR_CANCELLED:
            return "cancelled";
        case NICOL_ERROR_OPENGL:
            return "OpenGL error";
        case NICOL_ERROR_INTERNAL:
            return "internal error";
        case NICOL_ERROR_NOT_CURRENT:
            return "context not current";
        case NICOL_ERROR_TIMEOUT:
            return "timeout";
        case NICOL_ERROR_BUSY:
            return "busy";
        default:
            return "unknown result";
    }
}

nicol_result nicol_context_create(const nicol_context_options* options, nicol_context* context) {
    return guarded([&] {
        require(context, "context");
        const nicol_context_options chosen = context_options(options);
        gl::ContextRequest request{.backend = backend_of(chosen.backend)};
        if (chosen.device > 1024) {
            refuse("device is " + std::to_string(chosen.device) + "; it must lie in 0 (choose) to 1024");
        }
        if (chosen.device > 0) request.device = static_cast<int>(chosen.device) - 1;
        *context = make_context(gl::Context::create(request), chosen);
    });
}

nicol_result nicol_context_retain(nicol_context context) {
    return retain(context);
}
nicol_result nicol_context_release(nicol_context context) {
    return release(context);
}

nicol_result nicol_context_set_log(nicol_context context, nicol_log_callback log, void* log_user) {
    return guarded([&] {
        const SessionPtr session = resolve(context).session;
        refuse_in_callback(*session);
        session->log.set(log, log_user);
    });
}

nicol_result nicol_context_get_info(nicol_context context, nicol_context_info* info) {
    return guarded([&] {
        const nicol_context_impl& self = resolve(context);
        nicol_context_info out = NICOL_CONTEXT_INFO_INIT;
        out.backend = backend_of(self.content->backend);
        out.software = self.content->software ? 1 : 0;
        out.threads = static_cast<uint32_t>(worker_count(self.session->workers.threads));
        out.renderer = self.content->renderer.c_str();
        out.vendor = self.content->vendor.c_str();
        out.version = self.content->version.c_str();
        out.max_framebuffer_size =
            static_cast<uint32_t>(std::min<int>(self.session->gl->limits().target_size, NICOL_MAX_SIZE));
        out.memory_limit = self.session->memory_limit;
        out.load_bytes_limit = self.session->load_limits.bytes;
        out.vertex_limit = self.session->load_limits.vertices;
        out.triangle_limit = self.session->load_limits.triangles;
        out.load_seconds_limit = self.session->load_limits.seconds;
        out.device_uuid = self.content->device_uuid.c_str();
        out.driver_uuid = self.content->driver_uuid.c_str();
        for (const std::size_t bytes : self.session->gl->memory().bytes) out.device_bytes += bytes;
        write_struct(info, out, "info");
    });
}

NICOL_INITIALISER(nicol_context_options, NICOL_CONTEXT_OPTIONS_INIT)
NICOL_INITIALISER(nicol_context_info, NICOL_CONTEXT_INFO_INIT)
