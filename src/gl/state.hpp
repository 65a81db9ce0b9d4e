// SPDX-License-Identifier: MIT
// State of a context; this is the only header that includes OpenGL.
#pragma once

#include <glad/gl.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "gl/context.hpp"
#include "gl/host.hpp"
#include "gl/object.hpp"
#include "gl/platform.hpp"
#include "gl/program_notices.hpp"
#include "gl/worker.hpp"
#include "memory_share.hpp"

namespace nicol::gl {

class HostState;

/// State shared by the Context and its thread, so that either may end first. Only the thread uses it, apart
/// from the worker, the memory account and members that are constant after open().
struct Context::State {
    /// A part of a storage buffer.
    struct StorageRange {
        GLuint buffer = 0;
        std::size_t offset = 0, bytes = 0;
        bool operator==(const StorageRange&) const = default;
    };
    /// A place for a resource: the one that it shall have, and the one that OpenGL has there; Resource() for
    /// none, and where a host may have bound another.
    template <class Resource>
    struct Binding {
        Resource wanted{};
        Resource bound{};
    };

    Worker worker;  ///< worker of a context of our own
    std::thread thread;
    std::unique_ptr<Host> host;  ///< set for a host's context, instead of worker and thread
    std::unique_ptr<Platform> platform;
    GladGLContext gl{};
    ContextInfo info;
    Limits limits;
    std::vector<FailedAttempt> failed_attempts;
    std::array<std::atomic<std::size_t>, 5> bytes{};
    MemoryMonitor memory_monitor;       ///< set before the first object is made
    bool compatibility = false;         ///< whether a host's context has the compatibility profile
    GLuint empty_vertex_array = 0;      ///< core profiles cannot draw without a vertex array
    GLuint condition = 0;               ///< a query that tests for conditional rendering in a host's context
    GLint clip_distances = 0;           ///< number of a host's clip distances
    HostState* host_state = nullptr;    ///< a host's state during a visit; null in a context of our own
    bool validates = true;              ///< whether check_command() asks at once
    bool unchecked = false;             ///< whether commands were given since the last check()
    std::vector<std::string> messages;  ///< messages of KHR_debug since the last check()
    std::vector<Binding<StorageRange>> storages;
    std::vector<Binding<GLuint>> textures;  ///< by unit
    GLuint used_program = 0;                ///< set by us; 0 where a host may have set another
    int independent_dispatches = 0;         ///< number of IndependentDispatches that live
    std::filesystem::path programs;         ///< folder of linked programs; empty: no cache
    ProgramNotices program_notices;

    /// Makes the platform current and initialises OpenGL. Throws Error(no_backend).
    void open(std::unique_ptr<Platform> made, Backend backend, const std::string& device);
    /// Initialises OpenGL in the host's context, which must be current and stays unchanged.
    void open_in_host(HostAccess access);
    void close() noexcept;
    /// Throws Error(out_of_memory) or Error(opengl) naming `what`, with the driver's messages, if anything
    /// since the last check failed.
    void check(std::string_view what);
    /// Checks a command that makes no object: at once if `validates`, else with the next check(), at the
    /// latest at the end of the visit.
    void check_command(std::string_view what);
    [[nodiscard]] GLint integer(GLenum name) const;
    /// Deletes an object, which is bound nowhere from then on: a driver may give its name to a new one.
    void remove(ObjectKind kind, GLuint id) noexcept;
    /// Binds what Buffer::bind_storage() and Texture2D::bind() asked for since the last dispatch or draw,
    /// neighbours by one command.
    void bind_resources();
    /// Sets what a place shall have.
    template <class Resource>
    static void want(std::vector<Binding<Resource>>& bindings, std::size_t place, const Resource& resource) {
        if (bindings.size() <= place) bindings.resize(place + 1);
        bindings[place].wanted = resource;
    }
    /// Forgets what is bound, since a host may have bound others.
    void forget_bindings();

private:
    void load(Backend backend, const std::string& device);
    void read_limits();
};

/// Returns the name of an error, such as "GL_INVALID_ENUM".
[[nodiscard]] std::string error_name(GLenum error);

/// Returns the function pointers to a caller inside run(); throws Error(internal) naming `what` elsewhere.
[[nodiscard]] const GladGLContext& functions(Context& context, std::string_view what);

}  // namespace nicol::gl
