// SPDX-License-Identifier: MIT
// Tests of untidy mesh files, and of vertex data beside positions and normals.
#include <cstring>

#include "geometry/measures.hpp"
#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using nicol::load_mesh;
using nicol::Mesh;

namespace {

struct Loaded {
    Mesh mesh;
    std::vector<std::string> notices;
};

Loaded load(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    Loaded out;
    const auto file = folder.write(name, bytes);
    out.mesh = load_mesh(file, [&](const std::string& text) {
        REQUIRE(text.starts_with(file.string() + ": left out: "));
        out.notices.push_back(text.substr(file.string().size() + 12));
    });
    return out;
}

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string ply = "ply\nformat ascii 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list uchar int vertex_indices\n";
const std::string stl_facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

}  // namespace

TEST_CASE("what other programs read is read, and one notice counts what was left out") {
    struct Row {
        std::string name;
        std::string bytes;
        std::size_t triangles;
        std::size_t vertices;
        std::string notice;
    };
    const std::vector<Row> rows{
        {"a.obj", corners + "f 1 2 3 4\n", 2, 4, ""},
        {"a.obj", corners + "f 1 2 3 4\nf 1 2 2\nf 1 1 1\n", 2, 4, "2 triangles without area"},
        {"a.obj", corners + "f 1 1 2 3 3 4\n", 2, 4, "2 triangles without area"},
        {"a.obj", corners + "v 9 9 9\nv 8 8 8\nf 1 2 3\n", 1, 3, "3 vertices of no face"},
        {"a.obj", corners + "f 1 2\nf 1\nf 1 2 3 4\n", 2, 4, "2 faces of fewer than 3 corners"},
        {"a.obj", corners + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n", 2, 4,
         "2 choices of a material (usemtl)"},
        {"a.obj", corners + "vn nan 0 1\nf 1//1 2//1 3//1 4//1\n", 2, 4, "1 normals that are not finite"},
        {"a.obj", corners + "f 1/7 2/8 3/9 4\n", 2, 4, "3 texture coordinates that the file does not have"},
        {"a.obj", "v 0 0 0e\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1, 3, "1 characters behind numbers"},
        {"a.obj", corners + "f 1 2 3\nf 1 2 3\nf 3 2 1\n", 3, 3, "1 vertices of no face"},
        {"a.obj", corners + "o one\ng two\ns 1\nf -4 -3 -2\no three\nf -4 -2 -1", 2, 4, ""},
        {"a.obj", "\xEF\xBB\xBF" + corners + "f 1 2 3 4", 2, 4, ""},
        {"a.obj", "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r", 1, 3, ""},
        {"a.obj", "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\n\r\nf 1 2 3\r\n", 1, 3, ""},
        {"a.ply",
         ply + "obj_info made by hand\nof some program\ncomment\nelement vertex 4\n" + xyz +
             "element face 2\n" + list +
             "element edge 1\nproperty int a\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" +
             "4 0 1 2 3\n3 0 0 1\n7\n",
         2, 4, "1 unknown lines of the header, 1 triangles without area"},
        {"a.ply",
         ply + "element face 1\n" + list + "element vertex 4\n" + xyz +
             "end_header\n4 0 1 2 3\n0 0 0\n1 0 0\n1 1 "
             "0\n0 1 0",
         2, 4, ""},
        {"a.ply",
         ply + "element vertex 3\n" + xyz +
             "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n" + list +
             "end_header\n0 0 0 nan nan nan\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
         1, 3, "1 normals that are not finite"},
        {"a.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n7 7 7\n4 0 1 2 3\n2 0 1\n3 0 1 1\n", 2, 4,
         "1 faces of fewer than 3 corners, 1 vertices of no face, 1 triangles without area"},
        {"a.stl",
         "solid x\n" + stl_facet +
             "facet normal nan nan nan\nouter loop\nvertex 1 0 0\nvertex 1 0 0\nvertex 0 1 "
             "0\nendloop\nendfacet\nendsolid x\nsolid y\nendsolid",
         1, 3, "1 triangles without area"}};
    for (const Row& row : rows) {
        CAPTURE(row.bytes);
        const Loaded found = load(row.name, row.bytes);
        CHECK(found.mesh.triangles.size() == row.triangles);
        CHECK(found.mesh.positions.size() == row.vertices);
        CHECK(found.notices == (row.notice.empty() ? std::vector<std::string>{} : std::vector{row.notice}));
        for (const glm::vec3& n : found.mesh.normals) CHECK(std::abs(n.z) == 1);
    }
}

TEST_CASE("texture coordinates and colours are kept, through every format that has them") {
    const std::string uv_rgb =
        "property float u\nproperty float v\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const std::string st_rgb =
        "property float blue\nproperty float green\nproperty float red\n"
        "property float s\nproperty float t\n";
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.obj",
         "v 0 0 0 1 0 0\nv 1 0 0 0 0.2 0\nv 0 1 0 0 0 1\nvt 0 0\nvt 0.5 0 0\nvt 0 1\nf 1/1 2/2 3/3\n"},
        {"a.ply", ply + "element vertex 3\n" + xyz + uv_rgb + "element face 1\n" + list +
                      "end_header\n0 0 0 0 0 255 0 0\n1 0 0 0.5 0 0 51 0\n0 1 0 0 1 0 0 255\n3 0 1 2\n"},
        {"a.ply", ply + "element vertex 3\n" + xyz + st_rgb + "element face 1\n" + list +
                      "end_header\n0 0 0 0 0 1 0 0\n1 0 0 0 0.2 0 0.5 0\n0 1 0 1 0 0 0 1\n3 0 1 2\n"},
        {"a.off",
         "STCOFF\n3 1 0\n0 0 0 255 0 0 255 0 0\n1 0 0 0 0.2 0 1 0.5 0\n0 1 0 0 0 1 1 0 1\n3 0 1 2\n"}};
    // Returns the texture coordinates of a triangle's corners.
    const auto texcoords = [](const Mesh& mesh, std::size_t triangle) {
        std::vector<glm::vec2> out;
        for (glm::length_t k = 0; k < 3; ++k)
            out.push_back(mesh.texcoords.at(mesh.texcoord_triangles.at(triangle)[k]));
        return out;
    };
    for (const auto& [name, bytes] : files) {
        CAPTURE(bytes);
        const Mesh mesh = load(name, bytes).mesh;
        CHECK(texcoords(mesh, 0) == std::vector<glm::vec2>{{0, 0}, {0.5F, 0}, {0, 1}});
        CHECK(mesh.colors == std::vector<glm::vec3>{{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}});
    }
    // MeshLab stores the coordinates of corners in a list property of the face.
    const Mesh wedges = load("a.ply", ply + "element vertex 4\n" + xyz + "element face 2\n" + list +
                                          "property list uchar float texcoord\nend_header\n"
                                          "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                          "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0.5 1\n")
                            .mesh;
    CHECK(wedges.positions.size() == 4);
    CHECK(texcoords(wedges, 0) == std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 1}});
    CHECK(texcoords(wedges, 1) == std::vector<glm::vec2>{{0, 0}, {1, 1}, {0.5F, 1}});
    // Texture coordinates stay with their corners.
    for (const bool flipped : {false, true}) {
        Mesh other =
            load("a.obj", corners + "vt 1 1\nvt 2 2\nvt 3 3\nf 1/1 1/2 3/3\nf 1/1 2/2 3/3\nf 4 1 2\n").mesh;
        if (flipped) flip_normals(other);
        CHECK(texcoords(nicol::with_face_normals(other), 0) ==
              (flipped ? std::vector<glm::vec2>{{1, 1}, {3, 3}, {2, 2}}
                       : std::vector<glm::vec2>{{1, 1}, {2, 2}, {3, 3}}));
        CHECK(texcoords(other, 1) == std::vector<glm::vec2>(3, glm::vec2(0)));
    }
    CHECK(load("a.obj", corners + "f 1 2 3\n").mesh.texcoords.empty());
    CHECK(load("a.obj", corners + "f 1 2 3\n").mesh.colors.empty());
}

TEST_CASE("a seam of texture coordinates splits no vertices") {
    // A roof whose sides have separate texture coordinates.
    const std::string roof = "v -1 0 -1\nv -1 0 1\nv 0 1 1\nv 0 1 -1\nv 1 0 1\nv 1 0 -1\nvt 0 0\nvt 1 1\n";
    const Mesh seam = load("a.obj", roof + "f 1/1 2/1 3/1 4/1\nf 4/2 3/2 5/2 6/2\n").mesh;
    const Mesh plain = load("a.obj", roof + "f 1 2 3 4\nf 4 3 5 6\n").mesh;
    CHECK(seam.positions == plain.positions);
    CHECK(seam.normals == plain.normals);
    CHECK(seam.triangles == plain.triangles);
    CHECK(seam.normals[2] == glm::vec3(0, 1, 0));
}

TEST_CASE("polygons of any shape are covered once") {
    const auto polygon = [](const std::vector<glm::dvec2>& points) {
        std::string text;
        std::string face = "f";
        // The polygon lies on a slanted plane, so that no axis is special. Its area is sqrt(1.25) times that
        // of its projection.
        for (std::size_t i = 0; i < points.size(); ++i) {
            text += "v " + std::to_string(points[i].x) + " " + std::to_string(points[i].y) + " " +
                    std::to_string(0.5 * points[i].x) + "\n";
            face += " " + std::to_string(i + 1);
        }
        return load("a.obj", text + face + "\n").mesh;
    };
    const auto check = [&](const std::vector<glm::dvec2>& points) {
        double twice = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2 a = points[i];
            const glm::dvec2 b = points[(i + 1) % points.size()];
            twice += a.x * b.y - a.y * b.x;
        }
        const Mesh mesh = polygon(points);
        CAPTURE(points.size());
        CHECK(mesh.triangles.size() == points.size() - 2);
        CHECK(area(mesh) == doctest::Approx(std::abs(twice) / 2 * std::sqrt(1.25)).epsilon(1e-5));
        const float side = twice > 0 ? 1.0F : -1.0F;
        for (const glm::vec3& n : mesh.normals)
            CHECK(glm::distance(n, side * glm::normalize(glm::vec3(-0.5F, 0, 1))) < 0.05F);
    };
    // Tests stars and combs, each star in both orientations.
    std::mt19937 random(3);
    for (int n = 5; n < 200; n += 13) {
        std::vector<glm::dvec2> star;
        std::vector<glm::dvec2> comb{{0, 0}};
        for (int i = 0; i < n; ++i) {
            const double radius = 0.1 + std::uniform_real_distribution<double>(0, 1)(random);
            star.push_back(radius * glm::dvec2(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)));
            comb.emplace_back(i + 1.0, i % 2 == 0 ? 0.1 : 5 + 0.01 * i);
        }
        comb.emplace_back(n + 1.0, 0.0);
        std::ranges::reverse(comb);
        check(star);
        check(comb);
        std::ranges::reverse(star);
        check(star);
    }
    // A square with a square hole, joined by a bridge that is traversed twice.
    check({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
    // Cutting a polygon that crosses itself still ends.
    CHECK(polygon({{0, 0}, {4, 4}, {4, 0}, {0, 3}, {1, -1}}).triangles.size() == 3);
}
