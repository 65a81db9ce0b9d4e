// SPDX-License-Identifier: MIT
// Queries of extension lists in EGL's format.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace nicol::gl {

/// Returns whether a name is in a list separated by blanks; the list may be null.
[[nodiscard]] inline bool has_extension(const char* list, std::string_view name) {
    std::istringstream words(list != nullptr ? list : "");
    for (std::string word; words >> word;)
        if (word == name) return true;
    return false;
}

}  // namespace nicol::gl
