// SPDX-License-Identifier: MIT
// RAII handles for the C interface, and its errors as exceptions.
#pragma once

#include <nicol.h>

#include <memory>
#include <type_traits>

#include "common/failure.hpp"

template <auto Release>
struct Releaser {
    template <typename T>
    void operator()(T* object) const {
        Release(object);
    }
};
template <typename Handle, auto Release>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Releaser<Release>>;

using Context = Owned<nicol_context, nicol_context_release>;
using Environment = Owned<nicol_environment, nicol_environment_release>;
using Material = Owned<nicol_material, nicol_material_release>;
using Mesh = Owned<nicol_mesh, nicol_mesh_release>;
using Scene = Owned<nicol_scene, nicol_scene_release>;
using Framebuffer = Owned<nicol_framebuffer, nicol_framebuffer_release>;

inline void check(nicol_result result) {
    if (result != NICOL_OK) throw Failure(nicol_last_error());
}
