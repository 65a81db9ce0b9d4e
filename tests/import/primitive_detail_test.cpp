// SPDX-License-Identifier: MIT
// Tests that primitives are as fine as the picture shows them.
#include <set>

#include "import/load_scene.hpp"
#include "import/scene_file.hpp"

using namespace nicol;

namespace {

/// Returns a sensor at the origin that looks along -z. kind: of the sensor. width: of its square film.
std::string sensor(const std::string& kind, int width) {
    const std::string pixels = "' value='" + std::to_string(width) + "'/>";
    return "<sensor type='" + kind + (kind == "perspective" ? "'><float name='fov' value='90'/>" : "'>") +
           "<transform name='to_world'><lookat origin='0,0,0' target='0,0,-1' up='0,1,0'/></transform>"
           "<film type='hdrfilm'><integer name='width" +
           pixels + "<integer name='height" + pixels + "</film></sensor>\n" + an_emitter;
}

std::string at(double z, const std::string& before = "") {
    return "<transform name='to_world'>" + before + "<translate z='" + std::to_string(z) + "'/></transform>";
}

std::string sphere(const std::string& inside) {
    return "<shape type='sphere'>" + inside + "</shape>\n";
}

std::size_t vertices(const std::string& content) {
    const LoadedScene loaded = load_scene(SceneFile(scene(content)).scene(), {});
    return loaded.scene.instances().front().mesh->positions.size();
}

}  // namespace

TEST_CASE("primitives are as fine as their outlines need in the picture") {
    const std::string wide = sensor("perspective", 1024), parallel = sensor("orthographic", 1024);
    // A sphere's outline lies 2.1e-4 of its radius inside the true one, over the square of the detail.
    struct Case {
        const char* what;
        std::string content;
        std::size_t vertices;
    };
    const std::size_t spheres[] = {1002, 1962, 4002, 7842, 14442};  // edges in 10, 14, 20, 28 and 38
    const Case cases[] = {
        {"512 pixels from centre to edge at distance 1", wide + sphere(at(-2)), spheres[4]},
        {"170 pixels", wide + sphere(at(-4)), spheres[4]},
        {"117 pixels", wide + sphere(at(-5.4)), spheres[3]},
        {"59 pixels", wide + sphere(at(-9.7)), spheres[2]},
        {"29 pixels", wide + sphere(at(-18.7)), spheres[1]},
        {"5 pixels", wide + sphere(at(-100)), spheres[0]},
        {"scaled", wide + sphere(at(-5.4, "<scale x='3'/>")), spheres[4]},
        {"large", wide + sphere("<float name='radius' value='20'/>" + at(-100)), spheres[4]},
        {"around the camera", wide + sphere("<float name='radius' value='9'/>" + at(-1)), spheres[4]},
        {"a light", wide + sphere("<emitter type='area'/>" + at(-100)), spheres[4]},
        {"a small picture may be drawn larger", sensor("perspective", 16) + sphere(at(-9.7)), spheres[0]},
        {"the same", sensor("perspective", 256) + sphere(at(-9.7)), spheres[0]},
        {"few segments", wide + sphere("<integer name='segments' value='4'/>" + at(-2)), 162},
        {"many segments", wide + sphere("<integer name='segments' value='50'/>" + at(-100)), 25002},
        {"parallel", parallel + sphere(at(-1000)), spheres[4]},
        {"parallel, small", parallel + sphere("<float name='radius' value='0.1'/>"), spheres[2]},
        {"disc of 4 rings of 45 and its centre", wide + "<shape type='disk'>" + at(-100) + "</shape>", 181},
        {"cylinder of 9 rows of 45", wide + "<shape type='cylinder'>" + at(-100) + "</shape>", 405},
        {"long cylinder that comes close",
         wide + "<shape type='cylinder'><point name='p1' z='99'/>" + at(-100) + "</shape>", 5940}};
    for (const Case& one : cases) {
        CAPTURE(std::string(one.what));
        CHECK(vertices(one.content) == one.vertices);
    }
}

TEST_CASE("spheres of nearly one size share a mesh, and cubes of any size do") {
    const std::string shapes = sphere(at(-50)) + sphere(at(-60)) + sphere(at(-3)) + "<shape type='cube'>" +
                               at(-3) + "</shape><shape type='cube'>" + at(-60) + "</shape>";
    const LoadedScene loaded = load_scene(SceneFile(scene(sensor("perspective", 256) + shapes)).scene(), {});
    std::set<const Mesh*> meshes;
    for (const Instance& instance : loaded.scene.instances()) meshes.insert(instance.mesh.get());
    CHECK(meshes.size() == 3);
}
