// SPDX-License-Identifier: MIT
// Tests of mesh files designed to take long.
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include "geometry/ear_clipping.hpp"
#include "geometry/mesh.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/polygon_mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

template <class T>
void append(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string out;
    out.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) out += text;
    return out;
}

/// Returns a cone of triangles about one vertex.
std::string stl_cone(std::uint32_t triangles) {
    std::string out(80, ' ');
    append(out, triangles);
    const auto rim = [&](std::uint32_t i) {
        const double angle = 2 * std::numbers::pi * (i % triangles) / triangles;
        return std::array{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), -0.2F};
    };
    for (std::uint64_t k = 0; k < triangles; ++k) {
        // Neighbours are far apart in the file, so most triangles meet no neighbour when they are added.
        const auto i = static_cast<std::uint32_t>(k * 300007 % triangles);
        append(out, std::array<float, 3>{});
        append(out, std::array<float, 3>{});
        append(out, rim(i));
        append(out, rim(i + 1));
        append(out, std::uint16_t{0});
    }
    return out;
}

/// Returns stars of 1,023 corners near a circle, each corner joined to one a third of the circle further on,
/// so that all edges cross. Many corners look like ears, which makes careless ways of cutting cubic.
std::string obj_stars(std::size_t stars) {
    constexpr int corners = 1023;
    std::string out, face = "f";
    std::uint32_t random = 1;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i * 342 % corners) / corners;
        random = random * 1664525 + 1013904223;
        const double radius = 0.95 + 0.1 * static_cast<double>(random) / 4294967296.0;
        out += "v " + std::to_string(radius * std::cos(angle)) + " " +
               std::to_string(radius * std::sin(angle)) + " 0\n";
        face += " " + std::to_string(1 + i);
    }
    return out + repeated(face + "\n", stars);
}

/// Returns a mesh of zeros, compressed as far as the reader believes.
std::string serialized(std::size_t vertices) {
    std::string content;
    append(content, std::uint32_t{1});  // normals
    content += std::string("mesh") + '\0';
    append(content, std::uint64_t{vertices});
    append(content, std::uint64_t{1});
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < 6 * vertices; ++i) {
        // One number of 16 is not zero, because the reader refuses higher compression.
        random = random * 1664525 + 1013904223;
        append(content, i % 16 == 0 ? static_cast<float>(random >> 8) : 0.0F);
    }
    append(content, std::array<std::uint32_t, 3>{0, 1, 2});
    uLongf size = compressBound(static_cast<uLong>(content.size()));
    std::string packed(size, '\0');
    REQUIRE(compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                      reinterpret_cast<const Bytef*>(content.data()), static_cast<uLong>(content.size()),
                      1) == Z_OK);
    packed.resize(size);
    std::string out;
    append(out, std::uint16_t{0x041C});
    append(out, std::uint16_t{4});
    out += packed;
    append(out, std::uint64_t{0});
    append(out, std::uint32_t{1});
    return out;
}

}  // namespace

TEST_CASE("triangles about one vertex of an STL are read in linear time") {
    const TemporaryFolder folder;
    constexpr std::uint32_t count = 500000;
    const Mesh mesh = load_mesh(folder.write("cone.stl", stl_cone(count)));
    CHECK(mesh.triangles.size() == count);
    // A cone of a few hundred triangles has a smooth tip.
    CHECK(load_mesh(folder.write("cone.stl", stl_cone(500))).positions.size() == 501);
}

TEST_CASE("polygons that cross themselves are cut in the square of their corners") {
    const TemporaryFolder folder;
    constexpr std::size_t stars = 1000;
    const Mesh mesh = load_mesh(folder.write("stars.obj", obj_stars(stars)));
    CHECK(mesh.triangles.size() > stars * 500);
}

TEST_CASE("every parser of meshes is asked to stop while it works") {
    struct Case {
        std::string name;
        std::string bytes;
        bool parse_freely = false;  ///< the limits hold for the triangulation alone
    };
    constexpr std::size_t many = 3000000;
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(many) +
                            "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                            "property list uchar int vertex_indices\nend_header\n";
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const std::vector<Case> cases{
        {"a.obj", repeated("v 0.25 0.5 1\n", many) + "f 1 2 3\n"},
        {"stars.obj", obj_stars(200), true},
        {"a.ply", ply + repeated("0.25 0.5 1\n", many) + "3 0 1 2\n"},
        {"a.off", "OFF\n" + std::to_string(many) + " 1 0\n" + repeated("0.25 0.5 1\n", many) + "3 0 1 2\n"},
        {"a.stl", "solid\n" + repeated(facet, many / 4) + "endsolid\n"},
        {"cone.stl", stl_cone(500000)},
        {"a.serialized", serialized(many)}};
    const auto covered = [&](const MeshFormat* format) {
        return std::ranges::any_of(cases,
                                   [&](const Case& one) { return mesh_format_of(one.name) == format; });
    };
    CHECK(std::ranges::all_of(mesh_formats(), covered));
    for (const Case& one : cases) {
        CAPTURE(one.name);
        // Neither limit depends on the speed of the machine: the parser meets it at its first check.
        const auto parse = [&](const LoadLimits& limits) {
            geometry::LeftOut left_out;
            const LoadBudget budget(limits);
            const geometry::PolygonMesh polygons =
                mesh_format_of(one.name)->parse({.name = one.name, .bytes = one.bytes, .colors = {}},
                                                left_out, one.parse_freely ? LoadBudget() : budget);
            if (one.parse_freely) static_cast<void>(triangulated(polygons, one.name, left_out, budget));
        };
        int asked = 0;
        check_error(ErrorCode::cancelled,
                    [&] { parse({.progress = [&](const char*, double) { return ++asked < 1; }}); });
        CHECK(asked == 1);
        check_error(
            ErrorCode::unsupported, [&] { parse({.seconds = 0}); }, "load_seconds_limit");
    }
}

TEST_CASE("a serialized mesh is not inflated beyond the limit of bytes") {
    const std::string bytes = serialized(100000);
    const TemporaryFolder folder;
    const auto file = folder.write("a.serialized", bytes);
    check_error(ErrorCode::unsupported, CALL(load_mesh(file, {}, 0, LoadLimits{.bytes = 1 << 20})),
                "load_bytes_limit");
}
