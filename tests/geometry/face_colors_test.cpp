// SPDX-License-Identifier: MIT
// Tests of face colours, from files to triangles.
#include <algorithm>
#include <bit>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using nicol::load_mesh;
using nicol::Mesh;

namespace {

const std::vector<glm::vec3> red_red_blue{{1, 0, 0}, {1, 0, 0}, {0, 0.2F, 1}};

Mesh load(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    return load_mesh(folder.write(name, bytes));
}

template <class Number>
std::string raw(Number value, bool big) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if (big != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    return {bytes.begin(), bytes.end()};
}

/// Returns the header of a file with the four vertices of a square. Its faces follow.
std::string ply(const std::string& format, int faces, const std::string& properties) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(faces) + "\n" + properties + "end_header\n";
}
const std::string list = "property list uchar int vertex_indices\n";
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// Returns a red quadrilateral, a face that is left out, and a blue triangle.
std::string binary(bool big) {
    std::string out = ply(big ? "binary_big_endian" : "binary_little_endian", 3,
                          "property uchar red\nproperty ushort green\n" + list + "property float blue\n");
    for (const float x : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.0F})
        out += raw(x, big);
    const auto face = [&](std::uint8_t red, std::uint16_t green, const std::vector<std::int32_t>& corners,
                          float blue) {
        out += raw(red, big) + raw(green, big) + raw(static_cast<std::uint8_t>(corners.size()), big);
        for (const std::int32_t corner : corners) out += raw(corner, big);
        out += raw(blue, big);
    };
    face(255, 0, {0, 1, 2, 3}, 0);
    face(0, 65535, {0, 1}, 0);
    face(0, 13107, {0, 2, 3}, 1);
    return out;
}

}  // namespace

TEST_CASE("colours of faces are read, and stay with the triangles of theirs") {
    const std::string rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const std::string reversed = "property float b\nproperty float g\nproperty float r\n";
    const std::string numbered =
        "property double color_0\nproperty double color_1\nproperty double color_2\nproperty int flags\n";
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.ply",
         ply("ascii", 3, list + rgb) + square + "4 0 1 2 3 255 0 0\n3 0 1 1 0 255 0\n3 0 2 3 0 51 255\n"},
        {"a.ply",
         ply("ascii", 3, reversed + list) + square + "0 0 1 4 0 1 2 3\n0 1 0 2 0 1\n1 0.2 0 3 0 2 3\n"},
        {"a.ply", ply("ascii", 2, list + numbered) + square + "4 0 1 2 3 1 0 0 7\n3 0 2 3 0 0.2 1 7\n"},
        {"little.ply", binary(false)},
        {"big.ply", binary(true)},
        {"a.off", "OFF\n4 4 0\n" + square +
                      "4 0 1 2 3 255 0 0\n3 0 1 1 0 255 0\n2 0 1 0 255 0\n3 0 2 3  0 51 255 128\n"},
        {"a.off", "OFF\n4 2 0\n" + square + "4 0 1 2 3 1.0 0 0\n3 0 2 3  0 0.2 1 0.5\n"}};
    for (const auto& [name, bytes] : files) {
        CAPTURE(bytes);
        const Mesh mesh = load(name, bytes);
        CHECK(mesh.triangles.size() == 3);
        CHECK(mesh.face_colors == red_red_blue);
        CHECK(mesh.colors.empty());
    }
}

TEST_CASE("attributes of PLY files become the colours that are asked for") {
    const std::string vertex =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
    const TemporaryFolder folder;
    struct Case {
        std::string properties;  ///< properties of vertices and, in the place of a list, of faces
        std::vector<glm::vec3> values;
    };
    const std::vector<glm::vec3> one{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, none;
    // Mitsuba 3.9 has the same attributes, but for those that it leaves out with a warning.
    for (const Case& c :
         {Case{"property float weight_0\n", one}, Case{"property uchar weight_x\n", one},
          Case{"property float other_0\nproperty float weight_1\n",
               {{10, 10, 10}, {20, 20, 20}, {30, 30, 30}}},
          Case{"property float weight_0\nproperty float weight_1\nproperty float weight_2\n",
               {{1, 10, 100}, {2, 20, 200}, {3, 30, 300}}},
          Case{"property float weight_0\nproperty float weight_1\n", none},
          Case{"property float weight\n", none}, Case{"property float vertex_weight_0\n", none},
          Case{"property uchar red\nproperty uchar green\nproperty uchar blue\n", none}}) {
        CAPTURE(c.properties);
        const auto count = std::ranges::count(c.properties, '\n');
        const auto row = [&](int i) {
            std::string text;
            for (int k = 0, scale = 1; k < count; ++k, scale *= 10)
                text += " " + std::to_string(std::min(scale * (i + 1), 300));
            return text + "\n";
        };
        const Mesh of_vertices =
            load_mesh(folder.write("v.ply", vertex + c.properties + faces + "end_header\n0 0 0" + row(0) +
                                                "1 0 0" + row(1) + "0 1 0" + row(2) + "3 0 1 2\n"),
                      {}, 0, {}, {.vertices = "weight"});
        CHECK(of_vertices.colors == c.values);
        const Mesh of_faces =
            load_mesh(folder.write("f.ply", vertex + faces + c.properties +
                                                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2" + row(0)),
                      {}, 0, {}, {.faces = "weight"});
        CHECK(of_faces.face_colors == (c.values.empty() ? none : std::vector<glm::vec3>{c.values.front()}));
    }
    const std::string rgb = "property float warm_r\nproperty float warm_g\nproperty float warm_b\n";
    const auto file = folder.write(
        "c.ply", vertex + rgb + faces + "end_header\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 " + "7 8 9\n3 0 1 2\n");
    CHECK(load_mesh(file, {}, 0, {}, {.vertices = "warm_color"}).colors.at(1) == glm::vec3(4, 5, 6));
    CHECK(load_mesh(file).colors.empty());
    // Other formats have no other attributes.
    const auto obj = folder.write("c.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
    CHECK(load_mesh(obj).colors.size() == 3);
    CHECK(load_mesh(obj, {}, 0, {}, {.vertices = "weight"}).colors.empty());
}

TEST_CASE("colours of some faces, or of some kind") {
    using Colors = std::vector<glm::vec3>;
    const struct {
        const char* name;
        std::string bytes;
        Colors expected;
    } rows[] = {
        // These properties do not count: two of three colours, a colour list, properties of vertices.
        {"a.ply",
         ply("ascii", 1, list + "property float red\nproperty float blue\n") + square + "3 0 1 2 1 1\n",
         {}},
        {"a.ply",
         ply("ascii", 1,
             list + "property list uchar float red\nproperty float green\nproperty float blue\n") +
             square + "3 0 1 2 1 1 1 1\n",
         {}},
        {"a.ply",
         ply("ascii", 1, list + "property float x\nproperty float y\nproperty float nx\n") + square +
             "3 0 1 2 nan 1 1\n",
         {}},
        {"a.ply",
         ply("ascii", 1, list + "property float r\nproperty float g\nproperty float b\n") + square +
             "3 0 1 2 1 nan 1\n",
         {glm::vec3(0)}},
        {"a.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 3\n", {}},
        // The faces have an index of a missing colour table, no colour, a colour, and no colour.
        {"a.off",
         "OFF\n4 4 0\n" + square + "3 0 1 2 7\n3 0 2 3\n3 0 1 2 0 0 1\n3 0 2 3",
         {glm::vec3(1), glm::vec3(1), glm::vec3(0, 0, 1), glm::vec3(1)}}};
    for (const auto& row : rows) {
        CAPTURE(row.bytes);
        CHECK(load(row.name, row.bytes).face_colors == row.expected);
    }
}

TEST_CASE("vertices and faces of one file may both have colours") {
    const Mesh mesh = load("a.ply",
                           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nproperty float r\nproperty float g\nproperty float b\n"
                           "element face 1\nproperty list uchar int vertex_indices\nproperty float r\n"
                           "property float g\nproperty float b\nend_header\n"
                           "0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2 0.5 0.25 0.125\n");
    CHECK(mesh.colors == std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(mesh.face_colors == std::vector<glm::vec3>{{0.5F, 0.25F, 0.125F}});
}

TEST_CASE("files that end within the colour of a face are refused") {
    const std::string bytes = binary(false);
    for (std::size_t left_out = 1; left_out < 8; ++left_out) {
        const TemporaryFolder folder;
        const auto file = folder.write("a.ply", bytes.substr(0, bytes.size() - left_out));
        check_error(nicol::ErrorCode::invalid_file, CALL(load_mesh(file)), "ends within face 2 (0-based)");
    }
    const TemporaryFolder folder;
    const auto text = folder.write("a.ply", ply("ascii", 1,
                                                list + "property uchar red\nproperty uchar green\n"
                                                       "property uchar blue\n") +
                                                square + "3 0 1 2 255 0\n");
    check_error(nicol::ErrorCode::invalid_file, CALL(load_mesh(text)), "ends where face 0 (0-based)");
}

TEST_CASE("colours of faces stay with them through what becomes of a mesh") {
    const Mesh mesh = load("a.ply", binary(false));
    Mesh flipped = mesh;
    nicol::flip_normals(flipped);
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    for (const Mesh& other : {flipped, nicol::transformed(mesh, mirror), nicol::with_face_normals(mesh)}) {
        CHECK(other.triangles.size() == 3);
        CHECK(other.face_colors == red_red_blue);
    }
    Mesh with_flat = mesh;
    with_flat.triangles.insert(with_flat.triangles.begin() + 2, glm::uvec3(0, 1, 1));
    with_flat.face_colors.insert(with_flat.face_colors.begin() + 2, glm::vec3(0, 1, 0));
    CHECK(nicol::validate(with_flat, "mesh") == 1);
    CHECK(with_flat.face_colors == red_red_blue);
}
