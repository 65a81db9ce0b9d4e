// SPDX-License-Identifier: MIT
// Scene files for tests.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "temporary_folder.hpp"

/// A scene file in a folder of its own.
class SceneFile : public TemporaryFolder {
public:
    explicit SceneFile(std::string_view text) { write("scene.xml", text); }

    [[nodiscard]] std::filesystem::path scene() const { return *this / "scene.xml"; }
};

/// The parts of a scene that are complete without being told anything.
inline const std::string a_sensor = "<sensor type='perspective'><float name='fov' value='40'/></sensor>\n";
inline const std::string an_emitter = "<emitter type='constant'/>\n";
inline const std::string a_shape = "<shape type='sphere'/>\n";

/// `content` begins on line 2.
inline std::string scene(const std::string& content) {
    return "<scene version='3.0.0'>\n" + content + "</scene>\n";
}
