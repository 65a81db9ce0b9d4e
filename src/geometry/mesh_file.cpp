// SPDX-License-Identifier: MIT
// Loading of mesh files.
#include <algorithm>
#include <array>
#include <limits>

#include "error.hpp"
#include "files/read_bytes.hpp"
#include "files/suffix.hpp"
#include "geometry/parse.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol {
namespace {

struct Format {
    std::string_view suffix;
    geometry::PolygonMesh (*parse)(std::string_view name, std::string_view bytes, std::size_t shape,
                                   geometry::LeftOut& left_out, const LoadBudget& budget);
};

/// Of a format that holds one mesh.
template <geometry::PolygonMesh (*Parse)(std::string_view, std::string_view, geometry::LeftOut&,
                                         const LoadBudget&)>
geometry::PolygonMesh single(std::string_view name, std::string_view bytes, std::size_t /*shape*/,
                             geometry::LeftOut& left_out, const LoadBudget& budget) {
    return Parse(name, bytes, left_out, budget);
}

constexpr std::array<Format, 5> kFormats = {{{".obj", single<geometry::parse_obj>},
                                             {".ply", single<geometry::parse_ply>},
                                             {".off", single<geometry::parse_off>},
                                             {".stl", single<geometry::parse_stl>},
                                             {".serialized", geometry::parse_serialized}}};

const Format& format_of(const std::filesystem::path& file) {
    const std::string suffix = suffix_of(file);
    const auto format = std::ranges::find(kFormats, std::string_view(suffix), &Format::suffix);
    if (format == kFormats.end())
        throw Error(ErrorCode::unsupported, file.string() + ": unknown kind of mesh \"" + suffix +
                                                "\"; expected .obj, .ply, .off, .stl or .serialized");
    return *format;
}

}  // namespace

Mesh geometry::mesh_of(const std::filesystem::path& file, std::string_view bytes,
                       const std::function<void(const std::string&)>& notice, std::size_t shape,
                       const LoadBudget& budget) {
    const std::string name = file.string();
    LeftOut left_out;
    PolygonMesh polygons = format_of(file).parse(name, bytes, shape, left_out, budget);
    // Corners may be as many vertices.
    if (polygons.corners.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::unsupported, name + ": more than 2^32 - 2 corners of faces");
    if (polygons.face_ends.empty())
        throw Error(ErrorCode::invalid_file, name + ": no faces; a mesh needs at least one");
    Mesh mesh = triangulated(polygons, name, left_out, budget);
    if (const std::string text = left_out.notice(name); notice && !text.empty()) notice(text);
    return mesh;
}

bool has_upward_texcoords(const std::filesystem::path& file) {
    return suffix_of(file) == ".obj";
}

Mesh load_mesh(const std::filesystem::path& file, const std::function<void(const std::string&)>& notice,
               std::size_t shape, const LoadBudget& budget) {
    static_cast<void>(format_of(file));  // of an unknown kind nothing is read
    return geometry::mesh_of(file, read_bytes(file, budget), notice, shape, budget);
}

}  // namespace nicol
