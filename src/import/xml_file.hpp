// SPDX-License-Identifier: MIT
// One XML file: well-formed, of bounded size, without entities.
#pragma once

#include <cstddef>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_record.hpp"

namespace nicol::scene {

/// Text in quotes for a message, long or unprintable text made harmless.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "<name>" of an element for a message, as harmless.
[[nodiscard]] std::string tag(pugi::xml_node node);

/// A whole file, whose size is taken off `bytes_left`. Throws as read_mitsuba_scene does.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, std::size_t& bytes_left,
                                    const LoadBudget& budget);

class XmlFile {
public:
    /// Takes the size of the file off `bytes_left`. Throws as read_mitsuba_scene does.
    XmlFile(const std::filesystem::path& file, std::size_t& bytes_left, const LoadBudget& budget);

    /// The outermost element.
    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    [[nodiscard]] const std::filesystem::path& path() const { return file_; }
    [[nodiscard]] const FileRecord& record() const { return record_; }
    /// Number of the line that holds a node of this file, from 1.
    [[nodiscard]] std::ptrdiff_t line(pugi::xml_node node) const { return line(node.offset_debug()); }

private:
    [[nodiscard]] std::ptrdiff_t line(std::ptrdiff_t offset) const;
    void check_entities() const;

    std::filesystem::path file_;
    FileRecord record_;
    pugi::xml_document document_;
    std::vector<std::ptrdiff_t> line_starts_;
};

}  // namespace nicol::scene
