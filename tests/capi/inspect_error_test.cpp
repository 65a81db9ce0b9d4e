// SPDX-License-Identifier: MIT
// Files and options of light that are wrong.
#include "inspect.hpp"
#include "psh_checks.hpp"

using namespace capi_test;

TEST_CASE("inspect: options that are wrong, or of no use") {
    const TemporaryFolder folder;
    write_sky(folder.file("sky.exr"), 16, 9);
    write_light(folder.file("f.npz"), 1, Doubles(vector_size(1)));
    const std::string npz = folder.file("o.npz"), exr = folder.file("o.exr"), cube = folder.file("o_s0.exr");
    const auto refuse = [&](const char* in, const std::string& out, const char* word, auto set) {
        CAPTURE(word);
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        set(options);
        FAILS(nicol_file_convert(folder.file(in).c_str(), &options, out.c_str()),
              NICOL_ERROR_INVALID_ARGUMENT, word);
    };
    using O = nicol_file_options;
    for (const std::int32_t order : {-2, NICOL_PSH_MAX_ORDER + 1, INT32_MIN, INT32_MAX})
        refuse("sky.exr", npz, "order", [=](O& o) { o.order = order; });
    refuse("sky.exr", exr, "height", [](O& o) { o.width = 16; });
    refuse("sky.exr", exr, "width", [](O& o) { o.height = 16; });
    refuse("sky.exr", exr, "height", [](O& o) { o.width = 16, o.height = 1; });
    refuse("sky.exr", exr, "width", [](O& o) { o.width = NICOL_MAX_SIZE + 1, o.height = 9; });
    refuse("sky.exr", cube, "edge", [](O& o) { o.edge = 1; });
    refuse("sky.exr", cube, "edge", [](O& o) { o.edge = 4097; });
    refuse("sky.exr", npz, "flags", [](O& o) { o.flags = 4; });
    for (const double scale : {-1.0, not_a_number, infinity, 1e13})
        refuse("sky.exr", npz, "scale", [=](O& o) { o.scale = scale; });
    refuse("sky.exr", npz, "rotation", [](O& o) { o.rotation[0] = not_a_number; });
    refuse("sky.exr", npz, "rotation", [](O& o) { o.rotation[0] = o.rotation[4] = 1, o.rotation[8] = -1; });
    refuse("sky.exr", npz, "wavelengths", [](O& o) { o.wavelengths.count = 17; });
    for (const float nm : {0.0F, 99.0F, 5001.0F, std::nanf("")})
        refuse("sky.exr", npz, "wavelength",
               [=](O& o) { o.wavelengths.count = 1, o.wavelengths.values[0] = nm; });
    refuse("sky.exr", npz, "reserved", [](O& o) { o.reserved = 1; });
    refuse("sky.exr", npz, "struct_size", [](O& o) { o.struct_size = 0; });
    // Of no use:
    refuse("sky.exr", npz, "width", [](O& o) { o.width = 16, o.height = 9; });
    refuse("sky.exr", npz, "edge", [](O& o) { o.edge = 16; });
    refuse("sky.exr", exr, "edge", [](O& o) { o.edge = 16; });
    refuse("sky.exr", cube, "width", [](O& o) { o.width = 16, o.height = 9; });
    refuse("sky.exr", npz, "PHYSICAL", [](O& o) { o.flags = NICOL_FILE_PHYSICAL; });
    refuse("f.npz", exr, "BAND_LIMITED", [](O& o) { o.flags = NICOL_FILE_BAND_LIMITED; });
    refuse("sky.exr", npz, "order 5",
           [](O& o) { o.order = 5, o.flags = NICOL_FILE_BAND_LIMITED; });  // 9 rows hold order 4
    refuse("f.npz", folder.file("o.png"), "o.png", [](O&) {});
    refuse("f.npz", "", "out", [](O&) {});
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.width = options.height = 20;
    FAILS(nicol_file_describe_light(folder.file("sky.exr").c_str(), &options, &report, nullptr, 0),
          NICOL_ERROR_INVALID_ARGUMENT, "width");
    CHECK(folder.names() == std::set<std::string>{"sky.exr", "f.npz"});
}

TEST_CASE("inspect: files that are no light") {
    const TemporaryFolder folder;
    nicol_file_kind kind = 77;
    const auto identify = [&](const std::string& name) {
        return nicol_file_identify(folder.file(name).c_str(), &kind);
    };
    FAILS(identify("none.exr"), NICOL_ERROR_FILE_NOT_FOUND, "none.exr");
    FAILS(identify("none"), NICOL_ERROR_FILE_NOT_FOUND, "none");
    FAILS(nicol_file_identify("", &kind), NICOL_ERROR_INVALID_ARGUMENT, "path");
    std::filesystem::create_directory(folder.file("folder.exr"));
    FAILS(identify("folder.exr"), NICOL_ERROR_UNSUPPORTED, "folder.exr");
    folder.write("text.xml", "<scene/>");
    FAILS(identify("text.xml"), NICOL_ERROR_UNSUPPORTED, ".exr");
    CHECK(kind == 77);

    write_light(folder.file("f.npz"), 3, Doubles(vector_size(3), 0.25));
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    for (const char* name : {"bad.exr", "bad_s0.exr", "bad.npz"}) {
        const std::string whole = file_bytes(folder.file("f.npz"));
        for (const std::string& content : {std::string(), std::string("v/1\x01"), std::string(4096, '\0'),
                                           whole.substr(0, 200), whole.substr(0, whole.size() - 30)}) {
            folder.write(name, content);
            const std::string path = folder.file(name);
            CHECK(nicol_file_describe_light(path.c_str(), nullptr, &r, nullptr, 0) != NICOL_OK);
            CHECK(std::string(nicol_last_error()).find("bad") != std::string::npos);
            CHECK(nicol_file_convert(path.c_str(), nullptr, folder.file("o.exr").c_str()) != NICOL_OK);
        }
    }
    CHECK(r.channels == 0);
    // One pixel is an image, but no light.
    nicol::write_exr(folder.file("one.exr"), nicol::StokesImage(1, 1, 1));
    FAILS(nicol_file_describe_light(folder.file("one.exr").c_str(), nullptr, &r, nullptr, 0),
          NICOL_ERROR_INVALID_FILE, "2 x 2");
    CHECK(folder.names().count("o.exr") == 0);
}

TEST_CASE("inspect: a failed output leaves what was there") {
    const TemporaryFolder folder;
    Doubles field(vector_size(1));
    field[0] = 1;
    write_light(folder.file("f.npz"), 1, field);
    const std::string file = folder.file("f.npz");
    for (const char* out : {"none/o.exr", "none/o.npz", "none/o_s0.exr"})
        FAILS(nicol_file_convert(file.c_str(), nullptr, folder.file(out).c_str()), NICOL_ERROR_WRITE_FAILED,
              "none/o");
    // The input may be the output.
    convert(file, file, of_order(3));
    CHECK(light_report_of(file).order == 3);
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}
