// SPDX-License-Identifier: MIT
// The pictures of a data set: what each step takes from a picture to its files.
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "sphere.hpp"
#include "stage.hpp"
#include "temporary_folder.hpp"

namespace {

constexpr int kViews = 60;    // pictures of each row
constexpr int kObjects = 12;  // of the row with new objects
constexpr double kTurn = 360.0 / kViews;

/// Memory and files of one picture.
class Output {
public:
    Output(nicol_framebuffer framebuffer, std::uint32_t size, std::filesystem::path folder)
        : framebuffer_(framebuffer), folder_(std::move(folder)), numbers_(std::size_t{size} * size) {
        std::uint32_t width = 0, height = 0, channels = 0;
        check(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
        stokes_.resize(4 * channels * numbers_.size());
        check(nicol_sensor_set_preset(&sensor_, NICOL_SENSOR_PRESET_IMX250MZR));
        raw_.width = raw_.height = size;
        raw_.pixels = numbers_.data();
        raw_.byte_size = numbers_.size() * sizeof(std::uint16_t);
    }

    void read() {
        auto plane = nicol::defaults(nicol_plane_buffer_init);
        plane.plane = NICOL_PLANE_STOKES;
        plane.channel = NICOL_ALL_CHANNELS;
        plane.pixels = stokes_.data();
        plane.byte_size = stokes_.size() * sizeof(float);
        check(nicol_framebuffer_read_plane(framebuffer_, &plane));
    }
    void expose(int frame) {
        check(nicol_framebuffer_expose(framebuffer_, &sensor_, static_cast<std::uint64_t>(frame), &raw_));
    }
    void write_png() const {
        check(nicol_sensor_write_png(&sensor_, &raw_, (folder_ / "mosaic.png").c_str()));
    }
    void write_exr() const {
        check(nicol_framebuffer_write_exr(framebuffer_, (folder_ / "stokes.exr").c_str()));
    }

private:
    nicol_framebuffer framebuffer_;
    std::filesystem::path folder_;
    std::vector<std::uint16_t> numbers_;
    std::vector<float> stokes_;
    nicol_sensor sensor_ = NICOL_SENSOR_INIT;
    nicol_raw_image raw_ = NICOL_RAW_IMAGE_INIT;
};

void add_row(Report& report, const std::string& name, int pictures, const std::function<void(int)>& picture) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const std::clock_t used = std::clock();
    for (int i = 0; i < pictures; ++i) picture(i);
    const double processor = 1000.0 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / pictures;
    const double wall = std::chrono::duration<double, std::milli>(Clock::now() - start).count() / pictures;
    report.add(name, {60000 / wall, wall, processor});
}

/// A scene with an object, a material and a light that no other picture has.
Scene new_scene(nicol_context context, int number) {
    auto scene = create<Scene>(nicol_scene_create, context);
    auto sky = nicol::defaults(nicol_sky_init);
    const auto turn = static_cast<float>(number);
    sky.sun_direction[0] = std::sin(turn);
    sky.sun_direction[1] = 0.7F;
    sky.sun_direction[2] = std::cos(turn);
    const auto light = create<Environment>(nicol_environment_create_sky, context, &sky);
    check(nicol_scene_set_environment(scene.get(), light.get(), nullptr, 1));
    auto plastic = nicol::defaults(nicol_pplastic_init);
    plastic.alpha = 0.05F + 0.02F * turn;
    const auto material = create<Material>(nicol_material_create_pplastic, context, &plastic);
    const Mesh mesh = make_sphere(context, 10000, 0.1 + 0.01 * number);
    auto instance = nicol::defaults(nicol_instance_init);
    instance.mesh = mesh.get();
    instance.material = material.get();
    check(nicol_scene_add_instance(scene.get(), &instance, nullptr));
    return scene;
}

void add_new_objects(Report& report, nicol_context context, std::uint32_t size,
                     const nicol_render_options& options) {
    auto camera = nicol::defaults(nicol_camera_init);
    const double place[] = {0, 0.5, 4}, target[] = {0, 0, 0}, up[] = {0, 1, 0};
    check(nicol_camera_look_at(&camera, place, target, up));
    const TemporaryFolder folder;
    add_row(report, "new object, material and light, and both files", kObjects, [&](int i) {
        const Scene scene = new_scene(context, i);
        std::uint32_t channels = 0;
        check(nicol_scene_get_channels(scene.get(), &channels));
        const auto framebuffer = create<Framebuffer>(nicol_framebuffer_create, context, size, size, channels);
        check(nicol_render(scene.get(), &camera, &options, framebuffer.get()));
        Output output(framebuffer.get(), size, folder.path());
        output.expose(i);
        output.write_png();
        output.write_exr();
    });
}

}  // namespace

Report bench_dataset(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 512 : options.size;
    const SceneSource source(options);
    Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    const auto wanted = nicol::defaults(nicol_render_options_init);
    const auto render = [&] {
        stage.orbit(kTurn);
        stage.render(wanted, framebuffer.get());
    };
    for (int i = 0; i < kViews; ++i) render();  // bakes and lights what the views show
    const TemporaryFolder folder;
    Output output(framebuffer.get(), size, folder.path());
    Report report({"a picture", "a minute", "ms", "processor ms"});
    add_row(report, "rendered, the camera moved", kViews, [&](int) { render(); });
    add_row(report, "and its Stokes vectors read", kViews, [&](int) {
        render();
        output.read();
    });
    add_row(report, "and a mosaic exposed", kViews, [&](int i) {
        render();
        output.read();
        output.expose(i);
    });
    add_row(report, "and the mosaic as PNG", kViews, [&](int i) {
        render();
        output.read();
        output.expose(i);
        output.write_png();
    });
    add_row(report, "and the Stokes image as EXR", kViews, [&](int i) {
        render();
        output.expose(i);
        output.write_png();
        output.write_exr();
    });
    add_new_objects(report, source.context(), size, wanted);
    report.note(source.machine() +
                ". One step after the other; nicol-dataset writes files while it renders, and zips less.");
    return report;
}
