// SPDX-License-Identifier: MIT
// Compression as PNG files and HTTP's coding "deflate" have it (RFC 1950).
#pragma once

#include <string>
#include <string_view>

std::string deflated(std::string_view data);
