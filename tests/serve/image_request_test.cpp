// SPDX-License-Identifier: MIT
#include "image_request.hpp"

#include <doctest/doctest.h>

#include <set>
#include <sstream>

#include "openapi.hpp"
#include "parameters.hpp"
#include "refused.hpp"

namespace {

SceneInfo scene() {
    SceneInfo info;
    info.id = "snail";
    info.digest = "00";
    info.channels = 3;
    info.width = 1024;
    info.height = 768;
    info.orbit = {.azimuth = -10, .elevation = 5, .distance = 4, .target = {0, 1, 0}};
    return info;
}

ImageRequest parse(const std::string& query, Format format = Format::png, const SceneInfo& info = scene(),
                   const Limits& limits = {}) {
    return parse_image(parse_target("/x?" + query), format, 0, info, limits);
}

std::string text(const std::string& query, Format format = Format::png) {
    return canonical(parse(query, format), scene());
}

}  // namespace

TEST_CASE("without parameters it is the scene's own image") {
    const ImageRequest request = parse("");
    CHECK(request.view.camera == CameraKind::scene);
    CHECK(request.view.width == 1024);
    CHECK(request.view.height == 768);
    CHECK(request.observer == Observer::s0);
    CHECK(request.view.order_low == -1);
}

TEST_CASE("a film beyond the limits is made smaller, in proportion") {
    const Limits limits{.max_side = 512, .max_pixels = 60000, .max_order = 9};
    const View view = parse("", Format::png, scene(), limits).view;
    CHECK(view.width * view.height <= 60000);
    CHECK(view.width == doctest::Approx(282).epsilon(0.01));
    CHECK(view.height == doctest::Approx(212).epsilon(0.01));
}

TEST_CASE("an orbit takes what is not said from the scene's camera") {
    const View view = parse("azimuth=-30").view;
    CHECK(view.camera == CameraKind::orbit);
    CHECK(view.orbit.azimuth == 330);
    CHECK(view.orbit.elevation == 5);
    CHECK(view.orbit.distance == 4);
    CHECK(view.orbit.target[1] == 1);
    CHECK(parse("target=1,2,3").view.orbit.target[2] == 3);
}

TEST_CASE("equal requests have one text") {
    const std::string base = text("azimuth=30&size=64x64");
    CHECK(base == text("size=64x64&azimuth=30.0"));
    CHECK(base == text("size=64x64&azimuth=-330"));
    CHECK(base == text("size=064x64&azimuth=3e1&elevation=5&distance=4&target=0,1,-0"));
    CHECK(base == text("azimuth=30&size=64x64&observer=s0&exposure=0&light=360"));
    CHECK(base == text("azimuth=30&size=64x64&expires=99"));
    // The scale has no effect on s0.
    CHECK(base == text("azimuth=30&size=64x64&scale=3"));
    CHECK(text("polarizer=10") == text("observer=polarizer&polarizer=190"));
    CHECK(text("observer=s1&exposure=3") == text("observer=s1"));
    CHECK(text("observer=s1&scale=3", Format::exr) == text("observer=s1", Format::exr));
}

TEST_CASE("other requests have another text") {
    std::istringstream all(
        "azimuth=30 azimuth=31 elevation=6 distance=3 target=0,1,1 fov=40 light=1 light_tilt=1 order_low=3 "
        "order_low=4 order_low=0 order_high=9 order_high=8 tolerance=0.1 tolerance=0.2 samples=4 samples=64 "
        "observer=s1 "
        "observer=s2 observer=s3 observer=dolp observer=aolp polarizer=0 polarizer=1 exposure=1 "
        "observer=s1&scale=2 size=10x20 size=20x10 matrix=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1 "
        "matrix=1,0,0,0,0,1,0,0,0,0,1,2,0,0,0,1");
    std::set<std::string> texts = {text("")};
    for (std::string query; all >> query;) CHECK_MESSAGE(texts.insert(text(query)).second, query);
    CHECK(texts.size() == 31);
    for (const Format format :
         {Format::exr, Format::stokes_exr, Format::stokes_planes, Format::stokes_f16, Format::stokes_f32})
        CHECK(texts.insert(text("", format)).second);
    CHECK(texts.insert(text("bits=6", Format::stokes_planes)).second);
    CHECK(texts.insert(text("bits=7", Format::stokes_planes)).second);
    ImageRequest compressed = parse("", Format::stokes_planes);
    compressed.deflate = true;
    CHECK(texts.insert(canonical(compressed, scene())).second);
    SceneInfo other = scene();
    other.id = "other";
    CHECK(texts.insert(canonical(parse(""), other)).second);
}

TEST_CASE("what lies outside its range is refused by name and range") {
    const struct {
        const char* query;
        const char* parameter;
        const char* range;
    } cases[] = {
        {"azimuth=361", "azimuth", "-360 to 360"},
        {"azimuth=nan", "azimuth", "-360 to 360"},
        {"azimuth=inf", "azimuth", "-360 to 360"},
        {"azimuth=", "azimuth", "-360 to 360"},
        {"azimuth=1x", "azimuth", "-360 to 360"},
        {"azimuth= 1", "azimuth", "-360 to 360"},
        {"azimuth=+1", "azimuth", "-360 to 360"},
        {"elevation=90", "elevation", "-89 to 89"},
        {"distance=0", "distance", "0.001 to 1e+06"},
        {"target=1,2", "target", "3 numbers"},
        {"target=1,2,3,4", "target", "3 numbers"},
        {"target=1,,3", "target", "3 numbers"},
        {"matrix=1", "matrix", "16 numbers"},
        {"matrix=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1&azimuth=3", "matrix", "16 numbers"},
        {"fov=0", "fov", "1 to 170"},
        {"fov=171", "fov", "1 to 170"},
        {"light=400", "light", "-360 to 360"},
        {"light_tilt=200", "light_tilt", "-180 to 180"},
        {"order_low=17", "order_low", "whole numbers from 0 to 16"},
        {"order_low=1.5", "order_low", "whole numbers from 0 to 16"},
        {"order_low=9&order_high=8", "order_high", "whole numbers from 0 to 16"},
        {"tolerance=0", "tolerance", "0.0001 to 1"},
        {"tolerance=0.1&order_low=2", "tolerance", "0.0001 to 1"},
        {"samples=0", "samples", "whole numbers from 1 to 64"},
        {"samples=65", "samples", "whole numbers from 1 to 64"},
        {"observer=S0", "observer", "s0, s1, s2, s3, dolp, aolp, polarizer"},
        {"observer=s1&polarizer=3", "observer", "s0, s1"},
        {"polarizer=1e9", "polarizer", "-360 to 360"},
        {"exposure=21", "exposure", "-20 to 20"},
        {"scale=0", "scale", "1e-06 to 1e+06"},
        {"size=0x1", "size", "WIDTHxHEIGHT, each 1 to 2048"},
        {"size=2049x1", "size", "WIDTHxHEIGHT, each 1 to 2048"},
        {"size=99999999999999999999x1", "size", "WIDTHxHEIGHT, each 1 to 2048"},
        {"size=-1x1", "size", "WIDTHxHEIGHT"},
        {"size=64", "size", "WIDTHxHEIGHT"},
        {"size=64x", "size", "WIDTHxHEIGHT"},
        {"size=64x64x64", "size", "WIDTHxHEIGHT"},
        {"size=2048x2048", "size", "at most 2097152 pixels"},
        {"colour=red", "colour", "one of size, azimuth"},
    };
    for (const auto& wrong : cases) {
        const Problem problem = refused([&] { parse(wrong.query); });
        CHECK_MESSAGE(problem.status == 400, wrong.query);
        CHECK_MESSAGE(problem.parameter == wrong.parameter, wrong.query);
        CHECK_MESSAGE(problem.range.starts_with(wrong.range), wrong.query << ": " << problem.range);
        CHECK_MESSAGE(!problem.detail.empty(), wrong.query);
    }
}

TEST_CASE("Stokes data has no observer") {
    CHECK(parse("azimuth=1", Format::stokes_f16).view.orbit.azimuth == 1);
    for (const char* query : {"observer=s0", "polarizer=1", "exposure=1", "scale=1"})
        CHECK_MESSAGE(refused([&] { parse(query, Format::stokes_exr); }).status == 400, query);
    CHECK(parse("bits=10", Format::stokes_planes).bits == 10);
    for (const Format format : {Format::png, Format::exr, Format::stokes_exr, Format::stokes_f16})
        CHECK(refused([&] { parse("bits=6", format); }).parameter == "bits");
    for (const char* query : {"bits=0", "bits=11", "bits=1.5"})
        CHECK_MESSAGE(refused([&] { parse(query, Format::stokes_planes); }).parameter == "bits", query);
}

TEST_CASE("channels that are no colour have no colour image") {
    SceneInfo spectral = scene();
    spectral.channels = 5;
    CHECK(refused([&] { parse("", Format::png, spectral); }).parameter == "observer");
    CHECK(refused([&] { parse("polarizer=3", Format::png, spectral); }).parameter == "observer");
    CHECK(parse("observer=dolp", Format::png, spectral).observer == Observer::dolp);
    CHECK(parse("", Format::exr, spectral).observer == Observer::s0);
}

TEST_CASE("the description names every parameter and the limits that hold") {
    Options options;
    options.limits.max_order = 7;
    const std::string json = openapi(options);
    for (const Parameter& parameter : parameters(options.limits))
        CHECK_MESSAGE(json.find("\"name\":\"" + parameter.name + "\"") != std::string::npos, parameter.name);
    for (const Resource& resource : resources)
        CHECK(json.find("/scenes/{id}/" + std::string(resource.name)) != std::string::npos);
    CHECK(json.find("\"minimum\":0,\"maximum\":7") != std::string::npos);
    CHECK(json.find("\"sig\"") == std::string::npos);
    options.keys = "some";
    CHECK(openapi(options).find("\"sig\"") != std::string::npos);
}
