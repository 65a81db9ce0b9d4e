// SPDX-License-Identifier: MIT
// Reader of mesh files.
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

/// Mesh of a file, for formats that hold several, and the attributes that become colours.
struct Choice {
    std::size_t shape;
    const MeshColorNames& colors;
};

/// A format of mesh files: one row of kFormats, which is all that the library knows of it beside its parser.
struct Format {
    std::string_view name;  ///< the suffix without its dot
    geometry::PolygonMesh (*parse)(std::string_view name, std::string_view bytes, const Choice& choice,
                                   geometry::LeftOut& left_out, const LoadBudget& budget);
    bool several_meshes = false;    ///< a file holds several
    bool upward_texcoords = false;  ///< programs that write it count v from the image's bottom
};

/// Drops colours that are not asked for.
geometry::PolygonMesh only(const MeshColorNames& colors, geometry::PolygonMesh mesh) {
    const MeshColorNames known;
    if (colors.vertices != known.vertices) mesh.colors.clear();
    if (colors.faces != known.faces) mesh.face_colors.clear();
    return mesh;
}

/// Parses a format that holds one mesh per file, without attributes but colours.
template <geometry::PolygonMesh (*Parse)(std::string_view, std::string_view, geometry::LeftOut&,
                                         const LoadBudget&)>
geometry::PolygonMesh single(std::string_view name, std::string_view bytes, const Choice& choice,
                             geometry::LeftOut& left_out, const LoadBudget& budget) {
    return only(choice.colors, Parse(name, bytes, left_out, budget));
}

geometry::PolygonMesh ply(std::string_view name, std::string_view bytes, const Choice& choice,
                          geometry::LeftOut& left_out, const LoadBudget& budget) {
    return geometry::parse_ply(name, bytes, left_out, budget, choice.colors);
}

geometry::PolygonMesh serialized(std::string_view name, std::string_view bytes, const Choice& choice,
                                 geometry::LeftOut& left_out, const LoadBudget& budget) {
    return only(choice.colors, geometry::parse_serialized(name, bytes, choice.shape, left_out, budget));
}

constexpr std::array kFormats = {
    Format{.name = "obj", .parse = single<geometry::parse_obj>, .upward_texcoords = true},
    Format{.name = "ply", .parse = ply}, Format{.name = "off", .parse = single<geometry::parse_off>},
    Format{.name = "stl", .parse = single<geometry::parse_stl>},
    Format{.name = "serialized", .parse = serialized, .several_meshes = true}};

/// Returns null for a file of another kind.
const Format* find_format(const std::filesystem::path& file) {
    const std::string suffix = suffix_of(file);
    const auto* const format =
        std::ranges::find_if(kFormats, [&](const Format& f) { return suffix == "." + std::string(f.name); });
    return format == kFormats.end() ? nullptr : &*format;
}

const Format& format_of(const std::filesystem::path& file) {
    if (const Format* const format = find_format(file)) return *format;
    std::string suffixes;
    for (const Format& format : kFormats) {
        const bool last = &format == &kFormats.back();
        suffixes += (suffixes.empty() ? "." : last ? " or ." : ", .") + std::string(format.name);
    }
    throw Error(ErrorCode::unsupported,
                file.string() + ": unknown kind of mesh \"" + suffix_of(file) + "\"; expected " + suffixes);
}

}  // namespace

Mesh geometry::mesh_of(const std::filesystem::path& file, std::string_view bytes,
                       const std::function<void(const std::string&)>& notice, std::size_t shape,
                       const LoadBudget& budget, const MeshColorNames& colors) {
    const std::string name = file.string();
    LeftOut left_out;
    PolygonMesh polygons = format_of(file).parse(name, bytes, {shape, colors}, left_out, budget);
    // In the worst case every corner becomes a vertex.
    if (polygons.corners.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::unsupported, name + ": more than 2^32 - 2 corners of faces");
    if (polygons.face_ends.empty())
        throw Error(ErrorCode::invalid_file, name + ": no faces; a mesh needs at least one");
    Mesh mesh = triangulated(polygons, name, left_out, budget);
    if (const std::string text = left_out.notice(name); notice && !text.empty()) notice(text);
    return mesh;
}

std::string mesh_format_names() {
    std::string names;
    for (const Format& format : kFormats) names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

bool is_mesh_format(std::string_view name) {
    return std::ranges::find(kFormats, name, &Format::name) != kFormats.end();
}

bool holds_several_meshes(const std::filesystem::path& file) {
    const Format* const format = find_format(file);
    return format != nullptr && format->several_meshes;
}

bool has_upward_texcoords(const std::filesystem::path& file) {
    const Format* const format = find_format(file);
    return format != nullptr && format->upward_texcoords;
}

Mesh load_mesh(const std::filesystem::path& file, const std::function<void(const std::string&)>& notice,
               std::size_t shape, const LoadBudget& budget, const MeshColorNames& colors) {
    static_cast<void>(format_of(file));  // throws before reading if the kind is unknown
    return geometry::mesh_of(file, read_bytes(file, budget), notice, shape, budget, colors);
}

}  // namespace nicol
