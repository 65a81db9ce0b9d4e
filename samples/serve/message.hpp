// SPDX-License-Identifier: MIT
// Messages between the front process and its workers. All processes are one program on one machine, so plain
// structs are sent unchanged: each message is a Head and the bytes that it announces.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "image_request.hpp"

enum class MessageKind : std::uint32_t {
    hello,     ///< worker: has a context; the ids of its scenes follow
    failed,    ///< worker: cannot start; the reason follows
    load,      ///< front: load the scene with this index; an Upload follows unless it is one of the folder
    loaded,    ///< worker: the scene, or the reason why it cannot be loaded, follows
    job,       ///< front: an ImageRequest follows
    cancel,    ///< front: the job's clients left; nothing follows
    progress,  ///< worker: a RenderProgress of the job follows
    result     ///< worker: a ResultHead and the answer's content or the failure follow
};

struct Head {
    MessageKind kind{};
    std::uint32_t length = 0;  ///< in bytes, of the content after the head
    std::uint64_t job = 0;     ///< job of the message; scene index for load and loaded
};

/// Largest length of a message, far above that of the largest Stokes image.
constexpr std::uint32_t kMaxMessageBytes = 0x7fffffff;

/// Verbs with reported times, in this order.
constexpr std::array<const char*, 6> kVerbs = {"project", "bake", "relight", "shade", "draw", "encode"};

/// Progress of a render.
struct RenderProgress {
    std::uint32_t verb = 0;  ///< index in kVerbs
    std::uint32_t reserved = 0;
    double fraction = 0;  ///< done of this verb, 0 to 1
};

struct ResultHead {
    std::int32_t status = 500;     ///< 200, or status of the problem; 499: cancelled
    std::uint32_t unchanged = 0;   ///< 1: the worker had rendered this view before
    std::array<double, 6> ms{};    ///< milliseconds by verb; 0: did not run
    float scale = 0;               ///< value at full colour, for s1, s2, s3 as PNG
    std::uint32_t components = 0;  ///< number in stokes.planes
};

static_assert(std::is_trivially_copyable_v<ImageRequest> && std::is_trivially_copyable_v<ResultHead> &&
              std::is_trivially_copyable_v<RenderProgress>);

template <typename T>
std::string_view bytes_of(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// Removes a value from the front. Returns false if there are too few bytes.
template <typename T>
bool take(std::string_view& from, T& into) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (from.size() < sizeof into) return false;
    from.copy(reinterpret_cast<char*>(&into), sizeof into);
    from.remove_prefix(sizeof into);
    return true;
}

/// Appends a text and its length.
void put_text(std::string& to, const std::string& text);
/// Removes a text of put_text() from the front. Returns false if it is not whole.
bool take_text(std::string_view& from, std::string& into);

/// Description of a worker, sent in its hello.
struct Hello {
    std::string renderer;             ///< name and version of OpenGL
    std::vector<std::string> scenes;  ///< ids of the scenes

    bool operator==(const Hello&) const = default;
};

/// A loaded scene, or one without a digest and the reason of its failure.
struct Loaded {
    SceneInfo info;
    std::string reason;
};

std::string pack(const Hello& hello);
std::string pack(const Loaded& loaded);
/// Unpacks bytes of pack(). Returns false if they are not.
bool unpack(std::string_view bytes, Hello& hello);
bool unpack(std::string_view bytes, Loaded& loaded);
