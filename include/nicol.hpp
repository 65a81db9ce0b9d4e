// SPDX-License-Identifier: MIT
// Nicol for C++20: handles that release themselves, and failures as exceptions. The functions are those of
// the C headers.
//
//     auto context = nicol::create<nicol::Context>(nicol_context_create, nullptr);
//     auto scene = nicol::create<nicol::Scene>(nicol_scene_load, context.get(), "a.xml", nullptr, 0);
//     nicol::check(nicol_render(scene.get(), &camera, nullptr, framebuffer.get()));
#ifndef NICOL_HPP
#define NICOL_HPP

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "nicol.h"
#include "nicol_files.h"
#include "nicol_psh.h"

namespace nicol {

/// Failure of a function: result() is its result code, and what() the message of nicol_last_error().
class Error : public std::runtime_error {
public:
    Error(nicol_result result, const char* message) : std::runtime_error(message), result_(result) {}
    [[nodiscard]] nicol_result result() const noexcept { return result_; }

private:
    nicol_result result_;
};

/// Throws Error unless `result` is NICOL_OK. Must be called on the thread of the function that returned
/// `result`, before another function fails on this thread.
inline void check(nicol_result result) {
    if (result != NICOL_OK) throw Error(result, nicol_last_error());
}

template <auto release>
struct Release {
    template <class Impl>
    void operator()(Impl* handle) const noexcept {
        release(handle);
    }
};

/// Owner of one reference to an object; movable, not copyable. get() returns the C handle, and release()
/// gives the reference away.
template <class Handle, auto release>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release<release>>;

using Context = Owned<nicol_context, nicol_context_release>;
using Environment = Owned<nicol_environment, nicol_environment_release>;
using Texture = Owned<nicol_texture, nicol_texture_release>;
using Material = Owned<nicol_material, nicol_material_release>;
using Mesh = Owned<nicol_mesh, nicol_mesh_release>;
using Scene = Owned<nicol_scene, nicol_scene_release>;
using Framebuffer = Owned<nicol_framebuffer, nicol_framebuffer_release>;
using Job = Owned<nicol_job, nicol_job_release>;
using PshTransform = Owned<nicol_psh_transform, nicol_psh_transform_release>;

/// Calls a function whose last parameter receives a new handle, and returns the handle's owner. Throws Error
/// if the function fails.
template <class Object, class... Parameters, class... Arguments>
[[nodiscard]] Object create(nicol_result (*function)(Parameters...), Arguments&&... arguments) {
    typename Object::pointer handle = nullptr;
    check(function(std::forward<Arguments>(arguments)..., &handle));
    return Object(handle);
}

/// Returns a struct with the defaults that its initialiser sets at run time: defaults(nicol_camera_init).
template <class Struct>
[[nodiscard]] Struct defaults(nicol_result (*initialiser)(Struct*, std::uint32_t)) {
    Struct made;
    check(initialiser(&made, sizeof made));
    return made;
}

}  // namespace nicol

#endif
