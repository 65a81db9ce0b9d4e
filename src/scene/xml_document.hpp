// SPDX-License-Identifier: MIT
// A scene's XML: well-formed, of bounded size and depth, its $parameters replaced, its ids known.
#pragma once

#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "nicol/error.hpp"
#include "nicol/scene_description.hpp"

namespace nicol::scene {

class XmlDocument {
public:
    /// Throws as read_mitsuba_scene does.
    XmlDocument(const std::filesystem::path& file, const SceneParameters& parameters);

    /// The <scene> element.
    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    /// The element with this id, null if there is none.
    [[nodiscard]] pugi::xml_node with_id(const std::string& id) const;
    /// A filename in the scene, relative to the folder of the scene.
    [[nodiscard]] std::filesystem::path resolved(const std::string& filename) const;
    /// "file:line" of a node.
    [[nodiscard]] std::string where(pugi::xml_node node) const;
    /// Throws Error(code) "file:line: message".
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message,
                           ErrorCode code = ErrorCode::invalid_file) const;

private:
    class Walker;
    void index_lines(std::string_view bytes);
    void check_scene() const;
    /// File, line and column of a byte.
    [[nodiscard]] std::string place(std::ptrdiff_t offset, bool with_column) const;

    std::filesystem::path file_;
    pugi::xml_document document_;
    std::vector<std::ptrdiff_t> line_starts_;
    std::map<std::string, pugi::xml_node> ids_;
};

/// Text in quotes for a message, long or unprintable text made harmless.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace nicol::scene
