// SPDX-License-Identifier: MIT
// Checks a mesh file before OpenMesh reads it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace nicol::geometry {

// OpenMesh's readers trust the file: a PLY header without its end makes them loop for ever, a list length
// fills the memory, double coordinates become zeros, faulty lines are passed over, material files are opened
// wherever they point. So each file is walked first, refused where it is faulty, and handed on in the
// plainest form of its format.

/// A file OpenMesh can be trusted with.
struct Vetted {
    std::string bytes;
    std::size_t vertices = 0;  ///< 0 for STL, whose vertices are only known once equal ones are merged
    std::size_t faces = 0;
};

// `name` begins every message. All throw Error(invalid_file), or Error(unsupported) for what is well-formed
// but not polygons, with the line, vertex or face (0-based) at fault.

/// Only v, vn and f; indices positive and in range; the corners of a face differ.
[[nodiscard]] Vetted vet_obj(std::string_view name, std::string_view bytes);
/// Binary, positions and perhaps normals as floats, then the faces.
[[nodiscard]] Vetted vet_ply(std::string_view name, std::string_view bytes);
/// OFF or NOFF, no colours.
[[nodiscard]] Vetted vet_off(std::string_view name, std::string_view bytes);
/// Binary; the corners of a triangle differ.
[[nodiscard]] Vetted vet_stl(std::string_view name, std::string_view bytes);

}  // namespace nicol::geometry
