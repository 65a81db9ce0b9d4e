// SPDX-License-Identifier: MIT
// Text of scene files, and lists in messages.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace nicol::scene {

/// Without the blanks at both ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Names with commas in between; empty ones are left out. "none" where there are none.
template <class Things, class Name = std::identity>
[[nodiscard]] std::string joined(const Things& things, const Name& name_of = {}) {
    std::string list;
    for (const auto& thing : things) {
        const std::string_view name = std::invoke(name_of, thing);
        if (!name.empty()) list.append(list.empty() ? "" : ", ").append(name);
    }
    return list.empty() ? "none" : list;
}

}  // namespace nicol::scene
