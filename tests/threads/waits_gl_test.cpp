// SPDX-License-Identifier: MIT
// Tests that no function waits for a running job: all of them return while the job is held.
#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "backends.hpp"
#include "bench/entry_points.hpp"
#include "bench/guest.hpp"
#include "capi/gate.hpp"
#include "temporary_folder.hpp"
#include "threads/no_workers.hpp"

namespace {

using Names = std::set<std::string>;

/// Returns the functions of the C headers that take a context or an object of one.
Names functions_of_contexts(bool in_host) {
    // These take neither, or a file of measurements, which the repository lacks.
    const Names apart{"nicol_build_info",
                      "nicol_version",
                      "nicol_version_string",
                      "nicol_last_error",
                      "nicol_result_name",
                      "nicol_camera_look_at",
                      "nicol_camera_set_opencv",
                      "nicol_camera_get_opencv",
                      "nicol_camera_frame",
                      "nicol_sky_get_sun",
                      "nicol_sensor_set_preset",
                      "nicol_sensor_load",
                      "nicol_sensor_load_memory",
                      "nicol_sensor_add_element",
                      "nicol_sensor_expose",
                      "nicol_sensor_write_png",
                      "nicol_sensor_demosaic",
                      "nicol_render_options_set_quality",
                      "nicol_device_count",
                      "nicol_device_get_info",
                      "nicol_context_create",
                      "nicol_context_create_host",
                      "nicol_material_load_measured",
                      "nicol_material_load_measured_memory"};
    const Names for_hosts{"nicol_framebuffer_create_textures", "nicol_framebuffer_draw_observation",
                          "nicol_framebuffer_draw_plane", "nicol_framebuffer_draw_stokes",
                          "nicol_framebuffer_get_texture"};
    Names names;
    std::ifstream file(NICOL_FUNCTIONS);
    for (std::string name; file >> name;) {
        const bool numbers = name.starts_with("nicol_psh_") || name.starts_with("nicol_file_");
        if (!numbers && !name.ends_with("_init") && !apart.contains(name) &&
            (in_host || !for_hosts.contains(name)))
            names.insert(name);
    }
    return names;
}

/// A cube under a sky, and its framebuffer.
class Picture {
public:
    explicit Picture(nicol_context context)
        : scene(create<Scene>(nicol_scene_create, context)),
          framebuffer(create<Framebuffer>(nicol_framebuffer_create, context, 24U, 16U, 3U)) {
        const auto sky = nicol::defaults(nicol_sky_init);
        const auto light = create<Environment>(nicol_environment_create_sky, context, &sky);
        check(nicol_scene_set_environment(scene.get(), light.get(), nullptr, 1));
        const auto mesh = create<Mesh>(nicol_mesh_create_cube, context);
        const auto material = create<Material>(nicol_material_create_diffuse, context, nullptr);
        auto instance = nicol::defaults(nicol_instance_init);
        instance.mesh = mesh.get();
        instance.material = material.get();
        check(nicol_scene_add_instance(scene.get(), &instance, &id_));
        const double eye[] = {2, 3, 5}, middle[] = {0, 0, 0}, up[] = {0, 1, 0};
        check(nicol_camera_look_at(&camera, eye, middle, up));
    }
    void move(double x) const {
        const double to_world[] = {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        check(nicol_scene_set_transform(scene.get(), id_, to_world));
    }
    [[nodiscard]] std::vector<float> read() const {
        std::vector<float> s0(std::size_t{24} * 16);
        check(nicol_framebuffer_read(framebuffer.get(), NICOL_PLANE_S0, 0, s0.data(), 0,
                                     s0.size() * sizeof(float)));
        return s0;
    }

    Scene scene;
    Framebuffer framebuffer;
    nicol_camera camera = nicol::defaults(nicol_camera_init);

private:
    std::uint32_t id_ = 0;
};

/// Calls everything while a job is held, and returns the names of the functions.
Names called_beside_a_job(const Guest& guest, nicol_method method) {
    const Picture picture(guest.context.get());
    auto options = nicol::defaults(nicol_render_options_init);
    options.method = method;
    options.samples = 4;
    check(nicol_render(picture.scene.get(), &picture.camera, &options, picture.framebuffer.get()));
    const std::vector<float> before = picture.read();
    picture.move(0.5);
    capi_test::Gate gate;
    options.progress = capi_test::Gate::callback;
    options.progress_user = &gate;
    const auto job = create<nicol::Job>(nicol_render_async, picture.scene.get(), &picture.camera, &options,
                                        picture.framebuffer.get());
    gate.wait_until_entered();

    Names called;
    const auto watch = [&called](const char* name, const std::function<void()>& call) {
        CAPTURE(name);
        called.insert(name);
        CHECK_NOTHROW(call());
    };
    const TemporaryFolder folder;
    EntryPoints points(guest.context.get(), folder.path());
    points.all(watch, guest.texture);
    points.reads(watch, picture.framebuffer.get());
    CHECK(picture.read() == before);
    picture.move(1);

    auto status = nicol::defaults(nicol_job_status_init);
    check(nicol_job_poll(job.get(), &status));
    CHECK(status.state == NICOL_JOB_RUNNING);
    gate.open();
    check(nicol_job_wait(job.get(), NICOL_WAIT_FOREVER));
    CHECK(picture.read() != before);
    return called;
}

constexpr nicol_method methods[] = {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE};

}  // namespace

TEST_CASE("no function waits for a job") {
    std::vector<nicol_backend> backends{NICOL_BACKEND_EGL};
    if (nicol::test::wanted_backends() != "egl") backends.push_back(NICOL_BACKEND_OSMESA);
    for (const nicol_backend backend : backends)
        for (const nicol_method method : methods)
            CHECK(called_beside_a_job(Guest::own(backend), method) == functions_of_contexts(false));
}

TEST_CASE("no function waits for a job inside a host's OpenGL") {
    const Guest guest = Guest::in_host();
    for (const nicol_method method : methods)
        CHECK(called_beside_a_job(guest, method) == functions_of_contexts(true));
}
