// SPDX-License-Identifier: MIT
// Scene files for tests.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

/// A scene file in a folder of its own that goes away with the test.
class SceneFile {
public:
    explicit SceneFile(std::string_view text)
        : folder_(std::filesystem::temp_directory_path() /
                  ("nicol_scene_" + std::to_string(getpid()) + "_" + std::to_string(next_++))) {
        std::filesystem::create_directories(folder_);
        std::ofstream(path(), std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    ~SceneFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    /// Another file in the folder, in folders of its own if the name says so.
    void add(const std::string& name, std::string_view text) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary)
            .write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;

    [[nodiscard]] std::filesystem::path path() const { return folder_ / "scene.xml"; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    static inline int next_ = 0;
    std::filesystem::path folder_;
};

/// The parts of a scene that are complete without being told anything.
inline const std::string a_sensor = "<sensor type='perspective'><float name='fov' value='40'/></sensor>\n";
inline const std::string an_emitter = "<emitter type='constant'/>\n";
inline const std::string a_shape = "<shape type='sphere'/>\n";

/// `content` begins on line 2.
inline std::string scene(const std::string& content) {
    return "<scene version='3.0.0'>\n" + content + "</scene>\n";
}
