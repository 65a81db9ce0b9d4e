// SPDX-License-Identifier: MIT
// PLY, text and binary of either byte order.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "error.hpp"
#include "geometry/parse.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

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
    std::size_t size = 0;   ///< bytes, end_header and its line end included
    std::size_t lines = 0;  ///< lines of the same
};

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

Header parsed_header(std::string_view name, std::string_view bytes) {
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
            tokens.fail(
                "unknown line in the header; expected format, element, property, comment or end_header");
        }
    }
}

/// The values after the header in order, text or binary.
class Values {
public:
    Values(std::string_view name, std::string_view bytes, const Header& header)
        : name_(name),
          bytes_(bytes.substr(header.size)),
          format_(header.format),
          tokens_(name, bytes_, 0, header.lines + 1) {}

    /// `what` names the value in error messages, for example "vertex 5 (0-based)".
    double next(Type type, const std::string& what) {
        if (format_ == Format::text) return tokens_.number(what);
        switch (type) {
            case Type::i8:
                return raw<std::int8_t>(what);
            case Type::u8:
                return raw<std::uint8_t>(what);
            case Type::i16:
                return raw<std::int16_t>(what);
            case Type::u16:
                return raw<std::uint16_t>(what);
            case Type::i32:
                return raw<std::int32_t>(what);
            case Type::u32:
                return raw<std::uint32_t>(what);
            case Type::f32:
                return raw<float>(what);
            case Type::f64:
                return raw<double>(what);
        }
        return 0.0;
    }

    /// A count or an index: an integer from 0 to 2^32 - 1.
    std::uint64_t integer(Type type, const std::string& what) {
        if (format_ == Format::text) return tokens_.count(what);
        const double value = next(type, what);
        if (!(value >= 0.0 && value == std::floor(value) && value <= 4294967295.0))
            fail(what + " has a count or an index that is not a whole number from 0 up");
        return static_cast<std::uint64_t>(value);
    }

    [[noreturn]] void fail(const std::string& message) const {
        if (format_ == Format::text) tokens_.fail(message);
        throw Error(ErrorCode::invalid_file, std::string(name_) + ": " + message);
    }

private:
    template <class T>
    double raw(const std::string& what) {
        if (bytes_.size() - at_ < sizeof(T)) fail("the file ends within " + what);
        std::array<char, sizeof(T)> bytes{};
        std::copy_n(bytes_.data() + at_, sizeof(T), bytes.data());
        at_ += sizeof(T);
        if ((format_ == Format::big) != (std::endian::native == std::endian::big))
            std::ranges::reverse(bytes);
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

    std::string_view name_;
    std::string_view bytes_;
    Format format_;
    Tokenizer tokens_;
    std::size_t at_ = 0;
};

void skip(Values& values, const Property& property, const std::string& what) {
    const std::uint64_t count = property.length ? values.integer(*property.length, what) : 1;
    for (std::uint64_t i = 0; i < count; ++i) values.next(property.type, what);
}

/// A writer with the vertices added.
PlyWriter read_vertices(Values& values, const Element& element) {
    constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
    const auto column = [&](std::string_view name) {
        const auto at = std::ranges::find(element.properties, name, &Property::name);
        return at == element.properties.end() || at->length
                   ? std::size_t(-1)
                   : static_cast<std::size_t>(at - element.properties.begin());
    };
    std::array<std::size_t, 6> columns{};
    for (std::size_t i = 0; i < 6; ++i) columns[i] = column(names[i]);
    for (std::size_t i = 0; i < 3; ++i)
        if (columns[i] == std::size_t(-1))
            values.fail("the vertices have no property " + std::string(names[i]) + "; expected x, y and z");
    const bool normals =
        std::none_of(columns.begin() + 3, columns.end(), [](std::size_t c) { return c == std::size_t(-1); });
    PlyWriter out(normals);
    for (std::uint64_t v = 0; v < element.count; ++v) {
        const std::string what = "vertex " + std::to_string(v) + " (0-based)";
        std::array<float, 6> row{};
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const auto at = std::ranges::find(columns, p);
            if (at == columns.end()) {
                skip(values, element.properties[p], what);
                continue;
            }
            const double value = values.next(element.properties[p].type, what);
            if (!(std::abs(value) <= std::numeric_limits<float>::max()))
                values.fail(what + " has a " + element.properties[p].name + " that is not finite");
            row[static_cast<std::size_t>(at - columns.begin())] = static_cast<float>(value);
        }
        for (std::size_t i = 0; i < (normals ? 6u : 3u); ++i) out.add_number(row[i]);
    }
    return out;
}

void read_faces(Values& values, const Element& element, std::uint64_t vertices, PlyWriter& out) {
    const auto is_indices = [](const Property& p) {
        return p.length && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    if (std::ranges::count_if(element.properties, is_indices) != 1)
        values.fail("the faces have no list vertex_indices, or more than one");
    for (std::uint64_t f = 0; f < element.count; ++f) {
        const std::string what = "face " + std::to_string(f) + " (0-based)";
        for (const Property& property : element.properties) {
            if (!is_indices(property)) {
                skip(values, property, what);
                continue;
            }
            const std::uint64_t corners = values.integer(*property.length, what);
            if (corners < 3)
                values.fail(what + " has " + std::to_string(corners) + " corners; it needs 3 or more");
            out.begin_face(static_cast<std::uint32_t>(corners));
            for (std::uint64_t i = 0; i < corners; ++i) {
                const std::uint64_t index = values.integer(property.type, what);
                if (index >= vertices)
                    values.fail(what + " uses vertex " + std::to_string(index) + ", but there are " +
                                std::to_string(vertices));
                out.add_index(static_cast<std::uint32_t>(index));
            }
        }
    }
}

template <class T>
void append(std::string& bytes, T value) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
}

}  // namespace

void PlyWriter::add_number(float x) {
    append(vertices_, x);
}

void PlyWriter::begin_face(std::uint32_t corners) {
    ++face_count_;
    append(faces_, corners);
}

void PlyWriter::add_index(std::uint32_t index) {
    append(faces_, index);
}

ParsedFile PlyWriter::file() const {
    ParsedFile out;
    out.suffix = ".ply";
    out.vertices = vertices_.size() / (sizeof(float) * (normals_ ? 6 : 3));
    out.faces = face_count_;
    out.bytes = std::string("ply\nformat ") +
                (std::endian::native == std::endian::big ? "binary_big_endian" : "binary_little_endian") +
                " 1.0\nelement vertex " + std::to_string(out.vertices) +
                "\nproperty float x\nproperty float y\nproperty float z\n" +
                (normals_ ? "property float nx\nproperty float ny\nproperty float nz\n" : "") +
                "element face " + std::to_string(out.faces) +
                "\nproperty list int int vertex_indices\nend_header\n";
    out.bytes.append(vertices_).append(faces_);
    return out;
}

ParsedFile parse_ply(std::string_view name, std::string_view bytes) {
    const Header header = parsed_header(name, bytes);
    Values values(name, bytes, header);
    const auto element = [&](std::string_view wanted) -> const Element& {
        const auto at = std::ranges::find(header.elements, wanted, &Element::name);
        if (at == header.elements.end() || std::ranges::count(header.elements, wanted, &Element::name) > 1)
            values.fail("expected one element \"" + std::string(wanted) + "\" in the header");
        return *at;
    };
    const Element& vertex = element("vertex");
    const Element& face = element("face");
    if (&face < &vertex) values.fail("the faces come before the vertices; expected the other order");
    PlyWriter out(false);
    for (const Element& e : header.elements) {
        if (&e == &vertex) {
            out = read_vertices(values, e);
        } else if (&e == &face) {
            read_faces(values, e, vertex.count, out);
        } else if (!e.properties.empty()) {
            for (std::uint64_t i = 0; i < e.count; ++i)
                for (const Property& p : e.properties)
                    skip(values, p, e.name + " " + std::to_string(i) + " (0-based)");
        }
    }
    return out.file();
}

}  // namespace nicol::geometry
