// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context without a window, on a thread of its own, or the context of a host.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "memory_share.hpp"

namespace nicol::gl {

enum class Backend { automatic, egl, osmesa, host };

/// Requested kind of context. `automatic` tries EGL hardware devices, the EGL software device, EGL without a
/// device, then OSMesa; the environment variable NICOL_BACKEND (egl or osmesa) overrides it. Any other choice
/// is tried alone and never replaced by another backend.
struct ContextRequest {
    Backend backend = Backend::automatic;
    /// Position in EGL's own device list, which differs from CUDA's list and that of /dev/dri. Implies EGL.
    std::optional<int> device = std::nullopt;
};

/// Access to the context of a host. None of the functions may throw.
struct HostAccess {
    std::function<void (*(const char* name))()> function;  ///< the host's look-up of OpenGL functions
    std::function<bool()> is_current;  ///< whether it is current on this thread; empty: OpenGL is queried
    bool sets_state =
        false;               ///< whether the host sets its state again after each call, so that none is saved
    bool validates = false;  ///< whether errors are asked after each command, and not once a call
};

struct ContextInfo {
    Backend backend = Backend::automatic;   ///< never automatic
    std::string device;                     ///< opened device, for example "EGL device 0 (/dev/dri/card0)"
    std::string vendor, renderer, version;  ///< GL_VENDOR, GL_RENDERER, GL_VERSION
    /// UUIDs of the device and of the driver as 32 hexadecimal digits, as Vulkan has them; empty if OpenGL
    /// does not tell (GL_EXT_memory_object).
    std::string device_uuid{}, driver_uuid{};
    bool software = false;  ///< whether the processor rasterises; if so, prefer threads to compute shaders
};

/// A failed attempt to make a context, and the reason.
struct FailedAttempt {
    std::string what;
    std::string reason;
};

/// The driver's limits. Anything larger throws Error(invalid_argument).
struct Limits {
    int texture_size = 0;        ///< texels per side
    int target_size = 0;         ///< pixels per side of a RenderTarget
    int colour_attachments = 0;  ///< colour attachments of one RenderTarget
    int texture_units = 0;       ///< texture units of one program
    int storage_bindings = 0;    ///< shader storage buffers of one compute program
    int vertex_attributes = 0;
    std::size_t vertex_stride = 0;      ///< bytes from vertex to vertex
    std::size_t storage_bytes = 0;      ///< bytes of one shader storage binding
    std::size_t storage_alignment = 1;  ///< alignment of the offset of a storage binding, bytes
    std::array<unsigned, 3> groups{};   ///< work groups of one dispatch, by axis
};

enum class MemoryKind { vertex, index, storage, texture, render_target };

/// Bytes of the objects in a context, as requested (a driver may pad them).
struct MemoryUse {
    std::array<std::size_t, 5> bytes{};  ///< by MemoryKind
    [[nodiscard]] std::size_t of(MemoryKind kind) const { return bytes[static_cast<std::size_t>(kind)]; }
};

/// An OpenGL context. Objects of this folder are made and used inside run() and keep their context alive;
/// their destructors, and the context's, may run on any thread and in any order. Two contexts share nothing,
/// and contexts of different backends may exist in one process. A function running in one context must not
/// wait for a second context whose own function waits for the first.
class Context : public std::enable_shared_from_this<Context> {
public:
    /// Makes a context. Throws Error(no_backend) with the reason of every failed attempt, or
    /// Error(invalid_argument) for an unknown NICOL_BACKEND, a device that does not exist, or a device
    /// together with OSMesa.
    [[nodiscard]] static std::shared_ptr<Context> create(const ContextRequest& request = {});
    /// Uses the context of the caller, which must be current on this thread and of OpenGL 4.5 or newer, core
    /// or compatibility. run() makes its calls on the calling thread, saves and restores the host's state
    /// (host_state.hpp), and throws Error(not_current) if the context is not current. Objects that are
    /// dropped while the context is not current are deleted at the next run(), or with the host's context.
    /// Throws Error(not_current), Error(no_backend).
    [[nodiscard]] static std::shared_ptr<Context> create_in_host(HostAccess access);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] const ContextInfo& info() const noexcept;
    [[nodiscard]] const Limits& limits() const noexcept;
    /// Returns the attempts that failed before this context was made, in order.
    [[nodiscard]] const std::vector<FailedAttempt>& failed_attempts() const noexcept;
    [[nodiscard]] MemoryUse memory() const noexcept;
    /// Tells a monitor of the memory of all objects. Must be called before the first of them is made.
    void set_memory_monitor(MemoryMonitor monitor);

    /// Calls f() on the context's thread, waits, and returns its value or rethrows its exception. On the
    /// context's own thread it is a plain call. Calls from several threads run one after another.
    template <class F>
    auto run(F&& f) -> std::invoke_result_t<F&>;

    /// Calls f(), with the host's state saved at the first run() inside and restored at the end, instead of
    /// around each run(). Throws Error(not_current), and Error(opengl) for commands that failed. Plain call
    /// for a context of our own.
    void visit(const std::function<void()>& f);

    /// Returns whether the caller is inside run(), or on the context's own thread.
    [[nodiscard]] bool on_thread() const noexcept;

    /// Throws what run() would throw if a host's context is not current; never throws for a context of our
    /// own.
    void require_current() const;

    /// Runs the call that a Borrower of the host's context waits for, if there is one and the context is
    /// current on the calling thread. Never waits.
    void lend();
    /// Waits until over() or `until`, and lends a host's context meanwhile. Calls over() at first and after
    /// each wake(); over() must not use the context. Returns the last answer of over(). Throws
    /// Error(not_current) if there is a Borrower and the context is not current. Only for a host's context,
    /// outside run().
    [[nodiscard]] bool lend_until(const std::function<bool()>& over,
                                  std::optional<std::chrono::steady_clock::time_point> until = std::nullopt);
    /// Makes every lend_until() call over() again.
    void wake();

    struct State;  ///< the thread, the platform's context and the function pointers (state.hpp)
    [[nodiscard]] State& state() noexcept { return *state_; }

private:
    explicit Context(std::shared_ptr<State> state);
    void execute(void (*call)(void*), void* argument);

    std::shared_ptr<State> state_;
};

/// Makes the calling thread's run() give way to that of other threads while it lives. In a host's context it
/// is the permission to call run() where that context is not current: such a call waits for a thread that
/// lends the context. In a context of our own, calls of other threads go first. At most one Borrower may
/// exist per context.
class Borrower {
public:
    /// Calls `meanwhile` about ten times a second while a call waits; an exception of `meanwhile` withdraws
    /// the call. `meanwhile` must not use the context.
    Borrower(std::shared_ptr<Context> context, std::function<void()> meanwhile);
    ~Borrower();
    Borrower(const Borrower&) = delete;
    Borrower& operator=(const Borrower&) = delete;

private:
    std::shared_ptr<Context> context_;
};

template <class F>
auto Context::run(F&& f) -> std::invoke_result_t<F&> {
    using Result = std::invoke_result_t<F&>;
    static_assert(!std::is_reference_v<Result>, "return a value: a reference would cross threads");
    if constexpr (std::is_void_v<Result>) {
        auto job = [&f] { f(); };
        execute([](void* p) { (*static_cast<decltype(job)*>(p))(); }, &job);
    } else {
        std::optional<Result> result;
        auto job = [&f, &result] { result.emplace(f()); };
        execute([](void* p) { (*static_cast<decltype(job)*>(p))(); }, &job);
        return std::move(*result);
    }
}

/// Waits until all earlier commands of the context are done, so that times measured around them are theirs.
/// In a host's context it only submits the commands, because the host's own commands would wait too. Inside
/// run().
void finish(Context& context);
/// Submits all earlier commands, so that the device works while the caller does something else. Inside run().
void flush(Context& context);

}  // namespace nicol::gl
