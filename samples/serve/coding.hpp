// SPDX-License-Identifier: MIT
// Which codings of an answer a client takes.
#pragma once

#include <string_view>

/// Whether the value of Accept-Encoding (RFC 9110, 12.5.3) allows this coding, a name in lower case. Who says
/// nothing is sent none.
bool accepts_coding(std::string_view accept_encoding, std::string_view coding);
