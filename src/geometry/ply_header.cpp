// SPDX-License-Identifier: MIT
#include "geometry/ply_header.hpp"

#include <array>
#include <limits>
#include <utility>

#include "geometry/tokenizer.hpp"

namespace nicol::geometry::ply {
namespace {

Type type_named(const Tokenizer& tokens, std::string_view token) {
    constexpr std::array<std::array<std::string_view, 2>, 8> names = {{{"char", "int8"},
                                                                       {"uchar", "uint8"},
                                                                       {"short", "int16"},
                                                                       {"ushort", "uint16"},
                                                                       {"int", "int32"},
                                                                       {"uint", "uint32"},
                                                                       {"float", "float32"},
                                                                       {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (token == names[i][0] || token == names[i][1]) return static_cast<Type>(i);
    tokens.fail("not a PLY type; expected char, uchar, short, ushort, int, uint, float or double");
}

Property parsed_property(Tokenizer& tokens) {
    Property property;
    std::string_view type = tokens.require("a type");
    if (type == "list") {
        property.length = type_named(tokens, tokens.require("the type of a list's length"));
        if (*property.length == Type::f32 || *property.length == Type::f64)
            tokens.fail("the length of a list must be a whole number type");
        type = tokens.require("a type");
    }
    property.type = type_named(tokens, type);
    property.name = tokens.require("a property's name");
    return property;
}

}  // namespace

Header parsed_header(std::string_view name, std::string_view bytes, LeftOut& left_out) {
    Header header;
    bool has_format = false;
    for (;;) {
        const std::size_t end = bytes.find('\n', header.size);
        const std::size_t line_number = ++header.lines;
        if (end == std::string_view::npos) fail_at(name, line_number, "the file ends before \"end_header\"");
        Tokenizer tokens(name, bytes.substr(header.size, end - header.size), 0, line_number);
        header.size = end + 1;
        const std::string_view key = tokens.next();
        if (line_number == 1) {
            if (key != "ply" && key != "PLY") tokens.fail("not a PLY file: the first line is not \"ply\"");
        } else if (key == "format") {
            const std::string_view format = tokens.next();
            if (format == "binary_little_endian")
                header.format = Format::little;
            else if (format == "binary_big_endian")
                header.format = Format::big;
            else if (format != "ascii")
                tokens.fail("unknown format; expected ascii, binary_little_endian or binary_big_endian");
            has_format = true;
        } else if (key == "element") {
            Element element;
            element.name = tokens.require("an element's name");
            element.count = tokens.count("the element's count", std::numeric_limits<std::uint64_t>::max());
            header.elements.push_back(std::move(element));
        } else if (key == "property") {
            if (header.elements.empty()) tokens.fail("a property before the first element");
            header.elements.back().properties.push_back(parsed_property(tokens));
        } else if (key == "end_header") {
            if (!has_format) tokens.fail("the header has no \"format\" line");
            return header;
        } else if (!key.empty() && key != "comment" && key != "obj_info") {
            left_out.add("unknown lines of the header");
        }
    }
}

}  // namespace nicol::geometry::ply
