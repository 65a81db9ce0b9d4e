// SPDX-License-Identifier: MIT
// Values of HTTP header fields (RFC 9110, 5.6).
#pragma once

#include <string>
#include <string_view>

/// Returns the text without blanks around it.
std::string_view trimmed(std::string_view text);

/// Returns the part before the separator, trimmed, and removes both from the text.
std::string_view take_part(std::string_view& text, char separator);

/// Returns the text with its ASCII letters in lower case.
std::string lower_case(std::string_view text);
