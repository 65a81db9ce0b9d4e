// SPDX-License-Identifier: MIT
#include "geometry/deformed_mesh.hpp"

#include <cmath>

#include "test.hpp"

using namespace nicol;

TEST_CASE("a deformed mesh keeps all but the places of its vertices") {
    Mesh mesh = make_rectangle(2);
    mesh.colors.assign(mesh.positions.size(), glm::vec3(0.5));
    validate(mesh, "rectangle");
    std::vector<glm::vec3> positions = mesh.positions;
    for (glm::vec3& p : positions) p.z = p.x;
    const Mesh bent = deformed(mesh, positions, {});
    CHECK(bent.positions == positions);
    CHECK(bent.triangles == mesh.triangles);
    CHECK(bent.texcoords == mesh.texcoords);
    CHECK(bent.texcoord_triangles == mesh.texcoord_triangles);
    CHECK(bent.colors == mesh.colors);
    CHECK(same_triangles(bent, mesh));
    for (const glm::vec3& n : bent.normals)
        CHECK(glm::distance(n, glm::normalize(glm::vec3(-1, 0, 1))) < 1e-6F);

    // Normals of any length are made unit length, and those of no length smooth.
    std::vector<glm::vec3> normals(positions.size(), glm::vec3(0, 3, 0));
    normals[1] = glm::vec3(0);
    const Mesh given = deformed(mesh, positions, normals);
    CHECK(given.normals[0] == glm::vec3(0, 1, 0));
    CHECK(given.normals[1] == bent.normals[1]);
}

TEST_CASE("a mesh that collapses keeps its triangles") {
    const Mesh mesh = make_cube(1);
    const Mesh point = deformed(mesh, std::vector<glm::vec3>(mesh.positions.size(), glm::vec3(1)), {});
    CHECK(same_triangles(point, mesh));
    for (const glm::vec3& n : point.normals) CHECK(std::abs(glm::length(n) - 1) < 1e-6F);
    CHECK(!same_triangles(mesh, make_cube(2)));
    CHECK(!same_triangles(mesh, make_rectangle(1)));
}

TEST_CASE("positions and normals of a deformed mesh are one per vertex, and finite") {
    const Mesh mesh = make_rectangle(1);
    std::vector<glm::vec3> positions = mesh.positions;
    positions.pop_back();
    CHECK(error_of(CALL(deformed(mesh, positions, {}))).find("3 positions for a mesh of 4 vertices") !=
          std::string::npos);
    CHECK(error_of(CALL(deformed(mesh, mesh.positions, {glm::vec3(1)}))).find("1 normals for a mesh of 4") !=
          std::string::npos);
    positions = mesh.positions;
    positions[2].y = NAN;
    CHECK(error_of(CALL(deformed(mesh, positions, {}))).find("the position of vertex 2") !=
          std::string::npos);
    positions[2].y = HUGE_VALF;
    CHECK(error_of(CALL(deformed(mesh, mesh.positions, positions))).find("the normal of vertex 2") !=
          std::string::npos);
}
