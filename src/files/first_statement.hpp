// SPDX-License-Identifier: MIT
// Beginnings of text files.
#pragma once

#include <algorithm>
#include <string_view>

namespace nicol {

/// Returns the text behind a byte order mark, blanks, and lines that begin with #.
[[nodiscard]] inline std::string_view first_statement(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        if (!text.starts_with('#')) return text;
        text.remove_prefix(std::min(text.find('\n'), text.size()));
    }
}

}  // namespace nicol
