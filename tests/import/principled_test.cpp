// SPDX-License-Identifier: MIT
// Tests of Mitsuba's principled material in scene files.
#include "material/principled.hpp"
#include "import/described_material.hpp"
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"
#include "material/spatial_variation.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

std::string bsdf(const std::string& parameters) {
    return "<bsdf type='principled'>" + parameters + "</bsdf>";
}

std::string value_of(const std::string& name, const std::string& value) {
    return "<float name='" + name + "' value='" + value + "'/>";
}

std::string board(const std::string& name) {
    return "<texture name='" + name + "' type='checkerboard'>" + value_of("color0", "0.75") +
           value_of("color1", "0.25") + "</texture>";
}

const std::string numbers[] = {"roughness", "anisotropic", "metallic", "spec_trans", "spec_tint",
                               "sheen",     "sheen_tint",  "flatness", "clearcoat",  "clearcoat_gloss"};

MaterialPtr made(const std::string& parameters) {
    const SceneFile file(::scene(shape_with(bsdf(parameters))));
    return load_scene(file.scene(), {}).scene.instances().at(0).material;
}

void refused(const std::string& parameters, const std::vector<std::string>& parts,
             ErrorCode code = ErrorCode::invalid_file) {
    const SceneFile file(::scene(shape_with(bsdf(parameters))));
    check_refused(file, code, file.scene().string(), parts);
}

}  // namespace

TEST_CASE("principled parameters of a scene are those of the material") {
    CHECK(made("")->content_key() == principled({.base_color = {0.5, 0.5, 0.5}})->content_key());
    CHECK(made("<rgb name='base_color' value='0.2,0.4,0.6'/>" + value_of("roughness", "0.3") +
               value_of("anisotropic", "0.15") + value_of("metallic", "0.2") +
               value_of("spec_trans", "0.35") + value_of("specular", "0.25") + value_of("spec_tint", "0.4") +
               value_of("sheen", "0.6") + value_of("sheen_tint", "0.7") + value_of("flatness", "0.8") +
               value_of("clearcoat", "0.9") + value_of("clearcoat_gloss", "0.1") +
               value_of("main_specular_sampling_rate", "2"))
              ->content_key() == principled({.base_color = {0.2, 0.4, 0.6},
                                             .roughness = 0.3,
                                             .anisotropic = 0.15,
                                             .metallic = 0.2,
                                             .spec_trans = 0.35,
                                             .eta = index_of_specular(0.25),
                                             .spec_tint = 0.4,
                                             .sheen = 0.6,
                                             .sheen_tint = 0.7,
                                             .flatness = 0.8,
                                             .clearcoat = 0.9,
                                             .clearcoat_gloss = 0.1})
                                     ->content_key());
    CHECK(made(value_of("eta", "1.8"))->content_key() ==
          principled({.base_color = {0.5, 0.5, 0.5}, .eta = 1.8})->content_key());
}

TEST_CASE("every principled parameter but the index may be a texture") {
    std::string all = board("base_color");
    for (const std::string& name : numbers) all += board(name);
    const SceneDescription description = read_shape(bsdf(all));
    using P = PrincipledParameters;
    const auto model = as<PrincipledModel>(description.materials.at(0));
    CHECK(color(model, &P::base_color).texture);
    for (const auto parameter : {&P::roughness, &P::anisotropic, &P::metallic, &P::spec_trans, &P::spec_tint,
                                 &P::sheen, &P::sheen_tint, &P::flatness, &P::clearcoat, &P::clearcoat_gloss})
        CHECK(number(model, parameter).texture);
    refused(board("eta"), {"\"eta\" is a texture"}, ErrorCode::unsupported);
}

TEST_CASE("notices of what principled does here are one for all of them") {
    const auto notices = [](const std::string& first, const std::string& second) {
        std::string all;
        for (const std::string& notice :
             read(shape_with(bsdf(first)) + "<shape type='cube'>" + bsdf(second) + "</shape>").notices)
            all += notice;
        return all;
    };
    const auto count = [](const std::string& text, const std::string& part) {
        std::size_t found = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
        return found;
    };
    const std::string opaque = notices("", "");
    CHECK(count(opaque, "depolarizes") == 1);
    CHECK(count(opaque, "spec_trans") == 0);
    const std::string clear = notices(value_of("spec_trans", "0.5"), board("spec_trans"));
    CHECK(count(clear, "depolarizes") == 1);
    CHECK(count(clear, "spec_trans") == 1);
}

TEST_CASE("principled parameters out of range, with place and range") {
    for (const std::string& name : numbers)
        for (const char* value : {"-0.5", "1.5"})
            refused(value_of(name, value), {"principled", "\"" + name + "\" is " + value, "from 0 to 1"});
    refused("<rgb name='base_color' value='0.5,1.5,0'/>", {"\"base_color\""});
    refused(value_of("specular", "2"), {"\"specular\" is 2", "from 0 to 1"});
    refused(value_of("eta", "0"), {"\"eta\" is 0", "from 0.001 to 1000"});
    refused(value_of("eta", "1.5") + value_of("specular", "0.5"), {"\"specular\" is given beside eta"});
    refused(value_of("diff_trans", "0.5"), {"\"diff_trans\" is unknown", "spec_trans"});
}
