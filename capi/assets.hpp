// SPDX-License-Identifier: MIT
// Functions common to environments, materials and meshes.
#pragma once

#include <cstddef>

#include "asset_bytes.hpp"
#include "geometry/box.hpp"
#include "handles.hpp"
#include "input_file.hpp"
#include "light/environment.hpp"

namespace nicol::capi {

/// Returns the asset as an object whose memory the context's monitor knows as long as it exists. Throws
/// Error(out_of_memory) if the monitor refuses.
template <class Content>
std::shared_ptr<const Content> monitored(const Session& session, std::shared_ptr<const Content> content) {
    if (!session.memory) return content;
    struct Kept {
        MemoryShare share;  // first, because memory is given back before the monitor is told
        std::shared_ptr<const Content> content;
    };
    const auto kept = std::make_shared<const Kept>(
        Kept{MemoryShare(session.memory, bytes_of(*content)), std::move(content)});
    return {kept, kept->content.get()};
}
/// A scene has told of its memory while it was loaded.
inline std::shared_ptr<SceneState> monitored(const Session& /*session*/, std::shared_ptr<SceneState> scene) {
    return scene;
}

/// Makes an immutable asset on the caller's thread, without locking the context, of which nothing is used.
template <class Impl, class Make>
nicol_result create(nicol_context context, Impl** out, const char* name, Make&& make,
                    const char* function = __builtin_FUNCTION()) {
    return guarded(
        [&] {
            require(out, name);
            const SessionPtr session = resolve(context).session;
            *out = make_handle<Impl>(session, monitored(*session, make()));
        },
        function);
}

/// Loads an asset from `file`, a path or a nicol_memory_file: make(name, budget, session) gets the file's
/// name, the context's limits with the source of the file, and the context, whose log it may write.
template <class Impl, class File, class Make>
nicol_result load(nicol_context context, const File* file, Impl** out, const char* name, Make&& make,
                  const char* function = __builtin_FUNCTION()) {
    return guarded(
        [&] {
            require(out, name);
            const SessionPtr session = resolve(context).session;
            const InputFile input = input_file(file, session->load_limits);
            *out = make_handle<Impl>(session, monitored(*session, make(input.name, input.budget, session)));
        },
        function);
}

/// Returns an owner that calls a descriptor's release callback with its user pointer once, when the last copy
/// of the owner is destroyed, also on failure. Refused descriptors are included, if their struct_size reaches
/// `end`, the number of bytes up to the end of both fields.
template <class T>
std::shared_ptr<void> owned_user(const T* given, void (*T::*release)(void*), void* T::*user,
                                 std::size_t end) {
    if (given == nullptr || given->struct_size < end || given->struct_size > kMaxStructSize) return nullptr;
    if (given->*release == nullptr) return nullptr;
    return {given->*user, given->*release};
}

/// Returns the texture of a descriptor's field, null if it has none. owner: context or scene that uses it.
template <class Owner>
TexturePtr texture_of(nicol_texture given, const Owner& owner) {
    if (given == nullptr) return nullptr;
    const nicol_texture_impl texture = resolve(given);
    require_same_context(owner, texture);
    return texture.content;
}

/// Writes the corners of a box.
inline void write_box(const Box& box, double* lower, double* upper) {
    for (int i = 0; i < 3; ++i) {
        lower[i] = box.lower[i];
        upper[i] = box.upper[i];
    }
}

/// Throws Error(invalid_argument) unless each side of an image lies in 1 to NICOL_MAX_SIZE. what: such as "an
/// image".
inline void require_size(const char* what, std::uint32_t width, std::uint32_t height) {
    if (width < 1 || width > NICOL_MAX_SIZE || height < 1 || height > NICOL_MAX_SIZE) {
        refuse(std::string(what) + " of " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels; each side must lie in 1 to " + std::to_string(NICOL_MAX_SIZE));
    }
}

/// Throws Error(invalid_argument) "name is 7; it must be one of NICOL_..." unless value <= last.
inline void require_constant(std::uint32_t value, std::uint32_t last, const char* name,
                             const char* constants) {
    if (value > last) {
        refuse(std::string(name) + " is " + std::to_string(value) + "; it must be one of " + constants);
    }
}

/// Returns the sky that a descriptor describes; the sky itself checks it.
RayleighSky sky_from(const nicol_sky* sky);

}  // namespace nicol::capi
