// SPDX-License-Identifier: MIT
// The hosts that the service answers for, and the origins whose pages may read its answers.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Returns whether the service answers a request for `host`, a name or an address with or without a port.
/// Accepted are localhost, 127.0.0.1, [::1], `local` (the local address of the connection), and the names in
/// `allowed`, where "*" is every name. The check prevents a page from reading answers through a name that
/// resolves to this machine (DNS rebinding).
bool answers_for(std::string_view host, std::string_view local, const std::vector<std::string>& allowed);

/// Returns whether a request from a page of `origin` (empty: from no page) may send data: a page of the
/// service itself, which has this host, or of an allowed origin.
bool may_send(std::string_view origin, std::string_view host, const std::vector<std::string>& allowed);

/// Returns headers of every answer to a request from a page of `origin` (empty if the browser sends none).
std::vector<std::pair<std::string, std::string>> origin_headers(std::string_view origin,
                                                                const std::vector<std::string>& allowed);

/// Returns headers of the answer to an OPTIONS request, empty if the origin is not allowed.
std::vector<std::pair<std::string, std::string>> preflight_headers(std::string_view origin,
                                                                   const std::vector<std::string>& allowed);
