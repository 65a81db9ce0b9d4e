// SPDX-License-Identifier: MIT
// Scenes: instances, environments, what a file asks for.
#include <cmath>
#include <tuple>

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

// Each line that a log callback was given: severity, code, text.
using Log = std::vector<std::tuple<std::uint32_t, nicol_result, std::string>>;

void write_log(void* user, std::uint32_t severity, nicol_result code, const char* message) {
    static_cast<Log*>(user)->emplace_back(severity, code, message);
}

}  // namespace

TEST_CASE("instances count up from 0") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);  // has one
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = stage.mesh;
        instance.material = stage.material;
        std::uint32_t id = 99;
        OK(nicol_scene_add_instance(stage.scene, &instance, &id));
        CHECK(id == 1);
        OK(nicol_scene_add_instance(stage.scene, &instance, nullptr));
        OK(nicol_scene_add_instance(stage.scene, &instance, &id));
        CHECK(id == 3);
        OK(nicol_scene_set_transform(stage.scene, 3, placed(0, 0, 0).rows));
        FAILS(nicol_scene_set_transform(stage.scene, 4, placed(0, 0, 0).rows), NICOL_ERROR_INVALID_ARGUMENT,
              "instance 4");
        FAILS(nicol_scene_set_transform(stage.scene, UINT32_MAX, placed(0, 0, 0).rows),
              NICOL_ERROR_INVALID_ARGUMENT, "instance");
        instance.reserved = 1;
        FAILS(nicol_scene_add_instance(stage.scene, &instance, &id), NICOL_ERROR_INVALID_ARGUMENT,
              "reserved");
        CHECK(id == 3);
    });
}

TEST_CASE("transforms that lose the surface are refused") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        Matrix flat = placed(0, 0, 0), nan = placed(0, NAN, 0), projective = placed(0, 0, 0);
        flat.rows[0] = 0;
        projective.rows[12] = 0.1;
        Matrix huge = placed(0, 0, 0, 1e200);
        for (const Matrix& bad : {flat, nan, projective, huge}) {
            FAILS(nicol_scene_set_transform(stage.scene, 0, bad.rows), NICOL_ERROR_INVALID_ARGUMENT,
                  "to_world");
            nicol_instance instance = NICOL_INSTANCE_INIT;
            instance.mesh = stage.mesh;
            instance.material = stage.material;
            std::copy_n(bad.rows, 16, instance.to_world);
            std::uint32_t id = 42;
            FAILS(nicol_scene_add_instance(stage.scene, &instance, &id), NICOL_ERROR_INVALID_ARGUMENT,
                  "to_world");
            CHECK(id == 42);
        }
        stage.render();
        CHECK(read_all(stage.framebuffer) == before);
    });
}

TEST_CASE("an environment is rotated and scaled, nothing else") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        const auto set = [&](const double* to_world, double scale) {
            return nicol_scene_set_environment(stage.scene, stage.environment, to_world, scale);
        };
        Matrix mirrored = placed(0, 0, 0), sheared = placed(0, 0, 0), flat = placed(0, 0, 0),
               nan = placed(0, 0, 0);
        mirrored.rows[0] = -1;
        sheared.rows[1] = 0.5;
        flat.rows[5] = 0;
        nan.rows[10] = NAN;
        for (const Matrix& bad : {mirrored, sheared, flat, nan})
            FAILS(set(bad.rows, 1), NICOL_ERROR_INVALID_ARGUMENT, "to_world");
        for (const double bad : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
            FAILS(set(nullptr, bad), NICOL_ERROR_INVALID_ARGUMENT, "scale");
        stage.render();
        CHECK(read_all(stage.framebuffer) == before);

        // 0 asks for 1, zeros for the identity; a scale in the matrix is no matter.
        const double zeros[16] = {};
        for (const double* same : {static_cast<const double*>(zeros), static_cast<const double*>(nullptr)}) {
            OK(set(same, 0));
            stage.render();
            CHECK(read_all(stage.framebuffer) == before);
        }
        OK(set(placed(0, 0, 0, 2).rows, 1));
        stage.render();
        CHECK(read_all(stage.framebuffer) == before);
        OK(set(nullptr, 2));
        stage.render();
        const std::vector<float> doubled = read_all(stage.framebuffer);
        for (std::size_t i = 0; i < before.size(); ++i)
            CHECK(doubled[i] == doctest::Approx(2 * before[i]).epsilon(1e-4));
        const double rotated[16] = {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1};
        OK(set(rotated, 1));
        stage.render();
        CHECK(read_all(stage.framebuffer) != before);
    });
}

TEST_CASE("a scene's environment comes back as it was set") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const double rotated[16] = {0, 0, 2, 0, 0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 0, 1};
        OK(nicol_scene_set_environment(stage.scene, stage.environment, rotated, 0.25));
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);

        nicol_environment light = nullptr;
        double to_world[16] = {}, scale = 0;
        OK(nicol_scene_get_environment(stage.scene, &light, to_world, &scale));
        CHECK(scale == 0.25);
        // The rotation alone: what else is in a matrix does not concern light.
        for (std::size_t i = 0; i < 16; ++i) CHECK(to_world[i] == (i < 12 ? rotated[i] / 2 : rotated[i]));
        nicol_environment_info info = NICOL_ENVIRONMENT_INFO_INIT;
        OK(nicol_environment_get_info(light, &info));
        CHECK(info.polarized == 1);

        // The handle outlives the scene's own use of the light.
        OK(nicol_scene_set_environment(stage.scene, nullptr, nullptr, 0));
        nicol_environment none = marker<nicol_environment>();
        double identity[16] = {};
        OK(nicol_scene_get_environment(stage.scene, &none, identity, &scale));
        CHECK(none == nullptr);
        CHECK(scale == 1);
        for (std::size_t i = 0; i < 16; ++i) CHECK(identity[i] == (i % 5 == 0 ? 1 : 0));
        OK(nicol_scene_get_environment(stage.scene, &none, nullptr, nullptr));

        OK(nicol_scene_set_environment(stage.scene, light, to_world, 0.25));
        OK(nicol_environment_release(light));
        stage.render();
        CHECK(read_all(stage.framebuffer) == before);
    });
}

TEST_CASE("a file's light comes back with its turn and scale, a scale of 0 as darkness") {
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
        nicol_environment light = constant_light(context, {1});
        OK(nicol_environment_write(light, nullptr, folder.file("light.exr").c_str()));
        OK(nicol_environment_release(light));
        for (const bool dark : {false, true}) {
            const char* definition = dark ? "scale=0" : "scale=2.5";
            Owned<nicol_scene> scene;
            OK(nicol_scene_load(context, path.c_str(), &definition, 1, &scene));
            double to_world[16] = {}, scale = 0;
            OK(nicol_scene_get_environment(scene, &light, to_world, &scale));
            CHECK((light == nullptr) == dark);
            CHECK(scale == (dark ? 1 : 2.5));
            const double rotated[16] = {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1};
            for (std::size_t i = 0; i < 16; ++i)
                CHECK(to_world[i] == doctest::Approx(dark ? (i % 5 == 0 ? 1 : 0) : rotated[i]));
            OK(nicol_environment_release(light));
        }
    });
}

TEST_CASE("a scene has the channels of its parts, and they must fit") {
    on_every_backend([](nicol_context context) {
        const Owned scene(empty_scene(context));
        std::uint32_t channels = 0;
        OK(nicol_scene_get_channels(scene, &channels));
        CHECK(channels == 1);
        Owned<nicol_environment> two, three;
        nicol_spectrum values = spectrum({1, 2});
        OK(nicol_environment_create_constant(context, &values, &two));
        values = spectrum({1, 2, 3});
        OK(nicol_environment_create_constant(context, &values, &three));
        Owned<nicol_material> material;
        values = spectrum({0.1F, 0.2F, 0.3F});
        OK(nicol_material_create_diffuse(context, &values, &material));
        const Owned mesh(cube(context));

        OK(nicol_scene_set_environment(scene, two, nullptr, 0));
        OK(nicol_scene_get_channels(scene, &channels));
        CHECK(channels == 2);
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material;
        FAILS(nicol_scene_add_instance(scene, &instance, nullptr), NICOL_ERROR_INVALID_ARGUMENT, "channels");
        OK(nicol_scene_set_environment(scene, three, nullptr, 0));
        OK(nicol_scene_add_instance(scene, &instance, nullptr));
        FAILS(nicol_scene_set_environment(scene, two, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT, "channels");
        OK(nicol_scene_set_environment(scene, nullptr, nullptr, 0));
        OK(nicol_scene_get_channels(scene, &channels));
        CHECK(channels == 3);
    });
}

TEST_CASE("only a loaded scene has a camera and a film") {
    on_every_backend([](nicol_context context) {
        const Owned scene(empty_scene(context));
        nicol_camera camera = NICOL_CAMERA_INIT;
        camera.fov = 12;
        std::uint32_t width = 5, height = 6;
        FAILS(nicol_scene_get_camera(scene, &camera), NICOL_ERROR_UNSUPPORTED, "camera");
        FAILS(nicol_scene_get_film_size(scene, &width, &height), NICOL_ERROR_UNSUPPORTED, "film");
        CHECK(camera.fov == 12);
        CHECK(width == 5);
        CHECK(height == 6);
    });
}

TEST_CASE("a file is loaded with definitions, and notices go to the log") {
    for (const nicol_backend backend : every_backend) {
        Log log;
        nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
        options.backend = backend;
        options.log = write_log;
        options.log_user = &log;
        Owned<nicol_context> context;
        OK(nicol_context_create(&options, &context));
        const TemporaryFolder folder;
        const std::string path = folder.write("sc\xC3\xA8ne.xml", scene_text);
        nicol_scene scene = nullptr;
        OK(nicol_scene_load(context, path.c_str(), nullptr, 0, &scene));
        nicol_camera camera = NICOL_CAMERA_INIT;
        std::uint32_t width = 0, height = 0, channels = 0;
        OK(nicol_scene_get_camera(scene, &camera));
        OK(nicol_scene_get_film_size(scene, &width, &height));
        OK(nicol_scene_get_channels(scene, &channels));
        CHECK(camera.fov == doctest::Approx(50));
        CHECK(camera.projection == NICOL_PROJECTION_PERSPECTIVE);
        CHECK(width == 12);
        CHECK(height == 9);
        CHECK(channels == 3);
        const nicol_camera made = front_camera(4);
        for (std::size_t i = 0; i < 16; ++i) CHECK(camera.to_world[i] == doctest::Approx(made.to_world[i]));
        const Owned framebuffer(framebuffer_of(context, width, height, channels));
        OK(nicol_render(scene, &camera, nullptr, framebuffer));
        // The corner shows the light, the middle a reflectance of 0.2, 0.4, 0.6 under it.
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::vector<float> s0 = read_plane(framebuffer, NICOL_PLANE_S0, c);
            const double light = c + 1.0;
            CHECK(s0[0] == doctest::Approx(light).epsilon(1e-3));
            CHECK(s0[4 * 12 + 6] == doctest::Approx(light * 0.2 * (c + 1)).epsilon(1e-3));
        }
        OK(nicol_scene_release(scene));

        const char* definitions[] = {"fov=25", "spp=1"};
        OK(nicol_scene_load(context, path.c_str(), definitions, 2, &scene));
        OK(nicol_scene_get_camera(scene, &camera));
        CHECK(camera.fov == doctest::Approx(25));
        OK(nicol_scene_release(scene));

        log.clear();
        const std::string dark = folder.write("dark.xml", R"(<scene version="3.0.0">
            <sensor type="perspective"><float name="fov" value="50"/></sensor>
            <shape type="cube"/></scene>)");
        OK(nicol_scene_load(context, dark.c_str(), nullptr, 0, &scene));
        OK(nicol_scene_release(scene));
        REQUIRE_FALSE(log.empty());
        bool told = false;
        for (const auto& [severity, code, message] : log) {
            CHECK(severity == NICOL_LOG_NOTICE);
            CHECK(code == NICOL_OK);
            told = told || message.find("emitter") != std::string::npos;
        }
        CHECK(told);
    }
}

TEST_CASE("definitions that are none are refused") {
    on_every_backend([](nicol_context context) {
        const TemporaryFolder folder;
        const std::string path = folder.write("scene.xml", scene_text);
        nicol_scene scene = marker<nicol_scene>();
        FAILS(nicol_scene_load(context, path.c_str(), nullptr, 1, &scene), NICOL_ERROR_INVALID_ARGUMENT,
              "definitions");
        for (const char* bad : {"fov", "=3", ""}) {
            FAILS(nicol_scene_load(context, path.c_str(), &bad, 1, &scene), NICOL_ERROR_INVALID_ARGUMENT,
                  "name=value");
        }
        const char* null = nullptr;
        FAILS(nicol_scene_load(context, path.c_str(), &null, 1, &scene), NICOL_ERROR_INVALID_ARGUMENT,
              "definitions");
        const char* unreadable = "fov=wide";
        FAILS(nicol_scene_load(context, path.c_str(), &unreadable, 1, &scene), NICOL_ERROR_INVALID_FILE,
              "fov");
        CHECK(scene == marker<nicol_scene>());
    });
}
