// SPDX-License-Identifier: MIT
// Creation and destruction of contexts.
#include "gl/context.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>

#include "error.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

struct Candidate {
    Backend backend;
    std::string name;
    std::function<std::unique_ptr<Platform>()> make;
};

/// Returns the request with NICOL_BACKEND and the device applied.
ContextRequest resolved(ContextRequest request) {
    const char* variable = std::getenv("NICOL_BACKEND");
    if (request.backend == Backend::automatic && variable != nullptr && *variable != '\0') {
        const std::string_view value = variable;
        if (value == "egl")
            request.backend = Backend::egl;
        else if (value == "osmesa")
            request.backend = Backend::osmesa;
        else
            throw Error(ErrorCode::invalid_argument, "the environment variable NICOL_BACKEND is \"" +
                                                         std::string(value) + "\"; it may be egl or osmesa");
    }
    if (request.device && request.backend == Backend::osmesa)
        throw Error(ErrorCode::invalid_argument, "the backend osmesa has no devices; leave the device out");
    if (request.device) request.backend = Backend::egl;
    return request;
}

/// Finds EGL's choices on a thread of its own, because EGL queries leave state in the calling thread.
EglChoices find_egl_choices_aside() {
    EglChoices choices;
    std::exception_ptr error;
    start_quiet_thread([&] {
        try {
            choices = find_egl_choices();
        } catch (...) {
            error = std::current_exception();
        }
    }).join();
    if (error) std::rethrow_exception(error);
    return choices;
}

std::vector<Candidate> candidates(const ContextRequest& request, std::vector<FailedAttempt>& failed) {
    std::vector<Candidate> list;
    if (request.backend != Backend::osmesa) {
        EglChoices found;
        try {
            found = find_egl_choices_aside();
            if (!found.no_device.empty()) failed.push_back({"EGL devices", found.no_device});
        } catch (const Error& error) {
            if (error.code() == ErrorCode::out_of_memory) throw;
            failed.push_back({"EGL", error.what()});
        }
        if (request.device && found.devices > 0 && (*request.device < 0 || *request.device >= found.devices))
            throw Error(ErrorCode::invalid_argument, "EGL device " + std::to_string(*request.device) +
                                                         " does not exist: EGL lists " +
                                                         std::to_string(found.devices) + ", counted from 0");
        for (const EglChoice& choice : found.choices)
            if (!request.device || choice.device == request.device)
                list.push_back({Backend::egl, choice.name, [choice] { return make_egl_platform(choice); }});
    }
    if (request.backend != Backend::egl)
        list.push_back({Backend::osmesa, "OSMesa", [] { return make_osmesa_platform(); }});
    return list;
}

}  // namespace

std::shared_ptr<Context> Context::create(const ContextRequest& asked) {
    const ContextRequest request = resolved(asked);
    std::vector<FailedAttempt> failed;
    for (const Candidate& candidate : candidates(request, failed)) {
        // Each attempt gets a new thread, because a thread that used one of Mesa's libraries cannot use the
        // other.
        auto state = std::make_shared<State>();
        state->thread = start_quiet_thread([state] {
            state->worker.work();
            state->close();
        });
        // The context's destructor ends the thread from here on.
        std::shared_ptr<Context> context(new Context(state));
        try {
            context->run([&] { state->open(candidate.make(), candidate.backend, candidate.name); });
            state->failed_attempts = std::move(failed);
            return context;
        } catch (const Error& error) {
            if (error.code() == ErrorCode::out_of_memory) throw;
            failed.push_back({candidate.name, error.what()});
        }
    }
    std::string text = "no OpenGL 4.5 core context could be made.";
    for (const FailedAttempt& attempt : failed) text += "\n  " + attempt.what + ": " + attempt.reason;
    throw Error(ErrorCode::no_backend, text);
}

std::shared_ptr<Context> Context::create_in_host(HostAccess access) {
    auto state = std::make_shared<State>();
    state->open_in_host(std::move(access));
    return std::shared_ptr<Context>(new Context(std::move(state)));
}

Context::Context(std::shared_ptr<State> state) : state_(std::move(state)) {}

Context::~Context() {
    if (state_->host) {
        if (state_->host->is_current(*state_)) {
            state_->host->remove_waiting(*state_);
            state_->close();
        }
        return;
    }
    state_->worker.stop();
    join_or_leave(std::move(state_->thread));
}

const ContextInfo& Context::info() const noexcept {
    return state_->info;
}

const Limits& Context::limits() const noexcept {
    return state_->limits;
}

const std::vector<FailedAttempt>& Context::failed_attempts() const noexcept {
    return state_->failed_attempts;
}

MemoryUse Context::memory() const noexcept {
    MemoryUse use;
    for (std::size_t kind = 0; kind < use.bytes.size(); ++kind) use.bytes[kind] = state_->bytes[kind];
    return use;
}

void Context::set_memory_monitor(MemoryMonitor monitor) {
    state_->memory_monitor = std::move(monitor);
}

bool Context::on_thread() const noexcept {
    return state_->host ? state_->host->on_thread() : state_->worker.on_thread();
}

void Context::require_current() const {
    if (state_->host) state_->host->require_current(*state_);
}

void Context::execute(void (*call)(void*), void* argument) {
    // The called function may drop the last reference to this context.
    const std::shared_ptr<State> kept = state_;
    const bool outermost = !on_thread();
    if (kept->host)
        kept->host->execute(*kept, call, argument);
    else
        kept->worker.execute(call, argument);
    if (outermost) kept->program_notices.deliver();
}

void Context::visit(const std::function<void()>& f) {
    if (!state_->host) return f();
    const std::shared_ptr<State> kept = state_;
    kept->host->visit(*kept, f);
    kept->program_notices.deliver();
}

void Context::lend() {
    if (state_->host) state_->host->lend(*state_);
}

bool Context::lend_until(const std::function<bool()>& over,
                         std::optional<std::chrono::steady_clock::time_point> until) {
    return state_->host->lend_until(*state_, over, until);
}

void Context::wake() {
    if (state_->host) state_->host->wake();
}

Borrower::Borrower(std::shared_ptr<Context> context, std::function<void()> meanwhile)
    : context_(std::move(context)) {
    if (Host* const host = context_->state().host.get()) {
        host->begin_borrowing(std::move(meanwhile));
    } else {
        context_->state().worker.begin_giving_way();
    }
}

Borrower::~Borrower() {
    if (Host* const host = context_->state().host.get()) {
        host->end_borrowing();
    } else {
        context_->state().worker.end_giving_way();
    }
}

void finish(Context& context) {
    const GladGLContext& gl = functions(context, "finish");
    if (context.info().backend == Backend::host) {
        gl.Flush();
    } else {
        gl.Finish();
    }
    context.state().check("finish");
}

void flush(Context& context) {
    functions(context, "flush").Flush();
}

}  // namespace nicol::gl
