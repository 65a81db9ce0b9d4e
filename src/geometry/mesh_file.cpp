// SPDX-License-Identifier: MIT
// Reader of mesh files.
#include <array>
#include <limits>

#include "error.hpp"
#include "files/read_bytes.hpp"
#include "files/suffix.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol {
namespace {

constexpr std::array kFormats = {&geometry::kObj, &geometry::kPly, &geometry::kOff, &geometry::kStl,
                                 &geometry::kSerialized};

const MeshFormat& format_of(const std::filesystem::path& file) {
    if (const MeshFormat* const format = mesh_format_of(file)) return *format;
    std::string suffixes;
    for (const MeshFormat* const format : kFormats) {
        const bool last = format == kFormats.back();
        suffixes += (suffixes.empty() ? "." : last ? " or ." : ", .") + std::string(format->name);
    }
    throw Error(ErrorCode::unsupported,
                file.string() + ": unknown kind of mesh \"" + suffix_of(file) + "\"; expected " + suffixes);
}

/// Drops colours that are not asked for.
void drop_others(const MeshColorNames& colors, geometry::PolygonMesh& mesh) {
    const MeshColorNames known;
    if (colors.vertices != known.vertices) mesh.colors.clear();
    if (colors.faces != known.faces) mesh.face_colors.clear();
}

}  // namespace

std::span<const MeshFormat* const> mesh_formats() {
    return kFormats;
}

Mesh geometry::mesh_of(const std::filesystem::path& file, std::string_view bytes,
                       const std::function<void(const std::string&)>& notice, std::size_t shape,
                       const LoadBudget& budget, const MeshColorNames& colors) {
    const std::string name = file.string();
    const MeshFormat& format = format_of(file);
    LeftOut left_out;
    PolygonMesh polygons = format.parse({name, bytes, shape, colors}, left_out, budget);
    if (!format.other_attributes) drop_others(colors, polygons);
    // In the worst case every corner becomes a vertex.
    if (polygons.corners.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::unsupported, name + ": more than 2^32 - 2 corners of faces");
    if (polygons.face_ends.empty())
        throw Error(ErrorCode::invalid_file, name + ": no faces; a mesh needs at least one");
    Mesh mesh = triangulated(polygons, name, left_out, budget);
    if (const std::string text = left_out.notice(name); notice && !text.empty()) notice(text);
    return mesh;
}

Mesh load_mesh(const std::filesystem::path& file, const std::function<void(const std::string&)>& notice,
               std::size_t shape, const LoadBudget& budget, const MeshColorNames& colors) {
    static_cast<void>(format_of(file));  // throws before reading if the kind is unknown
    return geometry::mesh_of(file, read_bytes(file, budget), notice, shape, budget, colors);
}

}  // namespace nicol
