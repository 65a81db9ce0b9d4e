// SPDX-License-Identifier: MIT
// Tests of validation, normals and transforms of meshes.
#include "geometry/mesh.hpp"

#include "test.hpp"

using nicol::ErrorCode;
using nicol::Mesh;

namespace {

Mesh triangle() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

void check_refused(Mesh mesh, const std::string& part) {
    const std::string message = error_of(CALL(nicol::validate(mesh, "thing")), ErrorCode::invalid_file);
    CAPTURE(message);
    CHECK(message.starts_with("thing: "));
    CHECK(message.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("validate refuses what no renderer can draw, by index") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    check_refused({}, "empty");
    Mesh mesh = triangle();
    mesh.triangles.clear();
    check_refused(mesh, "empty");
    mesh = triangle();
    mesh.positions[2].y = nan;
    check_refused(mesh, "vertex 2 (0-based) is not finite");
    mesh.positions[2].y = infinity;
    check_refused(mesh, "vertex 2 (0-based) is not finite");
    mesh = triangle();
    mesh.triangles.emplace_back(0, 1, 3);
    check_refused(mesh, "face 1 (0-based) uses vertex 3");
    mesh.triangles[1] = {0, 1, 0xffffffffu};
    check_refused(mesh, "face 1 (0-based) uses vertex 4294967295");
    mesh.triangles = {{0, 1, 1}};
    check_refused(mesh, "none of the 1 triangles has an area");
    mesh = triangle();
    mesh.normals.resize(2, glm::vec3(0, 0, 1));
    check_refused(mesh, "2 normals for 3 vertices");
    mesh.normals = {{0, 0, 1}, {0, nan, 0}, {0, 0, 1}};
    check_refused(mesh, "the normal of vertex 1 (0-based) is not finite");
    mesh = triangle();
    mesh.colors = {{0, 0, 1}, {0, 0, 1}};
    check_refused(mesh, "2 colours for 3 vertices");
    mesh.colors.emplace_back(0, 0, infinity);
    check_refused(mesh, "the colour of vertex 2 (0-based) is not finite");
    mesh = triangle();
    mesh.face_colors = {{0, 0, 1}, {0, 0, 1}};
    check_refused(mesh, "2 colours for 1 faces");
    mesh.face_colors = {{0, nan, 1}};
    check_refused(mesh, "the colour of face 0 (0-based) is not finite");
    mesh = triangle();
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    check_refused(mesh, "texture coordinates at 0 faces of 1; give them at each or at none");
    mesh.texcoord_triangles = {{0, 1, 3}};
    check_refused(mesh, "face 0 (0-based) uses texture coordinate 3, but there are only 3");
    mesh.texcoord_triangles = {{0, 1, 2}, {0, 1, 2}};
    check_refused(mesh, "texture coordinates at 2 faces of 1");
    mesh.texcoord_triangles.pop_back();
    mesh.texcoords[1].y = nan;
    check_refused(mesh, "texture coordinate 1 (0-based) is not finite");
    mesh.texcoords.clear();
    check_refused(mesh, "face 0 (0-based) uses texture coordinate 0, but there are only 0");
}

TEST_CASE("validate removes triangles without area, and says how many") {
    Mesh mesh = triangle();
    mesh.positions.emplace_back(1e-3f, 0, 0);
    mesh.positions.emplace_back(1, 0, 0);
    for (const glm::uvec3& flat : {glm::uvec3(0, 1, 1), {0, 1, 3}, {0, 1, 4}}) mesh.triangles.push_back(flat);
    mesh.triangles.emplace_back(0, 4, 2);
    CHECK(nicol::validate(mesh, "thing") == 3);
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 4, 2}});
    CHECK(mesh.positions.size() == 5);
}

TEST_CASE("size alone does not make a triangle degenerate") {
    for (const float scale : {1e-18f, 1e-6f, 1e6f, 1e18f, 1e37f}) {
        CAPTURE(scale);
        Mesh mesh = triangle();
        for (glm::vec3& p : mesh.positions) p *= scale;
        CHECK_NOTHROW(nicol::validate(mesh, "thing"));
        CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("validate makes normals unit and fills in the missing ones") {
    Mesh mesh = triangle();
    mesh.positions.emplace_back(5, 5, 5);  // a vertex without a face
    mesh.normals = {{0, 0, 1e-30f}, {0, 3e30f, 4e30f}, {0, 0, 0}, {0, 0, 0}};
    nicol::validate(mesh, "thing");
    CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
    CHECK(glm::distance(mesh.normals[1], glm::vec3(0, 0.6f, 0.8f)) < 1e-6f);
    CHECK(mesh.normals[2] == glm::vec3(0, 0, 1));
    CHECK(mesh.normals[3] == glm::vec3(0, 0, 1));
}

TEST_CASE("smooth normals do not depend on how a square is cut") {
    // A roof of two squares over one ridge. One square is cut along either diagonal.
    Mesh mesh;
    mesh.positions = {{0, 0, 1}, {1, 0, 1}, {0, -1, 0}, {1, -1, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}};
    Mesh other = mesh;
    other.triangles[0] = {1, 0, 2};
    other.triangles[1] = {1, 2, 3};
    nicol::smooth_normals(mesh);
    nicol::smooth_normals(other);
    for (std::size_t v = 0; v < 2; ++v) {
        CHECK(glm::distance(mesh.normals[v], glm::vec3(0, 0, 1)) < 1e-6f);
        CHECK(glm::distance(other.normals[v], glm::vec3(0, 0, 1)) < 1e-6f);
    }
    CHECK(glm::distance(mesh.normals[2], glm::normalize(glm::vec3(0, -1, 1))) < 1e-6f);
}

TEST_CASE("faces back to back leave the normal of the first") {
    Mesh mesh = triangle();
    mesh.triangles.emplace_back(0, 2, 1);
    nicol::validate(mesh, "thing");
    for (const glm::vec3& n : mesh.normals) CHECK(n == glm::vec3(0, 0, 1));
}

TEST_CASE("face normals make every edge hard") {
    Mesh sphere = nicol::make_sphere();
    const Mesh flat = nicol::with_face_normals(sphere);
    REQUIRE(flat.positions.size() == 3 * sphere.triangles.size());
    for (const glm::uvec3& t : flat.triangles) {
        const glm::vec3 across = flat.positions[t.y] - flat.positions[t.x];
        CHECK(std::abs(glm::dot(flat.normals[t.x], across)) < 1e-6f);
        CHECK(flat.normals[t.x] == flat.normals[t.z]);
    }
}

TEST_CASE("transformed normals stay perpendicular and outside, mirrored or not") {
    const Mesh sphere = nicol::make_sphere();
    const glm::dmat4 rotation = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    const glm::dmat4 move = glm::translate(glm::dmat4(1.0), glm::dvec3(4, 5, 6));
    for (const glm::dvec3 scale : {glm::dvec3(1, 2, 0.5), glm::dvec3(-1, 2, 0.5), glm::dvec3(-1, -1, -1)}) {
        const glm::dmat4 m = move * rotation * glm::scale(glm::dmat4(1.0), scale);
        const Mesh out = nicol::transformed(sphere, m);
        for (std::size_t i = 0; i < out.triangles.size(); i += 97) {
            const glm::uvec3 t = out.triangles[i];
            const glm::vec3 front = glm::normalize(
                glm::cross(out.positions[t.y] - out.positions[t.x], out.positions[t.z] - out.positions[t.x]));
            CHECK(glm::dot(front, out.normals[t.x]) > 0.99f);
            CHECK(glm::dot(front, out.positions[t.x] - glm::vec3(4, 5, 6)) > 0.0f);
            CHECK(glm::length(out.normals[t.x]) == doctest::Approx(1.0));
        }
    }
}

TEST_CASE("flipping twice changes nothing, flipping once the front") {
    Mesh mesh = nicol::make_cube(2);
    const Mesh before = mesh;
    nicol::flip_normals(mesh);
    CHECK(mesh.normals[0] == -before.normals[0]);
    CHECK(mesh.triangles[0] ==
          glm::uvec3(before.triangles[0].x, before.triangles[0].z, before.triangles[0].y));
    nicol::flip_normals(mesh);
    CHECK(mesh.normals == before.normals);
    CHECK(mesh.triangles == before.triangles);
}

TEST_CASE("transforms that cannot be inverted or are not affine are refused") {
    const Mesh mesh = nicol::make_rectangle(1);
    glm::dmat4 flat = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, 0));
    glm::dmat4 sheared(1.0);
    sheared[1] = sheared[0];
    glm::dmat4 projective(1.0);
    projective[0][3] = 0.1;
    glm::dmat4 broken(1.0);
    broken[3][0] = std::numeric_limits<double>::quiet_NaN();
    const glm::dmat4 far = glm::scale(glm::dmat4(1.0), glm::dvec3(1e60));
    for (const glm::dmat4& m : {flat, sheared, projective, broken, far, glm::dmat4(0.0)})
        check_error(ErrorCode::invalid_argument, CALL(nicol::transformed(mesh, m)));
    CHECK_NOTHROW(static_cast<void>(nicol::transformed(mesh, glm::scale(glm::dmat4(1.0), glm::dvec3(1e-6)))));
}
