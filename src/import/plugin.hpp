// SPDX-License-Identifier: MIT
// One plug-in of a scene file and its parameters.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/xml_document.hpp"

namespace nicol::scene {

/// An element inside a plug-in that is no parameter.
struct NestedObject {
    pugi::xml_node place;  ///< the element, or the <ref> to it
    pugi::xml_node node;   ///< the element
};

/// Returns `node` itself or, for a <ref>, the element that the <ref> names. Throws unless the name of the
/// element is among `accepted`. holder: the object around the element, for the message.
[[nodiscard]] NestedObject checked_object(const XmlDocument& document, pugi::xml_node node,
                                          const std::string& holder,
                                          std::initializer_list<std::string_view> accepted);

/// Upper end of a range without a limit.
inline constexpr double kNoLimit = std::numeric_limits<double>::max();

/// Plug-in of a scene file. Records the names that are read, so that finish() finds misspelt parameters,
/// which nothing reads. All functions throw Error(invalid_file) that names the place, the plug-in, the
/// parameter and the accepted values.
class Plugin {
public:
    Plugin(const XmlDocument& document, pugi::xml_node node);

    [[nodiscard]] const std::string& type() const { return type_; }
    [[nodiscard]] std::string id() const { return node_.attribute("id").value(); }
    [[nodiscard]] bool has(const std::string& name) const {
        return values_.contains(name) || textures_.contains(name);
    }
    /// Returns whether the file gives the parameter as an element of the name `tag`.
    [[nodiscard]] bool has_tag(const std::string& name, std::string_view tag) const;

    /// Returns a finite number within [least, most], or within (least, most) if `exclusive`.
    double number(const std::string& name, double otherwise, double least, double most,
                  bool exclusive = false);
    double number(const std::string& name, double otherwise);
    int integer(const std::string& name, int otherwise, int least, int most);
    bool boolean(const std::string& name, bool otherwise);
    std::string string(const std::string& name, const std::string& otherwise);
    /// Returns the index of a spelling in `choices`, which are in lower case. The file may use any case.
    std::size_t choice(const std::string& name, std::size_t otherwise,
                       const std::vector<std::string>& choices);
    /// Returns the file that a required parameter names.
    std::filesystem::path filename(const std::string& name);
    glm::dvec3 vector(const std::string& name, std::optional<glm::dvec3> otherwise);
    /// Returns the colour of an <rgb>, a <spectrum> or a <float>, in [least, most].
    ColorDescription color(const std::string& name, const ColorDescription& otherwise, double most = kNoLimit,
                           double least = 0.0);
    /// Returns a colour, in [least, most], whose value is the same for all channels.
    double uniform(const std::string& name, double otherwise, double least, double most);
    glm::dmat4 transform(const std::string& name);
    /// Returns the <texture> of a parameter; null if the file gives none.
    pugi::xml_node texture(const std::string& name);
    /// Returns the names of all <texture>s.
    [[nodiscard]] std::vector<std::string> texture_names() const;
    /// Returns the only <texture>, which may have any name.
    pugi::xml_node only_texture();
    /// Records known parameters that have no effect as read.
    void pass_over(std::initializer_list<const char*> names);

    /// Returns the nested objects except textures, in file order. Throws unless each has one of the
    /// `accepted` names.
    [[nodiscard]] std::vector<NestedObject> objects(std::initializer_list<std::string_view> accepted) const;
    /// Returns what objects() returns. Throws if two objects have the same name.
    [[nodiscard]] std::vector<NestedObject> single_objects(
        std::initializer_list<std::string_view> accepted) const;
    /// Throws if there is a parameter that nothing has read.
    void finish() const;
    /// Throws an error about a parameter, or about the plug-in if `parameter` is empty.
    [[noreturn]] void fail(const std::string& parameter, const std::string& message,
                           ErrorCode code = ErrorCode::invalid_file) const;
    /// Throws Error(unsupported) that lists the accepted types, and the reason unless it is empty.
    [[noreturn]] void fail_type(const std::string& accepted, const std::string& reason = "") const;

private:
    void ask(const std::string& name);
    void add_parameter(pugi::xml_node child);
    void add_texture(pugi::xml_node place, pugi::xml_node node);
    /// Returns the element of a parameter; null if the file does not give it.
    pugi::xml_node find(const std::string& name, std::initializer_list<std::string_view> tags);
    [[nodiscard]] std::string label() const;

    const XmlDocument& document_;
    pugi::xml_node node_;
    std::string type_;
    std::map<std::string, pugi::xml_node> values_;
    std::map<std::string, NestedObject> textures_;
    std::vector<pugi::xml_node> objects_;
    std::vector<std::string> asked_;
};

}  // namespace nicol::scene
