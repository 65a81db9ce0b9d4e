// SPDX-License-Identifier: MIT
// Limits of loading, which every function that loads holds.
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
