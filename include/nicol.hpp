// SPDX-License-Identifier: MIT
// Nicol for C++20: objects that release themselves, and failures as exceptions. The functions are those of
// the C headers. nicol_classes.hpp has the classes, such as Scene for nicol_scene.
//
//     const auto context = nicol::Context::create();
//     const auto scene = nicol::Scene::load(context, "a.xml");
//     const auto image = nicol::Framebuffer::create(context, 640, 480, scene.get_channels());
//     const nicol_camera camera = scene.get_camera();
//     nicol::render(scene, &camera, nullptr, image);
//     image.write_exr("a.exr");
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

/// Owner of one reference to an object; movable, not copyable. It converts to the C handle, so that it can be
/// an argument of every function. get() returns the C handle, and release() gives the reference away.
template <class Handle, auto release>
class Owned : public std::unique_ptr<std::remove_pointer_t<Handle>, Release<release>> {
public:
    using std::unique_ptr<std::remove_pointer_t<Handle>, Release<release>>::unique_ptr;
    operator Handle() const& noexcept { return this->get(); }
    operator Handle() const&& = delete;  // the handle would outlive its owner
};

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

#include "nicol_classes.hpp"

#endif
