// SPDX-License-Identifier: MIT
// OFF, the text form of Geomview.
#include "error.hpp"
#include "geometry/source_text.hpp"
#include "geometry/vet.hpp"

namespace nicol::geometry {

Vetted vet_off(std::string_view name, std::string_view bytes) {
    Words words(name, bytes, '#');
    std::string_view keyword = words.require("the keyword OFF");
    const auto dropped = [&keyword](std::string_view prefix) {
        const bool there = keyword.starts_with(prefix);
        if (there) keyword.remove_prefix(prefix.size());
        return there;
    };
    const bool has_texcoords = dropped("ST");
    const bool has_colours = dropped("C");
    const bool has_normals = dropped("N");
    const std::string prefix = std::string(name) + ": ";
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
        throw Error(ErrorCode::unsupported,
                    prefix + "OFF with other than three coordinates; expected OFF, NOFF, COFF or STOFF");
    if (keyword != "OFF") words.fail("not an OFF file: it does not begin with OFF");
    Words ahead = words;
    if (ahead.next() == "BINARY")
        throw Error(ErrorCode::unsupported, prefix + "binary OFF; save it as text, or as PLY or STL");

    const std::uint64_t vertices = words.count("the number of vertices");
    const std::uint64_t faces = words.count("the number of faces");
    words.count("the number of edges");
    PlainPly out(has_normals);
    for (std::uint64_t v = 0; v < vertices; ++v) {
        for (int i = 0; i < (has_normals ? 6 : 3); ++i)
            out.add_number(words.number("a coordinate of vertex " + std::to_string(v) + " (0-based)"));
        if (has_colours || has_texcoords) words.skip_line();
    }
    for (std::uint64_t f = 0; f < faces; ++f) {
        const std::string face = "face " + std::to_string(f) + " (0-based)";
        const std::uint64_t corners = words.count("the number of corners of " + face);
        if (corners < 3)
            words.fail(face + " has " + std::to_string(corners) + " corners; it needs 3 or more");
        out.begin_face(static_cast<std::uint32_t>(corners));
        for (std::uint64_t i = 0; i < corners; ++i) {
            const std::uint64_t index = words.count("a vertex of " + face);
            if (index >= vertices)
                words.fail(face + " uses vertex " + std::to_string(index) + ", but there are " +
                           std::to_string(vertices));
            out.add_index(static_cast<std::uint32_t>(index));
        }
        words.skip_line();  // the colour of the face
    }
    return out.finished();
}

}  // namespace nicol::geometry
