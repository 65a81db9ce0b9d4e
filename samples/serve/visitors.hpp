// SPDX-License-Identifier: MIT
// The hosts that the service answers for, and the origins whose pages may read its answers.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Whether the service answers a request for `host`, a name or an address with or without a port. It answers
/// for localhost, 127.0.0.1, [::1], for `local`, the address that the connection came to, and for the names
/// in `allowed`, where "*" is every name. Otherwise a page could let its own name stand for this machine's
/// address (DNS rebinding) and read the answers as if they were its own.
bool answers_for(std::string_view host, std::string_view local, const std::vector<std::string>& allowed);

/// Headers of every answer to a request from a page of `origin` (empty if the browser names none).
std::vector<std::pair<std::string, std::string>> origin_headers(std::string_view origin,
                                                                const std::vector<std::string>& allowed);

/// Headers of the answer to an OPTIONS request: empty where the origin is not allowed.
std::vector<std::pair<std::string, std::string>> preflight_headers(std::string_view origin,
                                                                   const std::vector<std::string>& allowed);
