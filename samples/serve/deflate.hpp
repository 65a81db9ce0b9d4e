// SPDX-License-Identifier: MIT
// Compression for PNG files and HTTP's coding "deflate" (RFC 1950).
#pragma once

#include <string>
#include <string_view>

/// Goal of the compression.
enum class Deflate { speed, size };

std::string deflated(std::string_view data, Deflate matters);
