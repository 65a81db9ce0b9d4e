// SPDX-License-Identifier: MIT
// Formats of mesh files: each is one object, which its parser's file defines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "files/load_budget.hpp"
#include "geometry/left_out.hpp"

namespace nicol {

struct MeshColorNames;

namespace geometry {
struct PolygonMesh;
}

/// Content of a mesh file and what is wanted of it.
struct MeshBytes {
    std::string_view name;  ///< name of the file, which begins every message
    std::string_view bytes;
    std::size_t shape = 0;         ///< 0-based, of formats that hold several meshes
    const MeshColorNames& colors;  ///< for formats that have other attributes than colours
};

struct MeshFormat {
    std::string_view name;  ///< suffix of its files without the dot
    std::string_view kind;  ///< "an OBJ mesh"
    /// Throws Error(invalid_file), or Error(unsupported) for a well-formed file that holds something other
    /// than polygons; the message names the line, vertex or face (0-based). Indices of the result are in
    /// range, positions finite, normals finite or zero. Ignored elements are counted in `left_out`. Memory is
    /// proportional to the bytes, whatever they claim. Parsers call `budget` at every line, vertex or face.
    geometry::PolygonMesh (*parse)(const MeshBytes& mesh, geometry::LeftOut& left_out,
                                   const LoadBudget& budget);
    /// Returns whether a file that begins with these bytes, which may be all or the first 4,096, is of this
    /// format. A binary STL file is known by all its bytes only.
    bool (*begins)(std::string_view bytes);
    bool other_attributes = false;  ///< MeshColorNames may name other attributes than the colours
    bool several_meshes = false;    ///< a file holds several
    bool upward_texcoords = false;  ///< v is counted from the image's last row upwards
};

namespace geometry {
extern const MeshFormat kObj, kPly, kOff, kStl, kSerialized;
}

/// Formats that load_mesh() reads; none in builds without mesh files.
[[nodiscard]] std::span<const MeshFormat* const> mesh_formats();
/// Returns "obj, ply, ...".
[[nodiscard]] std::string mesh_format_names();
/// Returns the format of this name, or null.
[[nodiscard]] const MeshFormat* mesh_format_named(std::string_view name);
/// Returns the format that a file's suffix says, or null.
[[nodiscard]] const MeshFormat* mesh_format_of(const std::filesystem::path& file);
/// Returns the format of a file that begins with these bytes, or null.
[[nodiscard]] const MeshFormat* mesh_format_of_content(std::string_view bytes);

}  // namespace nicol
