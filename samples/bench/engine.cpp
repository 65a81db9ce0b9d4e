// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "guest.hpp"

namespace {

constexpr std::uint32_t kFrames = 10000;
constexpr std::uint32_t kSettled = 100;      // frames after which memory and names should stay
constexpr std::uint32_t kRows = 5;           // rows of equally many frames
constexpr std::uint32_t kFramesOfSize = 50;  // frames from one change of the window's size to the next

/// Returns the process's resident memory in MiB.
double resident_mib() {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
        double kib = 0;
        if (word == "VmRSS:" && file >> kib) return kib / 1024;
    }
    return std::nan("");
}

/// Returns the number of OpenGL objects in the host's context.
double count_names(const EglContext& egl) {
    constexpr std::uint32_t highest = 4096;
    double count = 0;
    for (const char* const name : {"glIsTexture", "glIsBuffer", "glIsFramebuffer", "glIsRenderbuffer",
                                   "glIsVertexArray", "glIsProgram", "glIsShader"}) {
        const auto is = reinterpret_cast<unsigned char (*)(std::uint32_t)>(egl.function(name));
        for (std::uint32_t id = 1; id <= highest; ++id) count += is(id);
    }
    return count;
}

/// Texture of the host's, into which images are drawn.
class HostTexture {
public:
    HostTexture(const EglContext& egl, std::uint32_t width, std::uint32_t height) : egl_(egl) {
        constexpr std::uint32_t texture_2d = 0x0DE1, rgba8 = 0x8058;
        function<void(std::uint32_t, std::int32_t, std::uint32_t*)>("glCreateTextures")(texture_2d, 1,
                                                                                        &name_);
        function<void(std::uint32_t, std::int32_t, std::uint32_t, std::int32_t, std::int32_t)>(
            "glTextureStorage2D")(name_, 1, rgba8, static_cast<std::int32_t>(width),
                                  static_cast<std::int32_t>(height));
    }
    ~HostTexture() {
        if (name_ != 0) function<void(std::int32_t, const std::uint32_t*)>("glDeleteTextures")(1, &name_);
    }
    HostTexture(const HostTexture&) = delete;
    HostTexture& operator=(const HostTexture&) = delete;

    [[nodiscard]] std::uint32_t name() const { return name_; }

private:
    template <class Signature>
    [[nodiscard]] Signature* function(const char* name) const {
        return reinterpret_cast<Signature*>(egl_.function(name));
    }

    const EglContext& egl_;
    std::uint32_t name_ = 0;
};

/// Scene of a ball that moves above a floor, under the sky.
struct Stage {
    Scene scene;
    std::uint32_t ball = 0;
    nicol_camera camera = nicol::defaults(nicol_camera_init);

    explicit Stage(nicol_context context) : scene(create<Scene>(nicol_scene_create, context)) {
        const auto sky = nicol::defaults(nicol_sky_init);
        const auto light = create<Environment>(nicol_environment_create_sky, context, &sky);
        check(nicol_scene_set_environment(scene.get(), light.get(), nullptr, 1));
        const auto sphere = create<Mesh>(nicol_mesh_create_divided_sphere, context, 24U);
        const auto square = create<Mesh>(nicol_mesh_create_rectangle, context);
        const auto material = create<Material>(nicol_material_create_diffuse, context, nullptr);
        auto instance = nicol::defaults(nicol_instance_init);
        instance.material = material.get();
        instance.mesh = square.get();
        constexpr std::array<double, 16> floor{3, 0, 0, 0, 0, 0, 3, -1, 0, -3, 0, 0, 0, 0, 0, 1};
        std::ranges::copy(floor, instance.to_world);
        std::uint32_t id = 0;
        check(nicol_scene_add_instance(scene.get(), &instance, &id));
        instance = nicol::defaults(nicol_instance_init);
        instance.material = material.get();
        instance.mesh = sphere.get();
        check(nicol_scene_add_instance(scene.get(), &instance, &ball));
        const double eye[] = {0, 2, 6}, middle[] = {0, 0, 0}, up[] = {0, 1, 0};
        check(nicol_camera_look_at(&camera, eye, middle, up));
    }
    void move(double x) const {
        const double to_world[] = {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        check(nicol_scene_set_transform(scene.get(), ball, to_world));
    }
};

/// A job beside the frames: always one that renders a scene from nothing.
class Jobs {
public:
    explicit Jobs(nicol_context context)
        : context_(context), image_(create<Framebuffer>(nicol_framebuffer_create, context, 64U, 64U, 3U)) {
        next();
    }
    /// Ends the job, which must not outlive the host's context.
    ~Jobs() {
        nicol_job_cancel(job_.get());
        nicol_job_wait(job_.get(), NICOL_WAIT_FOREVER);
    }
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// Lends the context to the job, and begins the next one if it is done.
    void poll() {
        auto status = nicol::defaults(nicol_job_status_init);
        check(nicol_job_poll(job_.get(), &status));
        if (status.state != NICOL_JOB_DONE) return;
        check(status.result);
        ++done_;
        next();
    }
    [[nodiscard]] std::uint32_t done() const { return done_; }

private:
    void next() {
        stage_ = Stage(context_);
        const auto render = nicol::defaults(nicol_render_options_init);
        job_ =
            create<nicol::Job>(nicol_render_async, stage_.scene.get(), &stage_.camera, &render, image_.get());
    }

    nicol_context context_;
    Framebuffer image_;
    Stage stage_{context_};
    nicol::Job job_;
    std::uint32_t done_ = 0;
};

/// Renders a frame into the host's texture.
void render_frame(const Stage& stage, const Framebuffer& framebuffer, std::uint32_t texture) {
    auto render = nicol::defaults(nicol_render_options_init);
    render.bake_budget_ms = 4;
    check(nicol_render(stage.scene.get(), &stage.camera, &render, framebuffer.get()));
    const auto observation = nicol::defaults(nicol_observation_init);
    auto target = nicol::defaults(nicol_texture_target_init);
    target.texture = texture;
    check(nicol_framebuffer_draw_observation(framebuffer.get(), &observation, &target));
}

}  // namespace

Report bench_engine(const Options& options) {
    const std::uint32_t frames = options.samples == 0 ? kFrames : options.samples;
    const std::uint32_t size = options.size == 0 ? 128 : options.size;
    const Guest guest = Guest::in_host();
    const Stage stage(guest.context.get());
    Jobs jobs(guest.context.get());
    const auto framebuffer =
        create<Framebuffer>(nicol_framebuffer_create, guest.context.get(), size, size, 3U);
    std::optional<HostTexture> texture;
    texture.emplace(*guest.egl, size, size);
    Report report({"frames of an engine's host", "p50, ms", "p99, ms", "longest, ms", "MiB", "OpenGL objects",
                   "jobs done"});
    std::vector<double> times;
    const auto add_row = [&](std::uint32_t last) {
        std::ranges::sort(times);
        const auto at = [&](double part) {
            return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
        };
        report.add("to " + std::to_string(last), {at(0.5), at(0.99), times.back(), resident_mib(),
                                                  count_names(*guest.egl), static_cast<double>(jobs.done())});
        times.clear();
    };
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        if (frame % kFramesOfSize == kFramesOfSize - 1) {
            const std::uint32_t width = size + frame / kFramesOfSize % 7;
            check(nicol_framebuffer_resize(framebuffer.get(), width, size));
            texture.emplace(*guest.egl, width, size);
        }
        stage.move(std::sin(0.02 * frame));
        render_frame(stage, framebuffer, texture->name());
        jobs.poll();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        const std::uint32_t done = frame + 1;
        if (done == kSettled || done % std::max(frames / kRows, 1U) == 0 || done == frames) add_row(done);
    }
    report.note(
        "Each frame moves a ball, renders it within a bake_budget_ms of 4, and draws s0 into the host's "
        "texture; every 50th changes the image's size. A job at a time renders another scene from "
        "nothing. Times: of the frames since the row before. MiB (resident), OpenGL objects, jobs: at the "
        "row's last frame.");
    return report;
}
