// SPDX-License-Identifier: MIT
// Scene files for tests.
#pragma once

#include "import/scene_description.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

/// A scene file in its own folder.
class SceneFile : public TemporaryFolder {
public:
    explicit SceneFile(std::string_view text) { write("scene.xml", text); }

    [[nodiscard]] std::filesystem::path scene() const { return *this / "scene.xml"; }
};

/// Scene elements that are complete without parameters.
inline const std::string a_sensor = "<sensor type='perspective'><float name='fov' value='40'/></sensor>\n";
inline const std::string an_emitter = "<emitter type='constant'/>\n";
inline const std::string a_shape = "<shape type='sphere'/>\n";

/// Returns a scene whose `content` begins on line 2.
inline std::string scene(const std::string& content) {
    return "<scene version='3.0.0'>\n" + content + "</scene>\n";
}

inline nicol::SceneDescription read(const std::string& content,
                                    const nicol::SceneParameters& parameters = {}) {
    return nicol::read_mitsuba_scene(SceneFile(scene(content)).scene(), parameters);
}

/// Returns the content of a scene whose shape contains `inside`.
inline std::string shape_with(const std::string& inside) {
    return a_sensor + an_emitter + "<shape type='sphere'>" + inside + "</shape>";
}
inline nicol::SceneDescription read_shape(const std::string& inside) {
    return read(shape_with(inside));
}
/// Returns the matrix of a <transform>.
inline glm::dmat4 transform(const std::string& operations) {
    return read_shape("<transform name='to_world'>" + operations + "</transform>").shapes.at(0).to_world;
}

/// Checks that reading fails with `code` and a message that begins with `start`, contains every part and ends
/// with `ending`.
inline void check_refused(const SceneFile& file, nicol::ErrorCode code, const std::string& start,
                          const std::vector<std::string>& parts, const std::string& ending = "",
                          const nicol::SceneParameters& parameters = {}) {
    const std::string message = error_of(CALL(nicol::read_mitsuba_scene(file.scene(), parameters)), code);
    CAPTURE(message);
    CHECK(message.starts_with(start));
    CHECK(message.ends_with(ending));
    CHECK(message.size() < 1000);
    for (const std::string& part : parts) CHECK_MESSAGE(message.find(part) != std::string::npos, part);
}
