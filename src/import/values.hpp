// SPDX-License-Identifier: MIT
// Numbers, vectors, colours and transforms in attributes.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "import/scene_description.hpp"
#include "import/xml_document.hpp"

namespace nicol::scene {

/// Returns the finite number that the whole text is; nothing for other text.
[[nodiscard]] std::optional<double> parsed_number(std::string_view text);

/// Returns the numbers between commas or blanks; empty if one of them is not a finite number.
[[nodiscard]] std::vector<double> parsed_numbers(std::string_view text);

/// Throws unless the attributes of `node` are among `allowed`.
void check_attributes(const XmlDocument& document, pugi::xml_node node,
                      std::initializer_list<std::string_view> allowed);

/// Returns the vector of the attributes x, y and z (`missing` for an absent one), or of a value of one or
/// three numbers.
[[nodiscard]] glm::dvec3 parsed_vector(const XmlDocument& document, pugi::xml_node node, double missing);

/// Parses the `value` of <rgb>: one number, three, or #rrggbb, which stands for linear values of n / 255.
[[nodiscard]] std::optional<glm::dvec3> parsed_rgb(std::string_view text);

/// Parses the `value` of <spectrum>: one number, or wavelength:value pairs by increasing wavelength.
[[nodiscard]] std::optional<ColorDescription> parsed_spectrum(std::string_view text);

/// Returns the product of a <transform>'s operations, the first of which acts first. The result is affine and
/// invertible.
[[nodiscard]] glm::dmat4 parsed_transform(const XmlDocument& document, pugi::xml_node transform);

}  // namespace nicol::scene
