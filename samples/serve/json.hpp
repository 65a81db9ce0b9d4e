// SPDX-License-Identifier: MIT
// What little JSON the service writes.
#pragma once

#include <string>
#include <string_view>

/// The text in quotes. Bytes that are no UTF-8 become U+FFFD, so that the result always is JSON.
std::string json_string(std::string_view text);
/// The shortest decimal that reads back as the same number; it must be finite.
std::string json_number(double value);
