// SPDX-License-Identifier: MIT
#include <cstring>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "error.hpp"
#include "geometry/mesh.hpp"
#include "geometry/sdf_grid.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr SdfNormals both[] = {SdfNormals::smooth, SdfNormals::analytic};

/// Returns the bytes of a volume with values of the points of 0..1, x fastest.
std::string volume(const glm::ivec3& size, const std::function<double(const glm::dvec3&)>& value,
                   std::int32_t encoding = 1, std::int32_t channels = 1) {
    std::string out = "VOL\x03";
    const auto add = [&out](const auto& number) {
        out.append(reinterpret_cast<const char*>(&number), sizeof(number));
    };
    for (const std::int32_t number : {encoding, size.x, size.y, size.z, channels}) add(number);
    for (int i = 0; i < 6; ++i) add(0.0F);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                add(static_cast<float>(value(glm::dvec3(x, y, z) / glm::dvec3(size - 1))));
    return out;
}

Mesh surface(const std::string& bytes, SdfNormals normals = SdfNormals::smooth) {
    const TemporaryFolder folder;
    return load_sdf_grid(folder.write("a.vol", bytes), normals);
}

double ball(const glm::dvec3& at) {
    return glm::distance(at, glm::dvec3(0.52, 0.47, 0.5)) - 0.3;
}

/// Counts how often the triangles run along each edge, less how often they run against it.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> open_edges(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> out;
    for (const glm::uvec3& t : mesh.triangles)
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            out[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    std::erase_if(out, [](const auto& edge) { return edge.second == 0; });
    return out;
}

}  // namespace

TEST_CASE("a grid of distances from a plane is the plane, in a box of any shape") {
    const glm::dvec3 along = glm::normalize(glm::dvec3(0.4, -0.3, 1));
    const std::string bytes =
        volume({7, 5, 9}, [&](const glm::dvec3& at) { return glm::dot(along, at) - 0.45; });
    for (const SdfNormals normals : both) {
        const Mesh mesh = surface(bytes, normals);
        double area = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            REQUIRE(std::abs(glm::dot(along, glm::dvec3(mesh.positions[i])) - 0.45) < 1e-6);
            REQUIRE(glm::distance(along, glm::dvec3(mesh.normals[i])) < 1e-5);
        }
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
            const double part = glm::dot(along, glm::cross(b - a, c - a)) / 2;
            REQUIRE(part > 0);
            area += part;
        }
        // The plane's height lies inside the cube everywhere.
        CHECK(area == doctest::Approx(1 / along.z).epsilon(1e-5));
    }
}

TEST_CASE("a ball's surface is closed, where it should be, and faces outward") {
    const std::string bytes = volume(glm::ivec3(24), ball);
    for (const SdfNormals normals : both) {
        const Mesh mesh = surface(bytes, normals);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::dvec3 at(mesh.positions[i]);
            // Interpolation in a cell of length h misses the distance by up to 3 h^2 / (8 r).
            REQUIRE(std::abs(ball(at)) < 3.0 / (8 * 0.3 * 23 * 23));
            REQUIRE(glm::dot(glm::normalize(at - glm::dvec3(0.52, 0.47, 0.5)), glm::dvec3(mesh.normals[i])) >
                    (normals == SdfNormals::smooth ? 0.9995 : 0.99));
        }
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::vec3 a = mesh.positions[t.x];
            const glm::vec3 across = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
            REQUIRE(glm::dot(across, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) > 0);
        }
        // Cells share no vertices if normals are analytic.
        CHECK(open_edges(mesh).empty() == (normals == SdfNormals::smooth));
    }
}

TEST_CASE("surfaces of any signs are closed, but where the grid ends") {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        std::uint32_t state = seed;
        const auto random = [&state](const glm::dvec3&) {
            state = state * 1664525 + 1013904223;
            return state / 4294967296.0 - 0.5;
        };
        const Mesh mesh = surface(volume({9, 8, 7}, random));
        CHECK(mesh.triangles.size() > 1000);
        for (const auto& [edge, count] : open_edges(mesh)) {
            const glm::vec3 a = mesh.positions[edge.first], b = mesh.positions[edge.second];
            bool at_end = false;
            for (glm::length_t axis = 0; axis < 3; ++axis)
                at_end = at_end || (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == 1));
            REQUIRE(at_end);
        }
    }
}

TEST_CASE("grids that are no surface are refused") {
    const std::string good = volume(glm::ivec3(3), ball);
    const struct {
        std::string bytes;
        const char* part;
        ErrorCode code = ErrorCode::invalid_file;
    } rows[] = {{"", "does not begin with VOL"},
                {"VOL\x02" + good.substr(4), "does not begin with VOL"},
                {good.substr(0, 47), "does not begin with VOL"},
                {good.substr(0, good.size() - 4), "26 numbers after its header; expected 3 x 3 x 3"},
                {volume({3, 1, 3}, ball), "3 x 1 x 3 numbers; expected 2 or more"},
                {volume({-3, 3, 3}, ball), "-3 x 3 x 3 numbers; expected 2 or more"},
                {volume(glm::ivec3(3), ball, 2), "encoding 2", ErrorCode::unsupported},
                {volume(glm::ivec3(3), ball, 1, 3), "3 channels", ErrorCode::unsupported},
                {volume(glm::ivec3(3), [](const glm::dvec3&) { return 1.0; }), "no surface"},
                {volume(glm::ivec3(3), [](const glm::dvec3& at) { return at.x < 1 ? -1 : std::nan(""); }),
                 "number 2 (counted from 0) is not finite"}};
    for (const auto& row : rows) check_error(row.code, CALL(surface(row.bytes)), row.part, "a.vol");
}

TEST_CASE(
    "limits hold for the vertices and triangles that a surface has, and bytes after a grid are ignored") {
    const auto checkered = [](const glm::dvec3& at) {
        const glm::ivec3 corner(glm::round(at * 7.0));
        return (corner.x + corner.y + corner.z) % 2 == 0 ? 1.0 : -0.3;
    };
    const std::function<double(const glm::dvec3&)> shapes[] = {
        checkered, ball, [](const glm::dvec3& at) { return at.x - 0.6; }};
    const TemporaryFolder folder;
    for (const auto& shape : shapes)
        for (const SdfNormals normals : both) {
            CAPTURES(&shape - shapes, static_cast<int>(normals));
            const std::filesystem::path file = folder.write("a.vol", volume(glm::ivec3(8), shape) + "12345");
            const auto load = [&](std::uint64_t vertices, std::uint64_t triangles) {
                return load_sdf_grid(file, normals, LoadLimits{.vertices = vertices, .triangles = triangles});
            };
            const Mesh mesh = load(1 << 20, 1 << 20);
            const std::uint64_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
            CHECK(load(vertices, triangles).positions == mesh.positions);
            check_error(ErrorCode::unsupported, CALL(load(vertices - 1, triangles)), "vertex_limit");
            check_error(ErrorCode::unsupported, CALL(load(vertices, triangles - 1)), "triangle_limit");
        }
}
