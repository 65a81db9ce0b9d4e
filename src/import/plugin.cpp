// SPDX-License-Identifier: MIT
// Typed access to parameters.
#include "import/plugin.hpp"
#include "files/suffix.hpp"

#include <algorithm>
#include <array>

#include "import/text.hpp"
#include "import/values.hpp"
#include "shortest_text.hpp"

namespace nicol::scene {
namespace {

constexpr std::array<std::string_view, 9> kParameterTags = {
    "float", "integer", "string", "boolean", "rgb", "spectrum", "point", "vector", "transform"};

bool is_parameter(pugi::xml_node node) {
    // <spectrum type="..."> is an object.
    return std::ranges::find(kParameterTags, std::string_view(node.name())) != kParameterTags.end() &&
           !node.attribute("type");
}

/// Returns the node itself or, for a <ref>, the element that it names.
pugi::xml_node target(const XmlDocument& document, pugi::xml_node place) {
    if (std::string_view(place.name()) != "ref") return place;
    check_attributes(document, place, {"name", "id"});
    const std::string id = place.attribute("id").value();
    const pugi::xml_node node = document.with_id(id);
    if (!node) document.fail(place, "<ref> to " + in_quotes(id) + ", an id that no element has");
    return node;
}

constexpr std::string_view kTexture = "texture";

}  // namespace

NestedObject checked_object(const XmlDocument& document, pugi::xml_node place, const std::string& holder,
                            std::initializer_list<std::string_view> accepted) {
    const pugi::xml_node node = target(document, place);
    std::string found = tag(node) + " inside " + holder;
    if (node != place)
        found = "<ref> to " + in_quotes(place.attribute("id").value()) + ", which is a " + tag(node) +
                ", inside " + holder;
    const std::string_view name = node.name();
    if (std::ranges::find(accepted, name) != accepted.end()) return {place, node};
    const ErrorCode code = place == node ? ErrorCode::unsupported : ErrorCode::invalid_file;
    std::string reason = "accepted elements: " + joined(accepted);
    if (name == "spectrum")
        reason = "a <spectrum> with a type is not supported; give its value as <rgb>, <spectrum> or <float>";
    if (name == "emitter") reason = "an <emitter> is inside <scene> or, of type area, inside a <shape>";
    if (name == "medium") reason = "surfaces are opaque and nothing is between them";
    document.fail(place, found + "; " + reason, code);
}

Plugin::Plugin(const XmlDocument& document, pugi::xml_node node)
    : document_(document), node_(node), type_(node.attribute("type").value()) {
    document.budget().step(1024);
    if (node.parent().type() == pugi::node_document)
        check_attributes(document, node, {"type", "id", "name", "version"});
    else
        check_attributes(document, node, {"type", "id", "name"});
    if (type_.empty()) document.fail(node, tag(node) + " has no type");
    for (const pugi::xml_node child : document.elements(node)) {
        if (is_parameter(child))
            add_parameter(child);
        else if (const pugi::xml_node object = target(document, child); object.name() == kTexture)
            add_texture(child, object);
        else
            objects_.push_back(child);
    }
}

void Plugin::add_texture(pugi::xml_node place, pugi::xml_node node) {
    const std::string name = place.attribute("name").value();
    if (!textures_.try_emplace(name, NestedObject{place, node}).second || values_.contains(name))
        document_.fail(place, label() + ": parameter " + in_quotes(name) + " is given twice");
}

void Plugin::add_parameter(pugi::xml_node child) {
    // Mitsuba takes the objects of an included <scene>, and loses its parameters.
    if (child.parent() != node_)
        document_.fail(child, label() + ": a parameter in an included file; expected objects there");
    const std::string name = child.attribute("name").value();
    const std::string_view kind = child.name();
    if (name.empty()) document_.fail(child, label() + ": a " + tag(child) + " without a name");
    if (!values_.try_emplace(name, child).second || textures_.contains(name))
        document_.fail(child, label() + ": parameter " + in_quotes(name) + " is given twice");
    if (kind == "transform") return;
    if (kind == "point" || kind == "vector")
        check_attributes(document_, child, {"name", "value", "x", "y", "z"});
    else
        check_attributes(document_, child, {"name", "value"});
    if (child.first_child().type() == pugi::node_element)
        document_.fail(child,
                       label() + ": parameter " + in_quotes(name) + " has elements inside; expected none");
}

void Plugin::ask(const std::string& name) {
    if (std::ranges::find(asked_, name) == asked_.end()) asked_.push_back(name);
}

bool Plugin::has_tag(const std::string& name, std::string_view tag) const {
    const auto entry = values_.find(name);
    return entry != values_.end() && entry->second.name() == tag;
}

pugi::xml_node Plugin::find(const std::string& name, std::initializer_list<std::string_view> tags) {
    ask(name);
    if (textures_.contains(name))
        fail(name, "is a texture; expected one value, as <" + std::string(*tags.begin()) + ">",
             ErrorCode::unsupported);
    const auto entry = values_.find(name);
    if (entry == values_.end()) return {};
    if (std::ranges::find(tags, std::string_view(entry->second.name())) == tags.end())
        fail(name, "is given as " + tag(entry->second) + "; expected <" + std::string(*tags.begin()) + ">");
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
        fail(name, "is " + shortest_text(value) + "; expected a number " +
                       (most == std::numeric_limits<double>::max()
                            ? (exclusive ? "above " : "of at least ") + shortest_text(least)
                            : (exclusive ? "between " : "from ") + shortest_text(least) +
                                  (exclusive ? " and " : " to ") + shortest_text(most)));
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
    const std::string text = lower_case(node.attribute("value").value());
    if (text != "true" && text != "false") fail(name, "is " + in_quotes(text) + "; expected true or false");
    return text == "true";
}

std::string Plugin::string(const std::string& name, const std::string& otherwise) {
    const pugi::xml_node node = find(name, {"string"});
    return node ? node.attribute("value").value() : otherwise;
}

std::size_t Plugin::choice(const std::string& name, std::size_t otherwise,
                           const std::vector<std::string>& choices) {
    const std::string text = lower_case(string(name, choices[otherwise]));
    const auto found = std::ranges::find(choices, text);
    if (found == choices.end()) fail(name, "is " + in_quotes(text) + "; expected one of " + joined(choices));
    return static_cast<std::size_t>(found - choices.begin());
}

std::filesystem::path Plugin::filename(const std::string& name) {
    const std::string text = string(name, "");
    if (text.empty()) fail(name, "is missing or empty; expected the name of a file");
    return document_.resolved(node_, text);
}

glm::dvec3 Plugin::vector(const std::string& name, std::optional<glm::dvec3> otherwise) {
    const pugi::xml_node node = find(name, {"vector", "point"});
    if (node) return parsed_vector(document_, node, 0.0);
    if (!otherwise) fail(name, "is missing; expected <vector name=\"" + name + "\" x= y= z=>");
    return *otherwise;
}

ColorDescription Plugin::color(const std::string& name, const ColorDescription& otherwise, double most,
                               double least) {
    const pugi::xml_node node = find(name, {"rgb", "spectrum", "float"});
    if (!node) return otherwise;
    const std::string_view text = node.attribute("value").value();
    std::optional<ColorDescription> color;
    std::string expected;
    if (has_tag(name, "rgb")) {
        if (const auto rgb = parsed_rgb(text)) color = *rgb;
        expected = "one or three finite numbers, or #rrggbb";
    } else if (has_tag(name, "spectrum")) {
        color = parsed_spectrum(text);
        expected = "one finite number, or two and more wavelength:value pairs by increasing wavelength in nm";
    } else {
        if (const auto number = parsed_number(text)) color = *number;
        expected = "a finite number";
    }
    if (!color) fail(name, "is " + in_quotes(text) + "; expected " + expected);
    const auto check = [&](double value) {
        if (!(value >= least && value <= most))
            fail(name,
                 "is " + in_quotes(text) + "; expected values " +
                     (most == kNoLimit ? "of at least " + shortest_text(least)
                                       : "from " + shortest_text(least) + " to " + shortest_text(most)));
    };
    for (glm::length_t i = 0; i < 3; ++i) check(color->rgb[i]);
    for (const ColorDescription::Sample& sample : color->spectrum) check(sample.value);
    return *color;
}

double Plugin::uniform(const std::string& name, double otherwise, double least, double most) {
    const ColorDescription value = color(name, otherwise, most, least);
    if (!value.spectrum.empty() || value.rgb != glm::dvec3(value.rgb.x))
        fail(name, "is coloured; expected one value", ErrorCode::unsupported);
    return value.rgb.x;
}

glm::dmat4 Plugin::transform(const std::string& name) {
    const pugi::xml_node node = find(name, {"transform"});
    return node ? parsed_transform(document_, node) : glm::dmat4(1.0);
}

pugi::xml_node Plugin::texture(const std::string& name) {
    ask(name);
    const auto entry = textures_.find(name);
    return entry == textures_.end() ? pugi::xml_node() : entry->second.node;
}

std::vector<std::string> Plugin::texture_names() const {
    std::vector<std::string> names;
    for (const auto& [name, texture] : textures_) names.push_back(name);
    return names;
}

pugi::xml_node Plugin::only_texture() {
    if (textures_.size() != 1)
        fail("", "has " + std::to_string(textures_.size()) + " textures inside; expected one");
    return texture(textures_.begin()->first);
}

void Plugin::pass_over(std::initializer_list<const char*> names) {
    for (const char* name : names) ask(name);
}

std::vector<NestedObject> Plugin::objects(std::initializer_list<std::string_view> accepted) const {
    std::vector<NestedObject> found;
    for (const pugi::xml_node child : objects_)
        found.push_back(checked_object(document_, child, label(), accepted));
    return found;
}

std::vector<NestedObject> Plugin::single_objects(std::initializer_list<std::string_view> accepted) const {
    std::vector<NestedObject> found = objects(accepted);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (std::string_view(found[i].node.name()) == found[k].node.name())
                document_.fail(found[i].place,
                               label() + ": a second " + tag(found[i].node) + "; expected one");
    return found;
}

void Plugin::finish() const {
    for (const auto& [name, node] : values_)
        if (std::ranges::find(asked_, name) == asked_.end())
            fail(name, "is unknown; accepted: " + joined(asked_));
    for (const auto& [name, texture] : textures_)
        if (std::ranges::find(asked_, name) == asked_.end())
            document_.fail(texture.place, label() + ": texture " + in_quotes(name) +
                                              " is unknown; accepted parameters: " + joined(asked_));
}

std::string Plugin::label() const {
    // Without the brackets, which a message needs around elements only.
    const std::string element = tag(node_);
    return element.substr(1, element.size() - 2) + " " + in_quotes(type_);
}

void Plugin::fail(const std::string& parameter, const std::string& message, ErrorCode code) const {
    const auto value = values_.find(parameter);
    const auto texture = textures_.find(parameter);
    document_.fail(
        value != values_.end()       ? value->second
        : texture != textures_.end() ? texture->second.place
                                     : node_,
        label() + ": " + (parameter.empty() ? "" : "parameter " + in_quotes(parameter) + " ") + message,
        code);
}

void Plugin::fail_type(const std::string& accepted, const std::string& reason) const {
    document_.fail(
        node_,
        label() + " is not supported" + (reason.empty() ? "" : ": " + reason) + "; accepted: " + accepted,
        ErrorCode::unsupported);
}

}  // namespace nicol::scene
