// SPDX-License-Identifier: MIT
// Tests of the loading limits in every function that loads files.
#include "capi.hpp"
#include "files/bomb.hpp"

using namespace capi_test;

TEST_CASE("a small file that becomes a large image is refused by every function that loads images") {
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.load_bytes_limit = 1 << 20;
    const Owned context(make(nicol_context_create, &options));
    const TemporaryFolder folder;
    folder.write("a.png", black_png(16384, 8192, 1, 8192 * 2049ULL));
    const std::string png = folder.file("a.png");
    const std::string xml = folder.file("a.xml");
    folder.write("a.xml",
                 "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='40'/></sensor>"
                 "<shape type='rectangle'><bsdf type='diffuse'><texture type='bitmap' name='reflectance'>"
                 "<string name='filename' value='a.png'/></texture></bsdf></shape></scene>");
    nicol_environment light = nullptr;
    nicol_texture texture = nullptr;
    nicol_scene scene = nullptr;
    FAILS(nicol_environment_load(context, png.c_str(), nullptr, &light), NICOL_ERROR_UNSUPPORTED,
          "load_bytes_limit");
    FAILS(nicol_texture_load(context, png.c_str(), nullptr, &texture), NICOL_ERROR_UNSUPPORTED,
          "load_bytes_limit");
    FAILS(nicol_scene_load(context, xml.c_str(), nullptr, 0, &scene), NICOL_ERROR_UNSUPPORTED,
          "load_bytes_limit");
    CHECK(light == nullptr);
    CHECK(texture == nullptr);
    CHECK(scene == nullptr);
}

TEST_CASE("a load ends where its progress callback says so") {
    struct Asked {
        int times = 0;
        std::string verb;
    } asked;
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.load_progress_user = &asked;
    options.load_progress = [](void* user, const char* verb, double) -> std::int32_t {
        Asked& self = *static_cast<Asked*>(user);
        ++self.times;
        self.verb = verb;
        return 0;
    };
    const Owned context(make(nicol_context_create, &options));
    const TemporaryFolder folder;
    folder.write("a.png", black_png(64, 64, 1, 64 * 65ULL));
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("a.xml", "<scene version='3.0.0'></scene>");
    const auto path = [&](const char* name) { return folder.file(name); };
    nicol_environment light = nullptr;
    nicol_texture texture = nullptr;
    nicol_mesh mesh = nullptr;
    nicol_scene scene = nullptr;
    FAILS(nicol_environment_load(context, path("a.png").c_str(), nullptr, &light), NICOL_ERROR_CANCELLED,
          "progress callback");
    FAILS(nicol_texture_load(context, path("a.png").c_str(), nullptr, &texture), NICOL_ERROR_CANCELLED,
          "progress callback");
    FAILS(nicol_mesh_load(context, path("a.obj").c_str(), &mesh), NICOL_ERROR_CANCELLED, "progress callback");
    FAILS(nicol_scene_load(context, path("a.xml").c_str(), nullptr, 0, &scene), NICOL_ERROR_CANCELLED,
          "progress callback");
    CHECK(asked.times == 4);
    CHECK(asked.verb == "load");
}
