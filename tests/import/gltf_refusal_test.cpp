// SPDX-License-Identifier: MIT
// Tests of glTF files: ignored elements, refusals, and the files that are read.
#include "import/gltf_file.hpp"

using namespace nicol;

namespace {

std::string number(std::uint32_t n) {
    return {reinterpret_cast<const char*>(&n), 4};
}

/// Returns the bytes of a GLB file.
std::string glb(std::string json, const std::string& bytes) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto length = [](std::size_t n) { return number(static_cast<std::uint32_t>(n)); };
    return "glTF" + number(2) + length(28 + json.size() + bytes.size()) + length(json.size()) + "JSON" +
           json + length(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

/// Returns the JSON of a file whose material 0 has these members.
std::string with_material(const std::string& members) {
    return one_mesh(",\"material\":0") + ",\"nodes\":[{\"mesh\":0}],\"materials\":[{" + members + "}]";
}
const std::string a_node = ",\"nodes\":[{\"mesh\":0}]";

/// Returns an animation of one channel, whose target has these members.
std::string animation(const std::string& target) {
    return ",\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{" + target +
           "}}],\"samplers\":[{\"input\":0,\"output\":0}]}]";
}

void check_refused(const std::filesystem::path& file, ErrorCode code, const std::string& part) {
    const std::string message = error_of(CALL(read_gltf_scene(file)), code);
    CAPTURE(message);
    CHECK(message.starts_with(file.string() + ": "));
    CHECK_MESSAGE(message.find(part) != std::string::npos, part);
    CHECK(message.size() < 1000);
}

}  // namespace

TEST_CASE("what is read of glTF and not followed is one notice for each kind") {
    const std::string texture = ",\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"none.png\"}]";
    const std::string textured = "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}";
    struct Case {
        std::string rest, notice;
    };
    for (const Case& c : {
             Case{with_material(textured) + texture,
                  "textures are left out of primitives that lack the texture coordinates"},
             Case{with_material("\"occlusionTexture\":{\"index\":0}") + texture, "occlusion textures"},
             Case{with_material("\"emissiveFactor\":[1,0,0]"), "emit light"},
             Case{with_material("\"extensions\":{\"KHR_materials_transmission\":{\"transmissionFactor\":1,"
                                "\"transmissionTexture\":{\"index\":0}}}") +
                      texture,
                  "KHR_materials_transmission with a texture is not followed"},
             Case{with_material("\"extensions\":{\"KHR_materials_sheen\":{}}"),
                  "KHR_materials_sheen is not followed"},
             Case{one_mesh() + a_node + ",\"animations\":[{\"channels\":[],\"samplers\":[]}]", "animations"},
             Case{one_mesh() + a_node + animation("\"path\":\"scale\""), "animations"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{}}}]",
                  "EXT_mesh_gpu_instancing"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"camera\":0},{\"camera\":0}],\"cameras\":[{\"type\":"
                               "\"perspective\",\"perspective\":{\"yfov\":1,\"znear\":1}}]",
                  "only the first of several cameras"},
         }) {
        const GltfFile file(triangle_buffer(), c.rest);
        const SceneDescription scene = read_gltf_scene(file.scene());
        CHECK_MESSAGE(has_notice(scene, c.notice), c.notice);
        CHECK(scene.notices.size() == 1);
        CHECK(scene.shapes.size() == 1);
    }
}

TEST_CASE("glTF that is malformed, out of range or not supported is refused by element") {
    struct Case {
        std::string rest, part;
        ErrorCode code = ErrorCode::invalid_file;
    };
    const std::string primitive = "\"meshes\":[{\"primitives\":[{\"attributes\":{";
    const auto camera = [](const std::string& members) {
        return one_mesh() + ",\"nodes\":[{\"mesh\":0},{\"camera\":0}],\"cameras\":[{" + members + "}]";
    };
    for (const Case& c : {
             Case{"\"nodes\":[}", "parse error"},
             Case{"\"nodes\":[1]", "nodes"},
             Case{one_mesh(), "nodes: none has a mesh"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":3}]", "nodes[0]: refers to meshes[3]; the file has 1"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"children\":[4]}]", "nodes[0]: refers to nodes[4]"},
             Case{one_mesh() + a_node + ",\"scene\":2,\"scenes\":[{\"nodes\":[0]}]",
                  "scene: refers to scenes[2]"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"children\":[1]},{\"children\":[0]}],\"scenes\":[{"
                               "\"nodes\":[0]}]",
                  "nodes[0]: has two parents"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"matrix\":[1]}]", "nodes[0]: matrix has 1 numbers"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"matrix\":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}]",
                  "the last row of matrix"},
             Case{one_mesh() + ",\"nodes\":[{\"mesh\":0,\"rotation\":[0,0,0,0]}]", "rotation has length"},
             Case{one_mesh() + ",\"nodes\":[{\"scale\":[1e300,1,1],\"children\":[1]},{\"mesh\":0,\"scale\":["
                               "1e300,1,1]}]",
                  "nodes[1]: its transform is not finite"},
             Case{primitive + "}}]}]" + a_node, "meshes[0].primitives[0]: has no POSITION"},
             Case{primitive + "\"POSITION\":9}}]}]" + a_node,
                  "POSITION: refers to accessors[9]; the file has 1"},
             Case{primitive + "\"POSITION\":0},\"mode\":7}]}]" + a_node, "mode is 7"},
             Case{with_material("\"pbrMetallicRoughness\":{\"metallicFactor\":2}"),
                  "materials[0]: metallicFactor is 2.000000; expected 0 to 1"},
             Case{with_material("\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,-1,0,1]}"),
                  "baseColorFactor"},
             Case{with_material("\"pbrMetallicRoughness\":{\"metallicFactor\":0},\"extensions\":{"
                                "\"KHR_materials_ior\":{\"ior\":0.5}}"),
                  "ior is not 0"},
             Case{with_material("\"extensions\":{\"KHR_materials_anisotropy\":{\"anisotropyStrength\":2}}"),
                  "anisotropyStrength is 2"},
             Case{with_material("\"extensions\":{\"KHR_materials_anisotropy\":{\"anisotropyStrength\":1,"
                                "\"anisotropyRotation\":\"a\"}}"),
                  "anisotropyRotation is not a finite number"},
             Case{with_material("\"extensions\":{\"KHR_materials_anisotropy\":{\"anisotropyTexture\":{"
                                "\"index\":0.5}}}"),
                  "materials[0]: anisotropyTexture: index is not a whole number"},
             Case{one_mesh() + a_node + animation("\"path\":\"scale\",\"node\":\"a\""),
                  "animations[0].channels[0]: node is not a whole number"},
             Case{one_mesh() + a_node + animation("\"path\":\"scale\",\"node\":2147483648"),
                  "animations[0].channels[0]: node is not a whole number"},
             Case{one_mesh() + a_node +
                      ",\"skins\":[{\"joints\":[0]},{\"joints\":[0],\"inverseBindMatrices\":0.5}]",
                  "skins[1]: inverseBindMatrices is not a whole number"},
             Case{one_mesh() + a_node + animation("\"node\":0"), "'path' property is missing"},
             Case{one_mesh() + a_node + ",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]",
                  "\"KHR_draco_mesh_compression\" is not supported", ErrorCode::unsupported},
             Case{camera("\"type\":\"perspective\",\"perspective\":{\"yfov\":4,\"znear\":1}"),
                  "cameras[0]: yfov is 4"},
             Case{camera("\"type\":\"perspective\",\"perspective\":{\"yfov\":1,\"znear\":1,\"zfar\":0.5}"),
                  "0 < znear < zfar"},
             Case{
                 camera(
                     "\"type\":\"orthographic\",\"orthographic\":{\"xmag\":0,\"ymag\":1,\"znear\":1,\"zfar\":"
                     "2}"),
                 "xmag or ymag is 0"},
             Case{one_mesh() + a_node + ",\"extras\":" + std::string(5000, '[') + std::string(5000, ']'),
                  "levels deep", ErrorCode::unsupported},
         }) {
        CAPTURE(c.part);
        const GltfFile file(triangle_buffer(), c.rest);
        check_refused(file.scene(), c.code, c.part);
    }
    const TemporaryFolder folder;
    check_refused(folder / "none.gltf", ErrorCode::file_not_found, "no such file");
    check_refused(folder.write("old.gltf", "{\"asset\":{\"version\":\"1.0\"}}"), ErrorCode::unsupported,
                  "1.0");
    // The extension is named, not what the file lacks because of it.
    check_refused(
        folder.write("compressed.gltf",
                     R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"],)"
                     R"("accessors":[{"type":"SCALAR","componentType":5125,"count":3}],)"
                     R"("meshes":[{"primitives":[{"attributes":{},"indices":0}]}]})"),
        ErrorCode::unsupported, "KHR_draco_mesh_compression");
    const std::string message = error_of(
        CALL(read_gltf_scene(GltfFile(triangle_buffer(), one_mesh() + a_node).scene(), {{"a", "1"}})),
        ErrorCode::invalid_argument);
    CHECK(message.find("parameter a") != std::string::npos);
}

TEST_CASE("accessors of glTF that lead beyond their data are refused") {
    struct Case {
        std::string accessor, part;
    };
    const std::string big = "18446744073709551615";
    const auto accessor = [](const std::string& members) {
        return "{\"type\":\"VEC3\",\"componentType\":5126" + members + "}";
    };
    const std::string sparse = ",\"count\":3,\"bufferView\":0,\"sparse\":{\"count\":";
    const std::string values = "},\"values\":{\"bufferView\":0}}";
    for (const Case& c : {
             Case{accessor(",\"count\":4,\"bufferView\":0"), "4 elements of 12 bytes from byteOffset 0"},
             Case{accessor(",\"count\":3,\"bufferView\":0,\"byteOffset\":4"), "lead beyond the 36 bytes"},
             Case{accessor(",\"count\":" + big + ",\"bufferView\":0"), "lead beyond"},
             Case{accessor(",\"count\":3,\"bufferView\":0,\"byteOffset\":" + big), "lead beyond"},
             Case{accessor(",\"count\":0,\"bufferView\":0"), "count is 0"},
             Case{accessor(",\"count\":3,\"bufferView\":7"), "accessors[0]: refers to bufferViews[7]"},
             Case{accessor(",\"count\":3,\"bufferView\":1"), "refers to buffers[5]"},
             Case{accessor(",\"count\":3,\"bufferView\":2"), "lead beyond the buffer's 36 bytes"},
             Case{accessor(",\"count\":3,\"bufferView\":3"), "lead beyond the buffer's"},
             Case{accessor(",\"count\":3,\"bufferView\":4"), "byteStride 4 is less"},
             Case{accessor(",\"count\":1000"), "more than the buffers have bytes"},
             Case{"{\"type\":\"VEC2\",\"componentType\":5126,\"count\":3,\"bufferView\":0}", "expected 3"},
             Case{"{\"type\":\"VEC3\",\"componentType\":5130,\"count\":1,\"bufferView\":0}", "componentType"},
             Case{accessor(sparse + "4,\"indices\":{\"bufferView\":0,\"componentType\":5121" + values),
                  "sparse.count is 4; expected 1 to 3"},
             Case{accessor(sparse + "3,\"indices\":{\"bufferView\":0,\"componentType\":5121" + values),
                  "ascend"},
             Case{accessor(sparse + "1,\"indices\":{\"bufferView\":0,\"componentType\":5126" + values),
                  "sparse.indices.componentType"},
             Case{accessor(sparse +
                           "1,\"indices\":{\"bufferView\":0,\"byteOffset\":-1,\"componentType\":5121" +
                           values),
                  "accessors[0]: sparse.indices: byteOffset is not a whole number from 0"},
             Case{accessor(sparse + "1,\"indices\":{\"bufferView\":0,\"componentType\":5121},"
                                    "\"values\":{\"bufferView\":0,\"byteOffset\":0.5}}"),
                  "accessors[0]: sparse.values: byteOffset is not a whole number from 0"},
             Case{accessor(sparse +
                           "3,\"indices\":{\"bufferView\":0,\"byteOffset\":34,\"componentType\":5121" +
                           values),
                  "lead beyond"},
         }) {
        CAPTURE(c.accessor);
        const std::string view = "{\"buffer\":0,\"byteLength\":";
        const TemporaryFolder folder;
        folder.write("a.bin", triangle_buffer().bytes);
        check_refused(
            folder.write(
                "a.gltf",
                "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"a.bin\",\"byteLength\":36}],"
                "\"bufferViews\":[" +
                    view + "36},{\"buffer\":5,\"byteLength\":36}," + view + "37}," + view +
                    "36,\"byteOffset\":" + big + "}," + view + "36,\"byteStride\":4}],\"accessors\":[" +
                    c.accessor + "]," + one_mesh() + a_node + "}"),
            ErrorCode::invalid_file, c.part);
    }
    GltfBuffer buffer = triangle_buffer();
    buffer.indices({0, 1, 3});
    check_refused(GltfFile(buffer, one_mesh(",\"indices\":1") + a_node).scene(), ErrorCode::invalid_file,
                  "index 2 is 3, but there are only 3 vertices");
    GltfBuffer infinite;
    infinite.vectors({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<float>::infinity(), 0}});
    check_refused(GltfFile(infinite, one_mesh() + a_node).scene(), ErrorCode::invalid_file,
                  "POSITION of vertex 2 is not finite");
}

TEST_CASE("glTF in one binary file, or with data in its text, is the same scene") {
    const GltfBuffer buffer = triangle_buffer();
    const TemporaryFolder folder;
    const std::string rest = one_mesh() + a_node;
    std::vector<std::filesystem::path> files = {
        folder.write("a.GLB", glb(buffer.json(rest, ""), buffer.bytes)),
        folder.write("b.gltf", buffer.json(rest,
                                           "data:application/octet-stream;base64,"
                                           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"))};
    for (const auto& file : files) {
        const LoadedScene loaded = load_scene(file, {});
        CHECK(corners(*loaded.scene.instances().at(0).mesh) == a_gltf_triangle);
        REQUIRE(loaded.files.size() == 1);
        CHECK(loaded.files[0].path == file);
    }
    // Prefixes of a binary file must be refused, and so must lengths that lead beyond its end.
    const std::string whole = file_bytes(files[0]);
    for (std::size_t size = 0; size < whole.size(); ++size)
        static_cast<void>(error_of(CALL(read_gltf_scene(folder.write("c.glb", whole.substr(0, size)))),
                                   ErrorCode::invalid_file));
    const std::size_t of_data = whole.size() - buffer.bytes.size() - 8;
    for (const auto& [at, length] : {std::pair{std::size_t{8}, whole.size() + 4},
                                     {12, whole.size()},
                                     {of_data, buffer.bytes.size() + 4},
                                     {of_data, buffer.bytes.size() + 8}}) {
        std::string longer = whole;
        longer.replace(at, 4, number(static_cast<std::uint32_t>(length)));
        check_refused(folder.write("c.glb", longer), ErrorCode::invalid_file, "");
    }
}

TEST_CASE("the buffers of glTF are recorded, counted, and lie in its folder") {
    const GltfBuffer buffer = triangle_buffer();
    const std::string rest = one_mesh() + a_node;
    const TemporaryFolder folder;
    folder.write("part/a b.bin", buffer.bytes);
    folder.write("out.bin", buffer.bytes);
    const auto file = folder.write("sub/../a.gltf", buffer.json(rest, "part/a%20b.bin"));
    const LoadedScene loaded = load_scene(file, {});
    REQUIRE(loaded.files.size() == 2);
    CHECK(loaded.files[1].path.filename() == "a b.bin");
    CHECK(loaded.files[1].bytes == 36);
    static_cast<void>(error_of(CALL(load_scene(file, {}, LoadLimits{.bytes = file_size(file) + 35})),
                               ErrorCode::unsupported));
    static_cast<void>(
        error_of(CALL(load_scene(file, {}, LoadLimits{.triangles = 0})), ErrorCode::unsupported));
    static_cast<void>(
        error_of(CALL(load_scene(file, {}, LoadLimits{.vertices = 2})), ErrorCode::unsupported));
    for (const std::string uri :
         {"../out.bin", "/etc/passwd", "http://a/b.bin", "file:///a.bin", "data:text/x,a"}) {
        CAPTURE(uri);
        check_refused(folder.write("part/a.gltf", buffer.json(rest, uri)), ErrorCode::unsupported,
                      "expected a relative one");
    }
    check_refused(folder.write("b.gltf", buffer.json(rest, "none.bin")), ErrorCode::file_not_found,
                  "\"none.bin\"");
    folder.write("long.bin", buffer.bytes + "more");
    CHECK(read_gltf_scene(folder.write("b.gltf", buffer.json(rest, "long.bin"))).files.at(1).bytes == 40);
    folder.write("short.bin", "abc");
    check_refused(folder.write("b.gltf", buffer.json(rest, "short.bin")), ErrorCode::invalid_file,
                  "short.bin");
}
