// SPDX-License-Identifier: MIT
// Loading of mesh files.
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "error.hpp"
#include "geometry/parse.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol {
namespace {

struct Format {
    std::string_view suffix;
    geometry::PolygonMesh (*parse)(std::string_view name, std::string_view bytes,
                                   geometry::LeftOut& left_out);
};

constexpr std::array<Format, 4> kFormats = {{{".obj", geometry::parse_obj},
                                             {".ply", geometry::parse_ply},
                                             {".off", geometry::parse_off},
                                             {".stl", geometry::parse_stl}}};

const Format& format_of(const std::filesystem::path& file) {
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto format = std::ranges::find(kFormats, std::string_view(suffix), &Format::suffix);
    if (format == kFormats.end())
        throw Error(ErrorCode::unsupported, file.string() + ": unknown kind of mesh \"" + suffix +
                                                "\"; expected .obj, .ply, .off or .stl");
    return *format;
}

}  // namespace

Mesh geometry::mesh_of(const std::filesystem::path& file, std::string_view bytes,
                       const std::function<void(const std::string&)>& notice) {
    const std::string name = file.string();
    LeftOut left_out;
    PolygonMesh polygons = format_of(file).parse(name, bytes, left_out);
    // Corners may be as many vertices.
    if (polygons.corners.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::unsupported, name + ": more than 2^32 - 2 corners of faces");
    if (polygons.face_ends.empty())
        throw Error(ErrorCode::invalid_file, name + ": no faces; a mesh needs at least one");
    Mesh mesh = triangulated(polygons, name, left_out);
    if (const std::string text = left_out.notice(name); notice && !text.empty()) notice(text);
    return mesh;
}

Mesh load_mesh(const std::filesystem::path& file, const std::function<void(const std::string&)>& notice) {
    static_cast<void>(format_of(file));  // of an unknown kind nothing is read
    return geometry::mesh_of(file, geometry::read_bytes(file), notice);
}

}  // namespace nicol
