// SPDX-License-Identifier: MIT
#include "render/view_uniforms.hpp"

namespace nicol {

void set_view_uniforms(gl::Program& program, const Viewpoint& view) {
    const auto set = [&](const char* name, const auto& value) {
        if (program.uses(name)) program.set(name, value);
    };
    const glm::vec3 eye(view.eye);
    set("eye", eye);
    set("eye_rest", glm::vec3(view.eye - glm::dvec3(eye)));
    set("forward", glm::vec3(view.forward));
    set("up", glm::vec3(view.up));
    set("right", glm::vec3(view.right));
    set("orthographic", view.orthographic ? 1 : 0);
}

}  // namespace nicol
