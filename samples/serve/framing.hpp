// SPDX-License-Identifier: MIT
// What RFC 9110 and 9112 refuse in a request's header where Beast's parser does not.
#pragma once

#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>
#include <optional>
#include <string_view>

#include "problem.hpp"

/// Where the header is refused (400, 417 or 501), what is wrong with it; where its message ends is then in
/// doubt, and the connection must close. `bytes` are those that `header` was parsed from.
std::optional<Problem> refused_header(std::string_view bytes,
                                      const boost::beast::http::request_header<>& header);

/// Whether the client sends the body only once it was told to go on.
bool expects_continue(const boost::beast::http::request_header<>& header);
