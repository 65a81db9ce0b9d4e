// SPDX-License-Identifier: MIT
// Signatures of URLs, with which only images signed with a key can be requested.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Returns keys, one per line in hexadecimal, at least 16 bytes each. Empty lines and lines that begin with
/// '#' are ignored. Throws Failure naming the file and the line.
std::vector<std::string> read_keys(const std::filesystem::path& path);

/// Checks the target's end "sig=" and 64 hexadecimal digits: the HMAC-SHA-256 of everything before the
/// preceding '?' or '&', with one of the keys. A parameter "expires", in seconds since 1970, is part of the
/// signed text. All keys are compared in constant time. Throws Refusal (403) without a valid signature.
void check_signature(std::string_view target, const std::vector<std::string>& keys, std::int64_t now);

/// Returns the target with its signature.
std::string signed_target(std::string_view target, std::string_view key);
