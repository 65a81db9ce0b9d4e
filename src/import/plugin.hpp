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

/// Returns `node` itself or, for a <ref>, the element that it names. Throws unless it is one of the
/// `accepted` ones; `holder` is what it is inside of, for the message.
[[nodiscard]] NestedObject checked_object(const XmlDocument& document, pugi::xml_node node,
                                          const std::string& holder,
                                          std::initializer_list<std::string_view> accepted);

/// The upper end of a range that has none.
inline constexpr double kNoLimit = std::numeric_limits<double>::max();

/// Every name that is read is recorded, so that finish() finds parameters that nothing reads: misspelt ones.
/// All throw Error(invalid_file) with the place, the plug-in, the parameter and what is accepted.
class Plugin {
public:
    Plugin(const XmlDocument& document, pugi::xml_node node);

    [[nodiscard]] const std::string& type() const { return type_; }
    [[nodiscard]] std::string id() const { return node_.attribute("id").value(); }
    [[nodiscard]] bool has(const std::string& name) const {
        return values_.contains(name) || textures_.contains(name);
    }
    /// True if the file gives the parameter as an element of this name.
    [[nodiscard]] bool has_tag(const std::string& name, std::string_view tag) const;

    /// A finite number within [least, most]; `exclusive` shuts the ends out.
    double number(const std::string& name, double otherwise, double least, double most,
                  bool exclusive = false);
    double number(const std::string& name, double otherwise);
    int integer(const std::string& name, int otherwise, int least, int most);
    bool boolean(const std::string& name, bool otherwise);
    std::string string(const std::string& name, const std::string& otherwise);
    /// One of the spellings in `choices`, which are in lower case, in any case; their index.
    std::size_t choice(const std::string& name, std::size_t otherwise,
                       const std::vector<std::string>& choices);
    /// The file a required parameter names.
    std::filesystem::path filename(const std::string& name);
    glm::dvec3 vector(const std::string& name, std::optional<glm::dvec3> otherwise);
    /// An <rgb>, a <spectrum> or a <float>, in [least, most].
    ColorDescription color(const std::string& name, const ColorDescription& otherwise, double most = kNoLimit,
                           double least = 0.0);
    /// The same, of one value for all colours.
    double uniform(const std::string& name, double otherwise, double least, double most);
    glm::dmat4 transform(const std::string& name);
    /// The <texture> that the file gives for a parameter, null if it gives none.
    pugi::xml_node texture(const std::string& name);
    /// Returns the names of all <texture>s.
    [[nodiscard]] std::vector<std::string> texture_names() const;
    /// The only <texture>, whatever its name.
    pugi::xml_node only_texture();
    /// Known parameters that make no difference here.
    void pass_over(std::initializer_list<const char*> names);

    /// Nested objects but textures in file order, each of one of the `accepted` names.
    [[nodiscard]] std::vector<NestedObject> objects(std::initializer_list<std::string_view> accepted) const;
    /// The same, at most one of each name.
    [[nodiscard]] std::vector<NestedObject> single_objects(
        std::initializer_list<std::string_view> accepted) const;
    /// Throws if there is a parameter that nothing has read.
    void finish() const;
    /// Throws about one parameter, or about the plug-in if it is empty.
    [[noreturn]] void fail(const std::string& parameter, const std::string& message,
                           ErrorCode code = ErrorCode::invalid_file) const;
    /// Throws Error(unsupported) with the list of types that exist and, where there is one, the reason.
    [[noreturn]] void fail_type(const std::string& accepted, const std::string& reason = "") const;

private:
    void ask(const std::string& name);
    void add_parameter(pugi::xml_node child);
    void add_texture(pugi::xml_node place, pugi::xml_node node);
    /// The element of a parameter, null if the file does not give it.
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
