// SPDX-License-Identifier: MIT
// Calls in a host's context.
#include "gl/host.hpp"

#include <array>
#include <utility>

#include "error.hpp"
#include "gl/host_errors.hpp"
#include "gl/host_refusal.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
void Host::mark(const Context::State& state) {
    static std::atomic<unsigned long> contexts = 0;
    mark_ = "nicol " + std::to_string(++contexts);
    state.gl.ObjectLabel(GL_VERTEX_ARRAY, state.empty_vertex_array, static_cast<GLsizei>(mark_.size()),
                         mark_.data());
}

bool Host::is_current(const Context::State& state) const noexcept {
    if (on_thread()) return true;
    if (access_.is_current && !access_.is_current()) return false;
    // Without a context the query fails; another context has other vertex arrays, since these are never
    // shared. Functions that an older context lacks are called only once its version is known.
    const GLubyte* version = state.gl.GetString(GL_VERSION);
    if (version == nullptr || state.info.version != reinterpret_cast<const char*>(version)) return false;
    if (state.gl.IsVertexArray(state.empty_vertex_array) != GL_TRUE) return false;
    std::array<GLchar, 32> label{};
    state.gl.GetObjectLabel(GL_VERTEX_ARRAY, state.empty_vertex_array, static_cast<GLsizei>(label.size()),
                            nullptr, label.data());
    return mark_ == label.data();
}

void Host::require_current(const Context::State& state) const {
    if (!is_current(state))
        throw Error(ErrorCode::not_current,
                    "the host's OpenGL context that Nicol was given is not current on the calling thread");
}

void Host::execute(Context::State& state, void (*call)(void*), void* argument) {
    if (on_thread()) {
        call(argument);
        return;
    }
    if (borrower_.load() == std::this_thread::get_id()) {
        borrow(call, argument);
        return;
    }
    require_current(state);
    struct Inside {
        explicit Inside(std::atomic<std::thread::id>& place) : thread(place) {
            thread = std::this_thread::get_id();
        }
        ~Inside() { thread = std::thread::id(); }
        Inside(const Inside&) = delete;
        Inside& operator=(const Inside&) = delete;
        std::atomic<std::thread::id>& thread;
    } const inside(inside_);
    require_drawable(state);
    const HostErrors host_errors(state.gl);
    require_unconditional(state);
    remove_waiting(state);
    const HostState host_state(state);
    state.check("saving and setting the state of the host's OpenGL context");
    call(argument);
}

void Host::begin_borrowing(std::function<void()> meanwhile) {
    const std::lock_guard lock(lending_);
    meanwhile_ = std::move(meanwhile);
    borrower_ = std::this_thread::get_id();
    changed_.notify_all();
}

void Host::end_borrowing() noexcept {
    const std::lock_guard lock(lending_);
    borrower_ = std::thread::id();
    meanwhile_ = nullptr;
    changed_.notify_all();
}

void Host::borrow(void (*call)(void*), void* argument) {
    Call mine{.call = call, .argument = argument, .error = {}};
    std::unique_lock lock(lending_);
    asked_ = &mine;
    changed_.notify_all();
    const auto done = [&mine] { return mine.done; };
    while (!changed_.wait_for(lock, std::chrono::milliseconds(100), done)) {
        if (mine.taken) continue;
        try {
            meanwhile_();
        } catch (...) {
            asked_ = nullptr;
            throw;
        }
    }
    if (mine.error) std::rethrow_exception(std::move(mine.error));
}

void Host::run_asked(Context::State& state, std::unique_lock<std::mutex>& lock) {
    Call& asked = *std::exchange(asked_, nullptr);
    asked.taken = true;
    lock.unlock();
    std::exception_ptr error;
    try {
        execute(state, asked.call, asked.argument);
    } catch (...) {
        error = std::current_exception();
    }
    lock.lock();
    asked.error = std::move(error);
    asked.done = true;
    changed_.notify_all();
}

void Host::lend(Context::State& state) {
    std::unique_lock lock(lending_);
    if (asked_ == nullptr) return;
    lock.unlock();  // the host is asked
    if (!is_current(state)) return;
    lock.lock();
    if (asked_ != nullptr) run_asked(state, lock);
}

bool Host::lend_until(Context::State& state, const std::function<bool()>& over,
                      std::optional<std::chrono::steady_clock::time_point> until) {
    const bool current = is_current(state);
    std::unique_lock lock(lending_);
    while (!over()) {
        if (!current && borrower_.load() != std::thread::id()) {
            throw Error(
                ErrorCode::not_current,
                "a job waits for the host's OpenGL context, which is not current on the calling thread");
        }
        if (asked_ != nullptr) {
            run_asked(state, lock);
        } else if (!until) {
            changed_.wait(lock);
        } else if (changed_.wait_until(lock, *until) == std::cv_status::timeout) {
            return over();
        }
    }
    return true;
}

void Host::wake() noexcept {
    const std::lock_guard lock(lending_);
    changed_.notify_all();
}

void Host::remove(const Context::State& state, ObjectKind kind, unsigned id) noexcept {
    if (is_current(state)) {
        delete_object(state.gl, kind, id);
        return;
    }
    try {
        const std::lock_guard lock(mutex_);
        waiting_.push_back({kind, id});
    } catch (...) {
        // No memory for the name: the object stays until the host's context is destroyed.
    }
}

void Host::remove_waiting(const Context::State& state) noexcept {
    std::vector<Name> names;
    {
        const std::lock_guard lock(mutex_);
        names.swap(waiting_);
    }
    for (const Name& name : names) delete_object(state.gl, name.kind, name.id);
}

}  // namespace nicol::gl
