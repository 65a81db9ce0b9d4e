// SPDX-License-Identifier: MIT
// STL, text and binary.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>

#include "error.hpp"
#include "geometry/source_text.hpp"
#include "geometry/vet.hpp"

namespace nicol::geometry {
namespace {

static_assert(std::endian::native == std::endian::little,
              "binary STL is read and written as it lies in memory");

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

using Facet = std::array<std::array<float, 3>, 4>;  // normal, three corners

void append(Vetted& out, std::string_view name, const Facet& facet) {
    const std::string label = std::string(name) + ": facet " + std::to_string(out.faces) + " (0-based) ";
    for (std::size_t corner = 1; corner < 4; ++corner) {
        if (!std::ranges::all_of(facet[corner], [](float x) { return std::isfinite(x); }))
            throw Error(ErrorCode::invalid_file, label + "has a corner that is not finite");
        if (facet[corner] == facet[corner % 3 + 1])
            throw Error(ErrorCode::invalid_file,
                        label + "is degenerate: two of its corners are the same point; remove it");
    }
    std::array<char, facet_size> record{};
    std::memcpy(record.data(), &facet, sizeof(facet));
    out.bytes.append(record.data(), record.size());
    ++out.faces;
}

std::uint32_t binary_count(std::string_view bytes) {
    std::uint32_t count = 0;
    if (bytes.size() >= header_size) std::memcpy(&count, bytes.data() + 80, 4);
    return count;
}

void expect(Words& words, std::string_view expected) {
    const std::string_view word = words.require(expected);
    if (!std::ranges::equal(word, expected,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; }))
        words.fail("expected \"" + std::string(expected) + "\"");
}

void read_text(Vetted& out, std::string_view name, std::string_view bytes) {
    Words words(name, bytes, 0);
    for (Words ahead = words; !ahead.next().empty(); ahead = words) {
        expect(words, "solid");
        words.skip_line();  // the name of the solid
        for (;;) {
            Words end = words;
            const std::string_view word = end.require("facet or endsolid");
            if (word == "endsolid" || word == "ENDSOLID") break;
            expect(words, "facet");
            expect(words, "normal");
            // The normal follows from the corners, and some programs write nan here.
            for (int i = 0; i < 3; ++i) words.require("the normal");
            expect(words, "outer");
            expect(words, "loop");
            Facet facet{};
            for (std::size_t corner = 1; corner < 4; ++corner) {
                expect(words, "vertex");
                for (float& x : facet[corner])
                    x = words.number("a coordinate of facet " + std::to_string(out.faces) + " (0-based)");
            }
            expect(words, "endloop");
            expect(words, "endfacet");
            append(out, name, facet);
        }
        words.next();
        words.skip_line();
    }
}

void read_binary(Vetted& out, std::string_view name, std::string_view bytes) {
    const std::uint32_t count = binary_count(bytes);
    if (bytes.size() < header_size || (bytes.size() - header_size) / facet_size < count)
        throw Error(ErrorCode::invalid_file,
                    std::string(name) +
                        ": neither a text STL, which begins with \"solid\", nor a whole binary one: " +
                        std::to_string(count) + " facets take " +
                        std::to_string(header_size + std::uint64_t{count} * facet_size) +
                        " bytes, the file has " + std::to_string(bytes.size()));
    for (std::size_t f = 0; f < count; ++f) {
        Facet facet{};
        std::memcpy(&facet, bytes.data() + header_size + f * facet_size, sizeof(facet));
        append(out, name, facet);
    }
}

}  // namespace

Vetted vet_stl(std::string_view name, std::string_view bytes) {
    Vetted out;
    out.suffix = ".stl";
    out.bytes.assign(header_size, '\0');
    // Binary files may begin with "solid" too; only their size gives them away.
    const bool sized_as_binary =
        bytes.size() >= header_size &&
        bytes.size() == header_size + std::uint64_t{binary_count(bytes)} * facet_size;
    if (!sized_as_binary && (bytes.starts_with("solid") || bytes.starts_with("SOLID")))
        read_text(out, name, bytes);
    else
        read_binary(out, name, bytes);
    const auto count = static_cast<std::uint32_t>(out.faces);
    std::memcpy(out.bytes.data() + 80, &count, 4);
    return out;
}

}  // namespace nicol::geometry
