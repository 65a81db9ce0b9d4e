// SPDX-License-Identifier: MIT
// Parser of OFF, Geomview's text format.
#include <vector>

#include "error.hpp"
#include "files/first_statement.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

// Returns the numbers of a line up to the first token that is not a number.
std::vector<float> numbers(Tokenizer line) {
    std::vector<float> out;
    while (!Tokenizer(line).next().empty()) {
        bool finite = true;
        const float value = line.number_or_zero("a colour or a texture coordinate", finite);
        if (!finite) break;
        out.push_back(value);
    }
    return out;
}

// Returns the colour by Geomview's rule: the range is 0 to 255 if any value is above 1.
glm::vec3 color_of(const std::vector<float>& rgb) {
    const glm::vec3 color(rgb[0], rgb[1], rgb[2]);
    const bool bytes = color.r > 1 || color.g > 1 || color.b > 1;
    return bytes ? color / 255.0F : color;
}

// Data of vertices beside their positions, which letters before OFF announce.
struct OffData {
    bool texcoords, colors, normals;
};

// Drops the letters from the keyword.
OffData taken_data(std::string_view& keyword) {
    const auto strip_prefix = [&keyword](std::string_view prefix) {
        const bool present = keyword.starts_with(prefix);
        if (present) keyword.remove_prefix(prefix.size());
        return present;
    };
    const bool texcoords = strip_prefix("ST");
    const bool colors = strip_prefix("C");
    return {.texcoords = texcoords, .colors = colors, .normals = strip_prefix("N")};
}

PolygonMesh parse_off(const MeshBytes& mesh, LeftOut& left_out, const LoadBudget& budget) {
    Tokenizer tokens(mesh.name, as_text(mesh.name, mesh.bytes), '#');
    std::string_view keyword = tokens.require("the keyword OFF");
    const OffData data = taken_data(keyword);
    const std::string prefix = std::string(mesh.name) + ": ";
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
    PolygonMesh out;
    for (std::uint64_t v = 0; v < vertices; ++v) {
        budget.step(32);
        const std::string what = "a coordinate of vertex " + std::to_string(v) + " (0-based)";
        const auto triple = [&] {
            const float x = tokens.number(what);
            const float y = tokens.number(what);
            return glm::vec3(x, y, tokens.number(what));
        };
        out.positions.push_back(triple());
        if (data.normals) out.normals.push_back(triple());
        if (!data.colors && !data.texcoords) continue;
        const std::vector<float> rest = numbers(tokens.line());
        const std::size_t of_texcoord = data.texcoords ? 2 : 0;
        if (data.colors && rest.size() >= 3 + of_texcoord) {
            out.colors.resize(out.positions.size(), glm::vec3(1));
            out.colors.back() = color_of(rest);
        }
        if (data.texcoords) {
            out.texcoords.emplace_back(0);
            if (rest.size() >= 2) out.texcoords.back() = {rest[rest.size() - 2], rest.back()};
        }
    }
    if (!out.colors.empty()) out.colors.resize(vertices, glm::vec3(1));
    for (std::uint64_t f = 0; f < faces; ++f) {
        const std::string face = "face " + std::to_string(f) + " (0-based)";
        budget.step(16);
        const std::uint64_t corners = tokens.count("the number of corners of " + face);
        for (std::uint64_t i = 0; i < corners; ++i) {
            budget.step(8);
            const std::uint64_t index = tokens.count("a vertex of " + face);
            if (index >= vertices)
                tokens.fail(face + " uses vertex " + std::to_string(index) + ", but there are " +
                            std::to_string(vertices));
            const auto at = static_cast<std::uint32_t>(index);
            out.corners.push_back({.position = at,
                                   .normal = data.normals ? at : PolygonMesh::kNone,
                                   .texcoord = data.texcoords ? at : PolygonMesh::kNone});
        }
        const std::vector<float> rest = numbers(tokens.line());
        if (out.end_face(left_out) && rest.size() >= 3) {
            out.face_colors.resize(out.face_ends.size(), glm::vec3(1));
            out.face_colors.back() = color_of(rest);
        }
    }
    if (!out.face_colors.empty()) out.face_colors.resize(out.face_ends.size(), glm::vec3(1));
    return out;
}

bool begins_as_off(std::string_view bytes) {
    std::string_view keyword = first_statement(bytes);
    static_cast<void>(taken_data(keyword));
    return keyword.starts_with("OFF");
}

}  // namespace

const MeshFormat kOff{.name = "off", .kind = "an OFF mesh", .parse = parse_off, .begins = begins_as_off};

}  // namespace nicol::geometry
