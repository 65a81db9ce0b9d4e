// SPDX-License-Identifier: MIT
// Codings of an answer that a client accepts.
#pragma once

#include <string_view>

/// Returns whether the value of Accept-Encoding (RFC 9110, 12.5.3) allows this coding, a name in lower case.
/// An empty value allows none.
bool accepts_coding(std::string_view accept_encoding, std::string_view coding);
