// SPDX-License-Identifier: MIT
// Mesh files of every kind.
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "error.hpp"
#include "geometry/checks.hpp"
#include "geometry/soup.hpp"
#include "geometry/source_text.hpp"
#include "geometry/vet.hpp"

namespace nicol {
namespace {

struct FileKind {
    std::string_view suffix;
    geometry::Vetted (*vet)(std::string_view name, std::string_view bytes);
};

constexpr std::array<FileKind, 4> kinds = {{{".obj", geometry::vet_obj},
                                            {".ply", geometry::vet_ply},
                                            {".off", geometry::vet_off},
                                            {".stl", geometry::vet_stl}}};

}  // namespace

Mesh load_mesh(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto kind = std::ranges::find(kinds, std::string_view(suffix), &FileKind::suffix);
    if (kind == kinds.end())
        throw Error(ErrorCode::unsupported,
                    name + ": unknown kind of mesh \"" + suffix + "\"; expected .obj, .ply, .off or .stl");
    const geometry::Vetted vetted = kind->vet(name, geometry::read_bytes(file));
    // OpenMesh counts in int.
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
    if (vetted.vertices > most || vetted.faces > most)
        throw Error(ErrorCode::unsupported, name + ": more than 2^31 - 1 vertices or faces");
    if (vetted.faces == 0)
        throw Error(ErrorCode::invalid_file, name + ": no faces; a mesh needs at least one");
    geometry::Soup soup = geometry::read_soup(name, vetted.bytes, vetted.suffix);
    const bool welded = vetted.suffix == ".stl";
    if (soup.face_ends.size() != vetted.faces || (!welded && soup.positions.size() != vetted.vertices))
        throw Error(ErrorCode::invalid_file, name + ": OpenMesh read " +
                                                 std::to_string(soup.face_ends.size()) + " of " +
                                                 std::to_string(vetted.faces) + " faces");
    if (welded) geometry::smooth_within_crease(soup, stl_crease_degrees);
    std::vector<std::uint32_t> faces;
    Mesh mesh = geometry::triangulated(soup, faces);
    geometry::validate(mesh, name, faces);
    return mesh;
}

}  // namespace nicol
