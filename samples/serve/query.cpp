// SPDX-License-Identifier: MIT
#include "query.hpp"

#include <algorithm>

#include "problem.hpp"

namespace {

constexpr std::size_t kMaxParameters = 32;

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

[[noreturn]] void refuse(const std::string& detail) {
    throw Refusal({.status = 400, .detail = detail});
}

std::string decode(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        int value = static_cast<unsigned char>(text[i]);
        if (text[i] == '%') {
            const int high = i + 1 < text.size() ? hex_digit(text[i + 1]) : -1;
            const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
            if (high < 0 || low < 0)
                refuse("The request's target has a '%' that two hexadecimal digits do not follow.");
            value = high * 16 + low;
            i += 2;
        }
        if (value < 0x20 || value == 0x7f) refuse("The request's target has a control character.");
        result += static_cast<char>(value);
    }
    return result;
}

}  // namespace

const std::string* Target::find(std::string_view name) const {
    for (const auto& [key, value] : query)
        if (key == name) return &value;
    return nullptr;
}

std::string_view authority_of(std::string_view target) {
    const std::size_t scheme = target.find("://");
    if (scheme == std::string_view::npos) return {};
    std::string name(target.substr(0, scheme));
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    if (name != "http" && name != "https") return {};
    const std::string_view rest = target.substr(scheme + 3);
    return rest.substr(0, rest.find_first_of("/?"));
}

std::string origin_form(std::string_view target) {
    const std::string_view authority = authority_of(target);
    if (authority.empty()) return std::string(target);
    const std::string_view rest(authority.data() + authority.size(), target.data() + target.size());
    return (rest.starts_with('/') ? "" : "/") + std::string(rest);
}

Target parse_target(std::string_view target) {
    if (!target.starts_with('/')) refuse("The request's target must be a path that begins with '/'.");
    const std::size_t question = target.find('?');
    Target result;
    for (std::string_view path = target.substr(0, question); !path.empty();) {
        path.remove_prefix(1);
        const std::string_view segment = path.substr(0, path.find('/'));
        result.segments.push_back(decode(segment));
        path.remove_prefix(segment.size());
    }
    if (question == std::string_view::npos) return result;
    std::string_view rest = target.substr(question + 1);
    while (!rest.empty()) {
        const std::size_t end = rest.find('&');
        const std::string_view part = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos || equals == 0)
            refuse("Each part of the query must be name=value.");
        const std::string name = decode(part.substr(0, equals));
        if (result.find(name) != nullptr)
            throw Refusal({.status = 400,
                           .detail = "The parameter comes more than once.",
                           .parameter = name,
                           .range = "once"});
        if (result.query.size() == kMaxParameters)
            refuse("The query has more than " + std::to_string(kMaxParameters) + " parameters.");
        result.query.emplace_back(name, decode(part.substr(equals + 1)));
    }
    return result;
}
