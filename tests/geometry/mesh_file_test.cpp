// SPDX-License-Identifier: MIT
// Tests of mesh files: one surface through every format.
#include <cstdio>
#include <iostream>
#include <locale>
#include <map>
#include <sstream>
#include <thread>

#include "geometry/measures.hpp"
#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using nicol::load_mesh;
using nicol::Mesh;

namespace {

template <class T>
std::string raw(T value, bool big = false) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big) std::ranges::reverse(bytes);
    return bytes;
}

// Corners of a unit cube, and its sides counter-clockwise from outside.
constexpr std::array<std::array<int, 3>, 8> cube_points = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr std::array<std::array<int, 4>, 6> cube_sides = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}}};

std::string obj_cube() {
    std::ostringstream out;
    for (const auto& p : cube_points) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& s : cube_sides)
        out << "f " << s[0] + 1 << ' ' << s[1] + 1 << ' ' << s[2] + 1 << ' ' << s[3] + 1 << '\n';
    return out.str();
}

std::string off_cube() {
    std::ostringstream out;
    out << "OFF # a comment\n8 6 12\n";
    for (const auto& p : cube_points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& s : cube_sides)
        out << "4 " << s[0] << ' ' << s[1] << ' ' << s[2] << ' ' << s[3] << " 255 0 0\n";
    return out.str();
}

std::string ply_text_cube() {
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\ncomment x\nelement vertex 8\nproperty float x\nproperty float y\nproperty "
           "float z\n"
           "property uchar red\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& p : cube_points) out << p[0] << ' ' << p[1] << ' ' << p[2] << " 255\n";
    for (const auto& s : cube_sides) out << "4 " << s[0] << ' ' << s[1] << ' ' << s[2] << ' ' << s[3] << '\n';
    return out.str();
}

/// Returns a file with doubles, an unused list before the index list, and unknown elements.
std::string ply_binary_cube(bool big) {
    std::string out =
        std::string("ply\r\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\r\nelement note 2\r\nproperty list uchar short s\r\nelement vertex 8\r\n"
        "property double x\r\nproperty double y\r\nproperty double z\r\nelement face 6\r\n"
        "property list uchar float weights\r\nproperty list uint ushort vertex_index\r\nend_header\r\n";
    for (int i = 0; i < 2; ++i) out += raw<std::uint8_t>(1) + raw<std::int16_t>(7, big);
    for (const auto& p : cube_points)
        for (const int x : p) out += raw<double>(x, big);
    for (const auto& s : cube_sides) {
        out += raw<std::uint8_t>(1) + raw<float>(0.5f, big) + raw<std::uint32_t>(4, big);
        for (const int i : s) out += raw<std::uint16_t>(static_cast<std::uint16_t>(i), big);
    }
    return out;
}

using Triangle = std::array<std::array<float, 3>, 3>;

std::vector<Triangle> cube_triangles() {
    std::vector<Triangle> triangles;
    for (const auto& s : cube_sides)
        for (const auto& corners : {std::array{s[0], s[1], s[2]}, std::array{s[0], s[2], s[3]}}) {
            Triangle t{};
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    t[i][k] = static_cast<float>(cube_points[static_cast<std::size_t>(corners[i])][k]);
            triangles.push_back(t);
        }
    return triangles;
}

std::string stl_text(const std::vector<Triangle>& triangles) {
    std::ostringstream out;
    out << "solid a name with words\n";
    for (const Triangle& t : triangles) {
        out << " facet normal nan nan nan\n  outer loop\n";
        for (const auto& p : t) out << "   vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
        out << "  endloop\n endfacet\n";
    }
    out << "endsolid a name with words\n";
    return out.str();
}

std::string stl_binary(const std::vector<Triangle>& triangles) {
    std::string out = "solid, though it is binary";
    out.resize(80);
    out += raw(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& t : triangles) {
        out.append(12, '\0');
        for (const auto& p : t)
            for (const float x : p) out += raw(x);
        out.append(2, '\0');
    }
    return out;
}

std::vector<Triangle> facets_of(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (const glm::uvec3& t : mesh.triangles) {
        Triangle triangle{};
        for (glm::length_t i = 0; i < 3; ++i)
            for (glm::length_t k = 0; k < 3; ++k)
                triangle[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = mesh.positions[t[i]][k];
        triangles.push_back(triangle);
    }
    return triangles;
}

}  // namespace

TEST_CASE("every format gives the same cube, with its front outside") {
    const TemporaryFolder folder;
    for (const auto& [name, bytes] :
         std::map<std::string, std::string>{{"cube.obj", obj_cube()},
                                            {"cube.OFF", off_cube()},
                                            {"text.ply", ply_text_cube()},
                                            {"little.ply", ply_binary_cube(false)},
                                            {"big.ply", ply_binary_cube(true)},
                                            {"text.stl", stl_text(cube_triangles())},
                                            {"binary.stl", stl_binary(cube_triangles())}}) {
        CAPTURE(name);
        const Mesh mesh = load_mesh(folder.write(name, bytes));
        CHECK(mesh.triangles.size() == 12);
        CHECK(area(mesh) == doctest::Approx(6.0));
        CHECK(volume(mesh) == doctest::Approx(1.0));
        REQUIRE(mesh.normals.size() == mesh.positions.size());
        const bool hard = name.ends_with(".stl");
        CHECK(mesh.positions.size() == (hard ? 24 : 8));
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            CHECK(glm::length(mesh.normals[v]) == doctest::Approx(1.0));
            const glm::vec3 outward = glm::normalize(mesh.positions[v] - 0.5f);
            // The normal of a smooth corner points along the diagonal, and that of a hard corner along an
            // axis.
            CHECK(glm::dot(mesh.normals[v], outward) == doctest::Approx(hard ? 1.0 / std::sqrt(3.0) : 1.0));
        }
    }
}

TEST_CASE("an OBJ vertex splits where its corners name different normals, and only there") {
    const TemporaryFolder folder;
    const std::string folded =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvn 0 0 2\nvn 0 -1 0\n"
        "f 1//1 2//1 3//1\nf 1/9/1 3/9/1 4/9/1\nf 1//-1 5//-1 2//-1\n";
    const Mesh mesh = load_mesh(folder.write("fold.obj", folded));
    REQUIRE(mesh.positions.size() == 7);
    CHECK(mesh.triangles.size() == 3);
    for (std::size_t v = 0; v < 5; ++v)
        CHECK(mesh.normals[v] == (v == 4 ? glm::vec3(0, -1, 0) : glm::vec3(0, 0, 1)));
    CHECK(mesh.positions[5] == glm::vec3(0, 0, 0));
    CHECK(mesh.positions[6] == glm::vec3(1, 0, 0));
    CHECK(mesh.normals[5] == glm::vec3(0, -1, 0));
    CHECK(mesh.normals[6] == glm::vec3(0, -1, 0));
    CHECK(mesh.triangles[2] == glm::uvec3(5, 4, 6));
}

TEST_CASE("normals of PLY and OFF vertices are kept and made unit") {
    const TemporaryFolder folder;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 3 4 0 0 0\n0 0 2 1 0 0\n0 0 0 0 1 0\n3 0 1 "
        "2\n";
    const std::string off = "NOFF\n3 1 0\n0 0 0 0 3 4\n1 0 0 0 0 2\n0 1 0 0 0 0\n3 0 1 2\n";
    for (const auto& file : {folder.write("n.ply", ply), folder.write("n.off", off)}) {
        const Mesh mesh = load_mesh(file);
        CHECK(mesh.positions[1] == glm::vec3(1, 0, 0));
        CHECK(glm::distance(mesh.normals[0], glm::vec3(0, 0.6f, 0.8f)) < 1e-6f);
        CHECK(mesh.normals[1] == glm::vec3(0, 0, 1));
        CHECK(mesh.normals[2] == glm::vec3(0, 0, 1));  // zero length in the file
    }
}

TEST_CASE("faces that a half-edge mesh would refuse are kept") {
    const TemporaryFolder folder;
    // Three faces share one edge, and a manifold would have to flip two of them.
    const Mesh mesh = load_mesh(
        folder.write("fan.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"));
    CHECK(mesh.triangles.size() == 3);
    CHECK(area(mesh) == doctest::Approx(1.5));
}

TEST_CASE("polygons with a notch or with corners on a straight side are covered once") {
    const TemporaryFolder folder;
    const Mesh notch =
        load_mesh(folder.write("notch.obj", "v 0 0 0\nv 4 -2 0\nv 1 0 0\nv 4 2 0\nf 2 3 4 1\n"));
    CHECK(area(notch) == doctest::Approx(2.0));
    const Mesh straight =
        load_mesh(folder.write("straight.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n"));
    CHECK(straight.triangles.size() == 3);
    CHECK(area(straight) == doctest::Approx(4.0));
}

TEST_CASE("a curved STL is smooth, a sharp one is not") {
    const TemporaryFolder folder;
    const Mesh sphere = nicol::make_sphere();
    const Mesh mesh = load_mesh(folder.write("sphere.stl", stl_binary(facets_of(sphere))));
    CHECK(mesh.positions.size() == sphere.positions.size());
    double worst = 1.0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        worst = std::min(worst, double(glm::dot(mesh.normals[v], mesh.positions[v])));
    CHECK(worst > 0.99999);
}

TEST_CASE("smooth STL normals do not depend on how a face is cut") {
    // A shallow roof whose front side is one triangle at the left end of the ridge and two at the right.
    const auto roof = [](bool other_diagonal) {
        const std::array<float, 3> a = {0, 0, 0.1f};
        const std::array<float, 3> b = {1, 0, 0.1f};
        const std::array<float, 3> c = {0, -1, 0};
        const std::array<float, 3> d = {1, -1, 0};
        std::vector<Triangle> triangles = {{{a, b, {1, 1, 0}}}, {{a, {1, 1, 0}, {0, 1, 0}}}};
        if (other_diagonal)
            triangles.insert(triangles.end(), {{{b, a, c}}, {{b, c, d}}});
        else
            triangles.insert(triangles.end(), {{{a, c, d}}, {{a, d, b}}});
        return stl_binary(triangles);
    };
    const TemporaryFolder folder;
    for (const bool other_diagonal : {false, true}) {
        const Mesh mesh = load_mesh(folder.write("roof.stl", roof(other_diagonal)));
        REQUIRE(mesh.positions.size() == 6);
        for (std::size_t v = 0; v < 6; ++v)
            if (mesh.positions[v].y == 0.0f)
                CHECK(glm::distance(mesh.normals[v], glm::vec3(0, 0, 1)) < 1e-6f);
    }
}

TEST_CASE("an OBJ face without normals does not take those of its neighbour") {
    const TemporaryFolder folder;
    const Mesh mesh = load_mesh(folder.write(
        "half.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 4 2\n"));
    REQUIRE(mesh.positions.size() == 6);
    for (glm::length_t i = 0; i < 3; ++i) {
        CHECK(mesh.normals[mesh.triangles[0][i]] == glm::vec3(1, 0, 0));
        CHECK(mesh.normals[mesh.triangles[1][i]] == glm::vec3(0, 1, 0));
    }
}

TEST_CASE("whatever else an OBJ holds does no harm") {
    const TemporaryFolder folder;
    const std::string text =
        "\xEF\xBB\xBF# comment\r\nmtllib ../../../../../../dev/zero\r\no thing\r\nv +1.5e0 0 0 1\r\nv 0 1 0 "
        "0.5 0.5 0.5\r\n"
        "v 0 0 1\r\nvt 0 0\r\nusemtl none\r\ns off\r\nl 1 2\r\nf 1/1 \\\r\n  2/1 3/1 # three\r\n";
    const Mesh mesh = load_mesh(folder.write("more.obj", text));
    CHECK(mesh.positions.size() == 3);
    CHECK(mesh.positions[0] == glm::vec3(1.5f, 0, 0));
    CHECK(mesh.triangles.size() == 1);
}

TEST_CASE("positions come through to the last bit, in any locale of the host") {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const TemporaryFolder folder;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> digits(-1.0f, 1.0f);
    std::vector<glm::vec3> points;
    std::string obj;
    std::string off = "OFF\n300 100 0\n";
    for (int i = 0; i < 300; ++i) {
        const float scale = std::pow(10.0f, static_cast<float>(i % 60 - 30));
        points.push_back(scale * glm::vec3{digits(random), digits(random), digits(random)});
        std::array<char, 100> line{};
        std::snprintf(line.data(), line.size(), "%.9g %.9g %.9g\n", double(points.back().x),
                      double(points.back().y), double(points.back().z));
        obj += "v " + std::string(line.data());
        off += line.data();
    }
    for (int i = 0; i < 300; i += 3) {
        obj +=
            "f " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " + std::to_string(i + 3) + "\n";
        off += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
    }
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const Mesh from_obj = load_mesh(folder.write("a.obj", obj));
    const Mesh from_off = load_mesh(folder.write("a.off", off));
    std::locale::global(before);
    CHECK(from_obj.positions == points);
    CHECK(from_off.positions == points);
}

TEST_CASE("OpenMesh writes nothing to the error stream") {
    const TemporaryFolder folder;
    std::ostringstream captured;
    std::streambuf* const before = std::cerr.rdbuf(captured.rdbuf());
    // Four faces share one edge, which no half-edge mesh accepts.
    std::vector<Triangle> fan;
    for (const float x : {1.0F, 2.0F, -1.0F, -2.0F}) fan.push_back({{{0, 0, 0}, {0, 0, 1}, {x, 1, 0}}});
    const Mesh mesh = load_mesh(folder.write("fan.stl", stl_binary(fan)));
    std::cerr.rdbuf(before);
    CHECK(captured.str().empty());
    CHECK(mesh.triangles.size() == 4);
}

TEST_CASE("several threads may load at once") {
    // The mesh is large enough that the threads run OpenMesh at the same time.
    const Mesh sphere = nicol::make_sphere();
    const TemporaryFolder folder;
    std::ostringstream text;
    text << "OFF\n" << sphere.positions.size() << ' ' << sphere.triangles.size() << " 0\n";
    for (const glm::vec3& p : sphere.positions) text << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (const glm::uvec3& t : sphere.triangles) text << "3 " << t.x << ' ' << t.y << ' ' << t.z << '\n';
    const std::array files{folder.write("sphere.off", text.str()),
                           folder.write("sphere.stl", stl_binary(facets_of(sphere)))};
    std::array<int, 4> loaded{};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < loaded.size(); ++i)
        threads.emplace_back([&, i] {
            for (int k = 0; k < 5; ++k)
                loaded[i] += load_mesh(files[i % 2]).triangles.size() == sphere.triangles.size();
        });
    for (std::thread& thread : threads) thread.join();
    for (const int count : loaded) CHECK(count == 5);
}

TEST_CASE("the scene of the paper loads") {
    const std::filesystem::path file = test_data("polarsh/buddha.obj");
    if (file.empty()) return;
    const Mesh buddha = load_mesh(file);
    CHECK(buddha.positions.size() == 19002);
    CHECK(buddha.triangles.size() == 38034);
    const Mesh plane = load_mesh(file.parent_path() / "plane.obj");
    CHECK(plane.positions.size() == 761);
    CHECK(plane.triangles.size() == 1476);
    CHECK(area(plane) == doctest::Approx(100.0));
    for (const glm::vec3& n : plane.normals) CHECK(n == glm::vec3(0, 1, 0));
}
