// SPDX-License-Identifier: MIT
// The target of a request: its path, and what stands behind the question mark.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct Target {
    /// Percent-decoded parts between the slashes of the path: "/" has one empty segment. An encoded slash is
    /// part of its segment.
    std::vector<std::string> segments;
    std::vector<std::pair<std::string, std::string>> query;  ///< decoded, as they came

    [[nodiscard]] const std::string* find(std::string_view name) const;
};

/// The host, with its port if there is one, of "http://host/path?query"; empty for other targets.
std::string_view authority_of(std::string_view target);

/// "/path?query" also of "http://host/path?query", in which form a proxy may be asked (RFC 9112, 3.2.2); any
/// other target as it is.
std::string origin_form(std::string_view target);

/// Throws Refusal (400) where the target does not begin with '/', an escape is broken or stands for a control
/// character, a parameter comes twice, has no '=' or there are more than 32.
Target parse_target(std::string_view target);
