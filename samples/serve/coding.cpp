// SPDX-License-Identifier: MIT
#include "coding.hpp"

#include "field.hpp"

namespace {

/// Returns whether a weight is zero: "q=0", "q=0.000".
bool is_refusal(std::string_view parameter) {
    return (parameter.starts_with("q=0") || parameter.starts_with("Q=0")) &&
           parameter.find_first_not_of("0.", 2) == std::string_view::npos;
}

}  // namespace

bool accepts_coding(std::string_view accept_encoding, std::string_view coding) {
    bool any = false;
    while (!accept_encoding.empty()) {
        std::string_view element = take_part(accept_encoding, ',');
        const std::string_view name = take_part(element, ';');
        const bool accepted = !is_refusal(trimmed(element));
        if (lower_case(name) == coding) return accepted;
        if (name == "*") any = accepted;
    }
    return any;
}
