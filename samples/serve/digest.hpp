// SPDX-License-Identifier: MIT
// SHA-256, and entity tags and signatures of URLs derived from it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

using Digest = std::array<unsigned char, 32>;

Digest sha256(std::string_view text);
Digest hmac_sha256(std::string_view key, std::string_view text);
std::string hex(const Digest& digest);

/// Returns a strong entity tag, quotes included, of a content that this text determines.
std::string entity_tag(std::string_view text);
/// Returns whether If-None-Match contains this tag by the weak comparison (RFC 9110, 8.8.3.2), or is "*".
bool matches(std::string_view if_none_match, std::string_view tag);
