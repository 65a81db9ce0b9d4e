// SPDX-License-Identifier: MIT
// The shaders of glsl/, embedded at build time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nicol::gl {

/// Source of one stage with its #includes resolved. The text begins with one comment line `//@ n name` for
/// each included file, and every piece carries `#line line n`, so that a driver's message names its file.
struct ShaderSource {
    std::string_view file;  ///< name in glsl/, such as "fullscreen.vert"
    std::string_view text;
};

/// Returns all embedded stages (generated).
[[nodiscard]] std::span<const ShaderSource> embedded_shaders();

/// Returns the stage of that file name. Throws Error(invalid_argument), listing the existing stages.
[[nodiscard]] ShaderSource embedded_shader(std::string_view file);

/// Preprocessor definition, inserted behind the #version line.
struct Define {
    std::string name;
    std::string value = "1";
};

/// Returns the text with the definitions inserted. Throws Error(invalid_argument) for a name that is no GLSL
/// identifier or is reserved (GL_, __), a value with a line break, or a text without #version.
[[nodiscard]] std::string with_defines(const ShaderSource& source, std::span<const Define> defines);

/// Returns a driver's log with the source numbers of its messages replaced by file names: "lobes.glsl:12:
/// ...".
[[nodiscard]] std::string with_file_names(const ShaderSource& source, std::string_view log);

}  // namespace nicol::gl
