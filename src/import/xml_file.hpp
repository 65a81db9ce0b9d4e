// SPDX-License-Identifier: MIT
// XML file that is well-formed, has a bounded size and no entities.
#pragma once

#include <cstddef>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_record.hpp"

namespace nicol::scene {

/// Returns text in quotes for a message. Long text is cut, and unprintable characters are replaced.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Returns "<name>" of an element for a message, cut and replaced as by in_quotes().
[[nodiscard]] std::string tag(pugi::xml_node node);

/// Returns the content of a file. Subtracts its size from `bytes_left`. Throws what read_mitsuba_scene
/// throws.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, std::size_t& bytes_left,
                                    const LoadBudget& budget);

class XmlFile {
public:
    /// Subtracts the size of the file from `bytes_left`. Throws what read_mitsuba_scene throws.
    XmlFile(const std::filesystem::path& file, std::size_t& bytes_left, const LoadBudget& budget);

    /// Returns the outermost element.
    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    [[nodiscard]] const std::filesystem::path& path() const { return file_; }
    [[nodiscard]] const FileRecord& record() const { return record_; }
    /// Returns the number of the line that holds a node of this file, from 1.
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
