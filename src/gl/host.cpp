// SPDX-License-Identifier: MIT
// Calls in a host's context. Unsuitable states throw.
#include "gl/host.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "gl/host_errors.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

// State queries of compatibility contexts. The core-profile loader does not define their names.
constexpr GLenum kListIndex = 0x0B33, kRenderMode = 0x0C40;
constexpr GLint kRender = 0x1C00;

[[noreturn]] void refuse_state(const char* text) {
    throw Error(ErrorCode::unsupported, text);
}

void require_lasting_program(const Context::State& state) {
    const auto program = static_cast<GLuint>(state.integer(GL_CURRENT_PROGRAM));
    if (program == 0) return;
    GLint deleted = GL_FALSE, linked = GL_TRUE;
    state.gl.GetProgramiv(program, GL_DELETE_STATUS, &deleted);
    state.gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (deleted == GL_TRUE)
        refuse_state(
            "the host's current program is deleted and would be gone once another one is used; use another "
            "or none around calls of Nicol");
    if (linked != GL_TRUE)
        refuse_state(
            "the host's current program failed to link again and what it was would be gone once another one "
            "is used; use another or none around calls of Nicol");
}

/// Throws Error(unsupported), which names the state, if nothing can be drawn or the state cannot be restored.
void require_drawable(const Context::State& state) {
    GLboolean active = GL_FALSE, paused = GL_FALSE;
    state.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    state.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
    if (active == GL_TRUE && paused == GL_FALSE)
        refuse_state("the host's transform feedback is active; end or pause it around calls of Nicol");
    if (state.compatibility && state.integer(kListIndex) != 0)
        refuse_state("the host compiles a display list; end it around calls of Nicol");
    if (state.compatibility && state.integer(kRenderMode) != kRender)
        refuse_state("the host's render mode is not GL_RENDER; return to it around calls of Nicol");
    require_lasting_program(state);
}

/// Throws Error(unsupported) if the host renders conditionally. Requires that no error is pending.
void require_unconditional(const Context::State& state) {
    // Conditional rendering cannot be queried, but beginning it twice is an error.
    state.gl.BeginConditionalRender(state.condition, GL_QUERY_NO_WAIT);
    if (state.gl.GetError() != GL_NO_ERROR)
        refuse_state("the host renders conditionally; end that around calls of Nicol");
    state.gl.EndConditionalRender();
}

}  // namespace

void Host::mark(const Context::State& state) {
    static std::atomic<unsigned long> contexts = 0;
    mark_ = "nicol " + std::to_string(++contexts);
    state.gl.ObjectLabel(GL_VERTEX_ARRAY, state.empty_vertex_array, static_cast<GLsizei>(mark_.size()),
                         mark_.data());
}

bool Host::is_current(const Context::State& state) const noexcept {
    if (on_thread() || visiting()) return true;
    if (access_.is_current && !access_.is_current()) return false;
    if (access_.is_current && access_.sets_state)
        return true;  // a host that wants no queries is taken at its word
    // The query fails without a context. Another context has other vertex arrays, because vertex arrays are
    // never shared. Functions that an older context lacks are called only after the version is checked.
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

// One saving and restoring of the host's errors and state, on the calling thread.
class Host::Visit {
public:
    Visit(Host& host, Context::State& state) : host_(host), state_(state) {
        host_.visit_ = this;
        host_.visitor_ = std::this_thread::get_id();
    }
    ~Visit() {
        saved_.reset();
        errors_.reset();
        state_.host_state = nullptr;
        host_.visitor_ = std::thread::id();
        host_.visit_ = nullptr;
    }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

    void begin() {
        if (saved_) return;
        const bool restores = !host_.access_.sets_state;
        if (restores) require_drawable(state_);
        errors_.emplace(state_.gl);
        if (restores) require_unconditional(state_);
        host_.remove_waiting(state_);
        state_.forget_bindings();
        state_.host_state = &saved_.emplace(state_, restores);
    }

private:
    Host& host_;
    Context::State& state_;
    std::optional<HostErrors> errors_;
    std::optional<HostState> saved_;
};

void Host::visit(Context::State& state, const std::function<void()>& call) {
    if (on_thread() || visiting() || borrows()) return call();
    require_current(state);
    Visit visit(*this, state);
    call();
    if (state.unchecked) state.check("the call's OpenGL commands (NICOL_HOST_VALIDATE says which)");
}

void Host::execute(Context::State& state, void (*call)(void*), void* argument) {
    if (on_thread()) {
        call(argument);
        return;
    }
    if (borrows()) {
        borrow(call, argument);
        return;
    }
    if (!visiting()) {
        visit(state, [&] { execute(state, call, argument); });
        return;
    }
    visit_->begin();
    struct Inside {
        explicit Inside(std::atomic<std::thread::id>& place) : thread(place) {
            thread = std::this_thread::get_id();
        }
        ~Inside() { thread = std::thread::id(); }
        Inside(const Inside&) = delete;
        Inside& operator=(const Inside&) = delete;
        std::atomic<std::thread::id>& thread;
    } const inside(inside_);
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
    lock.unlock();  // is_current() may call the host, so the lock is released
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
        // There is no memory for the name, so the object stays until the host's context is destroyed.
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
