// SPDX-License-Identifier: MIT
// Tests of glTF files: nodes, primitives, cameras and materials.
#include "import/described_material.hpp"
#include "import/gltf_clearcoat.hpp"
#include "import/gltf_file.hpp"
#include "import/scene_file.hpp"
#include "scene/projection.hpp"

using namespace nicol;

namespace {

void check_equal(const glm::dmat4& a, const glm::dmat4& b, double tolerance = 1e-12) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            CHECK(a[column][row] == doctest::Approx(b[column][row]).epsilon(tolerance));
}

/// A rotation by 120 degrees about (1, 1, 1), which maps x to y to z.
const std::string a_rotation = "\"rotation\":[0.5,0.5,0.5,0.5]";
const glm::dmat4 a_rotation_matrix = glm::rotate(glm::dmat4(1), 2 * pi / 3, glm::dvec3(1, 1, 1));

MaterialDescription material(const std::string& members, const std::string& factors = "") {
    const GltfFile file(triangle_buffer(), one_mesh(",\"material\":0") +
                                               ",\"nodes\":[{\"mesh\":0}],\"materials\":[{" + members +
                                               "\"pbrMetallicRoughness\":{" + factors + "}}]");
    const SceneDescription scene = read_gltf_scene(file.scene());
    static_cast<void>(load_scene(file.scene(), {}));
    return scene.materials.at(scene.shapes.at(0).material);
}

}  // namespace

TEST_CASE("nodes of glTF place meshes by their own transforms and those of all above") {
    const SceneDescription scene = read_nodes(
        "{\"children\":[1,2],\"translation\":[1,2,3]},{\"mesh\":0,\"name\":\"leaf\",\"scale\":[2,3,4]," +
        a_rotation + ",\"translation\":[0,0,5]},{\"mesh\":0,\"matrix\":[0,1,0,0,-1,0,0,0,0,0,1,0,7,8,9,1]}");
    REQUIRE(scene.shapes.size() == 2);
    const auto moved = [](double x, double y, double z) {
        return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z));
    };
    CHECK(scene.shapes[0].id == "leaf");
    check_equal(scene.shapes[0].to_world,
                moved(1, 2, 8) * a_rotation_matrix * glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 4)));
    check_equal(scene.shapes[1].to_world,
                moved(8, 10, 12) * glm::rotate(glm::dmat4(1), pi / 2, glm::dvec3(0, 0, 1)));
}

TEST_CASE("the default scene of a glTF file is read, else the first, else every node") {
    const std::string nodes = "{\"name\":\"a\",\"mesh\":0},{\"name\":\"b\",\"mesh\":0}";
    const std::string scenes = ",\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}]";
    CHECK(read_nodes(nodes, scenes + ",\"scene\":1").shapes.at(0).id == "b");
    CHECK(read_nodes(nodes, scenes).shapes.at(0).id == "a");
    CHECK(read_nodes(nodes).shapes.size() == 2);
}

TEST_CASE("nodes with the same mesh of glTF share it, and each primitive has its material") {
    GltfBuffer buffer = triangle_buffer();
    const GltfFile file(
        buffer,
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"material\":1},"
        "{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"scale\":[-1,1,1]}],"
        "\"materials\":[{},{\"doubleSided\":true}]");
    const LoadedScene loaded = load_scene(file.scene(), {});
    const std::vector<Instance>& instances = loaded.scene.instances();
    REQUIRE(instances.size() == 4);
    CHECK(instances[0].mesh == instances[2].mesh);
    CHECK(instances[1].mesh == instances[3].mesh);
    CHECK(instances[0].mesh != instances[1].mesh);
    CHECK(instances[0].material == instances[2].material);
    CHECK(instances[0].material != instances[1].material);
    // A mirrored instance keeps its front side.
    const Mesh mirrored = placed(*instances[2].mesh, instances[2].to_world, 2);
    CHECK(mirrored.normals[0].z == doctest::Approx(1));
}

TEST_CASE("strips and fans of glTF are the triangles that they stand for") {
    const std::vector<glm::vec3> square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
    struct Case {
        int mode;
        std::vector<std::uint16_t> indices, triangles;
    };
    for (const Case& c :
         {Case{4, {0, 1, 2, 2, 1, 3}, {0, 1, 2, 2, 1, 3}},
          Case{5, {0, 1, 2, 3, 4}, {0, 1, 2, 1, 3, 2, 2, 3, 4}}, Case{6, {0, 1, 3, 2}, {1, 3, 0, 3, 2, 0}}}) {
        CAPTURE(c.mode);
        GltfBuffer buffer;
        buffer.vectors(square);
        buffer.indices(c.indices);
        std::vector<glm::vec3> expected;
        for (const std::uint16_t i : c.triangles) expected.push_back(square[i]);
        const auto mesh = read_primitive(buffer, "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":" +
                                                     std::to_string(c.mode) + "}");
        CHECK(corners(*mesh) == expected);
        for (const glm::vec3& n : mesh->normals) CHECK(n == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("every layout of numbers in glTF gives the same mesh") {
    const std::vector<std::string> layouts = {"tight",       "interleaved", "sparse",
                                              "only sparse", "bytes",       "shorts"};
    for (const std::string& layout : layouts) {
        CAPTURE(layout);
        GltfBuffer buffer;
        std::string normalized = ",\"normalized\":true";
        if (layout == "tight") {
            buffer.vectors(a_gltf_triangle);
        } else if (layout == "interleaved") {
            const int view = buffer.view<float>({9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0}, 16);
            buffer.accessor("VEC3", gltf_float, 3, GltfBuffer::of(view) + ",\"byteOffset\":4");
        } else if (layout == "sparse" || layout == "only sparse") {
            const bool only = layout == "only sparse";
            const int dense = buffer.view<glm::vec3>({{0, 0, 0}, {1, 0, 0}, {5, 5, 5}});
            const int at = only ? buffer.view<std::uint8_t>({0, 1, 2}) : buffer.view<std::uint8_t>({2});
            const int values =
                only ? buffer.view<glm::vec3>(a_gltf_triangle) : buffer.view<glm::vec3>({{0, 1, 0}});
            buffer.accessor("VEC3", gltf_float, 3,
                            (only ? "" : GltfBuffer::of(dense)) +
                                ",\"sparse\":{\"count\":" + (only ? "3" : "1") +
                                ",\"indices\":{\"componentType\":5121" + GltfBuffer::of(at) +
                                "},\"values\":{" + GltfBuffer::of(values).substr(1) + "}}");
        } else if (layout == "bytes") {
            const int view = buffer.view<std::int8_t>({0, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0}, 4);
            buffer.accessor("VEC3", gltf_byte, 3, GltfBuffer::of(view) + normalized);
        } else {
            const int view = buffer.view<std::uint16_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 8);
            buffer.accessor("VEC3", gltf_ushort, 3, GltfBuffer::of(view));
        }
        CHECK(corners(*read_primitive(buffer, "{\"attributes\":{\"POSITION\":0}}")) == a_gltf_triangle);
    }
}

TEST_CASE("normals, colours and texture coordinates of glTF are kept, for the vertices that are used") {
    GltfBuffer buffer;
    std::vector<glm::vec3> positions = a_gltf_triangle;
    positions.insert(positions.begin(), {7, 7, 7});
    buffer.vectors(positions);
    buffer.vectors({{0, 0, 1}, {0, 0, 2}, {0, 1, 0}, {0, 0, 0}});
    buffer.accessor(
        "VEC4", gltf_ubyte, 4,
        GltfBuffer::of(buffer.view<std::uint8_t>({9, 9, 9, 9, 255, 0, 51, 9, 0, 0, 0, 0, 0, 0, 0, 0})) +
            ",\"normalized\":true");
    buffer.accessor("VEC2", gltf_float, 4,
                    GltfBuffer::of(buffer.view<glm::vec2>({{9, 9}, {0.5, 2}, {1, 0}, {0, 1}})));
    buffer.indices({1, 2, 3});
    const auto mesh = read_primitive(
        buffer,
        "{\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"COLOR_0\":2,\"TEXCOORD_0\":3},\"indices\":4}");
    CHECK(mesh->positions == a_gltf_triangle);
    // Normals have unit length. A zero normal in the file is replaced by the triangle's.
    CHECK(mesh->normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {0, 0, 1}});
    CHECK(mesh->colors.at(0) == glm::vec3(1, 0, 0.2F));
    CHECK(mesh->texcoords == std::vector<glm::vec2>{{0.5, 2}, {1, 0}, {0, 1}});
    CHECK(mesh->texcoord_triangles == mesh->triangles);
}

TEST_CASE("tangents of glTF are kept, except without normals") {
    GltfBuffer buffer;
    buffer.vectors(a_gltf_triangle);
    buffer.vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    const float not_finite = std::numeric_limits<float>::infinity();
    buffer.accessor(
        "VEC4", gltf_float, 3,
        GltfBuffer::of(buffer.view<glm::vec4>({{0, 2, 0, 1}, {1, 0, 0, -1}, {not_finite, 0, 0, 1}})));
    const auto mesh = [&](const std::string& attributes) {
        return read_primitive(buffer, "{\"attributes\":{\"POSITION\":0" + attributes + ",\"TANGENT\":2}}");
    };
    const auto with_normals = mesh(",\"NORMAL\":1");
    CHECK(with_normals->tangents == std::vector<glm::vec4>{{0, 1, 0, 1}, {1, 0, 0, -1}, {0, 0, 0, 1}});
    // Without texture coordinates in the file they are 0.
    CHECK(with_normals->texcoords == std::vector<glm::vec2>(3));
    CHECK(with_normals->texcoord_triangles == with_normals->triangles);
    CHECK(mesh("")->tangents.empty());
}

TEST_CASE("without normals glTF is flat, and what has no area is left out with one notice") {
    GltfBuffer buffer;
    buffer.vectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    buffer.indices({0, 1, 2, 0, 2, 3, 1, 1, 2, 3, 3});
    const GltfFile file(buffer,
                        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1},"
                        "{\"attributes\":{\"POSITION\":0},\"mode\":1}]}],\"nodes\":[{\"mesh\":0},"
                        "{\"mesh\":0,\"scale\":[1,0,1]}]");
    const SceneDescription scene = read_gltf_scene(file.scene());
    REQUIRE(scene.shapes.size() == 1);
    CHECK(scene.shapes[0].mesh->positions.size() == 6);
    CHECK(scene.shapes[0].mesh->normals[0] == glm::vec3(0, 0, 1));
    CHECK(scene.shapes[0].mesh->normals[5] == glm::vec3(1, 0, 0));
    CHECK(has_notice(scene,
                     "left out: 2 corners of no triangle, 1 triangles without area, 1 primitives of "
                     "points or lines, 1 instances that their transform makes flat"));
}

TEST_CASE("cameras of glTF are those of an equal XML scene") {
    // The rotation maps x to y, y to z and z to x, so the camera looks along -x and z is up.
    const std::string node = ",{\"camera\":0,\"scale\":[2,2,2],\"translation\":[4,5,6]," + a_rotation + "}";
    const std::string lookat = "<lookat origin='4 5 6' target='3 5 6' up='0 0 1'/>";
    struct Case {
        std::string gltf, xml;
    };
    for (const Case& c :
         {Case{"\"type\":\"perspective\",\"perspective\":{\"yfov\":0.7853981633974483,\"aspectRatio\":1.5,"
               "\"znear\":0.1,\"zfar\":50}",
               "<sensor type='perspective'><float name='fov' value='45'/><string name='fov_axis' value='y'/>"
               "<transform name='to_world'>" +
                   lookat + "</transform>"},
          Case{"\"type\":\"orthographic\",\"orthographic\":{\"xmag\":3,\"ymag\":2,\"znear\":0.1,\"zfar\":50}",
               "<sensor type='orthographic'><transform name='to_world'><scale x='3' y='3'/>" + lookat +
                   "</transform>"}}) {
        const GltfFile file(triangle_buffer(), one_mesh() + ",\"nodes\":[{\"mesh\":0}" + node +
                                                   "],\"cameras\":[{" + c.gltf + "}]");
        const LoadedScene gltf = load_scene(file.scene(), {});
        const LoadedScene xml = load_scene(
            SceneFile(::scene(c.xml +
                              "<float name='near_clip' value='0.1'/><float name='far_clip' value='50'/><film "
                              "type='hdrfilm'><integer name='width' value='768'/><integer name='height' "
                              "value='512'/></film></sensor>" +
                              an_emitter + a_shape))
                .scene(),
            {});
        REQUIRE(gltf.width == xml.width);
        REQUIRE(gltf.height == xml.height);
        check_equal(project(gltf.camera, 768, 512).world_to_clip, project(xml.camera, 768, 512).world_to_clip,
                    1e-6);
    }
}

TEST_CASE("the camera of a glTF file without one sees all of it from the front") {
    for (const std::string scale : {"[1,1,1]", "[300,0.1,1]", "[1,2000,1]", "[0.001,0.001,0.001]"}) {
        const GltfFile file(
            triangle_buffer(),
            one_mesh() + ",\"nodes\":[{\"mesh\":0,\"translation\":[5,6,7]," + "\"scale\":" + scale + "}]");
        const LoadedScene loaded = load_scene(file.scene(), {});
        CHECK(loaded.width == 768);
        CHECK(loaded.height == 576);
        const Projection projection = project(loaded.camera, loaded.width, loaded.height);
        CHECK(projection.view.forward.z == doctest::Approx(-1));
        CHECK(projection.view.up.y == doctest::Approx(1));
        double widest = 0;
        for (const glm::vec3& p : a_gltf_triangle) {
            const glm::dvec4 clip =
                projection.world_to_clip * (loaded.scene.instances()[0].to_world * glm::dvec4(p, 1));
            for (int i = 0; i < 3; ++i) CHECK(std::abs(clip[i]) <= clip.w);
            widest = std::max({widest, std::abs(clip.x) / clip.w, std::abs(clip.y) / clip.w});
        }
        CHECK(widest > 0.4);
    }
}

TEST_CASE("a glTF camera without zfar sees the whole scene") {
    const SceneDescription scene =
        read_nodes("{\"mesh\":0,\"translation\":[0,0,-1e6]},{\"camera\":0}",
                   ",\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":1,\"znear\":0.01}}]");
    CHECK(scene.sensor.far_clip > 1e6);
    CHECK(scene.sensor.near_clip == 0.01);
    CHECK(scene.sensor.height == 576);
}

TEST_CASE("materials of glTF without metal are pplastic") {
    const MaterialDescription d = material(
        "\"name\":\"red\",\"doubleSided\":true,\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.4}},",
        "\"baseColorFactor\":[0.5,0.25,0.125,1],\"metallicFactor\":0,\"roughnessFactor\":0.5");
    CHECK(d.id == "red");
    CHECK(d.twosided);
    const auto plastic = as<PplasticModel>(d);
    CHECK(color(plastic, &PplasticParameters::diffuse_reflectance).rgb == glm::dvec3(0.5, 0.25, 0.125));
    CHECK(plastic.parameters.int_ior == 1.4);
    CHECK(plastic.parameters.ext_ior == 1);
    CHECK(plastic.parameters.alpha.value == 0.25);
    CHECK(plastic.parameters.distribution == Distribution::ggx);
    const auto parameters = [](const std::string& factors) {
        return as<PplasticModel>(material("", factors)).parameters;
    };
    CHECK(parameters("\"metallicFactor\":0,\"roughnessFactor\":0").alpha.value == 0.001);
    CHECK(parameters("\"metallicFactor\":0").int_ior == 1.5);
}

TEST_CASE("anisotropic materials of glTF are wider along their direction") {
    const struct {
        double strength, turn, along, across, expected_turn;
    } rows[] = {{0, 1, 0.25, 0, 0},
                {0.5, 0, 0.4375, 0.25, 0},
                {0.5, -1, 0.4375, 0.25, -1},
                {1, 3.1415926, 1, 0.25, 0},
                {1, 4, 1, 0.25, 4 - 3.14159265}};
    for (const double metallic : {0.0, 1.0})
        for (const auto& row : rows) {
            CAPTURES(metallic, row.strength, row.turn);
            const MaterialDescription d =
                material("\"extensions\":{\"KHR_materials_anisotropy\":{\"anisotropyStrength\":" +
                             std::to_string(row.strength) +
                             ",\"anisotropyRotation\":" + std::to_string(row.turn) + "}},",
                         "\"metallicFactor\":" + std::to_string(metallic) + ",\"roughnessFactor\":0.5");
            const auto check = [&](const auto& facets) {
                CHECK(facets.alpha.value == doctest::Approx(row.along));
                CHECK(facets.alpha_v.value == doctest::Approx(row.across));
            };
            const bool turned = row.expected_turn != 0;
            REQUIRE(is<RotatedModel>(d) == turned);
            if (turned) CHECK(as<RotatedModel>(d).angle == doctest::Approx(row.expected_turn));
            const MaterialDescription of = turned ? as<RotatedModel>(d).base : d;
            if (metallic == 0)
                check(as<PplasticModel>(of).parameters);
            else
                check(as<MetalModel>(of).parameters);
        }
}

TEST_CASE("iridescent materials of glTF have a film, on the share of the surface that the factor says") {
    const auto with_film = [](const std::string& values, double metallic) {
        return material("\"extensions\":{\"KHR_materials_iridescence\":{" + values + "}},",
                        "\"metallicFactor\":" + std::to_string(metallic));
    };
    const auto metal = as<MetalModel>(with_film("\"iridescenceFactor\":1", 1));
    CHECK(metal.film.film.thickness == 400);
    CHECK(metal.film.film.eta == std::vector<std::complex<double>>{1.3});
    const auto plastic = as<CoatedPlasticModel>(
        with_film("\"iridescenceFactor\":1,\"iridescenceIor\":1.8,\"iridescenceThicknessMaximum\":250", 0));
    CHECK(plastic.film.film.thickness == 250);
    CHECK(plastic.film.film.eta == std::vector<std::complex<double>>{1.8});
    CHECK(plastic.parameters.int_ior == 1.5);
    const auto partly = as<BlendModel>(with_film("\"iridescenceFactor\":0.25", 1));
    CHECK_FALSE(as<MetalModel>(partly.base).film.present());
    CHECK(as<MetalModel>(partly.other).film.present());
    CHECK(partly.texture->color0.rgb == glm::dvec3(0.25));
    for (const char* nothing : {"", "\"iridescenceFactor\":1,\"iridescenceThicknessMaximum\":0"})
        CHECK_FALSE(as<MetalModel>(with_film(nothing, 1)).film.present());
    check_error(ErrorCode::invalid_file, CALL(with_film("\"iridescenceFactor\":2", 1)), "iridescenceFactor",
                "expected 0");
    check_error(ErrorCode::invalid_file,
                CALL(with_film("\"iridescenceFactor\":1,\"iridescenceThicknessMaximum\":20000", 1)),
                "iridescenceThicknessMaximum");
}

TEST_CASE("clear coats of glTF lie over the material and below its map of normals") {
    const auto coated = [](const std::string& values, const std::string& members = "") {
        return material("\"extensions\":{\"KHR_materials_clearcoat\":{" + values + "}}," + members,
                        "\"metallicFactor\":1");
    };
    const auto coat =
        as<scene::ClearcoatModel>(coated("\"clearcoatFactor\":0.5,\"clearcoatRoughnessFactor\":0.4"));
    CHECK(coat.factor.value == 0.5);
    CHECK(coat.alpha.value == doctest::Approx(0.16));
    CHECK(as<MetalModel>(coat.base).parameters.alpha.value == 1);
    CHECK(as<scene::ClearcoatModel>(coated("\"clearcoatFactor\":1")).alpha.value == 0.001);
    for (const char* none : {"", "\"clearcoatFactor\":0"}) as<MetalModel>(coated(none));
    for (const char* bad : {"clearcoatFactor", "clearcoatRoughnessFactor"})
        check_error(ErrorCode::invalid_file,
                    CALL(coated("\"clearcoatFactor\":1,\"" + std::string(bad) + "\":1.5")), bad,
                    "expected 0");
}

TEST_CASE("metals of glTF reflect the base colour at normal incidence") {
    for (const glm::dvec3 base : {glm::dvec3(1, 0.766, 0.336), glm::dvec3(0, 0.04, 0.9)}) {
        const auto metal =
            as<MetalModel>(material("", "\"baseColorFactor\":[" + std::to_string(base.x) + "," +
                                            std::to_string(base.y) + "," + std::to_string(base.z) + ",1]"));
        CHECK(metal.parameters.alpha.value == 1);
        for (int c = 0; c < 3; ++c) {
            const std::complex<double> index(metal.eta.rgb[c], -metal.k.rgb[c]);
            CHECK(std::norm((index - 1.0) / (index + 1.0)) == doctest::Approx(base[c]).epsilon(1e-3));
        }
    }
    // A primitive without material is white metal.
    const SceneDescription scene = read_nodes("{\"mesh\":0}");
    CHECK(as<MetalModel>(scene.materials.at(0)).parameters.alpha.value == 1);
}
