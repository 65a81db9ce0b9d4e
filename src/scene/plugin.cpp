// SPDX-License-Identifier: MIT
// Typed access to parameters.
#include "scene/plugin.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "scene/values.hpp"

namespace nicol::scene {
namespace {

constexpr std::array<std::string_view, 9> parameter_tags = {
    "float", "integer", "string", "boolean", "rgb", "spectrum", "point", "vector", "transform"};

bool is_parameter(pugi::xml_node node) {
    // <spectrum type="..."> is an object, as a texture is.
    return std::ranges::find(parameter_tags, std::string_view(node.name())) != parameter_tags.end() &&
           !node.attribute("type");
}

std::string text_of(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

std::string joined(auto&& names) {
    std::string list;
    for (const auto& name : names) list.append(list.empty() ? "" : ", ").append(name);
    return list.empty() ? "none" : list;
}

}  // namespace

Plugin::Plugin(const XmlDocument& document, pugi::xml_node node)
    : document_(document), node_(node), type_(node.attribute("type").value()) {
    check_attributes(document, node, {"type", "id", "name"});
    if (type_.empty()) document.fail(node, "<" + std::string(node.name()) + "> has no type");
    for (const pugi::xml_node child : node.children()) {
        if (child.type() != pugi::node_element || !is_parameter(child)) continue;
        const std::string name = child.attribute("name").value();
        if (name.empty()) document.fail(child, label() + ": a <" + child.name() + "> without a name");
        if (!values_.try_emplace(name, child).second)
            document.fail(child, label() + ": parameter " + in_quotes(name) + " is given twice");
        if (std::string_view(child.name()) != "transform") {
            check_attributes(document, child, {"name", "value", "x", "y", "z"});
            if (child.first_child().type() == pugi::node_element)
                document.fail(child, label() + ": parameter " + in_quotes(name) +
                                         " has elements inside; expected none");
        }
    }
}

bool Plugin::has_tag(const std::string& name, std::string_view tag) const {
    const auto entry = values_.find(name);
    return entry != values_.end() && entry->second.name() == tag;
}

pugi::xml_node Plugin::find(const std::string& name, std::initializer_list<std::string_view> tags) {
    asked_.push_back(name);
    const auto entry = values_.find(name);
    if (entry == values_.end()) return {};
    if (std::ranges::find(tags, std::string_view(entry->second.name())) == tags.end())
        fail(name, "is given as <" + std::string(entry->second.name()) + ">; expected <" +
                       std::string(*tags.begin()) + ">");
    return entry->second;
}

double Plugin::number(const std::string& name, double otherwise) {
    const pugi::xml_node node = find(name, {"float", "integer"});
    if (!node) return otherwise;
    const auto value = parsed_number(node.attribute("value").value());
    if (!value) fail(name, "is " + in_quotes(node.attribute("value").value()) + "; expected a finite number");
    return *value;
}

double Plugin::number(const std::string& name, double otherwise, double least, double most, bool exclusive) {
    const double value = number(name, otherwise);
    if (!(exclusive ? value > least && value < most : value >= least && value <= most))
        fail(name, "is " + text_of(value) + "; expected a number " +
                       (most == std::numeric_limits<double>::max()
                            ? (exclusive ? "above " : "of at least ") + text_of(least)
                            : (exclusive ? "between " : "from ") + text_of(least) +
                                  (exclusive ? " and " : " to ") + text_of(most)));
    return value;
}

int Plugin::integer(const std::string& name, int otherwise, int least, int most) {
    const pugi::xml_node node = find(name, {"integer"});
    if (!node) return otherwise;
    // Whole numbers of this size are exact in a double, and so is every comparison.
    const auto value = parsed_number(node.attribute("value").value());
    if (!value || *value != static_cast<double>(static_cast<int>(std::clamp(*value, -1e9, 1e9))) ||
        *value < least || *value > most)
        fail(name, "is " + in_quotes(node.attribute("value").value()) + "; expected a whole number from " +
                       std::to_string(least) + " to " + std::to_string(most));
    return static_cast<int>(*value);
}

bool Plugin::boolean(const std::string& name, bool otherwise) {
    const pugi::xml_node node = find(name, {"boolean"});
    if (!node) return otherwise;
    std::string text = node.attribute("value").value();
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (text != "true" && text != "false") fail(name, "is " + in_quotes(text) + "; expected true or false");
    return text == "true";
}

std::string Plugin::string(const std::string& name, const std::string& otherwise) {
    const pugi::xml_node node = find(name, {"string"});
    return node ? node.attribute("value").value() : otherwise;
}

std::size_t Plugin::choice(const std::string& name, std::size_t otherwise,
                           const std::vector<std::string>& choices) {
    const std::string text = string(name, choices[otherwise]);
    const auto found = std::ranges::find(choices, text);
    if (found == choices.end()) fail(name, "is " + in_quotes(text) + "; expected one of " + joined(choices));
    return static_cast<std::size_t>(found - choices.begin());
}

std::filesystem::path Plugin::filename(const std::string& name) {
    const std::string text = string(name, "");
    if (text.empty()) fail(name, "is missing or empty; expected the name of a file");
    return document_.resolved(text);
}

glm::dvec3 Plugin::vector(const std::string& name, std::optional<glm::dvec3> otherwise) {
    const pugi::xml_node node = find(name, {"vector", "point"});
    if (node) return parsed_vector(document_, node, 0.0);
    if (!otherwise) fail(name, "is missing; expected <vector name=\"" + name + "\" x= y= z=>");
    return *otherwise;
}

glm::dvec3 Plugin::color(const std::string& name, double otherwise, double most) {
    const pugi::xml_node node = find(name, {"rgb", "spectrum", "float"});
    if (!node) return glm::dvec3(otherwise);
    const std::string_view text = node.attribute("value").value();
    const bool is_rgb = std::string_view(node.name()) == "rgb";
    const auto number = parsed_number(text);
    const auto color = is_rgb ? parsed_rgb(text) : number ? std::optional(glm::dvec3(*number)) : std::nullopt;
    if (!color)
        fail(name, "is " + in_quotes(text) +
                       (is_rgb ? "; expected one or three finite numbers, or #rrggbb"
                               : "; expected one finite number (no tabulated spectra)"));
    for (glm::length_t i = 0; i < 3; ++i)
        if (!((*color)[i] >= 0.0 && (*color)[i] <= most))
            fail(name, "is " + in_quotes(text) + "; expected values " +
                           (most == 1.0 ? "from 0 to 1" : "of at least 0"));
    return *color;
}

glm::dmat4 Plugin::transform(const std::string& name) {
    const pugi::xml_node node = find(name, {"transform"});
    return node ? parsed_transform(document_, node) : glm::dmat4(1.0);
}

void Plugin::pass_over(std::initializer_list<const char*> names) {
    asked_.insert(asked_.end(), names.begin(), names.end());
}

std::vector<pugi::xml_node> Plugin::objects(std::initializer_list<std::string_view> accepted) const {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node child : node_.children()) {
        if (child.type() != pugi::node_element || is_parameter(child)) continue;
        const std::string_view name = child.name();
        if (name == "default") continue;
        if (std::ranges::find(accepted, name) == accepted.end())
            document_.fail(
                child,
                label() + ": <" + std::string(name) + "> inside it; accepted elements: " + joined(accepted),
                ErrorCode::unsupported);
        found.push_back(child);
    }
    return found;
}

void Plugin::finish() const {
    for (const auto& [name, node] : values_)
        if (std::ranges::find(asked_, name) == asked_.end())
            fail(name, "is unknown; accepted: " + joined(asked_));
}

std::string Plugin::label() const {
    return std::string(node_.name()) + " " + in_quotes(type_);
}

void Plugin::fail(const std::string& parameter, const std::string& message, ErrorCode code) const {
    const auto entry = values_.find(parameter);
    document_.fail(
        entry == values_.end() ? node_ : entry->second,
        label() + ": " + (parameter.empty() ? "" : "parameter " + in_quotes(parameter) + " ") + message,
        code);
}

void Plugin::fail_type(const std::string& accepted) const {
    document_.fail(node_, label() + " is not supported; accepted: " + accepted, ErrorCode::unsupported);
}

}  // namespace nicol::scene
