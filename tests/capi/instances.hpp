// SPDX-License-Identifier: MIT
// Instances in a scene, in one line.
#pragma once

#include <algorithm>
#include <cstdint>

#include "capi.hpp"

namespace capi_test {

/// Its id.
inline std::uint32_t add(nicol_scene scene, nicol_mesh mesh, nicol_material material,
                         const Matrix& to_world) {
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = mesh;
    instance.material = material;
    std::copy_n(to_world.rows, 16, instance.to_world);
    std::uint32_t id = NICOL_NO_INSTANCE;
    OK(nicol_scene_add_instance(scene, &instance, &id));
    return id;
}

}  // namespace capi_test
