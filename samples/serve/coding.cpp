// SPDX-License-Identifier: MIT
#include "coding.hpp"

#include <algorithm>

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Returns the part before the separator and removes both from the text.
std::string_view take(std::string_view& text, char separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    return trimmed(part);
}

bool same(std::string_view name, std::string_view lower) {
    return std::ranges::equal(name, lower,
                              [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

/// Returns whether a weight is zero: "q=0", "q=0.000".
bool is_refusal(std::string_view parameter) {
    return (parameter.starts_with("q=0") || parameter.starts_with("Q=0")) &&
           parameter.find_first_not_of("0.", 2) == std::string_view::npos;
}

}  // namespace

bool accepts_coding(std::string_view accept_encoding, std::string_view coding) {
    bool any = false;
    while (!accept_encoding.empty()) {
        std::string_view element = take(accept_encoding, ',');
        const std::string_view name = take(element, ';');
        const bool accepted = !is_refusal(trimmed(element));
        if (same(name, coding)) return accepted;
        if (name == "*") any = accepted;
    }
    return any;
}
