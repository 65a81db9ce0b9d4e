// SPDX-License-Identifier: MIT
// Signed URLs: only images whose URL was signed with a key can be requested.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// One key a line, in hexadecimal, at least 16 bytes; empty lines and those that begin with '#' do not count.
/// Throws Failure naming the file and the line.
std::vector<std::string> read_keys(const std::filesystem::path& path);

/// The target as it is sent ends in "sig=" and 64 hexadecimal digits: HMAC-SHA-256 of all before the '?' or
/// '&' that precedes it. A parameter "expires", in seconds since 1970, is part of what is signed. Any of the
/// keys will do. Throws Refusal (403) otherwise; all keys are tried and compared in constant time.
void check_signature(std::string_view target, const std::vector<std::string>& keys, std::int64_t now);

/// The target with its signature.
std::string signed_target(std::string_view target, std::string_view key);
