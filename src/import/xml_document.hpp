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

    /// To be asked by those who walk.
    [[nodiscard]] const LoadBudget& budget() const noexcept { return budget_; }
    /// The <scene> element.
    [[nodiscard]] pugi::xml_node root() const;
    /// The elements inside a node in the order of the file, without <default>, <path> and <alias>. An
    /// <include> gives way to what it includes: the elements inside a <scene>, or else the outermost element.
    [[nodiscard]] std::vector<pugi::xml_node> elements(pugi::xml_node node) const;
    /// The element with this id or alias, null if there is none.
    [[nodiscard]] pugi::xml_node with_id(const std::string& id) const;
    /// Returns the file that a name inside `node` stands for, as read_mitsuba_scene describes.
    [[nodiscard]] std::filesystem::path resolved(pugi::xml_node node, const std::string& filename) const;
    /// Elements with a $parameter that no one has given, of samplers alone: elsewhere it is an error.
    [[nodiscard]] const std::vector<pugi::xml_node>& left_open() const noexcept { return left_open_; }
    /// The scene file, those that it includes, and spectra.
    [[nodiscard]] std::vector<FileRecord> files() const;
    /// "file:line" of a node.
    [[nodiscard]] std::string where(pugi::xml_node node) const;
    /// Throws Error(code) "file:line: message", and who includes the file.
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message,
                           ErrorCode code = ErrorCode::invalid_file) const;

private:
    struct Source;
    class Walker;
    void load(const std::filesystem::path& file, pugi::xml_node include);
    void check_version(pugi::xml_node outermost) const;
    void include(pugi::xml_node node);
    void add_folder(pugi::xml_node node);
    /// Puts what the file of a <spectrum> holds in place of its name.
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
    /// " (included by a.xml:3, by b.xml:2)", empty for the outermost file.
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
