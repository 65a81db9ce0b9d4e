// SPDX-License-Identifier: MIT
// Tests of the version, build information, result names and the last error of a thread, without a context.
#include <thread>

#include "capi.hpp"

using namespace capi_test;

TEST_CASE("the header's version is the library's") {
    CHECK(nicol_version() == NICOL_VERSION);
    CHECK(nicol_version() == NICOL_VERSION_MAJOR * 10000 + NICOL_VERSION_MINOR * 100 + NICOL_VERSION_PATCH);
    CHECK(std::string(nicol_version_string()) == std::to_string(NICOL_VERSION_MAJOR) + "." +
                                                     std::to_string(NICOL_VERSION_MINOR) + "." +
                                                     std::to_string(NICOL_VERSION_PATCH));
    CHECK(nicol_version_string() == nicol_version_string());
}

TEST_CASE("build information is a list of key=value that ends") {
    std::set<std::string> keys;
    std::uint32_t count = 0;
    while (const char* fact = nicol_build_info(count)) {
        const std::string text = fact;
        const std::size_t equals = text.find('=');
        CAPTURE(text);
        REQUIRE(equals != std::string::npos);
        CHECK(equals > 0);
        CHECK(keys.insert(text.substr(0, equals)).second);
        if (text.starts_with("version=")) CHECK(text.substr(8) == nicol_version_string());
        if (text.starts_with("files=")) CHECK(text.substr(6) == "psh,exr,bitmaps,mesh_files,scene_files");
        if (text.starts_with("max_order=")) CHECK(text.substr(10) == std::to_string(NICOL_MAX_ORDER));
        if (text.starts_with("max_channels=")) CHECK(text.substr(13) == std::to_string(NICOL_MAX_CHANNELS));
        REQUIRE(++count < 1000);
    }
    for (const char* key : {"version", "source", "compiler", "backends", "files", "methods", "max_order"})
        CHECK_MESSAGE(keys.contains(key), key);
    CHECK(nicol_build_info(count + 1) == nullptr);
    CHECK(nicol_build_info(UINT32_MAX) == nullptr);
}

TEST_CASE("every result has a name of its own") {
    std::set<std::string> names;
    for (nicol_result result = NICOL_OK; result <= NICOL_ERROR_INTERNAL; ++result) {
        const char* name = nicol_result_name(result);
        REQUIRE(name != nullptr);
        CHECK(name[0] != '\0');
        CHECK_MESSAGE(names.insert(name).second, name);
    }
    for (const nicol_result result : {-1, NICOL_ERROR_INTERNAL + 1, INT32_MAX, INT32_MIN}) {
        REQUIRE(nicol_result_name(result) != nullptr);
        CHECK_FALSE(names.contains(nicol_result_name(result)));
    }
    CHECK(std::string(nicol_result_name(NICOL_ERROR_OUT_OF_MEMORY)) == "out of memory");
}

TEST_CASE("the last error is empty at first and stays after a success") {
    std::thread([] {
        const std::string first = nicol_last_error();
        const nicol_result failed = nicol_mesh_retain(nullptr);
        const std::string second = nicol_last_error();
        const nicol_result succeeded = nicol_mesh_release(nullptr);
        const std::string third = nicol_last_error();
        CHECK(first.empty());
        CHECK(failed == NICOL_ERROR_INVALID_HANDLE);
        CHECK(second.find("nicol_mesh") != std::string::npos);
        CHECK(succeeded == NICOL_OK);
        CHECK(third == second);
    }).join();
}

TEST_CASE("messages are one line of whole characters, however long") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    nicol_mesh mesh = marker<nicol_mesh>();
    for (const std::size_t length : {std::size_t{1500}, std::size_t{1501}, std::size_t{20000}}) {
        std::string path = length % 2 == 1 ? "a\n\x1b[31m\x7f" : "";
        while (path.size() < length) path += "\xC3\xA9";  // two bytes per character
        CHECK(nicol_mesh_load(context, (path + ".obj").c_str(), &mesh) == NICOL_ERROR_FILE_NOT_FOUND);
        const std::string message = nicol_last_error();
        CHECK(message.size() > 1000);
        CHECK(std::ranges::none_of(message, [](unsigned char c) { return c < ' ' || c == 0x7f; }));
        CHECK(std::ranges::count(message, '\xC3') == std::ranges::count(message, '\xA9'));
    }
    CHECK(mesh == marker<nicol_mesh>());
}

TEST_CASE("a camera is rotated towards its target") {
    nicol_camera camera = NICOL_CAMERA_INIT;
    camera.fov = 30;
    camera.far_clip = 7;
    const double origin[] = {1, 2, 3}, target[] = {1, 2, -5}, up[] = {0, 2, 1};
    OK(nicol_camera_look_at(&camera, origin, target, up));
    // The matrix's columns are left, up, forward and position.
    const double expected[] = {-1, 0, 0, 1, 0, 1, 0, 2, 0, 0, -1, 3, 0, 0, 0, 1};
    for (std::size_t i = 0; i < 16; ++i) CHECK(camera.to_world[i] == doctest::Approx(expected[i]));
    CHECK(camera.fov == 30);
    CHECK(camera.far_clip == 7);
    CHECK(camera.struct_size == sizeof camera);
}

TEST_CASE("cameras that cannot be are refused by the name of the argument, and leave the camera alone") {
    nicol_camera camera = NICOL_CAMERA_INIT;
    camera.to_world[3] = 42;
    const double good_k[] = {50, 0, 12, 0, 50, 8, 0, 0, 1}, r[] = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                 t[] = {0, 0, 0};
    const auto with = [&](std::size_t i, double value) {
        std::array<double, 9> k{};
        std::ranges::copy(good_k, k.begin());
        k[i] = value;
        return nicol_camera_set_opencv(&camera, k.data(), r, t, 24, 16);
    };
    const double lower[] = {0, 0, 0}, upper[] = {1, 1, 1};
    check_refused({{"K[1]", [&] { return with(1, 0.5); }},
                   {"K[8]", [&] { return with(8, 2); }},
                   {"focal", [&] { return with(4, -50); }},
                   {"K is NULL", [&] { return nicol_camera_set_opencv(&camera, nullptr, r, t, 24, 16); }},
                   {"0 x 16", [&] { return nicol_camera_set_opencv(&camera, good_k, r, t, 0, 16); }},
                   {"box", [&] { return nicol_camera_frame(&camera, upper, lower, 24, 16); }},
                   {"upper is NULL", [&] { return nicol_camera_frame(&camera, lower, nullptr, 24, 16); }}});
    CHECK((camera.to_world[3] == 42 && camera.fov == 45));
    OK(nicol_camera_set_opencv(&camera, good_k, r, t, 24, 16));
    CHECK((camera.to_world[3] == 0 && camera.fov < 45));
}

TEST_CASE("a quality sets what trades time for accuracy, and nothing else") {
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.seed = 5;
    options.order_low = 3;
    struct Case {
        nicol_quality quality;
        std::uint32_t samples;
        double tolerance;
    };
    for (const Case& one : {Case{NICOL_QUALITY_FINAL, 64, 0.01},
                            {NICOL_QUALITY_PREVIEW, 8, 0.03},
                            {NICOL_QUALITY_REALTIME, 0, 0.03}}) {
        CAPTURE(one.quality);
        options.light_samples = 3;
        OK(nicol_render_options_set_quality(&options, one.quality));
        CHECK(options.pixel_samples == one.samples);
        CHECK(options.tolerance == one.tolerance);
        CHECK(options.light_samples == 16);
        CHECK((options.seed == 5 && options.order_low == 3));
        CHECK(options.struct_size == sizeof options);
    }
    check_refused({{"quality", [&] { return nicol_render_options_set_quality(&options, 3); }}});
    CHECK(options.pixel_samples == 0);
}

TEST_CASE("a view without a direction is refused and leaves the camera alone") {
    nicol_camera camera = NICOL_CAMERA_INIT;
    camera.to_world[3] = 42;
    const double origin[] = {1, 2, 3}, target[] = {1, 2, -5}, up[] = {0, 1, 0}, along[] = {0, 0, 7};
    const double nowhere[] = {0, 0, NAN}, zero[] = {0, 0, 0};
    check_refused({{"target", [&] { return nicol_camera_look_at(&camera, origin, origin, up); }},
                   {"up", [&] { return nicol_camera_look_at(&camera, origin, target, along); }},
                   {"up", [&] { return nicol_camera_look_at(&camera, origin, target, zero); }},
                   {"look_at", [&] { return nicol_camera_look_at(&camera, nowhere, target, up); }},
                   {"look_at", [&] { return nicol_camera_look_at(&camera, origin, nowhere, up); }}});
    CHECK((camera.to_world[3] == 42 && camera.to_world[0] == 1));
}
