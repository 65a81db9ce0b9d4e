// SPDX-License-Identifier: MIT
// Tests of glTF extensions that change what a material is.
#include "image/color.hpp"
#include "import/described_material.hpp"
#include "import/textured_gltf_file.hpp"
#include "material/dielectric.hpp"

using namespace nicol;

namespace {

const std::string unlit = "\"extensions\":{\"KHR_materials_unlit\":{}}";
const std::string red_base = ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,0.125,0.75]}";

std::string required(const std::string& name) {
    return ",\"extensionsUsed\":[\"" + name + "\"],\"extensionsRequired\":[\"" + name + "\"]";
}
std::string with_material(const std::string& members, const std::string& more) {
    return one_mesh(",\"material\":0") + ",\"nodes\":[{\"mesh\":0}],\"materials\":[{" + members + "}]" + more;
}
std::string glossy(const std::string& members) {
    return "\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{" + members + "}}";
}

void check_near(const glm::dvec3& a, const glm::dvec3& b) {
    CAPTURES(a.x, a.y, a.z, b.x, b.y, b.z);
    CHECK(glm::distance(a, b) < 1e-5);
}

const glm::dvec3 up(0, 0, 1);

/// Returns what a material reflects straight back, times pi, in each channel.
glm::dvec3 reflected(const Material& material) {
    glm::dvec3 out;
    for (int c = 0; c < 3; ++c) out[c] = pi * evaluate(material, c, up, up)(0, 0);
    return out;
}
/// Returns what a white mirror of this roughness reflects straight back, times pi.
double of_mirror(double alpha) {
    return pi *
           evaluate(*rough_conductor({.alpha = alpha, .distribution = Distribution::ggx}), 0, up, up)(0, 0);
}

}  // namespace

TEST_CASE("unlit glTF is black and emits its base colour, flat, with one notice") {
    struct Case {
        std::string members, more;
        bool two_sided, masked;
    };
    for (const Case& c :
         {Case{unlit + red_base, "", false, false},
          Case{unlit + red_base, required("KHR_materials_unlit"), false, false},
          Case{unlit + red_base + ",\"doubleSided\":true,\"emissiveFactor\":[1,1,1]", "", true, false},
          Case{unlit + red_base + ",\"alphaMode\":\"BLEND\"", "", false, true}}) {
        CAPTURES(c.members, c.more);
        const GltfFile file(triangle_buffer(), with_material(c.members, c.more));
        const SceneDescription scene = read_gltf_scene(file.scene());
        REQUIRE(scene.notices.size() == 1);
        CHECK(has_notice(scene, "KHR_materials_unlit: the base colour is the radiance of a black surface"));
        const MaterialDescription& d = scene.materials.at(0);
        CHECK(is<MaskModel>(d) == c.masked);
        CHECK(as<DiffuseModel>(c.masked ? as<MaskModel>(d).base : d).black());
        const Instance instance = load_scene(file.scene(), {}).scene.instances().at(0);
        REQUIRE(instance.emission);
        CHECK(instance.emission->radiance == std::vector{0.5, 0.25, 0.125});
        CHECK(instance.emission->two_sided == c.two_sided);
    }
}

TEST_CASE("light passes glTF's transmission: a sheet, or a body with an index and Beer's absorption") {
    const auto made = [](const std::string& pbr, const std::string& transmission, const std::string& volume) {
        const std::string members = "\"doubleSided\":true,\"pbrMetallicRoughness\":{" + pbr +
                                    "},\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.4},"
                                    "\"KHR_materials_transmission\":{" +
                                    transmission + "},\"KHR_materials_volume\":{" + volume + "}}";
        const GltfFile file(triangle_buffer(), with_material(members, ""));
        CHECK(read_gltf_scene(file.scene()).notices.empty());
        return load_scene(file.scene(), {}).scene.instances().at(0).material;
    };
    const std::string color = "\"baseColorFactor\":[0.25,1,0.16,1],\"metallicFactor\":0,\"roughnessFactor\":";
    const std::string all = "\"transmissionFactor\":1";

    const MaterialPtr sheet = made(color + "0", all, "");
    REQUIRE(sheet->smooth_boundary() != nullptr);
    CHECK(sheet->smooth_boundary()->behind == SmoothBoundary::Behind::slab);
    CHECK(sheet->smooth_boundary()->alpha == 0);
    CHECK(sheet->smooth_boundary()->eta == doctest::Approx(1.4));
    CHECK(sheet->smooth_boundary()->transmittance[0] == doctest::Approx(0.25));

    const MaterialPtr body = made(color + "0.5", "\"transmissionFactor\":0.5",
                                  "\"thicknessFactor\":1,\"attenuationDistance\":2,"
                                  "\"attenuationColor\":[0.5,1,0]");
    REQUIRE(body->smooth_boundary() != nullptr);
    const SmoothBoundary& boundary = *body->smooth_boundary();
    CHECK(boundary.behind == SmoothBoundary::Behind::body);
    CHECK(boundary.alpha == doctest::Approx(0.25));
    CHECK(boundary.transmittance[2] == doctest::Approx(0.5 * 0.4));
    CHECK(boundary.absorption[0] == doctest::Approx(std::log(2) / 2));
    CHECK(boundary.absorption[1] == 0);
    CHECK(boundary.absorption[2] > 2);
    // Half of the base's light passes.
    const MaterialPtr opaque = made(color + "0.5", "\"transmissionFactor\":0", "");
    CHECK(opaque->smooth_boundary() == nullptr);
    const glm::dvec3 whole = reflected(*opaque), half = reflected(*body);
    CHECK(whole.y - half.y == doctest::Approx(4 * (whole.x - half.x)).epsilon(1e-3));
    CHECK(whole.y - half.y > 0.3);
    CHECK(made("\"metallicFactor\":1", all, "")->smooth_boundary() == nullptr);
}

TEST_CASE("unlit glTF emits its texture times the colours of vertices, without normals") {
    const std::string base =
        ",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0},\"baseColorFactor\":[0.5,1,1,1]}";
    const TexturedFile file(unlit + base, "", "\"TEXCOORD_0\":1,\"COLOR_0\":3,\"NORMAL\":3");
    const LoadedScene loaded = file.load();
    const Instance& instance = loaded.scene.instances().at(0);
    REQUIRE(instance.emission);
    REQUIRE(instance.emission->texture);
    check_near(glm::dvec3(instance.emission->texture->at({.uv = {0.5, 0.5}, .color = {1, 0.5, 0.25}})),
               {0.5 * srgb_to_linear(0.2F), 0.5 * srgb_to_linear(0.4F), 0.25 * srgb_to_linear(0.8F)});
    for (const glm::vec3& normal : instance.mesh->normals) CHECK(normal == glm::vec3(0, 0, 1));
    CHECK(instance.mesh->colors == std::vector<glm::vec3>{{1, 0.5, 0.25}, {1, 1, 1}, {0, 0, 0}});
}

TEST_CASE("surfaces of glTF with variants have the default material, or else the first variant's") {
    struct Case {
        std::string material, mappings, name;  ///< no name: white metal
    };
    const std::string both = R"({"material":1,"variants":[1]},{"material":2,"variants":[2,0]})";
    for (const Case& c : {Case{",\"material\":0", both, "default"}, Case{"", both, "first"},
                          Case{"", R"({"material":1,"variants":[1]})", ""}, Case{"", "", ""}}) {
        CAPTURES(c.material, c.mappings);
        const GltfFile file(
            triangle_buffer(),
            one_mesh(c.material + ",\"extensions\":{\"KHR_materials_variants\":{\"mappings\":[" + c.mappings +
                     "]}}") +
                R"(,"nodes":[{"mesh":0}],"materials":[{"name":"default"},{"name":"second"},{"name":"first"}])" +
                required("KHR_materials_variants"));
        const SceneDescription scene = read_gltf_scene(file.scene());
        CHECK(scene.materials.at(scene.shapes.at(0).material).id == c.name);
        REQUIRE(scene.notices.size() == 1);
        CHECK(has_notice(scene, "KHR_materials_variants"));
    }
}

TEST_CASE("specular and glossiness of glTF reflect the specular colour at normal incidence") {
    struct Case {
        std::string members;
        glm::dvec3 specular;
        double roughness;
        bool diffuse;  ///< in blue
    };
    const std::string image = ",\"specularGlossinessTexture\":{\"index\":0}";
    const glm::dvec3 texel(srgb_to_linear(0.2F), srgb_to_linear(0.4F), srgb_to_linear(0.8F));
    const std::string blue = "\"diffuseFactor\":[0,0,0.5,1]", black = "\"diffuseFactor\":[0,0,0,1]";
    for (const Case& c :
         {Case{blue + ",\"specularFactor\":[0.04,0.02,0.04],\"glossinessFactor\":0.25",
               {0.04, 0.02, 0.04},
               0.75,
               true},
          Case{blue + ",\"specularFactor\":[0.7,0.02,0.3],\"glossinessFactor\":0", {0.7, 0.02, 0.3}, 1, true},
          Case{black + ",\"specularFactor\":[0.9,0.5,0.1],\"glossinessFactor\":0.5",
               {0.9, 0.5, 0.1},
               0.5,
               false},
          Case{black + ",\"specularFactor\":[0.01,0.04,0],\"glossinessFactor\":0.5",
               {0.01, 0.04, 0},
               0.5,
               false},
          Case{blue + image, texel, 1 - 128.0 / 255, true},
          Case{black + image, texel, 1 - 128.0 / 255, false},
          Case{blue + ",\"specularFactor\":[0.5,1,1],\"glossinessFactor\":0.5" + image,
               texel * glm::dvec3(0.5, 1, 1), 1 - 64.0 / 255, true}}) {
        CAPTURE(c.members);
        const TexturedFile file(glossy(c.members));
        const SceneDescription scene = file.read();
        REQUIRE(scene.notices.size() == 1);
        CHECK(has_notice(scene, "KHR_materials_pbrSpecularGlossiness is followed as"));
        const LoadedScene loaded = file.load();
        glm::dvec3 actual = reflected(*loaded.scene.instances().at(0).material);
        const glm::dvec3 expected = c.specular * of_mirror(c.roughness * c.roughness);
        CHECK((actual.z > expected.z + 0.01) == c.diffuse);
        if (c.diffuse) actual.z = expected.z;
        CAPTURES(actual.x, actual.y, actual.z, expected.x, expected.y, expected.z);
        CHECK(glm::distance(actual, expected) < 1e-3 * glm::length(expected));
    }
}

TEST_CASE("the diffuse colour beside glTF's specular colour") {
    const auto diffuse = [](const std::string& members) {
        const LoadedScene loaded = TexturedFile(glossy(members)).load();
        return reflected(*loaded.scene.instances().at(0).material);
    };
    const std::string specular = ",\"specularFactor\":[0.52,0.04,0.04],\"glossinessFactor\":0";
    const glm::dvec3 texel(srgb_to_linear(0.2F), srgb_to_linear(0.4F), srgb_to_linear(0.8F));
    for (const auto& [members, color] :
         {std::pair{std::string("\"diffuseFactor\":[0.5,0.25,0.125,1]"), glm::dvec3(0.5, 0.25, 0.125)},
          {"\"diffuseTexture\":{\"index\":0},\"diffuseFactor\":[1,0.5,1,1]",
           texel * glm::dvec3(1, 0.5, 1)}}) {
        CAPTURE(members);
        const MaterialPtr plastic = pplastic({.diffuse_reflectance = {color.x, color.y, color.z},
                                              .int_ior = 1.5,
                                              .ext_ior = 1,
                                              .alpha = 1,
                                              .distribution = Distribution::ggx});
        check_near(diffuse(members + specular),
                   glm::dvec3(0.5, 1, 1) * reflected(*plastic) + glm::dvec3(0.5 * of_mirror(1), 0, 0));
    }
    const TexturedFile masked(glossy("\"diffuseTexture\":{\"index\":0}") + ",\"alphaMode\":\"BLEND\"");
    CHECK(is<MaskModel>(masked.material()));
}

TEST_CASE("specular and glossiness of glTF win over metal and roughness only where they are required") {
    const std::string members = glossy("\"specularFactor\":[0.04,0.04,0.04]") + red_base;
    const std::string name = "KHR_materials_pbrSpecularGlossiness";
    const auto read = [&](const std::string& of, const std::string& more) {
        return read_gltf_scene(GltfFile(triangle_buffer(), with_material(of, more)).scene());
    };
    const SceneDescription core = read(members, "");
    CHECK(is<MetalModel>(core.materials.at(0)));
    CHECK(has_notice(core, name + " is not followed"));
    const auto diffuse = [](const SceneDescription& scene) {
        return color(as<PplasticModel>(scene.materials.at(0)), &PplasticParameters::diffuse_reflectance).rgb;
    };
    CHECK(diffuse(read(members, required(name))) == glm::dvec3(1));
    // Extensions that describe metal and roughness are left out beside it.
    const SceneDescription both =
        read("\"extensions\":{\"" + name + "\":{},\"KHR_materials_iridescence\":{\"iridescenceFactor\":1}}",
             required(name));
    CHECK(has_notice(both, "KHR_materials_iridescence is not followed beside " + name));
    CHECK(diffuse(read(glossy("\"specularFactor\":[0.04,0.04,0.04]"), "")) == glm::dvec3(1));
}

TEST_CASE("values of glTF's extensions that are refused, by element") {
    struct Case {
        std::string rest, part;
    };
    const auto variants = [](const std::string& value) {
        return one_mesh(",\"extensions\":{\"KHR_materials_variants\":" + value + "}") +
               ",\"nodes\":[{\"mesh\":0}],\"materials\":[{}]";
    };
    const std::string primitive = "meshes[0].primitives[0]: KHR_materials_variants: ";
    for (const Case& c :
         {Case{variants("{\"mappings\":7}"), primitive + "mappings is not an array"},
          Case{variants("{\"mappings\":[3]}"), primitive + "mappings has an element"},
          Case{variants("{\"mappings\":[{\"variants\":0}]}"), primitive + "variants is not an array"},
          Case{variants("{\"mappings\":[{\"variants\":[0.5]}]}"), primitive + "variants has an element"},
          Case{variants("{\"mappings\":[{\"variants\":[0]}]}"), primitive + "material is not a whole number"},
          Case{variants("{\"mappings\":[{\"variants\":[0],\"material\":\"a\"}]}"), primitive + "material is"},
          Case{variants("{\"mappings\":[{\"variants\":[0],\"material\":5}]}"), "refers to materials[5]"},
          Case{variants("{\"mappings\":[{\"variants\":[0],\"material\":-7}]}"), "refers to materials[-7]"},
          Case{with_material(glossy("\"diffuseFactor\":[1,1,1]"), ""),
               "materials[0]: diffuseFactor is not an array of 4 finite numbers"},
          Case{with_material(glossy("\"diffuseFactor\":[1,1,\"a\",1]"), ""), "diffuseFactor is not an array"},
          Case{with_material(glossy("\"specularFactor\":2"), ""), "specularFactor is not an array of 3"},
          Case{with_material(glossy("\"specularFactor\":[2,0,0]"), ""), "specularFactor is 2"},
          Case{with_material(glossy("\"glossinessFactor\":-1"), ""), "glossinessFactor is -1"},
          Case{with_material(glossy("\"glossinessFactor\":\"a\""), ""), "glossinessFactor is not a finite"},
          Case{with_material(glossy("\"diffuseTexture\":{\"index\":\"a\"}"), ""),
               "diffuseTexture: index is not a whole number"},
          Case{with_material(unlit + ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[2,1,1,1]}", ""),
               "baseColorFactor is 2"}}) {
        CAPTURE(c.rest);
        const GltfFile file(triangle_buffer(), c.rest);
        const std::string message = error_of(CALL(read_gltf_scene(file.scene())), ErrorCode::invalid_file);
        CHECK(message.starts_with(file.scene().string() + ": "));
        CHECK_MESSAGE(message.find(c.part) != std::string::npos, message);
    }
    const TexturedFile none(glossy("\"diffuseTexture\":{\"index\":4}"));
    CHECK(error_of(CALL(none.read()), ErrorCode::invalid_file)
              .find("materials[0].diffuseTexture: refers to textures[4]") != std::string::npos);
}
