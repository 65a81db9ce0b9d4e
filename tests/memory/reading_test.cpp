// SPDX-License-Identifier: MIT
// Tests of reading files without enough memory: no failing allocation makes a file count as damaged.
#include "memory/sweep.hpp"

using namespace capi_test;
using namespace memory_test;

namespace {

struct Format {
    const char* folder;  ///< folder of the files; a file of another suffix is copied first
    const char* suffix;  ///< suffix of the format's files
    /// Reads a file and writes numbers that describe it into `text`.
    nicol_result (*read)(nicol_context context, const char* path, std::string& text);
};

nicol_result read_mesh(nicol_context context, const char* path, std::string& text) {
    nicol_mesh mesh = nullptr;
    const nicol_result result = nicol_mesh_load(context, path, &mesh);
    std::uint32_t vertices = 0, triangles = 0;
    if (result == NICOL_OK) nicol_mesh_get_size(mesh, &vertices, &triangles);
    text = std::to_string(vertices) + " " + std::to_string(triangles);
    release(mesh);
    return result;
}

nicol_result read_scene(nicol_context context, const char* path, std::string& text) {
    nicol_scene scene = nullptr;
    const nicol_result result = nicol_scene_load(context, path, nullptr, 0, &scene);
    std::uint32_t instances = 0, channels = 0;
    if (result == NICOL_OK) nicol_scene_get_instance_count(scene, &instances);
    if (result == NICOL_OK) nicol_scene_get_channels(scene, &channels);
    text = std::to_string(instances) + " " + std::to_string(channels);
    release(scene);
    return result;
}

nicol_result read_texture(nicol_context context, const char* path, std::string&) {
    nicol_texture texture = nullptr;
    const nicol_result result = nicol_texture_load(context, path, nullptr, &texture);
    release(texture);
    return result;
}

nicol_result read_sensor(nicol_context, const char* path, std::string& text) {
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    const nicol_result result = nicol_sensor_load(&sensor, path);
    if (result == NICOL_OK) text.assign(reinterpret_cast<const char*>(&sensor), sizeof sensor);
    return result;
}

nicol_result describe_light(nicol_context, const char* path, std::string& text) {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.order = 2;
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    const nicol_result result = nicol_file_describe_light(path, &options, &report, nullptr, 0);
    if (result == NICOL_OK) text.assign(reinterpret_cast<const char*>(&report), sizeof report);
    return result;
}

nicol_result describe_material(nicol_context, const char* path, std::string& text) {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.order = 2;
    nicol_material_report report = NICOL_MATERIAL_REPORT_INIT;
    const nicol_result result = nicol_file_describe_material(path, &options, &report, nullptr, 0);
    if (result == NICOL_OK) text.assign(reinterpret_cast<const char*>(&report), sizeof report);
    return result;
}

}  // namespace

TEST_CASE("a file that lacks memory says so, and is read when there is some") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const TemporaryFolder folder;
    for (const Format& format : {Format{NICOL_TEST_SEEDS "/obj", ".obj", read_mesh},
                                 Format{NICOL_TEST_SEEDS "/ply", ".ply", read_mesh},
                                 Format{NICOL_TEST_SEEDS "/off", ".off", read_mesh},
                                 Format{NICOL_TEST_SEEDS "/stl", ".stl", read_mesh},
                                 Format{NICOL_TEST_SEEDS "/serialized", ".serialized", read_mesh},
                                 Format{NICOL_TEST_SEEDS "/scene", ".xml", read_scene},
                                 Format{NICOL_TEST_ASSETS, ".gltf", read_scene},
                                 Format{NICOL_TEST_SEEDS "/bitmap", ".png", read_texture},
                                 Format{NICOL_TEST_SEEDS "/sensor", ".json", read_sensor},
                                 Format{NICOL_TEST_SEEDS "/exr", ".exr", describe_light},
                                 Format{NICOL_TEST_SEEDS "/npz", ".npz", describe_light},
                                 Format{NICOL_TEST_SEEDS "/npz", ".npz", describe_material},
                                 Format{NICOL_TEST_SEEDS "/pbsdf", ".pbsdf", describe_material}}) {
        int read = 0;
        std::string expected, found;
        // Reserves space, because the test itself must not allocate during a shortage.
        expected.reserve(std::size_t{1} << 14U);
        found.reserve(std::size_t{1} << 14U);
        for (const auto& seed : files_in(format.folder)) {
            // The larger sample would take minutes.
            if (seed.has_extension() && seed.filename() != "solids.gltf") continue;
            const std::string path =
                seed.extension() == format.suffix
                    ? seed.string()
                    : folder.write("file" + std::string(format.suffix), file_bytes(seed)).string();
            CAPTURE(seed.string());
            // Skips seeds that this reader does not accept.
            if (format.read(context, path.c_str(), expected) != NICOL_OK) continue;
            ++read;
            sweep(
                100, [&] { return format.read(context, path.c_str(), found); },
                [&](nicol_result result) {
                    if (result == NICOL_OK) CHECK(found == expected);
                });
            OK(format.read(context, path.c_str(), found));
            CHECK(found == expected);
        }
        CAPTURE(std::string(format.folder));
        CHECK(read > 0);
    }
}
