// SPDX-License-Identifier: MIT
// Parts of an answer, asked for by the Range header (RFC 9110, 14).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

/// Bytes from `first` on.
struct ByteRange {
    std::size_t first = 0, count = 0;
};

/// Answer to a Range header: the whole content, a part of it, or no byte because all wanted ones lie beyond
/// the end.
struct Everything {};
struct NothingThere {};
using WantedBytes = std::variant<Everything, ByteRange, NothingThere>;

/// Parses a Range header for a content of this size. Everything is wanted if the header is empty, is no
/// single range of bytes, or holds for another content than that with this tag (If-Range).
WantedBytes wanted_bytes(std::string_view range, std::string_view if_range, std::string_view tag,
                         std::size_t size);

/// Returns the value of a Content-Range header.
std::string content_range(const ByteRange& range, std::size_t size);
