// SPDX-License-Identifier: MIT
// Tests of the files that a scene consists of.
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"
#include "light/cube_cross.hpp"
#include "material/measured.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"
#include "scene/projection.hpp"

using namespace nicol;
using std::filesystem::path;

namespace {

const std::string a_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string obj(const std::string& filename) {
    return "<shape type='obj'><string name='filename' value='" + filename + "'/></shape>\n";
}

/// Returns a digest of all files and checks that they are these, in this order.
std::string digests(const SceneFile& file, const std::vector<std::string>& names) {
    const LoadedScene loaded = load_scene(file.scene(), {});
    std::vector<std::string> found;
    std::string all;
    for (const FileRecord& record : loaded.files) {
        found.push_back(record.path.lexically_relative(file.path()).string());
        CHECK(record.bytes == file_size(record.path));
        CHECK(record.digest.size() == 32);
        all += record.digest;
    }
    CHECK(found == names);
    return all;
}

}  // namespace

TEST_CASE("a loaded scene knows every file it was made of, and what it held") {
    // These names would be missed by a search for quotes in the text: after an apostrophe, under a <path>,
    // with an entity, with a parameter inside another's name, parts of a cube map, in an included file.
    const SceneFile file(
        scene("<!-- the lamp's light -->\n<path value='far'/><default name='m' value='wrong'/>"
              "<default name='mesh' value='right'/>" +
              a_sensor + obj("below.obj") + obj("a&amp;b.obj") + obj("$mesh.obj") + obj("a&amp;b.obj") +
              "<include filename='part/b.xml'/><emitter type='envmap'>"
              "<string name='filename' value='light_s0.exr'/></emitter>"));
    for (const char* name : {"far/below.obj", "a&b.obj", "right.obj", "part/c.obj", "unused.obj"})
        file.write(name, a_triangle);
    file.write("part/b.xml", scene(obj("c.obj")));
    write_cube_cross(file / "light", *constant_environment({1, 1, 1}), 2);

    const std::vector<std::string> names = {"scene.xml",    "part/b.xml",   "light_s0.exr",  "light_s1.exr",
                                            "light_s2.exr", "light_s3.exr", "far/below.obj", "a&b.obj",
                                            "right.obj",    "part/c.obj"};
    std::string known = digests(file, names);
    CHECK(digests(file, names) == known);
    const auto changes = [&](const std::string& name, const auto& change) {
        change();
        const std::string now = digests(file, names);
        CHECK_MESSAGE((now != known) == (name != "unused.obj"), name);
        known = now;
    };
    for (const std::string name : {"far/below.obj", "a&b.obj", "right.obj", "part/c.obj", "unused.obj"})
        changes(name, [&] { file.write(name, a_triangle + "\n"); });
    changes("part/b.xml", [&] { file.write("part/b.xml", scene(" " + obj("c.obj"))); });
    changes("light_s0.exr", [&] { write_cube_cross(file / "light", *constant_environment({2, 1, 1}), 2); });
}

TEST_CASE("a measured material that lacks its angles is one notice, however many shapes it has") {
    const TemporaryFolder folder;
    test::PbsdfFile file = test::make_pbsdf(
        test::even_angles(3, 0, 2 * pi), test::even_angles(2, 0, pi / 2), test::even_angles(2, 0, pi / 2),
        {550}, [](std::size_t, const glm::dvec3&, const glm::dvec3&) { return Mueller(); });
    file.field("phi_d").shape[0] = 0;
    file.field("phi_d").bytes.clear();
    folder.write("m.pbsdf", file.bytes());
    const std::string bsdf =
        "<bsdf type='measured_polarized'><string name='filename' value='m.pbsdf'/></bsdf>";
    const std::string shape = "<shape type='rectangle'>" + bsdf + "</shape>";
    const LoadedScene loaded =
        load_scene(folder.write("a.xml", scene(a_sensor + an_emitter + shape + shape)), {});
    REQUIRE(loaded.notices.size() == 1);
    CHECK(loaded.notices[0].find("m.pbsdf: ") != std::string::npos);
}

TEST_CASE("measured materials are made whole or symmetrized, as the scene says") {
    const TemporaryFolder folder;
    IsotropicMatrix matrix(2, 2);
    matrix.block(1, 1, 1)[0] = {1, 0.5};
    write_psh_matrix(folder / "m.npz", std::vector{matrix});
    folder.write("m.pbsdf",
                 test::make_pbsdf(test::even_angles(5, -pi, pi), test::even_angles(2, 0, pi / 2),
                                  test::even_angles(2, 0, pi / 2), {550},
                                  [](std::size_t, const glm::dvec3&, const glm::dvec3&) { return Mueller(); })
                     .bytes());
    for (const auto& [type, name] : {std::pair{"psh", "m.npz"}, std::pair{"measured_polarized", "m.pbsdf"}}) {
        for (const std::string flag : {"", "false", "true"}) {
            const std::string shape =
                "<shape type='rectangle'><bsdf type='" + std::string(type) +
                "'><string name='filename' value='" + name + "'/>" +
                (flag.empty() ? "" : "<boolean name='symmetrize' value='" + flag + "'/>") + "</bsdf></shape>";
            const LoadedScene loaded =
                load_scene(folder.write("a.xml", scene(a_sensor + an_emitter + shape)), {});
            CHECK(loaded.scene.instances()[0].material->mirror_symmetric() == (flag == "true"));
        }
    }
}

TEST_CASE("what fails while a scene is made names the file and the object") {
    const SceneFile file("");
    file.write("bad.obj", "v 0 0 0\n");
    file.write("m.pbsdf", "no table");
    const std::string turned =
        "<transform name='to_world'><matrix value='1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1'/></transform>";
    const std::string flat = "<transform name='to_world'><scale x='1e-200'/></transform>";
    const std::string group =
        "<shape type='shapegroup' id='g'><shape type='rectangle'>" + flat + "</shape></shape>";
    struct Case {
        std::string content;
        std::vector<std::string> parts;
    };
    for (const Case& wrong : std::vector<Case>{
             {obj("bad.obj"), {": shape: ", "bad.obj: no faces"}},
             {"<shape type='rectangle'><bsdf type='measured_polarized' id='b'>"
              "<string name='filename' value='m.pbsdf'/></bsdf></shape>",
              {": bsdf \"b\": ", "m.pbsdf: "}},
             {a_shape + "<emitter type='sky'><vector name='sun_direction' x='0' y='1' z='0'/>" + turned +
                  "</emitter>",
              {": emitter: the emitter: to_world must rotate"}},
             {group + "<shape type='instance' id='i'><ref id='g'/><transform name='to_world'>"
                      "<scale x='1e-200'/></transform></shape>",
              {": shape \"i\": to_world cannot be inverted"}},
         }) {
        CAPTURE(wrong.content);
        write_bytes(file.scene(), scene(a_sensor + wrong.content));
        std::string message;
        try {
            static_cast<void>(load_scene(file.scene(), {}));
        } catch (const Error& error) {
            message = error.what();
        }
        CHECK_MESSAGE(message.starts_with(file.scene().string() + ": "), message);
        for (const std::string& part : wrong.parts)
            CHECK_MESSAGE(message.find(part) != std::string::npos, message, " lacks ", part);
    }
}

TEST_CASE("the sun of a sky is a light that the sky's transform rotates") {
    const SceneFile file(scene(
        a_sensor + a_shape + "<emitter type='point'/>" +
        "<emitter type='sky'><vector name='sun_direction' x='1' y='1'/><float name='turbidity' value='3'/>"
        "<boolean name='sun' value='true'/><transform name='to_world'><rotate y='1' angle='90'/></transform>"
        "</emitter>"));
    const LoadedScene loaded = load_scene(file.scene(), {});
    REQUIRE(loaded.scene.light_ids().size() == 2);
    // The file's lights come first, because elements before lights are found by their ids.
    CHECK(loaded.scene.light(0).kind == LocalLight::Kind::point);
    const LocalLight& sun = loaded.scene.light(1);
    CHECK(sun.kind == LocalLight::Kind::directional);
    // 90 degrees about y take the sun from +x to -z.
    CHECK(glm::length(glm::dvec3(sun.to_world[2]) - glm::dvec3(0, -1, 1) / std::sqrt(2.0)) < 1e-12);
    CHECK(sun.value.size() == 3);
}

TEST_CASE("the pixels of a crop look where they do in the film, by its principal point") {
    const auto projection = [](const std::string& type, const std::string& film) {
        const SceneFile file(
            scene("<sensor type='" + type +
                  "'><transform name='to_world'><lookat origin='1, 2, 5' target='0, 0, 0' up='0, 1, 0'/>"
                  "</transform><film type='hdrfilm'><integer name='width' value='120'/>"
                  "<integer name='height' value='80'/>" +
                  film + "</sensor>" + a_shape));
        const LoadedScene loaded = load_scene(file.scene(), {});
        return std::pair(project(loaded.camera, loaded.width, loaded.height),
                         glm::dvec2(loaded.width, loaded.height));
    };
    const auto pixel = [](const auto& of, const glm::dvec3& point) {
        const glm::dvec4 clip = of.first.world_to_clip * glm::dvec4(point, 1);
        return (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * of.second;
    };
    constexpr glm::dvec3 point(0.3, -0.2, 0.5);
    const std::string crop =
        "<integer name='crop_offset_x' value='70'/><integer name='crop_width' value='31'/>"
        "<integer name='crop_offset_y' value='9'/><integer name='crop_height' value='60'/></film>";
    const std::string offset =
        "<float name='principal_point_offset_x' value='0.25'/>"
        "<float name='principal_point_offset_y' value='-0.1'/>";
    for (const char* type : {"perspective", "orthographic"}) {
        const auto whole = projection(type, "</film>");
        const auto part = projection(type, crop);
        CHECK(part.second == glm::dvec2(31, 60));
        CHECK(glm::distance(pixel(part, point), pixel(whole, point) - glm::dvec2(70, 9)) < 1e-9);
    }
    // With an offset of 0.25 a pixel has the ray of the pixel a quarter of the width further right.
    const auto whole = projection("perspective", "</film>");
    const auto moved = projection("perspective", "</film>" + offset);
    const auto both = projection("perspective", crop + offset);
    CHECK(glm::distance(pixel(moved, point), pixel(whole, point) - glm::dvec2(30, -8)) < 1e-9);
    CHECK(glm::distance(pixel(both, point), pixel(moved, point) - glm::dvec2(70, 9)) < 1e-9);
}

TEST_CASE("a path that is too long is that of a file which is not there") {
    const std::string longest(5000, 'x'), name(300, 'x');
    for (const std::string& place : {"/" + longest, longest, "/tmp/" + name, name}) {
        const auto missing = [&](const std::string& suffix, auto read) {
            check_error(
                ErrorCode::file_not_found, [&] { static_cast<void>(read(path(place + suffix))); }, place);
        };
        for (const char* suffix : {".obj", ".ply", ".off", ".stl"})
            missing(suffix, [](const path& file) { return load_mesh(file); });
        for (const char* suffix : {".exr", ".npz", "_s0.exr"})
            missing(suffix, [](const path& file) { return load_environment(file); });
        missing(".npz", [](const path& file) { return read_psh_matrix(file); });
        missing(".pbsdf", [](const path& file) { return load_measured(file); });
        missing(".xml", [](const path& file) { return load_scene(file, {}); });
        const SceneFile file("");
        for (const std::string& content :
             {"<include filename='" + place + "'/>", "<path value='" + place + "'/>" + obj(place + ".obj"),
              a_shape + "<emitter type='envmap'><string name='filename' value='" + place +
                  ".exr'/></emitter>"}) {
            write_bytes(file.scene(), scene(a_sensor + content));
            check_error(ErrorCode::file_not_found, CALL(load_scene(file.scene(), {})), file.scene().string());
        }
    }
}

TEST_CASE("a record is of the bytes that were read, also if the file changes meanwhile") {
    const TemporaryFolder folder;
    const path file = folder.write("a", "first");
    int reads = 0;
    const auto read = [&](int changes) {
        reads = 0;
        FileRecorder recorder({});
        const std::string bytes = recorder.read(std::span(&file, 1), [&] {
            std::string content = file_bytes(file);
            // The file is replaced by a new file of equal size, as editors save it.
            if (reads++ < changes) rename(folder.write("b", "next" + std::to_string(reads)), file);
            return content;
        });
        const std::vector<FileRecord> records = recorder.take();
        REQUIRE(records.size() == 1);
        CHECK(records[0].digest == record_of(file, bytes).digest);
        return bytes;
    };
    CHECK(read(0) == "first");
    CHECK(read(1) == "next1");
    CHECK(reads == 2);
    CHECK(error_of(CALL(read(100)), ErrorCode::invalid_file).find("changes while") != std::string::npos);
    CHECK(reads == 3);
}

TEST_CASE("what takes more than its limits is refused, and the option is named") {
    const SceneFile file(scene("<shape type='shapegroup' id='g'>" + obj("a.obj") + obj("b.obj") + "</shape>" +
                               a_sensor +
                               "<shape type='instance'><ref id='g'/></shape>"
                               "<shape type='instance'><ref id='g'/></shape>"));
    file.write("a.obj", a_triangle);
    file.write("b.obj", a_triangle);
    const LoadLimits exact{.bytes = 2 * a_triangle.size(), .vertices = 12, .triangles = 4};
    CHECK(load_scene(file.scene(), {}, exact).scene.ids().size() == 4);
    struct Case {
        const char* option;
        LoadLimits limits;
    };
    std::vector<Case> cases(4, {"", exact});
    cases[0].option = "load_bytes_limit", --cases[0].limits.bytes;
    cases[1].option = "vertex_limit", --cases[1].limits.vertices;
    cases[2].option = "triangle_limit", --cases[2].limits.triangles;
    cases[3].option = "load_seconds_limit", cases[3].limits.seconds = 0;
    for (const Case& one : cases)
        check_error(ErrorCode::unsupported, CALL(load_scene(file.scene(), {}, one.limits)), one.option,
                    file.path().string());
}

TEST_CASE("a grid of distances of a scene file becomes its surface, with the normals that the shape names") {
    const auto grid = [](const std::string& more) {
        return "<shape type='sdfgrid'><string name='filename' value='a.vol'/>" + more + "</shape>";
    };
    const std::string analytic = "<string name='normals' value='analytic'/>";
    const SceneFile file(scene(a_sensor + an_emitter + grid("") + grid(analytic) + grid("")));
    // Distances from the plane z = 0.25.
    std::string bytes("VOL\x03\1\0\0\0\2\0\0\0\2\0\0\0\2\0\0\0\1\0\0\0", 24);
    bytes.resize(48);
    for (const float value : {-0.25F, 0.75F})
        for (int i = 0; i < 4; ++i) bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    file.write("a.vol", bytes);
    const LoadedScene loaded = load_scene(file.scene(), {});
    REQUIRE(loaded.scene.instances().size() == 3);
    const auto mesh = [&](std::size_t i) { return loaded.scene.instances()[i].mesh; };
    for (const glm::vec3& position : mesh(0)->positions) CHECK(position.z == 0.25F);
    CHECK(mesh(1) != mesh(0));
    CHECK(mesh(2) == mesh(0));
    check_refused(SceneFile(scene(a_sensor + grid("<string name='normals' value='flat'/>"))),
                  ErrorCode::invalid_file, "", {"normals", "\"flat\"", "smooth or analytic"});
}

TEST_CASE("curves of a scene file become tubes, and the case of a shape's name does not matter") {
    const SceneFile file(scene(a_sensor + an_emitter +
                               "<shape type='Sphere'/>"
                               "<shape type='linearcurve'><string name='filename' value='a.txt'/></shape>"
                               "<shape type='bsplinecurve'><string name='filename' value='a.txt'/></shape>"
                               "<shape type='linearcurve'><string name='filename' value='a.txt'/>"
                               "<transform name='to_world'><scale value='2'/><translate x='5'/></transform>"
                               "</shape>"));
    file.write("a.txt", "0 0 0 0.1\n0 0 1 0.1\n1 0 1 0.1\n1 0 0 0.1\n");
    const LoadedScene loaded = load_scene(file.scene(), {});
    REQUIRE(loaded.scene.instances().size() == 4);
    const Mesh linear = load_curves(file / "a.txt", CurveKind::linear);
    const Mesh bspline = load_curves(file / "a.txt", CurveKind::bspline);
    CHECK(loaded.scene.instances()[1].mesh->positions.size() == linear.positions.size());
    CHECK(loaded.scene.instances()[2].mesh->positions.size() == bspline.positions.size());

    // The points move, from 0 0 0 to 5 0 0 and from 0 0 1 to 5 0 2, and radii stay.
    const Instance& moved = loaded.scene.instances()[3];
    glm::dvec3 low(9), high(-9);
    for (const glm::vec3& position : moved.mesh->positions) {
        const glm::dvec3 at(moved.to_world * glm::dvec4(position, 1));
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    CHECK(glm::distance(low, glm::dvec3(4.9, -0.1, -0.1)) < 1e-3);
    CHECK(glm::distance(high, glm::dvec3(7.1, 0.1, 2.1)) < 1e-3);
}

TEST_CASE("a scene without colours has one channel under a film of luminance") {
    const auto constant = [](const std::string& radiance) {
        return "<emitter type='constant'>" + radiance + "</emitter>\n";
    };
    const std::string grey = constant("<rgb name='radiance' value='0.5'/>"),
                      coloured = constant("<rgb name='radiance' value='0.5, 0.4, 0.3'/>"),
                      grey_shape = "<shape type='sphere'><bsdf type='diffuse'/></shape>\n",
                      red_shape =
                          "<shape type='sphere'><bsdf type='diffuse'>"
                          "<rgb name='reflectance' value='0.5, 0.1, 0.1'/></bsdf></shape>\n";
    struct Row {
        std::string content;
        int channels;
    };
    for (const Row& row : {Row{grey_shape, 1}, Row{grey + grey_shape, 1}, Row{coloured + grey_shape, 3},
                           Row{grey + red_shape, 3}, Row{grey + grey_shape + red_shape, 3},
                           Row{constant("<spectrum name='radiance' value='5'/>") + grey_shape, 3}}) {
        CAPTURE(row.content);
        for (const bool luminance : {false, true}) {
            CAPTURE(luminance);
            const std::string format = luminance ? "luminance" : "rgb";
            const SceneFile file(
                scene("<sensor type='perspective'><float name='fov' value='40'/>"
                      "<film type='hdrfilm'><string name='pixel_format' value='" +
                      format + "'/></film></sensor>\n" + row.content));
            CHECK(load_scene(file.scene(), {}).scene.channels() == (luminance ? row.channels : 3));
        }
    }
}
