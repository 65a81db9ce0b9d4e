// SPDX-License-Identifier: MIT
// Tests of glTF extensions that change what a material is.
#include "import/gltf_file.hpp"

using namespace nicol;

namespace {

std::string required(const std::string& name) {
    return ",\"extensionsUsed\":[\"" + name + "\"],\"extensionsRequired\":[\"" + name + "\"]";
}

}  // namespace

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
          Case{variants("{\"mappings\":[{\"variants\":[0],\"material\":-7}]}"), "refers to materials[-7]"}}) {
        CAPTURE(c.rest);
        const GltfFile file(triangle_buffer(), c.rest);
        const std::string message = error_of(CALL(read_gltf_scene(file.scene())), ErrorCode::invalid_file);
        CHECK(message.starts_with(file.scene().string() + ": "));
        CHECK_MESSAGE(message.find(c.part) != std::string::npos, message);
    }
}
