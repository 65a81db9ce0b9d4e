// SPDX-License-Identifier: MIT
// Compression as PNG files and HTTP's coding "deflate" have it (RFC 1950).
#pragma once

#include <string>
#include <string_view>

/// What matters more.
enum class Deflate { speed, size };

std::string deflated(std::string_view data, Deflate matters);
