// SPDX-License-Identifier: MIT
// Loading of mesh files.
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "error.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol {
namespace {

struct Format {
    std::string_view suffix;
    geometry::ParsedFile (*parse)(std::string_view name, std::string_view bytes);
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

Mesh geometry::mesh_of(const std::filesystem::path& file, std::string_view bytes) {
    const std::string name = file.string();
    const ParsedFile parsed = format_of(file).parse(name, bytes);
    // OpenMesh counts in int.
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
    if (parsed.vertices > most || parsed.faces > most)
        throw Error(ErrorCode::unsupported, name + ": more than 2^31 - 1 vertices or faces");
    if (parsed.faces == 0)
        throw Error(ErrorCode::invalid_file, name + ": no faces; a mesh needs at least one");
    PolygonMesh polygons = read_polygons(name, parsed);
    const bool welded = parsed.suffix == ".stl";
    if (polygons.face_ends.size() != parsed.faces ||
        (!welded && polygons.positions.size() != parsed.vertices))
        throw Error(ErrorCode::invalid_file, name + ": OpenMesh read " +
                                                 std::to_string(polygons.face_ends.size()) + " of " +
                                                 std::to_string(parsed.faces) + " faces");
    if (welded) smooth_within_crease(polygons, kStlCreaseDegrees);
    std::vector<std::uint32_t> faces;
    Mesh mesh = triangulated(polygons, faces);
    validate(mesh, name, faces);
    return mesh;
}

Mesh load_mesh(const std::filesystem::path& file) {
    static_cast<void>(format_of(file));  // of an unknown kind nothing is read
    return geometry::mesh_of(file, geometry::read_bytes(file));
}

}  // namespace nicol
