// SPDX-License-Identifier: MIT
// The shaders of tests/gl/shaders, embedded in the same way as those of glsl/.
#pragma once

#include <span>
#include <stdexcept>
#include <string>

#include "gl/shader_source.hpp"

namespace nicol::gl {

[[nodiscard]] std::span<const ShaderSource> test_shaders();

[[nodiscard]] inline ShaderSource test_shader(std::string_view file) {
    for (const ShaderSource& shader : test_shaders())
        if (shader.file == file) return shader;
    throw std::logic_error("no test shader " + std::string(file));
}

}  // namespace nicol::gl
