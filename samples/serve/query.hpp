// SPDX-License-Identifier: MIT
// The target of a request: its path and its query.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct Target {
    /// Percent-decoded parts between the slashes of the path. "/" has one empty segment. An encoded slash
    /// belongs to its segment.
    std::vector<std::string> segments;
    std::vector<std::pair<std::string, std::string>> query;  ///< decoded, in the order of the target

    [[nodiscard]] const std::string* find(std::string_view name) const;
};

/// Returns the host, with its port if there is one, of "http://host/path?query"; empty for other targets.
std::string_view authority_of(std::string_view target);

/// Returns "/path?query" of "http://host/path?query", a form sent to proxies (RFC 9112, 3.2.2), and other
/// targets unchanged.
std::string origin_form(std::string_view target);

/// Parses a target. Throws Refusal (400) if it does not begin with '/', an escape is broken or encodes a
/// control character, a parameter occurs twice or has no '=', or there are more than 32 parameters.
Target parse_target(std::string_view target);
