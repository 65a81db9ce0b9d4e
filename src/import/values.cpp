// SPDX-License-Identifier: MIT
// Parses attributes.
#include "import/values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "geometry/perpendicular.hpp"
#include "import/text.hpp"

namespace nicol::scene {

std::optional<double> parsed_number(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

namespace {

/// Returns the parts between commas and blanks.
std::vector<std::string_view> tokens(std::string_view text) {
    constexpr std::string_view separators = ", \t\r\n";
    std::vector<std::string_view> found;
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
        if (text.empty()) return found;
        const std::size_t length = std::min(text.find_first_of(separators), text.size());
        found.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
}

}  // namespace

std::vector<double> parsed_numbers(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view token : tokens(text)) {
        const auto number = parsed_number(token);
        if (!number) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<ColorDescription> parsed_spectrum(std::string_view text) {
    ColorDescription color(0.0);
    if (const auto number = parsed_number(text)) {
        color.rgb = glm::dvec3(*number);
        color.equal_energy = true;
        return color;
    }
    double last = 0.0;
    for (const std::string_view token : tokens(text)) {
        const std::size_t colon = token.find(':');
        if (colon == std::string_view::npos) return std::nullopt;
        const auto wavelength = parsed_number(token.substr(0, colon));
        const auto value = parsed_number(token.substr(colon + 1));
        if (!wavelength || !value || !(*wavelength > last)) return std::nullopt;
        last = *wavelength;
        color.spectrum.push_back({*wavelength, *value});
    }
    if (color.spectrum.size() < 2) return std::nullopt;
    return color;
}

void check_attributes(const XmlDocument& document, pugi::xml_node node,
                      std::initializer_list<std::string_view> allowed) {
    for (const pugi::xml_attribute attribute : node.attributes()) {
        if (std::ranges::find(allowed, std::string_view(attribute.name())) != allowed.end()) continue;
        document.fail(node, tag(node) + " has an attribute " + in_quotes(attribute.name()) +
                                "; accepted: " + joined(allowed));
    }
}

namespace {

double number_attribute(const XmlDocument& document, pugi::xml_node node, const char* name,
                        std::optional<double> missing) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute && missing) return *missing;
    const auto number = parsed_number(attribute.value());
    if (!number)
        document.fail(node, tag(node) + ": " + name + " is " + in_quotes(attribute.value()) +
                                "; expected a finite number");
    return *number;
}

glm::dvec3 triple_attribute(const XmlDocument& document, pugi::xml_node node, const char* name) {
    const std::vector<double> numbers = parsed_numbers(node.attribute(name).value());
    if (numbers.size() != 3)
        document.fail(node, tag(node) + ": " + name + " is " + in_quotes(node.attribute(name).value()) +
                                "; expected three finite numbers");
    return {numbers[0], numbers[1], numbers[2]};
}

glm::dmat4 rotation(const XmlDocument& document, pugi::xml_node node) {
    check_attributes(document, node, {"x", "y", "z", "value", "angle"});
    const double angle = number_attribute(document, node, "angle", std::nullopt);
    const glm::dvec3 axis = parsed_vector(document, node, 0.0);
    const double length = glm::length(axis);
    if (!(length > 0.0) || !std::isfinite(length))
        document.fail(node, "<rotate> about an axis of no length; give x, y or z");
    return glm::rotate(glm::dmat4(1.0), glm::radians(angle), axis / length);
}

/// +z towards the target, +x to the left for a viewer behind it, +y as near to `up` as can be.
glm::dmat4 look_at(const XmlDocument& document, pugi::xml_node node) {
    check_attributes(document, node, {"origin", "target", "up"});
    const glm::dvec3 origin = triple_attribute(document, node, "origin");
    const glm::dvec3 forward = triple_attribute(document, node, "target") - origin;
    glm::dvec3 up(0.0);
    if (*node.attribute("up").value() != '\0') up = triple_attribute(document, node, "up");
    if (up == glm::dvec3(0.0)) up = perpendicular(glm::normalize(forward));
    const glm::dvec3 left = glm::cross(up, forward);
    if (!(glm::length(left) > 1e-12 * glm::length(up) * glm::length(forward)) ||
        !std::isfinite(glm::length(left)))
        document.fail(node,
                      "<lookat>: origin and target coincide, or up is parallel to the line between them");
    const glm::dvec3 z = glm::normalize(forward);
    const glm::dvec3 x = glm::normalize(left);
    return {glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
            glm::dvec4(origin, 1.0)};
}

glm::dmat4 matrix(const XmlDocument& document, pugi::xml_node node) {
    check_attributes(document, node, {"value"});
    const std::vector<double> numbers = parsed_numbers(node.attribute("value").value());
    if (numbers.size() != 16 && numbers.size() != 9)
        document.fail(node, "<matrix>: expected 16 or 9 finite numbers, row by row");
    const glm::length_t size = numbers.size() == 16 ? 4 : 3;
    glm::dmat4 result(1.0);
    for (glm::length_t row = 0; row < size; ++row)
        for (glm::length_t column = 0; column < size; ++column)
            result[column][row] = numbers[static_cast<std::size_t>(row * size + column)];
    return result;
}

glm::dmat4 operation(const XmlDocument& document, pugi::xml_node node) {
    const std::string_view name = node.name();
    if (name == "translate" || name == "scale") {
        check_attributes(document, node, {"x", "y", "z", "value"});
        const glm::dmat4 identity(1.0);
        return name == "scale" ? glm::scale(identity, parsed_vector(document, node, 1.0))
                               : glm::translate(identity, parsed_vector(document, node, 0.0));
    }
    if (name == "rotate") return rotation(document, node);
    if (name == "lookat") return look_at(document, node);
    if (name == "matrix") return matrix(document, node);
    document.fail(node, tag(node) + " in <transform>; accepted: translate, rotate, scale, matrix, lookat",
                  ErrorCode::unsupported);
}

}  // namespace

glm::dvec3 parsed_vector(const XmlDocument& document, pugi::xml_node node, double missing) {
    const pugi::xml_attribute value = node.attribute("value");
    const bool has_parts = node.attribute("x") || node.attribute("y") || node.attribute("z");
    if (value && has_parts)
        document.fail(node, tag(node) + " has both a value and x, y or z; expected one of them");
    if (value) {
        const std::vector<double> numbers = parsed_numbers(value.value());
        if (numbers.size() == 1) return glm::dvec3(numbers[0]);
        if (numbers.size() != 3)
            document.fail(node, tag(node) + ": value is " + in_quotes(value.value()) +
                                    "; expected one or three finite numbers");
        return {numbers[0], numbers[1], numbers[2]};
    }
    return {number_attribute(document, node, "x", missing), number_attribute(document, node, "y", missing),
            number_attribute(document, node, "z", missing)};
}

std::optional<glm::dvec3> parsed_rgb(std::string_view text) {
    if (text.starts_with('#')) {
        std::uint32_t code = 0;
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), code, 16);
        if (text.size() != 7 || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
        return glm::dvec3(code >> 16, (code >> 8) & 255u, code & 255u) / 255.0;
    }
    const std::vector<double> numbers = parsed_numbers(text);
    if (numbers.size() == 1) return glm::dvec3(numbers[0]);
    if (numbers.size() != 3) return std::nullopt;
    return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

glm::dmat4 parsed_transform(const XmlDocument& document, pugi::xml_node transform) {
    check_attributes(document, transform, {"name"});
    glm::dmat4 product(1.0);
    for (const pugi::xml_node node : transform.children())
        if (node.type() == pugi::node_element) product = operation(document, node) * product;
    for (glm::length_t column = 0; column < 4; ++column)
        if (product[column][3] != (column == 3 ? 1.0 : 0.0))
            document.fail(transform, "<transform>: the last row of the matrix must be 0 0 0 1",
                          ErrorCode::unsupported);
    const glm::dmat3 linear(product);
    const double box = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    if (!(std::abs(glm::determinant(linear)) > 1e-12 * box) || !std::isfinite(box) ||
        !std::isfinite(glm::length(glm::dvec3(product[3]))))
        document.fail(transform, "<transform> cannot be inverted; is there a scale of zero?");
    return product;
}

}  // namespace nicol::scene
