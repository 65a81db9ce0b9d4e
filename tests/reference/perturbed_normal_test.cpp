// SPDX-License-Identifier: MIT
// Tests of perturbed normals by rays.
#include "material/mixture.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

TEST_CASE("the back of a one-sided surface is dark, even where a perturbed normal faces the viewer") {
    // The normal leans by 64 degrees towards +x.
    const TexturePtr leaning = constant_texture({0.95F, 0.5F, 0.72F, 1}, 3);
    for (const bool two_sided : {false, true}) {
        CAPTURE(two_sided);
        MaterialPtr material = normal_mapped(diffuse({0.8}), leaning);
        if (two_sided) material = twosided(material);
        Instance wall = square(material, Frame(1.0), {0, 0, 0}, 50);
        Mesh mesh = *wall.mesh;
        mesh.texcoords.clear();
        for (const glm::vec3& p : mesh.positions) mesh.texcoords.emplace_back(p.x, p.y);
        mesh.texcoord_triangles = mesh.triangles;
        wall.mesh = std::make_shared<const Mesh>(std::move(mesh));
        Scene scene;
        scene.add(wall);
        scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
        for (const double height : {0.3, -0.3, -0.05}) {
            CAPTURE(height);
            const double s0 = point(scene, camera_on({0, 0, 0}, {1, 0, height}), 256)[0][0];
            CHECK((s0 > 0.1) == (height > 0 || two_sided));
        }
    }
}
