// SPDX-License-Identifier: MIT
// Common parts of all C calls: no exception leaves a call, and every failure has a message.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "error.hpp"
#include "floating_environment.hpp"
#include "nicol.h"

namespace nicol::capi {

/// Returns whether a character is replaced in messages, which are one line that a terminal shows unchanged,
/// even if it quotes a path, a file or a driver.
[[nodiscard]] inline bool is_control(char c) noexcept {
    return static_cast<unsigned char>(c) < ' ' || c == 0x7f;
}

/// Stores the message for nicol_last_error() and returns the code. Allocates nothing.
nicol_result fail(ErrorCode code, const char* message) noexcept;

/// Returns the code of an exception other than Error: out_of_memory if the system lacks resources for a
/// thread or a lock, else internal.
ErrorCode code_of(const std::exception& error) noexcept;

/// Throws Error(unsupported) in the child of a process that forked after its first call, because the child
/// lacks the threads and the graphics driver's state.
void refuse_after_fork();

struct Session;

/// A call in progress on the calling thread, which reports its failure to the error callback of its context.
class Call {
public:
    explicit Call(const char* function) noexcept
        : function_(function), outer_(std::exchange(current_, this)) {}
    ~Call() { current_ = outer_; }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// Tells the thread's call that it was given an object of the session. The first session counts.
    static void concerns(const std::shared_ptr<Session>& session) noexcept {
        if (current_ != nullptr && !current_->session_) current_->session_ = session;
    }
    /// Returns whether the thread's call was made by a callback of another call that was given an object of
    /// the session.
    [[nodiscard]] static bool inside_another(const Session& session) noexcept {
        for (const Call* call = current_ != nullptr ? current_->outer_ : nullptr; call != nullptr;
             call = call->outer_)
            if (call->session_.get() == &session) return true;
        return false;
    }
    /// Calls capi::fail() and the error callback, unless the call was made by an error callback.
    nicol_result fail(ErrorCode code, const char* message) noexcept;

private:
    static inline thread_local Call* current_ = nullptr;

    const char* function_;
    Call* outer_;
    bool reports_ = false;  ///< whether the error callback runs
    std::shared_ptr<Session> session_;
};

/// Runs the body of a C function in a floating-point environment that does not depend on the caller's.
/// `function` is the name of the C function.
template <class F>
nicol_result guarded(F&& body, const char* function = __builtin_FUNCTION()) noexcept {
    const FloatingEnvironment environment;
    Call call(function);
    try {
        refuse_after_fork();
        body();
        return NICOL_OK;
    } catch (const Error& error) {
        return call.fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return call.fail(ErrorCode::out_of_memory, "out of memory");
    } catch (const std::exception& error) {
        return call.fail(code_of(error), error.what());
    } catch (...) {
        return call.fail(ErrorCode::internal, "an unknown exception");
    }
}

using nicol::require;
/// Throws Error(invalid_argument) naming the argument if it is NULL.
template <class T>
void require(T* pointer, const char* name) {
    if (pointer == nullptr) refuse(std::string(name) + " is NULL");
}

/// Largest size of a descriptor. Larger ones indicate uninitialised memory.
inline constexpr std::uint32_t kMaxStructSize = 65536;

/// Returns whether a version's T can have this size: a multiple of T's alignment, so that no number of the
/// struct is cut, from the size of struct_size on.
template <class T>
constexpr bool may_be_size(std::uint32_t size) {
    return size >= sizeof size && size % alignof(T) == 0 && size <= kMaxStructSize;
}

/// Returns a caller's descriptor in the layout of this version: fields that an older caller lacks are taken
/// from `defaults`, the values of NICOL_..._INIT; fields that only a newer caller has must be zero.
template <class T>
T read_struct(const T* from, T defaults, const char* name) {
    require(from, name);
    std::uint32_t size = 0;
    std::memcpy(&size, from, sizeof size);
    if (!may_be_size<T>(size)) {
        refuse(std::string(name) + "->struct_size is " + std::to_string(size) +
               "; it must be sizeof(the struct), " + std::to_string(sizeof(T)) + " in this version");
    }
    const auto* bytes = reinterpret_cast<const unsigned char*>(from);
    if (std::any_of(bytes + std::min<std::size_t>(size, sizeof(T)), bytes + size,
                    [](unsigned char b) { return b != 0; })) {
        refuse(std::string(name) + " has fields set that version " + nicol_version_string() +
               " does not know");
    }
    std::memcpy(&defaults, from, std::min<std::size_t>(size, sizeof(T)));
    return defaults;
}

/// Throws Error(invalid_argument) unless there may be so many channels.
inline void require_channels(std::uint32_t channels, const std::string& name = "channels") {
    if (channels < 1 || channels > NICOL_MAX_CHANNELS)
        refuse(name + " is " + std::to_string(channels) + "; it must lie in 1 to " +
               std::to_string(NICOL_MAX_CHANNELS));
}

/// Returns the path. Throws Error(invalid_argument) for NULL and an empty one.
inline std::filesystem::path read_path(const char* path, const char* name) {
    require(path, name);
    if (*path == '\0') refuse(std::string(name) + " is empty");
    return path;
}

/// Returns options in the layout of this version, the defaults for NULL.
template <class T>
T read_options(const T* from, const T& defaults) {
    return from != nullptr ? read_struct(from, defaults, "options") : defaults;
}

/// Returns a caller's progress callback in the library's form; empty for NULL.
inline std::function<bool(const char*, double)> progress_from(nicol_progress_callback callback, void* user) {
    if (callback == nullptr) return {};
    return
        [callback, user](const char* verb, double fraction) { return callback(user, verb, fraction) != 0; };
}

/// Fills the part of a caller's struct that its struct_size covers; struct_size becomes the number of bytes
/// of that part.
template <class T>
void write_struct(T* to, T value, const char* name) {
    require(to, name);
    std::uint32_t size = 0;
    std::memcpy(&size, to, sizeof size);
    if (!may_be_size<T>(size))
        refuse(std::string(name) + "->struct_size is not set; it must be sizeof(the struct), " +
               std::to_string(sizeof(T)) + " in this version");
    value.struct_size = static_cast<std::uint32_t>(std::min<std::size_t>(size, sizeof(T)));
    std::memcpy(to, &value, value.struct_size);
}

}  // namespace nicol::capi
