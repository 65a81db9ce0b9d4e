// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context without a window, on a thread of its own.
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

namespace nicol::gl {

enum class Backend { automatic, egl, osmesa, host };

/// Which context to make. `automatic` tries EGL hardware devices, the EGL software device, EGL without a
/// device, then OSMesa, and can be overridden by the environment variable NICOL_BACKEND (egl or osmesa).
/// Any other choice is tried alone and never replaced by another backend.
struct ContextRequest {
    Backend backend = Backend::automatic;
    /// Position in EGL's own device list, which is neither CUDA's nor that of /dev/dri. Implies EGL.
    std::optional<int> device = std::nullopt;
};

/// Access to the context of a host. None of the functions may throw.
struct HostAccess {
    std::function<void (*(const char* name))()> function;  ///< the host's look-up of OpenGL functions
    std::function<bool()> is_current;  ///< on the calling thread; empty: OpenGL is queried
};

struct ContextInfo {
    Backend backend = Backend::automatic;   ///< never automatic
    std::string device;                     ///< what was opened, for example "EGL device 0 (/dev/dri/card0)"
    std::string vendor, renderer, version;  ///< GL_VENDOR, GL_RENDERER, GL_VERSION
    bool software = false;                  ///< the processor rasterises: prefer threads to compute shaders
};

/// An attempt to make a context, and why it failed.
struct FailedAttempt {
    std::string what;
    std::string reason;
};

/// The driver's limits; anything larger is refused with Error(invalid_argument).
struct Limits {
    int texture_size = 0;        ///< texels a side
    int target_size = 0;         ///< pixels a side of a RenderTarget
    int colour_attachments = 0;  ///< of one RenderTarget
    int texture_units = 0;       ///< of one program
    int storage_bindings = 0;    ///< shader storage buffers of one compute program
    int vertex_attributes = 0;
    std::size_t vertex_stride = 0;      ///< bytes from vertex to vertex
    std::size_t storage_bytes = 0;      ///< of one shader storage binding
    std::size_t storage_alignment = 1;  ///< of the offset of a storage binding, bytes
    std::array<unsigned, 3> groups{};   ///< work groups of one dispatch, by axis
};

enum class MemoryKind { vertex, index, storage, texture, render_target };

/// Bytes of the objects in a context, as requested (a driver may pad).
struct MemoryUse {
    std::array<std::size_t, 5> bytes{};  ///< by MemoryKind
    [[nodiscard]] std::size_t of(MemoryKind kind) const { return bytes[static_cast<std::size_t>(kind)]; }
};

/// Objects of this folder are made and used inside run() and keep their context alive; their destructors, and
/// the context's, may run on any thread and in any order. Two contexts share nothing, and one of each backend
/// may exist in the same process. A function running in one context must not wait for a second context whose
/// own function waits for the first.
class Context : public std::enable_shared_from_this<Context> {
public:
    /// Throws Error(no_backend) with the reason of every failed attempt, or Error(invalid_argument) for an
    /// unknown NICOL_BACKEND, a device that does not exist, or a device together with OSMesa.
    [[nodiscard]] static std::shared_ptr<Context> create(const ContextRequest& request = {});
    /// Uses the context of the caller, which is current on this thread and of OpenGL 4.5 or newer, core or
    /// compatibility. run() calls on the calling thread, finds the host's state (host_state.hpp) as it left
    /// it, and throws Error(not_current) where the context is not current. Objects that are dropped while it
    /// is not current are deleted at the next run(), or with the host's context. Throws Error(not_current),
    /// Error(no_backend).
    [[nodiscard]] static std::shared_ptr<Context> create_in_host(HostAccess access);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] const ContextInfo& info() const noexcept;
    [[nodiscard]] const Limits& limits() const noexcept;
    /// The attempts that failed before this context was made, in order.
    [[nodiscard]] const std::vector<FailedAttempt>& failed_attempts() const noexcept;
    [[nodiscard]] MemoryUse memory() const noexcept;

    /// Calls f() on the context's thread, waits, and returns its value or rethrows its exception. From the
    /// context's own thread it is a plain call. Calls from several threads run one after another.
    template <class F>
    auto run(F&& f) -> std::invoke_result_t<F&>;

    /// Whether the caller is inside run(), or on the context's own thread.
    [[nodiscard]] bool on_thread() const noexcept;

    /// Throws what run() would where a host's context is not current; never for a context of our own.
    void require_current() const;

    /// Does what a Borrower of the host's context waits for, if there is something and the context is current
    /// on the calling thread. Never waits.
    void lend();
    /// Waits until over() or `until`, and lends a host's context meanwhile. over() is asked at first and
    /// after each wake(); it must not use the context. Returns its last answer. Throws Error(not_current)
    /// where there is a Borrower and the context is not current. For a host's context alone, outside run().
    [[nodiscard]] bool lend_until(const std::function<bool()>& over,
                                  std::optional<std::chrono::steady_clock::time_point> until = std::nullopt);
    /// Lets every lend_until() ask again.
    void wake();

    struct State;  ///< the thread, the platform's context and the function pointers (state.hpp)
    [[nodiscard]] State& state() noexcept { return *state_; }

private:
    explicit Context(std::shared_ptr<State> state);
    void execute(void (*call)(void*), void* argument);

    std::shared_ptr<State> state_;
};

/// While it lives, run() on the thread that made it works without the host's context, where a context is a
/// host's: the call waits for a thread that lends it. At most one of a context at a time.
class Borrower {
public:
    /// `meanwhile` is called about ten times a second while a call waits, and takes it back by an exception.
    /// It must not use the context.
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
/// In a host's context, where the host's own wait as well, they are only sent on their way. Inside run().
void finish(Context& context);
/// Sends all earlier commands on their way, so that the device works while the caller does something else.
/// Inside run().
void flush(Context& context);

}  // namespace nicol::gl
