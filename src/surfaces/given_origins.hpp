// SPDX-License-Identifier: MIT
// Start points of the bake's rays beside the vertices of a scene that changes.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "surfaces/scene_geometry.hpp"

namespace nicol {

/// The result of bake_origins() for the vertices before refinement. After a change of the surfaces, only
/// origins are found anew that the change may affect.
class GivenOrigins {
public:
    /// Returns the origins of the surfaces' vertices, valid until the next call. Runs on the calling thread's
    /// TBB arena.
    const std::vector<glm::vec3>& of(const SceneGeometry& surfaces);

private:
    void carry(const SceneGeometry& surfaces);

    Version version_ = 0;  // of the surfaces of origins_
    std::vector<glm::vec3> origins_;
};

}  // namespace nicol
