// SPDX-License-Identifier: MIT
// Tests of valid scenes and their descriptions.
#include "import/described_material.hpp"
#include "import/scene_file.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using P = PplasticParameters;

void check_equal(const glm::dmat4& matrix, const glm::dmat4& expected) {
    CHECK(largest_difference(matrix, expected) < 1e-12);
}

}  // namespace

TEST_CASE("defaults are Mitsuba's") {
    const SceneDescription s = read("<sensor type='orthographic'/>" + an_emitter + a_shape +
                                    "<shape type='sphere'><bsdf type='pplastic'/></shape>");
    CHECK(s.sensor.kind == SensorDescription::Kind::orthographic);
    CHECK(s.sensor.width == 768);
    CHECK(s.sensor.sample_count == 0);
    CHECK(s.sensor.height == 576);
    CHECK(s.sensor.near_clip == 1e-2);
    CHECK(s.sensor.far_clip == 1e4);
    check_equal(s.sensor.to_world, glm::dmat4(1.0));
    REQUIRE(s.shapes.size() == 2);
    CHECK(s.shapes[0].kind == ShapeDescription::Kind::sphere);
    CHECK(s.shapes[0].radius == 1.0);
    CHECK(s.shapes[0].center == glm::dvec3(0.0));
    CHECK_FALSE(s.shapes[0].flip_normals);
    REQUIRE(s.materials.size() == 2);
    CHECK(s.shapes[0].material == 0);
    CHECK(as<DiffuseModel>(s.materials[0]).reflectance.rgb == glm::dvec3(0.5));
    const auto plastic = as<PplasticModel>(s.materials[1]);
    CHECK(color(plastic, &P::diffuse_reflectance).rgb == glm::dvec3(0.5));
    CHECK(color(plastic, &P::specular_reflectance).rgb == glm::dvec3(1.0));
    CHECK(plastic.parameters.int_ior == 1.49);
    CHECK(plastic.parameters.ext_ior == 1.000277);
    CHECK(number(plastic, &P::alpha).value == 0.1);
    CHECK(plastic.parameters.distribution == Distribution::beckmann);
    REQUIRE(s.environment);
    CHECK(s.environment->kind == EnvironmentDescription::Kind::constant);
    CHECK(s.environment->radiance.rgb == glm::dvec3(1.0));
    CHECK(s.notices.empty());
}

TEST_CASE("everything that a scene can hold is read") {
    const SceneFile file(::scene(R"(
<?xml-stylesheet none?><!-- a comment -->
<integrator type="stokes"><integrator type="direct"/></integrator>
<sensor type="perspective" id="camera">
  <float name="fov" value="30"/><string name="fov_axis" value="larger"/>
  <float name="near_clip" value="0.5"/><integer name="far_clip" value="50"/><float name="focus_distance" value="3"/>
  <sampler type="independent"><integer name="sample_count" value="4"/></sampler>
  <film type="hdrfilm"><integer name="width" value="300"/><integer name="height" value="400"/>
    <string name="pixel_format" value="rgb"/><string name="component_format" value="float32"/><rfilter type="box"/></film>
</sensor>
<sensor type="batch"/>
<emitter type="envmap"><string name="filename" value="light/sky.exr"/><float name="scale" value="2.5"/>
  <transform name="to_world"><rotate y="1" angle="90"/></transform></emitter>
<shape type="ply" id="first"><string name="filename" value="../first.PLY"/><boolean name="face_normals" value="TRUE"/>
  <ref id="gold"/></shape>
<bsdf type="psh" id="gold"><string name="filename" value="/data/gold.npz"/><rgb name="scale" value="2, 3 4"/></bsdf>
<shape type="sphere"><point name="center" x="1" z="3"/><float name="radius" value="0.25"/>
  <boolean name="flip_normals" value="true"/>
  <bsdf type="pplastic"><rgb name="diffuse_reflectance" value="#ff8000"/><spectrum name="specular_reflectance" value="0.25"/>
    <string name="int_ior" value="BK7"/><string name="ext_ior" value="water"/><float name="alpha" value="+3e-1"/>
    <string name="distribution" value="ggx"/></bsdf></shape>
<shape type="rectangle"><ref name="bsdf" id="gold"/></shape>
<shape type="cube"/><shape type="off"><string name="filename" value="a.off"/></shape>
<shape type="stl"><string name="filename" value="a.stl"/></shape><shape type="obj"><string name="filename" value="a.obj"/></shape>
<shape type="serialized"><string name="filename" value="a.serialized"/><integer name="shape_index" value="2"/></shape>
)"));
    const SceneDescription s = read_mitsuba_scene(file.scene());
    CHECK(s.sensor.kind == SensorDescription::Kind::perspective);
    CHECK(s.sensor.fov == 30.0);
    CHECK(s.sensor.fov_axis == SensorDescription::FovAxis::larger);
    CHECK(s.sensor.near_clip == 0.5);
    CHECK(s.sensor.far_clip == 50.0);
    CHECK(s.sensor.width == 300);
    CHECK(s.sensor.height == 400);
    REQUIRE(s.environment);
    CHECK(s.environment->kind == EnvironmentDescription::Kind::envmap);
    CHECK(s.environment->filename == file / "light" / "sky.exr");
    CHECK(s.environment->scale == 2.5);
    // A rotation of 90 degrees about y maps z to x.
    CHECK(glm::distance(glm::dvec3(s.environment->to_world * glm::dvec4(0, 0, 1, 0)), glm::dvec3(1, 0, 0)) <
          1e-12);
    REQUIRE(s.shapes.size() == 8);
    CHECK(s.shapes[0].id == "first");
    CHECK(s.shapes[7].index == 2);
    CHECK(s.shapes[0].filename == file.path().parent_path() / "first.PLY");
    CHECK(s.shapes[0].face_normals);
    CHECK(s.shapes[1].center == glm::dvec3(1, 0, 3));
    CHECK(s.shapes[1].radius == 0.25);
    CHECK(s.shapes[1].flip_normals);
    using Kind = ShapeDescription::Kind;
    const std::pair<Kind, const char*> kinds[] = {
        {Kind::file, ".PLY"}, {Kind::sphere, ""},   {Kind::rectangle, ""}, {Kind::cube, ""},
        {Kind::file, ".off"}, {Kind::file, ".stl"}, {Kind::file, ".obj"}};
    for (std::size_t i = 0; i < 7; ++i) {
        CHECK(s.shapes[i].kind == kinds[i].first);
        CHECK(s.shapes[i].filename.extension() == kinds[i].second);
    }
    // Materials shared by reference are made once.
    REQUIRE(s.materials.size() == 3);
    CHECK(s.shapes[0].material == s.shapes[2].material);
    CHECK(s.shapes[3].material == s.shapes[6].material);
    const MaterialDescription& gold = s.materials[s.shapes[0].material];
    CHECK(gold.id == "gold");
    CHECK(as<PshModel>(gold).filename == "/data/gold.npz");
    CHECK(as<PshModel>(gold).scale.rgb == glm::dvec3(2, 3, 4));
    const auto plastic = as<PplasticModel>(s.materials[s.shapes[1].material]);
    CHECK(glm::distance(color(plastic, &P::diffuse_reflectance).rgb, glm::dvec3(1.0, 128.0 / 255.0, 0.0)) <
          1e-12);
    CHECK(color(plastic, &P::specular_reflectance).rgb == glm::dvec3(0.25));
    CHECK(plastic.parameters.int_ior == 1.5046);
    CHECK(plastic.parameters.ext_ior == 1.333);
    CHECK(number(plastic, &P::alpha).value == doctest::Approx(0.3));
    CHECK(plastic.parameters.distribution == Distribution::ggx);
    REQUIRE(s.notices.size() == 2);
    CHECK(s.notices[0] ==
          file.scene().string() + ":4: not followed: integrator \"stokes\", integrator \"direct\".");
    CHECK(s.notices[1].find("scene.xml:12: only the first") != std::string::npos);
}

TEST_CASE("the reconstruction filter is the film's, with Mitsuba's defaults") {
    using Kind = ReconstructionFilter::Kind;
    const std::initializer_list<std::pair<std::string, ReconstructionFilter>> cases = {
        {"", {.kind = Kind::gaussian, .size = 0.5}},
        {"<rfilter type='box'/>", {.kind = Kind::box}},
        {"<rfilter type='gaussian'/>", {.kind = Kind::gaussian, .size = 0.5}},
        {"<rfilter type='gaussian'><float name='stddev' value='0.8'/></rfilter>",
         {.kind = Kind::gaussian, .size = 0.8}},
        {"<rfilter type='tent'/>", {.kind = Kind::tent, .size = 1}},
        {"<rfilter type='tent'><float name='radius' value='2'/></rfilter>", {.kind = Kind::tent, .size = 2}},
        {"<rfilter type='mitchell'/>", {.kind = Kind::mitchell}},
        {"<rfilter type='mitchell'><float name='B' value='0.2'/><float name='C' value='0.4'/></rfilter>",
         {.kind = Kind::mitchell, .b = 0.2, .c = 0.4}},
        {"<rfilter type='catmullrom'/>", {.kind = Kind::catmullrom}},
        {"<rfilter type='lanczos'/>", {.kind = Kind::lanczos, .size = 3}},
        {"<rfilter type='lanczos'><integer name='lobes' value='2'/></rfilter>",
         {.kind = Kind::lanczos, .size = 2}}};
    for (const auto& [filter, expected] : cases) {
        CAPTURE(filter);
        const SceneDescription s = read(
            "<sensor type='perspective'><float name='fov' value='40'/><film "
            "type='hdrfilm'>" +
            filter + "</film></sensor>" + an_emitter + a_shape);
        CHECK(s.sensor.filter == expected);
        CHECK(s.notices.empty());
    }
}

TEST_CASE("the number of samples of a pixel is the sampler's") {
    struct Case {
        std::string sampler;
        std::uint32_t count;
        std::size_t notices;
    };
    const std::initializer_list<Case> cases = {
        {"<sampler type='independent'/>", 4, 0},
        {"<sampler type='multijitter'><integer name='sample_count' value='256'/></sampler>", 256, 0},
        {"<sampler type='ldsampler'><integer name='seed' value='1'/></sampler>", 4, 0},
        {"<sampler type='independent'><integer name='sample_count' value='0'/></sampler>", 4, 1},
        {"<sampler type='independent'><integer name='sample_count' value='many'/></sampler>", 4, 1}};
    for (const Case& one : cases) {
        CAPTURE(one.sampler);
        const SceneFile file(::scene("<sensor type='perspective'><float name='fov' value='40'/>" +
                                     one.sampler + "</sensor>" + a_shape));
        const SceneDescription s = read_mitsuba_scene(file.scene());
        CHECK(s.sensor.sample_count == one.count);
        CHECK(s.notices.size() == one.notices);
    }
}

TEST_CASE("our own emitters") {
    const SceneDescription sky = read(a_sensor + a_shape +
                                      "<emitter type='sky'><vector name='sun_direction' value='0, 3, 4'/>"
                                      "<rgb name='radiance' value='2'/></emitter>");
    REQUIRE(sky.environment);
    CHECK(sky.environment->kind == EnvironmentDescription::Kind::sky);
    CHECK(glm::distance(sky.environment->sun_direction, glm::dvec3(0, 0.6, 0.8)) < 1e-12);
    CHECK(sky.environment->dop_max == 0.8);
    CHECK(sky.environment->radiance.rgb == glm::dvec3(2.0));
    const SceneDescription psh =
        read(a_sensor + a_shape + "<emitter type='psh'><string name='filename' value='a.npz'/></emitter>");
    CHECK(psh.environment->kind == EnvironmentDescription::Kind::psh);
    CHECK(psh.environment->filename.filename() == "a.npz");
    CHECK(psh.environment->scale == 1.0);
}

TEST_CASE("a scene may have no light") {
    const SceneDescription s = read(a_sensor + a_shape);
    CHECK_FALSE(s.environment);
    CHECK(s.notices.empty());
}

TEST_CASE("lookat: +z forward, +x left, +y up") {
    // The camera looks from z = 5 towards the origin: forward is -z, and left is -x.
    check_equal(transform("<lookat origin='0,0,5' target='0,0,0' up='0,1,0'/>"),
                glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, -1, 0),
                           glm::dvec4(0, 0, 5, 1)));
    // The camera looks along +x: left is up x forward = y x x = -z.
    check_equal(transform("<lookat origin='1,2,3' target='4,2,3' up='0,2,0'/>"),
                glm::dmat4(glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(1, 0, 0, 0),
                           glm::dvec4(1, 2, 3, 1)));
    // The camera looks down, and z is up in the image.
    check_equal(transform("<lookat origin='0,4,0' target='0,0,0' up='0,0,1'/>"),
                glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, -1, 0, 0),
                           glm::dvec4(0, 4, 0, 1)));
}

TEST_CASE("operations apply in the order in which they are written") {
    // The point is scaled, then rotated from x to y, then translated.
    const glm::dmat4 m = transform("<scale value='2'/><rotate z='1' angle='90'/><translate x='10'/>");
    CHECK(glm::distance(glm::dvec3(m * glm::dvec4(1, 0, 0, 1)), glm::dvec3(10, 2, 0)) < 1e-12);
    const glm::dmat4 reversed = transform("<translate x='10'/><rotate z='1' angle='90'/><scale value='2'/>");
    CHECK(glm::distance(glm::dvec3(reversed * glm::dvec4(1, 0, 0, 1)), glm::dvec3(0, 22, 0)) < 1e-12);
    check_equal(transform("<scale x='1.25' y='1.25'/><lookat origin='0,0,5' target='0,0,0' up='0,1,0'/>"),
                glm::dmat4(glm::dvec4(-1.25, 0, 0, 0), glm::dvec4(0, 1.25, 0, 0), glm::dvec4(0, 0, -1, 0),
                           glm::dvec4(0, 0, 5, 1)));
    check_equal(transform("<matrix value='1 2 3 4  0 1 5 6  0 0 1 7  0 0 0 1'/>"),
                glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(2, 1, 0, 0), glm::dvec4(3, 5, 1, 0),
                           glm::dvec4(4, 6, 7, 1)));
    check_equal(transform("<matrix value='0,1,0, 1,0,0, 0,0,1'/>"),
                glm::dmat4(glm::dvec4(0, 1, 0, 0), glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0),
                           glm::dvec4(0, 0, 0, 1)));
    check_equal(transform(""), glm::dmat4(1.0));
    // The length of the axis has no effect.
    check_equal(transform("<rotate value='0, 5, 0' angle='-30'/>"),
                transform("<rotate y='0.1' angle='-30'/>"));
}

TEST_CASE("parameters: defaults, overrides, the longest name, within other parameters") {
    const std::string content =
        "<default name='r' value='1'/><default name='radius' value='2'/><default name='place' "
        "value='$r,$radius,3'/>" +
        a_sensor + an_emitter +
        "<shape type='sphere'><float name='radius' value='$radius'/><point name='center' "
        "value='$place'/></shape>"
        "<shape type='obj'><string name='filename' value='$folder/a$r.obj'/></shape>";
    const SceneDescription s = read(content, {{"folder", "/meshes"}, {"r", "7"}});
    CHECK(s.shapes.at(0).radius == 2.0);
    CHECK(s.shapes.at(0).center == glm::dvec3(7, 2, 3));
    CHECK(s.shapes.at(1).filename == "/meshes/a7.obj");
    // A parameter counts as used even if it stands only in an ignored element.
    CHECK_NOTHROW(static_cast<void>(
        read(a_sensor + a_shape + "<integrator type='path'><integer name='n' value='$depth'/></integrator>",
             {{"depth", "3"}})));
}

TEST_CASE("the field of view along any axis") {
    SensorDescription sensor;
    sensor.width = 400;
    sensor.height = 300;
    sensor.fov = 90.0;
    using Axis = SensorDescription::FovAxis;
    const auto along = [&](Axis axis) {
        sensor.fov_axis = axis;
        return std::tan(horizontal_fov(sensor) * std::numbers::pi / 360.0);
    };
    CHECK(along(Axis::x) == doctest::Approx(1.0));
    CHECK(along(Axis::larger) == doctest::Approx(1.0));
    CHECK(along(Axis::y) == doctest::Approx(4.0 / 3.0));
    CHECK(along(Axis::smaller) == doctest::Approx(4.0 / 3.0));
    CHECK(along(Axis::diagonal) == doctest::Approx(0.8));
    // Without fov the lens is 50 mm before 36 x 24 mm film, whose width spans 2 atan(18 / 50) in that aspect.
    const SceneDescription s = read(
        "<sensor type='perspective'><film type='hdrfilm'><integer name='width' value='600'/>"
        "<integer name='height' value='400'/></film></sensor>" +
        a_shape);
    CHECK(horizontal_fov(s.sensor) ==
          doctest::Approx(2.0 * std::atan(18.0 / 50.0) * 180.0 / std::numbers::pi));
}
