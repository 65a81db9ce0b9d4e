// SPDX-License-Identifier: MIT
// Strings and numbers in JSON.
#pragma once

#include <string>
#include <string_view>

/// Returns the text in quotes. Invalid UTF-8 becomes U+FFFD, so the result is always valid JSON.
std::string json_string(std::string_view text);
/// Returns the shortest decimal that reads back as an equal number, which must be finite.
std::string json_number(double value);
