// SPDX-License-Identifier: MIT
// Tests of scenes of several files.
#include "import/described_material.hpp"
#include "import/scene_file.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr auto invalid = ErrorCode::invalid_file;
constexpr auto unsupported = ErrorCode::unsupported;
constexpr auto missing = ErrorCode::file_not_found;

const std::string scene_end = a_sensor + an_emitter + a_shape;

}  // namespace

TEST_CASE("an included scene stands where it is included") {
    const SceneFile file(::scene("<shape type='cube'/><include filename='parts/two.xml'/>" + a_sensor +
                                 an_emitter + "<shape type='rectangle'><ref id='shared'/></shape>"));
    file.write("parts/two.xml", ::scene("<shape type='sphere'><bsdf type='pplastic' id='shared'/></shape>"
                                        "<include filename='three.xml'/><shape type='sphere'/>"));
    file.write("parts/three.xml",
               ::scene("<shape type='obj'><string name='filename' value='mesh.obj'/></shape>"));
    const SceneDescription s = read_mitsuba_scene(file.scene());
    REQUIRE(s.shapes.size() == 5);
    using Kind = ShapeDescription::Kind;
    const Kind kinds[] = {Kind::cube, Kind::sphere, Kind::file, Kind::sphere, Kind::rectangle};
    for (std::size_t i = 0; i < 5; ++i) CHECK(s.shapes[i].kind == kinds[i]);
    CHECK(s.shapes[4].material == s.shapes[1].material);
    CHECK(is<PplasticModel>(s.materials.at(s.shapes[4].material)));
    // The path is relative to the file that contains it.
    CHECK(s.shapes[2].filename == file / "parts" / "mesh.obj");
}

TEST_CASE("the id of a <scene> names nothing") {
    const SceneFile file(::scene("<include filename='a.xml'/><include filename='a.xml'/>" + scene_end));
    file.write("a.xml", "<scene version='3.0.0' id='scene'>" + a_shape + "</scene>");
    CHECK(read_mitsuba_scene(file.scene()).shapes.size() == 3);
}

TEST_CASE("an included object stands where it is included") {
    const SceneFile file(
        ::scene(a_sensor + an_emitter +
                "<shape type='sphere'><include name='surface' filename='plastic.xml'/></shape>"
                "<shape type='cube'><include filename='many.xml'/></shape>"));
    file.write("plastic.xml",
               "<bsdf version='3.0.0' type='pplastic'><float name='alpha' value='0.25'/></bsdf>");
    file.write("many.xml", ::scene("<bsdf type='conductor'/>"));
    const SceneDescription s = read_mitsuba_scene(file.scene());
    REQUIRE(s.shapes.size() == 2);
    CHECK(as<PplasticModel>(s.materials.at(s.shapes[0].material)).parameters.alpha.value == 0.25);
    CHECK(as<MetalModel>(s.materials.at(s.shapes[1].material)).parameters.alpha.value == 0);
}

TEST_CASE("parameters and defaults cross includes, and the caller's win") {
    const SceneFile file(::scene("<default name='r' value='1'/><include filename='$part.xml'/>" + a_sensor +
                                 an_emitter +
                                 "<shape type='sphere'><float name='radius' value='$late'/></shape>"));
    file.write("b.xml",
               ::scene("<default name='r' value='2'/><default name='late' value='3'/>"
                       "<default name='over' value='4'/>"
                       "<shape type='sphere'><point name='center' value='$r,$late,$over'/></shape>"));
    const SceneDescription s = read_mitsuba_scene(file.scene(), {{"part", "b"}, {"over", "5"}});
    CHECK(s.shapes.at(0).center == glm::dvec3(1, 3, 5));
    CHECK(s.shapes.at(1).radius == 3.0);
    CHECK_THROWS_WITH_AS(
        static_cast<void>(read_mitsuba_scene(file.scene(), {{"part", "b"}, {"late", "7"}, {"no", "1"}})),
        doctest::Contains("no parameter \"$no\""), Error);
}

TEST_CASE("files are searched in <path>s, the folder of the file, and those of the including files") {
    const SceneFile file(
        ::scene("<path value='first'/><path value='second'/><include filename='sub/a.xml'/>" + a_sensor +
                an_emitter));
    const auto obj = [](const std::string& name) {
        return "<shape type='obj'><string name='filename' value='" + name + ".obj'/></shape>";
    };
    file.write("first/both.obj", "");
    file.write("second/both.obj", "");
    file.write("first/one.obj", "");
    file.write("sub/both.obj", "");
    file.write("root.obj", "");
    file.write("inner/deep.obj", "");
    file.write("sub/inner/deep.obj", "");
    file.write("sub/a.xml",
               ::scene(obj("both") + obj("one") + obj("root") + obj("none") + "<path value='inner'/>" +
                       obj("deep") + "<path value='" + (file / "first").string() + "'/>"));
    const SceneDescription s = read_mitsuba_scene(file.scene());
    REQUIRE(s.shapes.size() == 5);
    // The <path>s of a file precede its folder, wherever they stand in the file.
    CHECK(s.shapes[0].filename == file / "first" / "both.obj");
    CHECK(s.shapes[1].filename == file / "first" / "one.obj");
    CHECK(s.shapes[2].filename == file / "root.obj");
    CHECK(s.shapes[3].filename == file / "sub" / "none.obj");
    CHECK(s.shapes[4].filename == file / "sub" / "inner" / "deep.obj");

    const SceneFile newest(::scene("<path value='first'/><path value='second'/>" + obj("both") + scene_end));
    newest.write("first/both.obj", "");
    newest.write("second/both.obj", "");
    CHECK(read_mitsuba_scene(newest.scene()).shapes.at(0).filename == newest / "second" / "both.obj");
}

TEST_CASE("an <alias> is another name for what has an id") {
    const SceneFile file(
        ::scene(a_sensor + an_emitter +
                "<bsdf type='pplastic' id='a'/><alias id='a' as='b'/><alias id='b' as='c'/>"
                "<shape type='sphere'><ref id='a'/></shape><shape type='sphere'><ref id='c'/></shape>"));
    const SceneDescription s = read_mitsuba_scene(file.scene());
    CHECK(s.materials.size() == 1);
    CHECK(s.shapes.at(0).material == s.shapes.at(1).material);
    const std::string start = scene_end + "<bsdf type='diffuse' id='a'/>\n";
    const auto refused = [&](const std::string& alias, const std::string& part) {
        const SceneFile bad(::scene(start + alias + "<bsdf type='diffuse' id='late'/>"));
        check_refused(bad, invalid, bad.scene().string() + ":6: ", {part});
    };
    refused("<alias id='a' as='a'/>", "id \"a\" is taken by the element at");
    refused("<alias id='late' as='b'/>", "\"late\", an id that no element above has");
    refused("<alias id='a'/>", "<alias> needs");
    refused("<alias id='a' as='b' to='c'/>", "attribute \"to\"");
    refused("<alias id='a' as='b'/><bsdf type='diffuse' id='b'/>", "id \"b\" is taken");
    refused("<alias id='a' as='b'><bsdf type='diffuse'/></alias>", "elements inside");
}

TEST_CASE("errors in an included file name its line and who includes it") {
    const SceneFile file(::scene("\n<include filename='a.xml'/>" + scene_end));
    const std::string a = (file / "a.xml").string(), b = (file.path() / "b.xml").string();
    file.write("a.xml", ::scene("<include filename='b.xml'/>"));
    const std::string ending = " (included by a.xml:2, by scene.xml:3)";
    const struct {
        std::string content;
        ErrorCode code;
        std::string start;
    } faults[] = {
        {::scene("\n<shape type='hair'/>"), unsupported, ":3: shape \"hair\""},
        {"<scene version='3.0.0'>\n<shape", invalid, ":2:"},
        {"<scene/>", invalid, ":1: <scene> has no version"},
        {"<scene version='0.6'/>", unsupported, ":1: scene version"},
        {"<scene version='3.0.0' kind='x'/>", invalid, ":1: <scene> has an attribute \"kind\""},
        {"<!DOCTYPE x [<!ENTITY lol 'lol'>]><scene version='3.0.0'/>", unsupported, ":1: <!DOCTYPE>"},
        {::scene("<float name='x' value='$y'/>"), invalid, ":2: undefined parameter"}};
    for (const auto& fault : faults) {
        file.write("b.xml", fault.content);
        check_refused(file, fault.code, b + fault.start, {}, ending);
    }
    file.write("b.xml", ::scene("<bsdf type='diffuse' id='x'/>"));
    file.write("a.xml", ::scene("<bsdf type='diffuse' id='x'/><include filename='b.xml'/>"));
    check_refused(file, invalid, b + ":2: id \"x\" is taken by the element at " + a + ":2", {}, ending);
}

TEST_CASE("includes that cannot be") {
    const auto refused = [](const std::string& content, ErrorCode code, const std::string& part) {
        const SceneFile file(::scene("\n" + content + scene_end));
        file.write("diffuse.xml", "<bsdf version='3.0.0' type='diffuse'/>");
        file.write("radius.xml", ::scene("<float name='radius' value='2'/>"));
        check_refused(file, code, "", {part});
    };
    refused("<include filename='none.xml'/>", missing, "scene.xml:3: <include> of");
    refused("<include filename='.'/>", missing, "no such file");
    refused("<include/>", invalid, "<include> needs a filename");
    refused("<include filename='a.xml' version='3'/>", invalid, "attribute \"version\"");
    refused("<include filename='diffuse.xml'><bsdf type='diffuse'/></include>", invalid, "elements inside");
    refused(
        "<shape type='sphere'><transform name='to_world'><include "
        "filename='diffuse.xml'/></transform></shape>",
        unsupported, "<include> in <transform>");
    refused("<shape type='sphere'><include filename='radius.xml'/></shape>", invalid,
            "parameter in an included file");
    refused("<path value='none'/>", missing, "scene.xml:3: <path>: \"none\" is no folder");
    refused("<path/>", missing, "no folder");
    refused("<shape type='sphere'><path value='.'/></shape>", invalid, "<path> in <shape>");
    std::string folders;
    for (int i = 0; i < 101; ++i) folders += "<path value='.'/>";
    refused(folders, unsupported, "more than 100 folders");
}

TEST_CASE("circular includes are refused") {
    const SceneFile file(::scene("<include filename='a.xml'/>" + scene_end));
    file.write("a.xml",
               ::scene("\n<include filename='../" + file.path().filename().string() + "/scene.xml'/>"));
    check_refused(file, invalid, (file / "a.xml").string() + ":3: <include> of", {"goes in a circle"},
                  " (included by scene.xml:2)");
    file.write("a.xml", ::scene("<include filename='a.xml'/>"));
    check_refused(file, invalid, (file / "a.xml").string() + ":2: ", {"goes in a circle"},
                  " (included by scene.xml:2)");
}

TEST_CASE("includes are bounded in depth, number and size") {
    const auto number = [](int i) { return std::to_string(i) + ".xml"; };
    const auto chain_of = [&](int depth) {
        auto file = std::make_unique<SceneFile>(::scene("<include filename='1.xml'/>" + scene_end));
        for (int i = 1; i < depth; ++i)
            file->write(number(i), ::scene("<include filename='" + number(i + 1) + "'/>"));
        file->write(number(depth), ::scene(a_shape));
        return file;
    };
    CHECK(read_mitsuba_scene(chain_of(15)->scene()).shapes.size() == 2);
    const auto deep = chain_of(16);
    check_refused(*deep, invalid, (*deep / "15.xml").string() + ":2: ",
                  {"more than 15 deep", "(included by 14.xml:2, by 13.xml:2"}, ", by scene.xml:2)");

    // Four includes per level make 4^8 files without a limit.
    const SceneFile wide(::scene("<include filename='1.xml'/>" + scene_end));
    for (int i = 1; i < 9; ++i) {
        std::string content;
        for (int k = 0; k < 4; ++k) content += "<include filename='" + number(i + 1) + "'/>";
        wide.write(number(i), ::scene(content));
    }
    wide.write("9.xml", ::scene(""));
    check_refused(wide, unsupported, "", {"more than 1000 included files"});

    const SceneFile large(::scene("<include filename='a.xml'/><include filename='a.xml'/>" + scene_end));
    large.write("a.xml", ::scene(std::string(std::size_t{9} << 20, ' ')));
    check_refused(large, unsupported, (large / "a.xml").string(), {"16 MiB"}, " (included by scene.xml:2)");
}
