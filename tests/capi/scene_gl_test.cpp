// SPDX-License-Identifier: MIT
// Tests of scenes: instances, environments, and settings from a scene file.
#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr const char* scene_text = R"(<scene version="3.0.0">
    <default name="spp" value="4"/>
    <default name="fov" value="50"/>
    <integrator type="stokes"><integer name="max_depth" value="2"/></integrator>
    <sensor type="perspective">
        <float name="fov" value="$fov"/>
        <transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/></transform>
        <sampler type="independent"><integer name="sample_count" value="$spp"/></sampler>
        <film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="9"/></film>
    </sensor>
    <emitter type="constant"><rgb name="radiance" value="1, 2, 3"/></emitter>
    <shape type="cube"><bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.4, 0.6"/></bsdf></shape>
</scene>)";

}  // namespace

STAGE_TEST_CASE("an environment is rotated and scaled, nothing else") {
    const std::vector<float> before = stage.image();
    const auto image = [&](const double* to_world, double scale) {
        OK(nicol_scene_set_environment(stage.scene, stage.environment, to_world, scale));
        return stage.image();
    };
    CHECK(image(nullptr, 1) == before);
    CHECK(image(placed(0, 0, 0, 2).rows, 1) == before);  // a scale in the matrix has no effect
    CHECK(std::ranges::count(image(nullptr, 0), 0.0F) == std::ptrdiff_t(before.size()));
    const std::vector<float> doubled = image(nullptr, 2);
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(doubled[i] == doctest::Approx(2 * before[i]).epsilon(1e-4));
    const double rotated[16] = {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1};
    CHECK(image(rotated, 1) != before);
}

STAGE_TEST_CASE("a scene's environment comes back as it was set") {
    const double rotated[16] = {0, 0, 2, 0, 0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 0, 1};
    OK(nicol_scene_set_environment(stage.scene, stage.environment, rotated, 0.25));
    const std::vector<float> before = stage.image();

    nicol_environment light = nullptr;
    double to_world[16] = {}, scale = 0;
    OK(nicol_scene_get_environment(stage.scene, &light, to_world, &scale));
    CHECK(scale == 0.25);
    // The stored matrix is the rotation alone, because scale and translation do not affect light.
    for (std::size_t i = 0; i < 16; ++i) CHECK(to_world[i] == (i < 12 ? rotated[i] / 2 : rotated[i]));
    nicol_environment_info info = NICOL_ENVIRONMENT_INFO_INIT;
    OK(nicol_environment_get_info(light, &info));
    CHECK(info.polarized == 1);

    // The handle outlives the scene's own use of the light.
    OK(nicol_scene_set_environment(stage.scene, nullptr, nullptr, 1));
    nicol_environment none = marker<nicol_environment>();
    double identity[16] = {};
    OK(nicol_scene_get_environment(stage.scene, &none, identity, &scale));
    CHECK(none == nullptr);
    CHECK(scale == 1);
    for (std::size_t i = 0; i < 16; ++i) CHECK(identity[i] == (i % 5 == 0 ? 1 : 0));
    OK(nicol_scene_get_environment(stage.scene, &none, nullptr, nullptr));

    OK(nicol_scene_set_environment(stage.scene, light, to_world, 0.25));
    OK(nicol_environment_release(light));
    CHECK(stage.image() == before);
}

TEST_CASE("a file's max_depth is that of its integrators") {
    const TemporaryFolder folder;
    std::string text = scene_text;
    const std::string integrator =
        R"(<integrator type="stokes"><integer name="max_depth" value="2"/></integrator>)";
    const std::string none =
        folder.write("none.xml", std::string(text).erase(text.find(integrator), integrator.size()));
    text.replace(text.find(integrator), integrator.size(), R"(<default name="depth" value="5"/>
        <integrator type="stokes"><integrator type="path"><integer name="max_depth" value="$depth"/></integrator></integrator>)");
    const std::string path = folder.write("scene.xml", text);
    const auto depth_of = [](const LoadedScene& loaded) {
        std::int32_t depth = 7;
        OK(nicol_scene_get_max_depth(loaded.scene, &depth));
        return depth;
    };
    on_every_backend([&](nicol_context context) {
        CHECK(depth_of(LoadedScene(context, path, {})) == 5);
        CHECK(depth_of(LoadedScene(context, path, {"depth=2"})) == 2);
        CHECK(depth_of(LoadedScene(context, path, {"depth=-1"})) == NICOL_DEPTH_UNLIMITED);
        CHECK(depth_of(LoadedScene(context, path, {"depth=0"})) == 1);
        CHECK(depth_of(LoadedScene(context, none, {})) == 0);
    });
}

TEST_CASE("a file's light comes back with its rotation and scale, a scale of 0 as darkness") {
    const TemporaryFolder folder;
    std::string text = scene_text;
    const std::string constant =
        R"(<emitter type="constant"><rgb name="radiance" value="1, 2, 3"/></emitter>)";
    text.replace(text.find(constant), constant.size(),
                 R"(<emitter type="envmap"><string name="filename" value="light.exr"/>
        <float name="scale" value="$scale"/>
        <transform name="to_world"><rotate y="1" angle="90"/></transform></emitter>)");
    const std::string path = folder.write("scene.xml", text);
    on_every_backend([&](nicol_context context) {
        OK(nicol_environment_write(Owned(constant_light(context, {1})), nullptr,
                                   folder.file("light.exr").c_str()));
        nicol_environment light = nullptr;
        for (const bool dark : {false, true}) {
            const LoadedScene loaded(context, path, {dark ? "scale=0" : "scale=2.5"});
            double to_world[16] = {}, scale = 0;
            OK(nicol_scene_get_environment(loaded.scene, &light, to_world, &scale));
            CHECK((light == nullptr) == dark);
            CHECK(scale == (dark ? 1 : 2.5));
            const double rotated[16] = {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1};
            for (std::size_t i = 0; i < 16; ++i)
                CHECK(to_world[i] == doctest::Approx(dark ? (i % 5 == 0 ? 1 : 0) : rotated[i]));
            OK(nicol_environment_release(light));
        }
    });
}

CONTEXT_TEST_CASE("a scene has the channels of its parts, which must fit, and no camera of its own") {
    const Owned scene(empty_scene(context));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(scene, &channels));
    CHECK(channels == 1);
    const Owned two(constant_light(context, {1, 2})), three(constant_light(context, {1, 2, 3}));
    const Owned material(diffuse(context, {0.1F, 0.2F, 0.3F}));
    const Owned mesh(cube(context));
    // Only a loaded scene has a camera and a film size.
    nicol_camera camera = NICOL_CAMERA_INIT;
    camera.fov = 12;
    std::uint32_t width = 5, height = 6;
    FAILS(nicol_scene_get_camera(scene, &camera), NICOL_ERROR_UNSUPPORTED, "camera");
    FAILS(nicol_scene_get_film_size(scene, &width, &height), NICOL_ERROR_UNSUPPORTED, "film");
    FAILS(nicol_scene_get_sample_count(scene, &width), NICOL_ERROR_UNSUPPORTED, "film");
    std::int32_t max_depth = 7;
    FAILS(nicol_scene_get_max_depth(scene, &max_depth), NICOL_ERROR_UNSUPPORTED, "film");
    CHECK(max_depth == 7);
    nicol_filter filter = NICOL_FILTER_INIT;
    FAILS(nicol_scene_get_filter(scene, &filter), NICOL_ERROR_UNSUPPORTED, "film");
    FAILS(nicol_scene_get_aovs(scene, &width), NICOL_ERROR_UNSUPPORTED, "film");
    CHECK((camera.fov == 12 && width == 5 && height == 6));

    OK(nicol_scene_set_environment(scene, two, nullptr, 1));
    OK(nicol_scene_get_channels(scene, &channels));
    CHECK(channels == 2);
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = mesh;
    instance.material = material;
    REFUSES(nicol_scene_add_instance(scene, &instance, nullptr), "channels");
    OK(nicol_scene_set_environment(scene, three, nullptr, 1));
    OK(nicol_scene_add_instance(scene, &instance, nullptr));
    REFUSES(nicol_scene_set_environment(scene, two, nullptr, 1), "channels");
    OK(nicol_scene_set_environment(scene, nullptr, nullptr, 1));
    OK(nicol_scene_get_channels(scene, &channels));
    CHECK(channels == 3);
}

CONTEXT_TEST_CASE("a file is loaded with definitions, and those that are none are refused") {
    const TemporaryFolder folder;
    const std::string path = folder.write("sc\xC3\xA8ne.xml", scene_text);
    const LoadedScene loaded(context, path);
    CHECK(loaded.camera.fov == doctest::Approx(50));
    CHECK(loaded.camera.projection == NICOL_PROJECTION_PERSPECTIVE);
    CHECK((loaded.width == 12 && loaded.height == 9 && loaded.channels == 3));
    const nicol_camera made = front_camera(4);
    CHECK(largest_difference(loaded.camera.to_world, made.to_world) < 1e-6);
    const std::vector<float> image = loaded.image();
    // The corner pixel shows the light, the middle pixel a reflectance of 0.2, 0.4, 0.6 under it.
    for (std::uint32_t c = 0; c < 3; ++c) {
        const float* pixels = &image[std::size_t{c} * 4 * 12 * 9];
        const double light = c + 1.0;
        CHECK(pixels[0] == doctest::Approx(light).epsilon(1e-3));
        CHECK(pixels[4 * (4 * 12 + 6)] == doctest::Approx(light * 0.2 * (c + 1)).epsilon(1e-3));
    }
    CHECK(LoadedScene(context, path, {"fov=25", "spp=1"}).camera.fov == doctest::Approx(25));
    std::uint32_t files = 0;
    OK(nicol_scene_get_file_count(loaded.scene, &files));
    CHECK(files == 1);
    nicol_scene_file file = NICOL_SCENE_FILE_INIT;
    OK(nicol_scene_get_file(loaded.scene, 0, &file));
    CHECK((file.path == path && file.bytes == std::strlen(scene_text) && std::strlen(file.digest) == 32));
    REFUSES(nicol_scene_get_file(loaded.scene, 1, &file), "index is 1");

    const auto load = [&](const char* const* given) {
        nicol_scene none = marker<nicol_scene>();
        const nicol_result result = nicol_scene_load(context, path.c_str(), given, 1, &none);
        CHECK(none == marker<nicol_scene>());
        return result;
    };
    REFUSES(load(nullptr), "definitions");
    const char* null = nullptr;
    REFUSES(load(&null), "definitions");
    for (const char* bad : {"fov", "=3", ""}) REFUSES(load(&bad), "name=value");
    const char* unreadable = "fov=wide";
    FAILS(load(&unreadable), NICOL_ERROR_INVALID_FILE, "fov");
}
