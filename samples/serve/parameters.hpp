// SPDX-License-Identifier: MIT
// The parameters of an image's URL: one table for validation, for error messages and for the OpenAPI
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
    double least = 0, most = 0;  ///< of each number; of each side of a size
    int count = 1;               ///< of Kind::numbers
    std::vector<std::string> choices = {};
    std::string description = {};
    Of of = Of::every;  ///< images: of image.png and image.exr alone; planes: of stokes.planes alone

    [[nodiscard]] bool applies_to(Format format) const;
    /// For people: "-360 to 360".
    [[nodiscard]] std::string range() const;
};

std::vector<Parameter> parameters(const Limits& limits);

/// Throws Refusal (400) where the text is no finite number, or lies outside the range.
double parse_number(const Parameter& parameter, std::string_view text);
/// Likewise, separated by commas.
std::vector<double> parse_numbers(const Parameter& parameter, std::string_view text);
/// WIDTHxHEIGHT; the product is checked too.
std::pair<std::uint32_t, std::uint32_t> parse_size(const Parameter& parameter, std::string_view text,
                                                   const Limits& limits);
/// The index of the choice.
std::size_t parse_choice(const Parameter& parameter, std::string_view text);

[[noreturn]] void refuse_parameter(const Parameter& parameter, const std::string& detail);
