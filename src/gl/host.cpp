// SPDX-License-Identifier: MIT
// Calls in a host's context. Pending errors are taken and put back; unsuitable states throw.
#include "gl/host.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

constexpr int kMostErrors = 8;  // a lost context reports errors without end

constexpr std::array<GLenum, 5> kProvokable{GL_INVALID_ENUM, GL_INVALID_VALUE, GL_INVALID_OPERATION,
                                            GL_INVALID_FRAMEBUFFER_OPERATION, GL_OUT_OF_MEMORY};

void provoke(const GladGLContext& gl, GLenum error) {
    GLuint name = 0;
    switch (error) {
        case GL_INVALID_ENUM:
            gl.Enable(GL_NONE);
            break;
        case GL_INVALID_VALUE:
            gl.LineWidth(0);
            break;
        case GL_INVALID_OPERATION:
            gl.BindVertexArray(std::numeric_limits<GLuint>::max());  // no driver has given this name
            break;
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            gl.CreateFramebuffers(1, &name);
            gl.BlitNamedFramebuffer(name, name, 0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
            gl.DeleteFramebuffers(1, &name);
            break;
        default:  // GL_OUT_OF_MEMORY
            gl.CreateBuffers(1, &name);
            gl.NamedBufferStorage(name, PTRDIFF_MAX, nullptr, 0);
            gl.DeleteBuffers(1, &name);
            break;
    }
}

/// Takes the host's pending errors on construction, so that errors found later are this library's, and makes
/// them pending again on destruction: the host's next glGetError returns what it would have returned without
/// the call.
class HostErrors {
public:
    /// Throws Error(opengl) for an error that cannot be made pending again: GL_STACK_OVERFLOW,
    /// GL_STACK_UNDERFLOW or GL_CONTEXT_LOST.
    explicit HostErrors(const GladGLContext& gl) : gl_(gl) {
        for (int i = 0; i < kMostErrors; ++i) {
            const GLenum error = gl_.GetError();
            if (error == GL_NO_ERROR) return;
            if (std::ranges::find(kProvokable, error) == kProvokable.end()) {
                put_back();
                throw Error(
                    ErrorCode::opengl,
                    "the host left " + error_name(error) +
                        " pending in its OpenGL context, which Nicol took and cannot make pending again");
            }
            pending_.push_back(error);
        }
    }

    ~HostErrors() {
        for (int i = 0; i < kMostErrors && gl_.GetError() != GL_NO_ERROR; ++i) {
            // The call has reported its own errors.
        }
        put_back();
    }
    HostErrors(const HostErrors&) = delete;
    HostErrors& operator=(const HostErrors&) = delete;

private:
    void put_back() const {
        if (pending_.empty()) return;
        const GLboolean debug = gl_.IsEnabled(GL_DEBUG_OUTPUT);
        gl_.Disable(GL_DEBUG_OUTPUT);  // the driver has already told the host
        for (const GLenum error : pending_) provoke(gl_, error);
        if (debug == GL_TRUE) gl_.Enable(GL_DEBUG_OUTPUT);
    }

    const GladGLContext& gl_;
    std::vector<GLenum> pending_;
};

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
    if (on_thread()) return true;
    if (access_.is_current && !access_.is_current()) return false;
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
