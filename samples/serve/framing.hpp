// SPDX-License-Identifier: MIT
// Refusal of request headers that RFC 9110 and 9112 forbid but Beast's parser accepts.
#pragma once

#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>
#include <optional>
#include <string_view>

#include "problem.hpp"

/// Returns the problem of a refused header (400, 417 or 501), else nothing. The end of a refused message is
/// in doubt, so the connection must close. `bytes` are the header's text.
std::optional<Problem> refused_header(std::string_view bytes,
                                      const boost::beast::http::request_header<>& header);

/// Returns whether the client waits for permission before it sends the body.
bool expects_continue(const boost::beast::http::request_header<>& header);
