// SPDX-License-Identifier: MIT
// Lists of extensions, as EGL gives them.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace nicol::gl {

/// Whether a name is in a list between blanks, which may be null.
[[nodiscard]] inline bool has_extension(const char* list, std::string_view name) {
    std::istringstream words(list != nullptr ? list : "");
    for (std::string word; words >> word;)
        if (word == name) return true;
    return false;
}

}  // namespace nicol::gl
