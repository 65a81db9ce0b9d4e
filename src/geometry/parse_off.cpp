// SPDX-License-Identifier: MIT
// OFF, Geomview's text format.
#include "error.hpp"
#include "geometry/parse.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {

ParsedFile parse_off(std::string_view name, std::string_view bytes) {
    Tokenizer tokens(name, bytes, '#');
    std::string_view keyword = tokens.require("the keyword OFF");
    const auto strip_prefix = [&keyword](std::string_view prefix) {
        const bool present = keyword.starts_with(prefix);
        if (present) keyword.remove_prefix(prefix.size());
        return present;
    };
    const bool has_texcoords = strip_prefix("ST");
    const bool has_colours = strip_prefix("C");
    const bool has_normals = strip_prefix("N");
    const std::string prefix = std::string(name) + ": ";
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
        throw Error(ErrorCode::unsupported,
                    prefix + "OFF with other than three coordinates; expected OFF, NOFF, COFF or STOFF");
    if (keyword != "OFF") tokens.fail("not an OFF file: it does not begin with OFF");
    Tokenizer ahead = tokens;
    if (ahead.next() == "BINARY")
        throw Error(ErrorCode::unsupported, prefix + "binary OFF; save it as text, or as PLY or STL");

    const std::uint64_t vertices = tokens.count("the number of vertices");
    const std::uint64_t faces = tokens.count("the number of faces");
    tokens.count("the number of edges");
    PlyWriter out(has_normals);
    for (std::uint64_t v = 0; v < vertices; ++v) {
        for (int i = 0; i < (has_normals ? 6 : 3); ++i)
            out.add_number(tokens.number("a coordinate of vertex " + std::to_string(v) + " (0-based)"));
        if (has_colours || has_texcoords) tokens.skip_line();
    }
    for (std::uint64_t f = 0; f < faces; ++f) {
        const std::string face = "face " + std::to_string(f) + " (0-based)";
        const std::uint64_t corners = tokens.count("the number of corners of " + face);
        if (corners < 3)
            tokens.fail(face + " has " + std::to_string(corners) + " corners; it needs 3 or more");
        out.begin_face(static_cast<std::uint32_t>(corners));
        for (std::uint64_t i = 0; i < corners; ++i) {
            const std::uint64_t index = tokens.count("a vertex of " + face);
            if (index >= vertices)
                tokens.fail(face + " uses vertex " + std::to_string(index) + ", but there are " +
                            std::to_string(vertices));
            out.add_index(static_cast<std::uint32_t>(index));
        }
        tokens.skip_line();  // the colour of the face
    }
    return out.file();
}

}  // namespace nicol::geometry
