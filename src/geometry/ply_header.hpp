// SPDX-License-Identifier: MIT
// Header of a PLY file: its elements and their properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/left_out.hpp"

namespace nicol::geometry::ply {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
    std::string name;
    Type type = Type::f32;
    std::optional<Type> length;  ///< type of a list's length; empty for a scalar
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Format { text, little, big };

struct Header {
    Format format = Format::text;
    std::vector<Element> elements;
    std::size_t size = 0;   ///< size in bytes, end_header and its line end included
    std::size_t lines = 0;  ///< number of lines, end_header included
};

/// Parses the header at the start of a file's bytes. Counts unknown lines in `left_out`. Throws
/// Error(invalid_file), naming the line.
[[nodiscard]] Header parsed_header(std::string_view name, std::string_view bytes, LeftOut& left_out);

}  // namespace nicol::geometry::ply
