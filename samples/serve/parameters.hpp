// SPDX-License-Identifier: MIT
// The parameters of an image's URL in one table, used for validation, error messages and the OpenAPI
// description.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image_request.hpp"

struct Parameter {
    enum class Kind { number, whole, numbers, size, choice };
    enum class Of { every, images, planes };
    std::string name;
    Kind kind = Kind::number;
    double least = 0, most = 0;  ///< range of each number, or of each side of a size
    int count = 1;               ///< number of values for Kind::numbers
    std::vector<std::string> choices = {};
    std::string description = {};
    Of of = Of::every;  ///< images: only image.png and image.exr; planes: only stokes.planes

    [[nodiscard]] bool applies_to(Format format) const;
    /// Returns the range as text, such as "-360 to 360".
    [[nodiscard]] std::string range() const;
};

std::vector<Parameter> parameters(const Limits& limits);

/// Parses a number. Throws Refusal (400) if the text is not a finite number or lies outside the range.
double parse_number(const Parameter& parameter, std::string_view text);
/// Parses numbers separated by commas. Throws Refusal (400) like parse_number().
std::vector<double> parse_numbers(const Parameter& parameter, std::string_view text);
/// Parses WIDTHxHEIGHT and also checks the product.
std::pair<std::uint32_t, std::uint32_t> parse_size(const Parameter& parameter, std::string_view text,
                                                   const Limits& limits);
/// Returns the index of the choice.
std::size_t parse_choice(const Parameter& parameter, std::string_view text);

[[noreturn]] void refuse_parameter(const Parameter& parameter, const std::string& detail);
