// SPDX-License-Identifier: MIT
// A scene's XML with its includes: $parameters replaced, ids and folders known.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "error.hpp"
#include "import/parameters.hpp"
#include "import/scene_description.hpp"
#include "import/xml_file.hpp"

namespace nicol::scene {

class XmlDocument {
public:
    /// Throws as read_mitsuba_scene does.
    XmlDocument(const std::filesystem::path& file, const SceneParameters& parameters, LoadBudget budget);
    ~XmlDocument();

    /// Returns the budget, which every walk over elements checks.
    [[nodiscard]] const LoadBudget& budget() const noexcept { return budget_; }
    /// Returns the <scene> element.
    [[nodiscard]] pugi::xml_node root() const;
    /// Returns the elements inside a node in the order of the file, without <default>, <path> and <alias>.
    /// The elements of an included <scene>, or any other included outermost element, replace the <include>.
    [[nodiscard]] std::vector<pugi::xml_node> elements(pugi::xml_node node) const;
    /// Returns the element with this id or alias; null if there is none.
    [[nodiscard]] pugi::xml_node with_id(const std::string& id) const;
    /// Returns the file that a name inside `node` stands for, as read_mitsuba_scene describes.
    [[nodiscard]] std::filesystem::path resolved(pugi::xml_node node, const std::string& filename) const;
    /// Returns the elements of samplers with a $parameter without a value. Elsewhere such a parameter is an
    /// error.
    [[nodiscard]] const std::vector<pugi::xml_node>& left_open() const noexcept { return left_open_; }
    /// Returns the records of the scene file, of included files and of spectra.
    [[nodiscard]] std::vector<FileRecord> files() const;
    /// Returns "file:line" of a node.
    [[nodiscard]] std::string where(pugi::xml_node node) const;
    /// Throws Error(code) "file:line: message" with the files that include the file.
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message,
                           ErrorCode code = ErrorCode::invalid_file) const;

private:
    struct Source;
    class Walker;
    void load(const std::filesystem::path& file, pugi::xml_node include);
    void check_version(pugi::xml_node outermost) const;
    void include(pugi::xml_node node);
    void add_folder(pugi::xml_node node);
    /// Replaces the name of the file of a <spectrum> by the file's content.
    void read_spectrum(pugi::xml_node node);
    /// Returns the first of the folders' files that is_there() finds.
    template <class IsThere>
    [[nodiscard]] std::filesystem::path resolved(pugi::xml_node node, const std::string& filename,
                                                 IsThere is_there) const;
    void add_alias(pugi::xml_node node);
    void replace_parameters(pugi::xml_node node, pugi::xml_attribute attribute);
    void add_id(const std::string& id, pugi::xml_node node, pugi::xml_node target);
    [[nodiscard]] Source& source_of(pugi::xml_node node) const;
    void append_elements(pugi::xml_node node, std::vector<pugi::xml_node>& found) const;
    /// Returns " (included by a.xml:3, by b.xml:2)"; empty for the outermost file.
    [[nodiscard]] std::string chain(pugi::xml_node include) const;

    Parameters parameters_;
    LoadBudget budget_;
    std::size_t bytes_left_;     // of files
    std::size_t replaced_left_;  // of attributes with parameters
    std::vector<std::unique_ptr<Source>> sources_;
    std::map<pugi::xml_node, Source*> source_of_root_;
    std::map<pugi::xml_node, Source*> source_of_include_;
    std::map<std::string, pugi::xml_node> ids_;
    std::vector<pugi::xml_node> left_open_;
    std::vector<FileRecord> spectra_;
};

}  // namespace nicol::scene
