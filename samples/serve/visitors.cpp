// SPDX-License-Identifier: MIT
#include "visitors.hpp"

#include <algorithm>

namespace {

/// Returns the host without its port, in lower case. An IPv6 address has no brackets.
std::string name_of(std::string_view host) {
    const std::size_t colon = host.rfind(':');
    const bool has_port = colon != std::string_view::npos &&
                          host.find(']', colon) == std::string_view::npos &&
                          host.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
    if (has_port) host = host.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
    // "localhost." is the fully qualified form.
    if (host.ends_with('.')) host.remove_suffix(1);
    std::string name(host);
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return name;
}

bool contains(const std::vector<std::string>& allowed, std::string_view name) {
    return std::ranges::any_of(allowed, [&](const std::string& one) { return one == "*" || one == name; });
}

}  // namespace

bool answers_for(std::string_view host, std::string_view local, const std::vector<std::string>& allowed) {
    const std::string name = name_of(host);
    return name == "localhost" || name == "127.0.0.1" || name == "::1" || name == local ||
           contains(allowed, name);
}

bool may_send(std::string_view origin, std::string_view host, const std::vector<std::string>& allowed) {
    const std::string name(host);
    return origin.empty() || origin == "http://" + name || origin == "https://" + name ||
           contains(allowed, origin);
}

std::vector<std::pair<std::string, std::string>> origin_headers(std::string_view origin,
                                                                const std::vector<std::string>& allowed) {
    std::vector<std::pair<std::string, std::string>> headers = {
        {"Cross-Origin-Resource-Policy", "same-origin"}};
    if (allowed.empty()) return headers;
    headers.emplace_back("Vary", "Origin");
    if (origin.empty() || !contains(allowed, origin)) return headers;
    headers.emplace_back("Access-Control-Allow-Origin", origin);
    headers.emplace_back("Access-Control-Expose-Headers",
                         "ETag, Location, Nicol-Components, Nicol-Scale, Nicol-Size, Retry-After");
    return headers;
}

std::vector<std::pair<std::string, std::string>> preflight_headers(std::string_view origin,
                                                                   const std::vector<std::string>& allowed) {
    if (origin.empty() || !contains(allowed, origin)) return {};
    // A page of the public network may request a service of a private network, for which browsers ask
    // separately.
    return {{"Access-Control-Allow-Methods", "GET, HEAD, POST"},
            {"Access-Control-Allow-Headers", "Content-Type, If-None-Match"},
            {"Access-Control-Allow-Private-Network", "true"},
            {"Access-Control-Max-Age", "600"}};
}
