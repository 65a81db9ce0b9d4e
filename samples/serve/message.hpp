// SPDX-License-Identifier: MIT
// What the front process and its workers say to each other. Both are the same program on the same machine, so
// that plain structs travel as they are: each message is a Head and the bytes it announces.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "image_request.hpp"

enum class MessageKind : std::uint32_t {
    hello,   ///< worker: has a context; the scenes that it can load follow
    failed,  ///< worker: cannot start; the reason follows
    load,    ///< front: load the scene of this index; nothing follows
    loaded,  ///< worker: the scene, or why it cannot be loaded, follows
    job,     ///< front: a Job
    cancel,  ///< front: the job's clients left; nothing follows
    result   ///< worker: a ResultHead and the answer's content, or what went wrong
};

struct Head {
    MessageKind kind{};
    std::uint32_t length = 0;  ///< of what follows, bytes
    std::uint64_t job = 0;     ///< which it is about; of load and loaded the scene's index
};

/// No message is longer; the largest Stokes image stays far below.
constexpr std::uint32_t kMaxMessageBytes = 0x7fffffff;

/// The verbs whose times are reported, in this order.
constexpr std::array<const char*, 6> kVerbs = {"project", "bake", "relight", "shade", "draw", "encode"};

struct ResultHead {
    std::int32_t status = 500;     ///< 200, or of the problem; 499: cancelled
    std::uint32_t unchanged = 0;   ///< 1: the worker had rendered this very view before
    std::array<double, 6> ms{};    ///< by verb; 0: it did not run
    float scale = 0;               ///< of s1, s2, s3 as PNG: the value at full colour
    std::uint32_t components = 0;  ///< of stokes.planes
};

static_assert(std::is_trivially_copyable_v<ImageRequest> && std::is_trivially_copyable_v<ResultHead>);

template <typename T>
std::string_view bytes_of(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// False where there are too few bytes.
template <typename T>
bool take(std::string_view& from, T& into) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (from.size() < sizeof into) return false;
    from.copy(reinterpret_cast<char*>(&into), sizeof into);
    from.remove_prefix(sizeof into);
    return true;
}

/// Description of a worker, sent in its hello.
struct Hello {
    std::string renderer;             ///< OpenGL's name and version
    std::vector<std::string> scenes;  ///< their ids

    bool operator==(const Hello&) const = default;
};

/// A scene that was loaded, or has no digest and the reason why it was not.
struct Loaded {
    SceneInfo info;
    std::string reason;
};

std::string pack(const Hello& hello);
std::string pack(const Loaded& loaded);
/// False where the bytes are not what pack() makes.
bool unpack(std::string_view bytes, Hello& hello);
bool unpack(std::string_view bytes, Loaded& loaded);
