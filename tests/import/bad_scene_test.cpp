// SPDX-License-Identifier: MIT
// Tests of scenes that must be refused, and of the error messages.
#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "geometry/mesh_format.hpp"
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Checks that reading fails with `code` and that the message names the file and contains every part.
void check_refused_text(const std::string& text, ErrorCode code, const std::vector<std::string>& parts,
                        const SceneParameters& parameters = {}) {
    CAPTURE(text.substr(0, 400));
    const SceneFile file(text);
    check_refused(file, code, file.scene().string(), parts, "", parameters);
}

void invalid(const std::string& content, const std::vector<std::string>& parts) {
    check_refused_text(scene(content), ErrorCode::invalid_file, parts);
}

void unsupported(const std::string& content, const std::vector<std::string>& parts) {
    check_refused_text(scene(content), ErrorCode::unsupported, parts);
}

std::string plastic_with(const std::string& parameters) {
    return a_sensor + an_emitter + a_shape + "<bsdf type='pplastic'>\n" + parameters + "</bsdf>";
}

std::string sensor_with(const std::string& parameters) {
    return an_emitter + a_shape + "<sensor type='perspective'>" + parameters + "</sensor>";
}

std::string film_with(const std::string& parameters) {
    return sensor_with("<float name='fov' value='40'/><film type='hdrfilm'>" + parameters + "</film>");
}

void bad_plastic(const std::string& parameters, const std::vector<std::string>& parts) {
    invalid(plastic_with(parameters), parts);
}
void bad_shape(const std::string& parameters, const std::vector<std::string>& parts) {
    invalid(shape_with(parameters), parts);
}
void bad_sensor(const std::string& parameters, const std::vector<std::string>& parts) {
    invalid(sensor_with(parameters), parts);
}
void bad_film(const std::string& parameters, const std::vector<std::string>& parts) {
    invalid(film_with(parameters), parts);
}

}  // namespace

TEST_CASE("files that cannot be read") {
    const SceneFile file("");
    const std::string pipe = file / "pipe.xml";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);  // nobody writes: opening it would block
    for (const std::string path : {"/no/such/scene.xml", "/tmp", "/dev/zero", pipe.c_str()})
        CHECK(error_of(CALL(read_mitsuba_scene(path)), ErrorCode::file_not_found).starts_with(path));
}

TEST_CASE("XML that is not well-formed, with line and column") {
    const ErrorCode code = ErrorCode::invalid_file;
    check_refused_text("", code, {"scene.xml:1:1: "});
    check_refused_text("not xml", code, {"scene.xml:1:"});
    check_refused_text("<scene version='3.0.0'>\n<sensor>\n</scene>", code, {"scene.xml:3:", "mismatch"});
    check_refused_text("<scene version='3.0.0'>\n  <a b=c/></scene>", code, {"scene.xml:2:"});
    check_refused_text("<scene version='3.0.0'>", code, {"scene.xml:1:"});
    check_refused_text(std::string("<scene\0version='3.0.0'/>", 24), code, {"scene.xml:1:"});
}

TEST_CASE("documents that are not scenes of Mitsuba 3") {
    check_refused_text("<html/>", ErrorCode::invalid_file, {":1: ", "<html>", "<scene version"});
    check_refused_text("<scene/>", ErrorCode::invalid_file, {"no version"});
    check_refused_text("<scene version='0.6.0'/>", ErrorCode::unsupported, {"0.6.0", "3.x.x"});
    check_refused_text("<scene version='30.0.0'/>", ErrorCode::unsupported, {"30.0.0"});
    invalid("", {"no <sensor>"});
    invalid(a_sensor, {"no <shape>"});
    invalid("\n words\n" + a_sensor + a_shape, {":3: text \"words\" inside <scene>"});
    invalid("<![CDATA[words]]>" + a_sensor + a_shape, {"text \"words\""});
}

TEST_CASE("plug-ins and elements that do not exist here, with what does") {
    unsupported("\n<shape type='hair'/>",
                {":3: shape \"hair\"", mesh_format_names() +
                                           ", sphere, rectangle, cube, disk, cylinder, linearcurve, "
                                           "bsplinecurve, sdfgrid, shapegroup, instance, merge"});
    unsupported("<bsdf type='hair'/>", {":2: bsdf \"hair\"", "pplastic, plastic, ", ", psh, twosided"});
    unsupported("<integrator type='bdpt'/>", {"integrator \"bdpt\"", "stokes, moment, aov, direct"});
    unsupported("<integrator type='stokes'><integrator type='prb'/></integrator>", {"\"prb\""});
    unsupported("<sensor type='batch'/>",
                {"sensor \"batch\"", "one image", "perspective, thinlens, orthographic"});
    invalid("<sensor type='thinlens'/>", {"sensor \"thinlens\"", "aperture_radius", "missing"});
    unsupported(sensor_with("<float name='fov' value='40'/><film type='specfilm'/>"),
                {"film \"specfilm\"", "hdrfilm"});
    unsupported(
        "<float name='x' value='1'/>",
        {"<float> inside <scene>",
         "accepted elements: integrator, sensor, emitter, bsdf, texture, shape, film, sampler, rfilter"});
    unsupported(a_sensor + scene(""), {"<scene> inside <scene>"});
    unsupported(shape_with("<medium type='homogeneous'/>"), {"<medium> inside shape", "opaque"});
    unsupported(shape_with("<sensor type='irradiancemeter'/>"),
                {"<sensor> inside shape", "elements: bsdf, emitter"});
    unsupported(plastic_with("<spectrum name='diffuse_reflectance' type='d65'/>"),
                {"<spectrum> inside", "a <spectrum> with a type is not supported"});
    unsupported(shape_with("<transform name='to_world'><shear x='1'/></transform>"), {"<shear>", "lookat"});
    invalid("<shape/>", {"<shape> has no type"});
}

TEST_CASE("unknown parameters, with the known ones") {
    bad_plastic("<float name='alhpa' value='0.1'/>",
                {":6: bsdf \"pplastic\": parameter \"alhpa\" is unknown", "alpha"});
    bad_shape("<string name='filename' value='a.obj'/>",
              {"shape \"sphere\": parameter \"filename\" is unknown", "radius"});
    for (const char* segments : {"7", "514"})
        bad_shape(std::string("<integer name='segments' value='") + segments + "'/>",
                  {"\"segments\"", segments});
    bad_sensor("<float name='fov' value='40'/><float name='aperture' value='1'/>", {"\"aperture\"", "fov"});
    bad_film("<integer name='widht' value='40'/>", {"film \"hdrfilm\": parameter \"widht\"", "width"});
    invalid(a_sensor + a_shape +
                "<emitter type='envmap'><string name='filename' value='a.exr'/><rgb name='radiance' "
                "value='1'/></emitter>",
            {"\"radiance\" is unknown", "filename"});
    bad_shape("<float value='1'/>", {"<float> without a name"});
    bad_shape("<float name='radius' value='1'/><float name='radius' value='2'/>",
              {"\"radius\" is given twice"});
    bad_shape("<float name='radius' velue='1'/>", {"attribute \"velue\"", "value"});
    bad_shape("<float name='radius' value='1'><float name='x' value='1'/></float>", {"elements inside"});
    invalid("<shape type='sphere' kind='x'/>", {"attribute \"kind\"", "type, id, name"});
    bad_shape("<transform name='to_wrld'/>", {"\"to_wrld\" is unknown", "to_world"});
}

TEST_CASE("values of the wrong type or outside their range") {
    bad_plastic("<string name='alpha' value='0.1'/>", {"\"alpha\" is given as <string>", "<float>"});
    bad_plastic("<float name='alpha' value='0'/>", {"\"alpha\" is 0", "from 0.001 to 1"});
    for (const char* number : {"nan", "inf", "-inf", "1e999", "", "x", "0.1f", "0x10", "1 2", "+-1", "++1"})
        bad_plastic(std::string("<float name='alpha' value='") + number + "'/>",
                    {"\"alpha\" is", "finite number"});
    bad_plastic("<float name='alpha'/>", {"\"alpha\" is \"\""});
    bad_plastic("<rgb name='diffuse_reflectance' value='1.1'/>", {"from 0 to 1"});
    bad_plastic("<rgb name='diffuse_reflectance' value='0.1, -0.1, 0'/>", {"from 0 to 1"});
    for (const char* color :
         {"", "1 2", "1 2 3 4", "1 nan 1", "#12345", "#1234567", "#12345g", "#-12345", "red"})
        bad_plastic(std::string("<rgb name='diffuse_reflectance' value='") + color + "'/>", {"#rrggbb"});
    for (const char* table :
         {"400:0.1", "400:0.1, 400:0.2", "500:0.1 400:0.2", "400:0.1 500", "400:0.1 :0.2",
          "400:0.1 500:", "400:0.1 500:nan", "-1:0.1 500:0.2", "0:0.1 1:0.2", "a:b c:d", ""})
        bad_plastic(std::string("<spectrum name='diffuse_reflectance' value='") + table + "'/>",
                    {":6: bsdf \"pplastic\": parameter \"diffuse_reflectance\"", "wavelength:value pairs"});
    bad_plastic("<spectrum name='diffuse_reflectance' value='400:0.1, 700:1.2'/>", {"from 0 to 1"});
    bad_plastic("<float name='diffuse_reflectance' value='400:0.1, 700:1'/>", {"a finite number"});
    bad_plastic("<string name='int_ior' value='cheese'/>", {"\"cheese\"", "bk7", "diamond"});
    bad_plastic("<float name='int_ior' value='-1.5'/>", {"\"int_ior\" is -1.5"});
    bad_plastic("<float name='int_ior' value='1.5'/><float name='ext_ior' value='1.5'/>", {"must differ"});
    bad_plastic("<string name='distribution' value='phong'/>", {"beckmann, ggx"});
    bad_shape("<float name='radius' value='-1'/>", {"above 0"});
    bad_shape("<point name='center' value='1 2'/>", {"one or three"});
    bad_shape("<point name='center' value='1' x='1'/>", {"both"});
    bad_shape("<point name='center' x='nan'/>", {"finite"});
    bad_shape("<boolean name='flip_normals' value='yes'/>", {"true or false"});
    invalid("<shape type='obj'/>", {"\"filename\" is missing"});
    invalid("<shape type='obj'><string name='filename' value='a.ply'/></shape>", {"a.ply", ".obj"});
    invalid("<emitter type='envmap'/>", {"\"filename\" is missing"});
    invalid("<emitter type='sky'/>", {"\"sun_direction\" is missing"});
    invalid("<emitter type='sky'><vector name='sun_direction' value='0'/></emitter>", {"no direction"});
    invalid(
        "<emitter type='sky'><vector name='sun_direction' y='1'/><float name='dop_max' "
        "value='1.5'/></emitter>",
        {"from 0 to 1"});
    invalid("<emitter type='constant'><rgb name='radiance' value='-1'/></emitter>", {"at least 0"});
}

TEST_CASE("cameras and films that cannot be") {
    for (const char* width : {"0", "-5", "100000000000", "1e99", "2.5", "99999999999999999999999", "nan", ""})
        bad_film(std::string("<integer name='width' value='") + width + "'/>",
                 {"\"width\" is", "from 1 to 32768"});
    bad_film("<float name='width' value='10'/>", {"<float>", "<integer>"});
    for (const char* crop : {"crop_width", "crop_height", "crop_offset_x", "crop_offset_y"})
        bad_film(std::string("<integer name='") + crop + "' value='1000'/>",
                 {"film \"hdrfilm\": parameter", crop, "is \"1000\"; expected"});
    bad_film("<integer name='crop_offset_x' value='700'/><integer name='crop_width' value='100'/>",
             {"\"crop_width\" is \"100\"", "from 1 to 68"});
    unsupported(film_with("<string name='pixel_format' value='xyz'/>"),
                {"\"pixel_format\"", "rgb and luminance"});
    unsupported(film_with("<string name='pixel_format' value='xyza'/>"), {"\"pixel_format\""});
    bad_film("<string name='pixel_format' value='bgr'/>", {"luminance, luminance_alpha, rgb"});
    bad_film("<string name='component_format' value='int8'/>", {"float32, float16, uint32"});
    unsupported(film_with("<string name='file_format' value='rgbe'/>"), {"\"file_format\"", "openexr"});
    unsupported(film_with("<string name='file_format' value='pfm'/>"), {"\"file_format\""});
    bad_film("<rfilter type='box'/><rfilter type='box'/>", {"second <rfilter>"});
    unsupported(film_with("<rfilter type='sinc'/>"), {"box, gaussian, tent, mitchell, catmullrom, lanczos"});
    bad_film("<rfilter type='gaussian'><float name='stddev' value='5'/></rfilter>", {"\"stddev\"", "0.125"});
    bad_film("<rfilter type='tent'><float name='width' value='2'/></rfilter>", {"\"width\""});
    for (const char* fov : {"0", "180", "-10", "nan"})
        bad_sensor(std::string("<float name='fov' value='") + fov + "'/>", {"\"fov\" is"});
    bad_sensor("<float name='fov' value='40'/><string name='fov_axis' value='z'/>", {"smaller, larger"});
    bad_sensor("<float name='fov' value='40'/><string name='focal_length' value='50mm'/>", {"beside fov"});
    for (const char* length : {"0mm", "-50mm", "mm", "", "50cm"})
        bad_sensor(std::string("<string name='focal_length' value='") + length + "'/>", {"millimetres"});
    bad_sensor("<float name='near_clip' value='0'/>", {"\"near_clip\" is 0"});
    bad_sensor("<float name='near_clip' value='5'/><float name='far_clip' value='5'/>",
               {"smaller than far_clip"});
    bad_sensor("<transform name='to_world'><scale value='2'/></transform>", {"\"to_world\" scales"});
    unsupported(sensor_with("<transform name='to_world'><scale x='-1'/></transform>"),
                {"sensor \"perspective\": parameter \"to_world\" mirrors"});
    bad_sensor("<float name='principal_point_offset_x' value='1e9'/>", {"\"principal_point_offset_x\" is"});
    bad_sensor("<film type='hdrfilm'/><film type='hdrfilm'/>", {"second <film>"});
}

TEST_CASE("transforms that cannot be") {
    const auto refused = [](const std::string& operations, const std::string& part) {
        bad_shape("<transform name='to_world'>" + operations + "</transform>", {part});
    };
    refused("<scale x='0'/>", "cannot be inverted");
    refused("<scale value='1e200'/><scale value='1e200'/>", "cannot be inverted");
    refused("<rotate angle='30'/>", "no length");
    refused("<rotate x='1'/>", "angle is \"\"");
    refused("<lookat origin='1,1,1' target='1,1,1' up='0,1,0'/>", "coincide");
    refused("<lookat origin='0,1,0' target='0,5,0' up='0,1,0'/>", "parallel");
    refused("<lookat origin='0,1,0' target='0,5' up='0,1,0'/>", "target is \"0,5\"");
    refused("<lookat origin='0,1,0' target='0,5,1' up='1'/>", "up is \"1\"");
    refused("<lookat origin='0,1,0' target='0,1,0'/>", "coincide");
    refused("<lookat target='0,1,0'/>", "origin is \"\"");
    refused("<matrix value='1 2 3'/>", "16 or 9");
    refused("<matrix value='1 0 0 0 0 1 0 0 0 0 nan 0 0 0 0 1'/>", "16 or 9");
    refused("<translate w='1'/>", "attribute \"w\"");
    unsupported(
        shape_with(
            "<transform name='to_world'><matrix value='1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1'/></transform>"),
        {"last row"});
}

TEST_CASE("ids and references") {
    invalid(a_sensor + "<bsdf type='diffuse' id='a'/>\n<bsdf type='diffuse' id='a'/>",
            {":4: id \"a\"", "scene.xml:3"});
    bad_shape("<ref id='nobody'/>", {"\"nobody\""});
    bad_shape("<ref/>", {"<ref> to \"\""});
    invalid(
        "<sensor type='orthographic' id='eye'/>" + a_shape + "<shape type='sphere'><ref id='eye'/></shape>",
        {"which is a <sensor>", "inside shape \"sphere\"", "bsdf"});
    bad_shape("<bsdf type='diffuse'/><bsdf type='diffuse'/>", {"second <bsdf>"});
    unsupported(an_emitter + an_emitter, {":3: a second emitter"});
}

TEST_CASE("$parameters") {
    bad_shape("<float name='radius' value='$size'/>", {"undefined parameter", "$size"});
    invalid("<default name='a' value='$b'/>", {":2: undefined parameter"});
    const SceneFile open(
        scene("<sensor type='perspective'><float name='fov' value='40'/><sampler type='independent'>"
              "<integer name='sample_count' value='$spp'/></sampler></sensor>" +
              a_shape));
    const std::vector<std::string> notices = read_mitsuba_scene(open.scene()).notices;
    CHECK(std::ranges::any_of(
        notices, [](const std::string& n) { return n.find("$parameter") != std::string::npos; }));
    invalid("<default name='size' value='1'/>" + shape_with("<float name='radius' value='$'/>"),
            {"undefined", "$size"});
    invalid("<default value='1'/>", {"<default> needs a name"});
    check_refused_text(scene("<default name='b' value='1'/>" + shape_with("")), ErrorCode::invalid_argument,
                       {"no parameter \"$a\"", "$b"}, {{"a", "1"}});
    const SceneFile file(scene(a_sensor + a_shape));
    CHECK_THROWS_AS(static_cast<void>(read_mitsuba_scene(file.scene(), {{"", "1"}})), Error);
    CHECK_THROWS_AS(static_cast<void>(read_mitsuba_scene(file.scene(), {{"$a", "1"}})), Error);
}

TEST_CASE("hostile documents are refused soon") {
    // Each parameter contains the previous one twice, which makes 2^60 characters without a limit.
    std::string doubling = "<default name='a0_' value='0123456789'/>\n";
    for (int i = 1; i < 60; ++i)
        doubling += "<default name='a" + std::to_string(i) + "_' value='$a" + std::to_string(i - 1) + "_$a" +
                    std::to_string(i - 1) + "_'/>\n";
    invalid(doubling, {"longer than 65536"});

    std::string nested;
    for (int i = 0; i < 100000; ++i) nested += "<shape type='x'>";
    for (int i = 0; i < 100000; ++i) nested += "</shape>";
    invalid(nested, {"nested more than 32 deep"});
    check_refused_text(std::string(100000, '<'), ErrorCode::invalid_file, {});

    const std::string entities =
        "<!-- --><!DOCTYPE scene [\n<!ENTITY a 'x'><!ENTITY b '&a;&a;&a;&a;'>]>\n<scene "
        "version='3.0.0'><sensor "
        "type='&b;'/></scene>";
    check_refused_text(entities, ErrorCode::unsupported,
                       {"scene.xml:1: <!DOCTYPE>", "entity \"a\"", "<default>"});
    check_refused_text("<!DOCTYPE scene [<!ENTITY % file SYSTEM '/etc/passwd'>]><scene version='3.0.0'/>",
                       ErrorCode::unsupported, {"entity \"file\""});
    unsupported("<shape type='sphere'><" + std::string(100000, 'n') + " value='1'/></shape>" + a_sensor,
                {"nnnn...> inside shape"});

    std::string huge = scene(a_sensor + a_shape);
    huge.append(std::size_t{17} << 20, ' ');
    check_refused_text(huge, ErrorCode::unsupported, {"16 MiB"});

    bad_shape("<float name='radius' value='" + std::string(1000000, '9') + "'/>", {"\"radius\""});
}

TEST_CASE("files of another kind are named as what they are") {
    struct Case {
        std::string name, bytes, kind;
    };
    const Case cases[] = {{"photograph.xml", "\x89PNG\r\n\x1a\n", "a PNG image"},
                          {"photograph", "\xff\xd8\xff\xe0", "a JPEG image"},
                          {"light.exr", std::string("\x76\x2f\x31\x01\2\0\0\0", 8), "an OpenEXR image"},
                          {"light.hdr", "#?RADIANCE\n", "a Radiance HDR image"},
                          {"bunny.PLY", "ply\nformat ascii 1.0\n", "a PLY mesh"},
                          {"bunny.obj", "v 0 0 0\n", "an OBJ mesh"},
                          {"bunny.xml", "# Exported\r\n#\r\n\r\nmtllib bunny.mtl\r\n", "an OBJ mesh"},
                          {"shape.xml", "\xef\xbb\xbfv\t0 0 0\n", "an OBJ mesh"},
                          {"cube.xml", "OFF\n8 6 12\n", "an OFF mesh"},
                          {"cube.stl", std::string(84, '\0'), "an STL mesh"},
                          {"saved.xml", "\n<!DOCTYPE HTML><html>", "a web page"},
                          {"lfs.xml", "version https://git-lfs.github.com/spec/v1\n", "git lfs pull"},
                          {"model.xml", " {\"asset\": {\"version\": \"2.0\"}}", "must end in .gltf"},
                          {"model.bin", "glTF\2", "must end in .glb"},
                          {"photograph.gltf", "\x89PNG\r\n\x1a\n", "a PNG image"},
                          {"scene.glb", "<?xml version='1.0'?><scene/>", "ends in .xml"},
                          {"empty.xml", "", "an empty file"}};
    const TemporaryFolder folder;
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const std::filesystem::path file = folder.path() / c.name;
        std::ofstream(file, std::ios::binary) << c.bytes;
        const std::string message = error_of(CALL(load_scene(file, {})), ErrorCode::invalid_file);
        CHECK(message.starts_with(file.string() + ": "));
        CHECK_MESSAGE(message.find(c.kind) != std::string::npos, message);
    }
    CHECK(error_of(CALL(load_scene(folder.path(), {})), ErrorCode::file_not_found)
              .ends_with("expected a file"));
    // Texts that only resemble the first bytes of a mesh are read as scenes.
    for (const char* const bytes : {"solidarity", "version 3", "v", "#", "# no line ends here"}) {
        CAPTURE(bytes);
        const std::filesystem::path text = folder.path() / "scene.txt";
        std::ofstream(text) << bytes;
        CHECK(error_of(CALL(load_scene(text, {})), ErrorCode::invalid_file).find(":1:") != std::string::npos);
    }
}

TEST_CASE("a scene cut short anywhere or with bytes changed never does worse than fail") {
    const std::string text = scene(
        "<default name='k' value='1'/><sensor type='perspective'><float name='fov' value='40'/>"
        "<transform name='to_world'><lookat origin='0,0,5' target='0,0,0' up='0,1,0'/></transform></sensor>" +
        an_emitter + "<shape type='sphere'><float name='radius' value='$k'/><bsdf type='pplastic'/></shape>");
    std::mt19937 random(3);
    int failures = 0;
    const auto attempt = [&](const std::string& changed) {
        const SceneFile file(changed);
        try {
            static_cast<void>(read_mitsuba_scene(file.scene()));
        } catch (const Error& e) {
            CHECK(e.code() != ErrorCode::internal);
            ++failures;
        }
    };
    for (std::size_t size = 0; size < text.size(); size += 3) attempt(text.substr(0, size));
    for (int i = 0; i < 500; ++i) {
        std::string changed = text;
        for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<char>(random());
        attempt(changed);
    }
    CHECK(failures > 500);
}
