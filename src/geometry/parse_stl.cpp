// SPDX-License-Identifier: MIT
// STL, text and binary.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>

#include "error.hpp"
#include "geometry/parse.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is copied to and from memory as it is");

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kFacetSize = 50;

using Facet = std::array<std::array<float, 3>, 4>;  // normal, three corners

void append(ParsedFile& out, std::string_view name, const Facet& facet) {
    const std::string label = std::string(name) + ": facet " + std::to_string(out.faces) + " (0-based) ";
    for (std::size_t corner = 1; corner < 4; ++corner) {
        if (!std::ranges::all_of(facet[corner], [](float x) { return std::isfinite(x); }))
            throw Error(ErrorCode::invalid_file, label + "has a corner that is not finite");
        if (facet[corner] == facet[corner % 3 + 1])
            throw Error(ErrorCode::invalid_file,
                        label + "is degenerate: two of its corners are the same point; remove it");
    }
    std::array<char, kFacetSize> record{};
    std::memcpy(record.data(), &facet, sizeof(facet));
    out.bytes.append(record.data(), record.size());
    ++out.faces;
}

std::uint32_t binary_count(std::string_view bytes) {
    std::uint32_t count = 0;
    if (bytes.size() >= kHeaderSize) std::memcpy(&count, bytes.data() + 80, 4);
    return count;
}

void expect(Tokenizer& tokens, std::string_view expected) {
    const std::string_view token = tokens.require(expected);
    if (!std::ranges::equal(token, expected,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; }))
        tokens.fail("expected \"" + std::string(expected) + "\"");
}

void read_text(ParsedFile& out, std::string_view name, std::string_view bytes) {
    Tokenizer tokens(name, bytes, 0);
    for (Tokenizer ahead = tokens; !ahead.next().empty(); ahead = tokens) {
        expect(tokens, "solid");
        tokens.skip_line();  // the name of the solid
        for (;;) {
            Tokenizer end = tokens;
            const std::string_view token = end.require("facet or endsolid");
            if (token == "endsolid" || token == "ENDSOLID") break;
            expect(tokens, "facet");
            expect(tokens, "normal");
            // The normal follows from the corners, and some programs write nan here.
            for (int i = 0; i < 3; ++i) tokens.require("the normal");
            expect(tokens, "outer");
            expect(tokens, "loop");
            Facet facet{};
            for (std::size_t corner = 1; corner < 4; ++corner) {
                expect(tokens, "vertex");
                for (float& x : facet[corner])
                    x = tokens.number("a coordinate of facet " + std::to_string(out.faces) + " (0-based)");
            }
            expect(tokens, "endloop");
            expect(tokens, "endfacet");
            append(out, name, facet);
        }
        tokens.next();
        tokens.skip_line();
    }
}

void read_binary(ParsedFile& out, std::string_view name, std::string_view bytes) {
    const std::uint32_t count = binary_count(bytes);
    if (bytes.size() < kHeaderSize || (bytes.size() - kHeaderSize) / kFacetSize < count)
        throw Error(ErrorCode::invalid_file,
                    std::string(name) +
                        ": neither a text STL, which begins with \"solid\", nor a whole binary one: " +
                        std::to_string(count) + " facets take " +
                        std::to_string(kHeaderSize + std::uint64_t{count} * kFacetSize) +
                        " bytes, the file has " + std::to_string(bytes.size()));
    for (std::size_t f = 0; f < count; ++f) {
        Facet facet{};
        std::memcpy(&facet, bytes.data() + kHeaderSize + f * kFacetSize, sizeof(facet));
        append(out, name, facet);
    }
}

}  // namespace

ParsedFile parse_stl(std::string_view name, std::string_view bytes) {
    ParsedFile out;
    out.suffix = ".stl";
    out.bytes.assign(kHeaderSize, '\0');
    // Binary files may begin with "solid" too; only their size tells them apart.
    const bool sized_as_binary =
        bytes.size() >= kHeaderSize &&
        bytes.size() == kHeaderSize + std::uint64_t{binary_count(bytes)} * kFacetSize;
    if (!sized_as_binary && (bytes.starts_with("solid") || bytes.starts_with("SOLID")))
        read_text(out, name, bytes);
    else
        read_binary(out, name, bytes);
    const auto count = static_cast<std::uint32_t>(out.faces);
    std::memcpy(out.bytes.data() + 80, &count, 4);
    return out;
}

}  // namespace nicol::geometry
