// SPDX-License-Identifier: MIT
// Objects behind the handles.
#pragma once

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "boundary.hpp"
#include "context_log.hpp"
#include "draw/framebuffer.hpp"
#include "files/file_record.hpp"
#include "files/load_budget.hpp"
#include "geometry/mesh.hpp"
#include "gl/context.hpp"
#include "gl/lending_mutex.hpp"
#include "import/scene_animation.hpp"
#include "job.hpp"
#include "light/environment.hpp"
#include "material/material.hpp"
#include "memory_share.hpp"
#include "render/renderer.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "texture/texture.hpp"
#include "worker_pool.hpp"

namespace nicol::capi {

/// The session for which this thread is inside a caller's callback.
inline thread_local const Session* calling_back = nullptr;

class CallbackScope {
public:
    explicit CallbackScope(const Session* session) : outer_(std::exchange(calling_back, session)) {}
    ~CallbackScope() { calling_back = outer_; }
    CallbackScope(const CallbackScope&) = delete;
    CallbackScope& operator=(const CallbackScope&) = delete;

private:
    const Session* outer_;
};

/// State shared by a context's objects, alive as long as any of them.
struct Session {
    std::shared_ptr<gl::Context> gl;
    WorkerOptions workers;
    ContextLog log;
    nicol_error_callback error = nullptr;
    void* error_user = nullptr;
    std::filesystem::path cache;                      ///< folder of tables; empty: none
    std::uint64_t memory_limit = MemoryLimit::kNone;  ///< memory limit per scene, in bytes
    MemoryMonitor memory;                             ///< empty: none
    LoadLimits load_limits;
    std::shared_ptr<struct HostPrograms>
        host_programs;                   ///< only in a host's context, made for its first image
    std::atomic<std::size_t> handles{};  ///< number of the context's handles

    /// Returns make(), whose parallel loops run on the context's threads.
    template <class Make>
    auto on_workers(const Make& make) const {
        std::optional<decltype(make())> made;
        WorkerPool(workers).run([&] { made.emplace(make()); });
        return std::move(*made);
    }

    /// Returns the queue, made on first use.
    JobQueue& job_queue() {
        const std::lock_guard lock(jobs_mutex);
        if (!jobs) jobs = std::make_unique<JobQueue>();
        return *jobs;
    }
    std::mutex jobs_mutex;
    std::unique_ptr<JobQueue> jobs;

    void log_message(std::uint32_t severity, std::string message) const {
        std::ranges::replace_if(message, is_control, ' ');
        const CallbackScope scope(this);
        log.send(severity, message);
    }
    void notice(const std::string& message) const { log_message(NICOL_LOG_NOTICE, message); }

    /// Returns whether OpenGL is a host's, so that callers who wait for a job lend it the context.
    [[nodiscard]] bool in_host() const { return gl->info().backend == gl::Backend::host; }
};

using SessionPtr = std::shared_ptr<Session>;

/// Throws Error(invalid_argument) inside a callback of the session, where waiting for a lock might never end.
inline void refuse_in_callback(const Session& session) {
    if (Call::inside_another(session) || calling_back == &session || session.gl->on_thread()) {
        refuse("a callback called Nicol with an object of the context that is calling it");
    }
}

/// Image settings of a scene file.
struct Film {
    Camera camera;
    std::uint32_t width;
    std::uint32_t height;
    bool luminance;              ///< one channel is requested
    std::uint32_t sample_count;  ///< 0: the file does not say
    ReconstructionFilter filter;
    int max_depth;  ///< see IntegratorDescription
    std::uint32_t aovs;
};

struct SceneState {
    explicit SceneState(const SessionPtr& session)
        : renderer(session->gl, session->workers), rendering(session->gl) {
        // The owner pointer stays valid, because renders happen inside a call that holds the session.
        renderer.set_cache(session->cache,
                           [owner = session.get()](const std::string& message) { owner->notice(message); });
        renderer.set_memory_limit(MemoryLimit(session->memory_limit, session->memory));
    }

    // In the order of alignment, which leaves little room between the members.
    Renderer renderer;  ///< only renders use it
    // The files, the animation and the film come from the scene file. They never change, but for the film's
    // camera, which `edit` protects.
    std::vector<FileRecord> files;
    /// Mutex of readers and writers of the scene. Jobs do not hold it, because they have copies.
    std::mutex edit;
    std::optional<MovingScene> animation;  ///< none: the scene's file has none
    /// Mutex of renders, held through each, before `edit` and the mutex of the framebuffer.
    gl::LendingMutex rendering;
    std::optional<Film> film;
    Scene scene;
    MemoryShare loaded;  ///< memory of what the scene's file describes
    // Only renders use these.
    bool darkness_noticed = false;
    bool error_noticed = false;
};

/// Content of every handle: a session, the object and a reference count.
template <class Content>
struct Handle {
    SessionPtr session;
    std::shared_ptr<Content> content;
    std::uint32_t references = 1;
};

enum class HandleKind : std::uint8_t {
    context,
    environment,
    texture,
    material,
    mesh,
    scene,
    framebuffer,
    job,
    psh_transform
};

/// Registry of all live handles of the process, which makes wrong or released ones errors instead of crashes.
/// A handle is a number unique in the process, not the address of its object, so a later object never has a
/// released handle's number.
namespace registry {
/// An object that stays alive until the lock ends. The lock keeps all threads from adding and releasing
/// handles.
struct Held {
    std::unique_lock<std::mutex> lock;
    void* object;
};
[[nodiscard]] void* add(void* object, HandleKind kind);
/// Returns the object. Throws Error(invalid_handle) unless the handle is alive and of this kind.
[[nodiscard]] Held hold(const void* handle, HandleKind kind);
/// Removes a handle. Requires the lock of hold().
void forget(const void* handle) noexcept;
}  // namespace registry

}  // namespace nicol::capi

// Types with the names in nicol.h.
struct nicol_context_impl : nicol::capi::Handle<const nicol::gl::ContextInfo> {
    static constexpr auto kKind = nicol::capi::HandleKind::context;
};
struct nicol_environment_impl : nicol::capi::Handle<const nicol::Environment> {
    static constexpr auto kKind = nicol::capi::HandleKind::environment;
};
struct nicol_texture_impl : nicol::capi::Handle<const nicol::Texture> {
    static constexpr auto kKind = nicol::capi::HandleKind::texture;
};
struct nicol_material_impl : nicol::capi::Handle<const nicol::Material> {
    static constexpr auto kKind = nicol::capi::HandleKind::material;
};
struct nicol_mesh_impl : nicol::capi::Handle<const nicol::Mesh> {
    static constexpr auto kKind = nicol::capi::HandleKind::mesh;
};
struct nicol_scene_impl : nicol::capi::Handle<nicol::capi::SceneState> {
    static constexpr auto kKind = nicol::capi::HandleKind::scene;
};
struct nicol_framebuffer_impl : nicol::capi::Handle<nicol::Framebuffer> {
    static constexpr auto kKind = nicol::capi::HandleKind::framebuffer;
};
struct nicol_job_impl : nicol::capi::Handle<nicol::capi::Job> {
    static constexpr auto kKind = nicol::capi::HandleKind::job;
};

namespace nicol::capi {

/// Lock for reading and changing a scene. Waits for direct renders, not for jobs.
class Edit {
public:
    explicit Edit(const nicol_scene_impl& scene)
        : lock_((refuse_in_callback(*scene.session), scene.content->edit)) {}

private:
    std::lock_guard<std::mutex> lock_;
};

/// Lock for reading and changing the content of a framebuffer. Waits for other readers and for a render that
/// puts its image into the framebuffer, not for the computation of the image.
class Access {
public:
    explicit Access(const nicol_framebuffer_impl& framebuffer)
        : lock_((refuse_in_callback(*framebuffer.session), framebuffer.content->mutex())) {}

private:
    std::lock_guard<gl::LendingMutex> lock_;
};

/// Returns a copy of the object behind a handle, which stays alive through the call even if other threads
/// release the handle. Throws Error(invalid_handle).
template <class Impl>
Impl resolve(Impl* handle) {
    const auto held = registry::hold(handle, Impl::kKind);
    const Impl& found = *static_cast<const Impl*>(held.object);
    Call::concerns(found.session);
    return found;
}

/// Throws Error(invalid_handle) if two objects belong to different contexts.
template <class A, class B>
void require_same_context(const A& a, const B& b) {
    if (a.session != b.session) {
        throw Error(ErrorCode::invalid_handle, "objects of different contexts cannot be used together");
    }
}

/// Returns a new handle with one reference.
template <class Impl, class Content>
Impl* make_handle(const SessionPtr& session, std::shared_ptr<Content> content) {
    auto handle = std::make_unique<Impl>();
    handle->session = session;
    handle->content = std::move(content);
    auto* const number = static_cast<Impl*>(registry::add(handle.get(), Impl::kKind));
    static_cast<void>(handle.release());
    if (session) ++session->handles;
    return number;
}

/// Gives another object to a handle. Throws Error(invalid_handle).
template <class Impl, class Content>
void replace_content(Impl* handle, std::shared_ptr<Content> content) {
    // The former object is destroyed after the lock, because that may take long.
    const auto held = registry::hold(handle, Impl::kKind);
    static_cast<Impl*>(held.object)->content.swap(content);
}

template <class Impl>
nicol_result retain(Impl* handle, const char* function = __builtin_FUNCTION()) noexcept {
    return guarded(
        [&] {
            const auto held = registry::hold(handle, Impl::kKind);
            ++static_cast<Impl*>(held.object)->references;
        },
        function);
}

template <class Impl>
nicol_result release(Impl* handle) noexcept {
    if (handle == nullptr) return NICOL_OK;
    return guarded([&] {
        std::unique_ptr<Impl> last;  // destroyed after the lock, because that may take long
        const auto held = registry::hold(handle, Impl::kKind);
        auto* const object = static_cast<Impl*>(held.object);
        if (--object->references > 0) return;
        registry::forget(handle);
        last.reset(object);
        if (object->session) --object->session->handles;
    });
}

/// Writes a handle to `to`, or null without an object, unless `to` is null. rest() writes the other outputs;
/// if it throws, nothing is written.
template <class Impl, class Content, class Rest>
void write_handle(const SessionPtr& session, std::shared_ptr<Content> content, Impl** to, const Rest& rest) {
    Impl* const handle =
        to != nullptr && content != nullptr ? make_handle<Impl>(session, std::move(content)) : nullptr;
    try {
        rest();
    } catch (...) {
        release(handle);
        throw;
    }
    if (to != nullptr) *to = handle;
}

/// Returns the caller's options, or the defaults for NULL. Throws Error(invalid_argument) naming a value out
/// of range.
nicol_context_options context_options(const nicol_context_options* options);
/// Returns a handle with one reference.
nicol_context make_context(std::shared_ptr<gl::Context> context, const nicol_context_options& options);

/// Returns whether the value is 1. Throws Error(invalid_argument) "name is 7; it must be 0 or 1" for other
/// values.
inline bool switch_from(std::uint32_t given, const char* name) {
    if (given > 1) refuse(std::string(name) + " is " + std::to_string(given) + "; it must be 0 or 1");
    return given == 1;
}
/// Returns the values of a spectrum, `fallback` if it is empty. Throws Error(invalid_argument).
std::vector<double> spectrum(const nicol_spectrum& values, double fallback, std::size_t fallback_channels,
                             const char* name);
/// A caller's image in its memory, released with the last copy of `user`.
struct ImagePixels {
    EquirectView view;
    std::shared_ptr<void> user;
};
/// Reads an image. Throws Error(invalid_argument); the release callback is called in any case.
ImagePixels read_image(const nicol_image* image);
/// Returns the matrix of 16 row-major numbers. write_matrix() writes these numbers.
glm::dmat4 matrix(const double* rows);
void write_matrix(const glm::dmat4& m, double* rows);
/// Writes ids. Throws Error(invalid_argument) unless `count` is their number; `what` names them.
void write_ids(const std::vector<std::uint32_t>& all, std::uint32_t* ids, std::uint64_t count,
               const char* what);

}  // namespace nicol::capi
