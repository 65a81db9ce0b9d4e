// SPDX-License-Identifier: MIT
// Checks a mesh file before OpenMesh reads it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
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
    std::string suffix;        ///< of the reader for these bytes: ".obj", ".ply" or ".stl"
    std::size_t vertices = 0;  ///< 0 for STL, whose vertices are only known once equal ones are merged
    std::size_t faces = 0;
};

// `name` begins every message. All throw Error(invalid_file), or Error(unsupported) for what is well-formed
// but not polygons, with the line, vertex or face (0-based) at fault.

/// Only v, vn and f; indices positive and in range; the corners of a face differ.
[[nodiscard]] Vetted vet_obj(std::string_view name, std::string_view bytes);
/// Binary, positions and perhaps normals as floats, then the faces.
[[nodiscard]] Vetted vet_ply(std::string_view name, std::string_view bytes);
/// Comes out as PLY: OpenMesh's OFF reader learns from a file's name, not from a stream, whether there are
/// normals.
[[nodiscard]] Vetted vet_off(std::string_view name, std::string_view bytes);
/// Binary; the corners of a triangle differ.
[[nodiscard]] Vetted vet_stl(std::string_view name, std::string_view bytes);

/// Positions, perhaps normals, and polygons as a binary PLY of nothing else.
class PlainPly {
public:
    explicit PlainPly(bool normals) : normals_(normals) {}
    void add_number(float x) { append(vertices_, x); }
    void begin_face(std::uint32_t corners) { ++faces_count_, append(faces_, corners); }
    void add_index(std::uint32_t index) { append(faces_, index); }
    [[nodiscard]] Vetted finished() const;

private:
    template <class T>
    static void append(std::string& bytes, T value) {
        const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
        bytes.append(raw.data(), raw.size());
    }

    bool normals_;
    std::string vertices_;
    std::string faces_;
    std::size_t faces_count_ = 0;
};

}  // namespace nicol::geometry
