// SPDX-License-Identifier: MIT
// Parsers that check a mesh file and rewrite it for OpenMesh's readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nicol::geometry {

// OpenMesh's readers do not check their input: a PLY header without end_header loops for ever, a list length
// may claim all memory, double coordinates become zeros, faulty lines are skipped, material files are opened
// wherever they point. Every file is therefore parsed here first and rewritten in the simplest form of its
// format.

/// A checked and rewritten file.
struct ParsedFile {
    std::string bytes;
    std::string suffix;        ///< of the reader for these bytes: ".obj", ".ply" or ".stl"
    std::size_t vertices = 0;  ///< 0 for STL, whose vertices are known only once equal ones are merged
    std::size_t faces = 0;
};

// `name` begins every message. All throw Error(invalid_file), or Error(unsupported) for a well-formed file
// that holds something other than polygons; the message names the line, vertex or face (0-based).

/// Keeps v, vn and f; indices become positive and are in range; the corners of a face differ.
[[nodiscard]] ParsedFile parse_obj(std::string_view name, std::string_view bytes);
/// Binary: positions and, if the file has them, normals as floats, then the faces.
[[nodiscard]] ParsedFile parse_ply(std::string_view name, std::string_view bytes);
/// Rewritten as PLY: OpenMesh's OFF reader learns from the file's name, not from a stream, whether there are
/// normals.
[[nodiscard]] ParsedFile parse_off(std::string_view name, std::string_view bytes);
/// Binary; the corners of a triangle differ.
[[nodiscard]] ParsedFile parse_stl(std::string_view name, std::string_view bytes);

/// Writes a binary PLY file with positions, optional normals and polygons.
class PlyWriter {
public:
    explicit PlyWriter(bool normals) : normals_(normals) {}
    void add_number(float x);
    void begin_face(std::uint32_t corners);
    void add_index(std::uint32_t index);
    [[nodiscard]] ParsedFile file() const;

private:
    bool normals_;
    std::string vertices_;
    std::string faces_;
    std::size_t face_count_ = 0;
};

}  // namespace nicol::geometry
