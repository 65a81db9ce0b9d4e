// SPDX-License-Identifier: MIT
// Tests of a render's image, refusals and cancellation.
#include <thread>

#include "capi.hpp"
#include "image/stokes_image.hpp"

using namespace capi_test;

namespace {

// A progress callback that stops at its first call and records the verbs.
struct Stop {
    std::vector<std::string> verbs;
    nicol_render_options options = plain_options();

    Stop() {
        options.progress = [](void* user, const char* verb, double fraction) -> std::int32_t {
            CHECK(fraction >= 0);
            CHECK(fraction <= 1);
            static_cast<Stop*>(user)->verbs.emplace_back(verb);
            return 0;
        };
        options.progress_user = this;
    }
    Stop(const Stop&) = delete;
    Stop& operator=(const Stop&) = delete;
};

}  // namespace

CONTEXT_TEST_CASE("scenes of 1, 2, 5 and 16 channels render") {
    for (const std::uint32_t channels : {1U, 2U, 5U, 16U}) {
        CAPTURE(channels);
        std::vector<float> light, reflectance;
        for (std::size_t c = 0; c < channels; ++c) {
            light.push_back(1 + 0.5F * static_cast<float>(c));
            reflectance.push_back(0.9F - 0.05F * static_cast<float>(c));
        }
        // A diffuse square of half the image's width in front of constant light.
        const Owned scene(empty_scene(context));
        const Owned framebuffer(framebuffer_of(context, 20, 20, channels));
        OK(nicol_scene_set_environment(scene, Owned(constant_light(context, light)), nullptr, 1));
        add(scene, Owned(rectangle(context)), Owned(diffuse(context, reflectance)), placed(0, 0, 0, 0.5));
        const nicol_camera camera = front_camera();
        OK(nicol_render(scene, &camera, nullptr, framebuffer));
        for (std::size_t c = 0; c < channels; ++c) {
            const std::vector<float> stokes =
                read_plane(framebuffer, NICOL_PLANE_STOKES, static_cast<std::uint32_t>(c));
            const float* corner = stokes.data();
            const float* middle = stokes.data() + std::size_t{4} * (10 * 20 + 10);
            CHECK(corner[0] == doctest::Approx(light[c]).epsilon(1e-5));
            // A diffuse surface under constant light reflects its reflectance times the light.
            CHECK(middle[0] == doctest::Approx(light[c] * reflectance[c]).epsilon(1e-3));
            for (std::size_t p = 1; p < 4; ++p) {
                CHECK(std::abs(corner[p]) < 1e-6F);
                CHECK(std::abs(middle[p]) < 1e-6F);
            }
        }
        const TemporaryFolder folder;
        const std::string exr = folder.file("image.exr"), png = folder.file("image.png");
        const nicol_observation image = NICOL_OBSERVATION_INIT;
        // EXR files hold any number of channels, while PNG images need one or three.
        OK(nicol_framebuffer_write_exr(framebuffer, exr.c_str()));
        CHECK(nicol::read_exr(exr).data == read_all(framebuffer));
        if (channels == 1) {
            OK(nicol_framebuffer_write_png(framebuffer, &image, png.c_str()));
        } else {
            REFUSES(nicol_framebuffer_write_png(framebuffer, &image, png.c_str()), "must have 1 (grey) or 3");
            CHECK(folder.names() == std::set<std::string>{"image.exr"});
        }
    }
}

STAGE_TEST_CASE("options mean what they say, and those that an older program does not have their defaults") {
    nicol_render_options options = plain_options();
    // This scene's sky has no order above 2.
    for (const auto& [low, high, order] :
         std::vector<std::array<std::uint32_t, 3>>{{0, 0, 0},
                                                   {0, 9, 2},
                                                   {1, 0, 1},
                                                   {1, 1, 1},
                                                   {12, 9, 12},
                                                   {2, 9, 2},
                                                   {4, 9, 4},
                                                   {NICOL_ORDER_AUTOMATIC, 1, 1},
                                                   {3, NICOL_ORDER_AUTOMATIC, 3},
                                                   {NICOL_ORDER_AUTOMATIC, 9, 4}}) {
        options.order_low = low;
        options.order_high = high;
        OK(stage.try_render(options));
        CHECK(statistics_of(stage.framebuffer).order == order);
        // Interpolation between vertices alone is predicted.
        CHECK(statistics_of(stage.framebuffer).predicted_error < 0.01);
    }
    options = NICOL_RENDER_OPTIONS_INIT;
    const std::vector<float> before = stage.image(options);
    CHECK(statistics_of(stage.framebuffer).order <= 2);
    CHECK(statistics_of(stage.framebuffer).predicted_error <= 0.03);
    nicol_render_options older;  // ends after method
    std::memset(&older, 0, sizeof older);
    older.struct_size = offsetof(nicol_render_options, order_low);
    CHECK(stage.image(older) == before);
    // Every option is set to its documented default.
    options.order_low = options.order_high = NICOL_ORDER_AUTOMATIC;
    options.tolerance = 0.03;
    options.physical = 1;
    options.shadows = 1;
    options.bake_directions = 1024;
    options.high_orders = NICOL_HIGH_ORDERS_SPLIT;
    CHECK(stage.image(options) == before);
}

STAGE_TEST_CASE("shadows are traced in as many directions as the tolerance needs") {
    // A second cube above the first casts shadows.
    add(stage.scene, stage.mesh, stage.material, {{0.4, 0, 0, 0, 0, 0.4, 0, 1, 0, 0, 0.4, 0, 0, 0, 0, 1}});
    const auto rays = [&](double tolerance, std::uint32_t order, std::uint32_t directions) {
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.refine_tolerance = 0;
        options.tolerance = tolerance;
        options.order_low = order;
        options.bake_directions = 256;  // other numbers of directions cannot reuse this bake
        OK(stage.try_render(options));
        options.bake_directions = directions;
        OK(stage.try_render(options));
        const nicol_statistics statistics = statistics_of(stage.framebuffer);
        return statistics.bake_rays + statistics.bake_rays_skipped;
    };
    for (const auto& [tolerance, order, directions] :
         std::vector<std::tuple<double, std::uint32_t, std::uint32_t>>{{1, NICOL_ORDER_AUTOMATIC, 1024},
                                                                       {0.03, NICOL_ORDER_AUTOMATIC, 1024},
                                                                       {0.029, NICOL_ORDER_AUTOMATIC, 2048},
                                                                       {0.01, NICOL_ORDER_AUTOMATIC, 4096},
                                                                       {0, NICOL_ORDER_AUTOMATIC, 8192},
                                                                       {0.01, 2, 2048}}) {
        CAPTURE(tolerance);
        CHECK(rays(tolerance, order, NICOL_DIRECTIONS_AUTOMATIC) == rays(tolerance, order, directions));
    }
    CHECK(rays(0.03, 2, 1024) < rays(0.03, 2, 2048));
}

STAGE_TEST_CASE("a framebuffer must have the scene's channels, or one of three") {
    for (const std::uint32_t channels : {2U, 4U, 16U}) {
        const Owned other(framebuffer_of(stage.context, 4, 4, channels));
        REFUSES(nicol_render(stage.scene, &stage.camera, nullptr, other), "channels");
    }
}

STAGE_TEST_CASE("a cancelled render leaves the image, whichever verb was at work") {
    const auto stop_at = [&](const char* verb, nicol_scene scene, const nicol_camera& camera,
                             std::uint32_t shadows = 1) {
        INFO(std::string(verb));
        const std::vector<float> image = read_all(stage.framebuffer);
        const nicol_statistics before = statistics_of(stage.framebuffer);
        Stop stop;
        stop.options.shadows = shadows;
        FAILS(nicol_render(scene, &camera, &stop.options, stage.framebuffer), NICOL_ERROR_CANCELLED,
              "progress");
        CHECK(stop.verbs == std::vector<std::string>{verb});
        CHECK(read_all(stage.framebuffer) == image);
        nicol_statistics after = statistics_of(stage.framebuffer);
        after.observe_ms = before.observe_ms;  // changed by the read above
        CHECK(std::memcmp(&before, &after, sizeof before) == 0);
    };
    // The framebuffer is still new at the first render.
    stop_at("bake", stage.scene, stage.camera);
    stop_at("bake", stage.scene, stage.camera);
    stop_at("project", stage.scene, stage.camera, 0);
    const std::vector<float> still = stage.image();
    OK(nicol_scene_set_transform(stage.scene, 0, placed(0.3, 0, 0, 0.4).rows));
    stop_at("bake", stage.scene, stage.camera);
    stop_at("relight", stage.scene, stage.camera, 0);
    stop_at("relight", stage.scene, stage.camera, 0);
    const std::vector<float> moved = stage.image();
    CHECK(moved != still);
    stop_at("shade", stage.scene, front_camera(5));
    const Owned empty(empty_scene(stage.context));
    OK(nicol_scene_set_environment(empty, stage.environment, nullptr, 1));
    stop_at("draw", empty, stage.camera, 0);
}

CONTEXT_TEST_CASE("a callback that calls back gets an error and no deadlock") {
    struct Caller {
        const Stage& own;
        const Stage& other;
        std::vector<nicol_result> refused, allowed;
        std::thread::id thread = std::this_thread::get_id();
        bool same_thread = true;
    };
    const Owned second(make_context(NICOL_BACKEND_OSMESA));
    {
        const Stage stage(context), other(second);
        Caller caller{stage, other, {}, {}};
        nicol_render_options options = plain_options();
        options.progress_user = &caller;
        options.progress = [](void* user, const char*, double) -> std::int32_t {
            Caller& self = *static_cast<Caller*>(user);
            self.same_thread = self.same_thread && std::this_thread::get_id() == self.thread;
            const Stage& own = self.own;
            nicol_instance instance = NICOL_INSTANCE_INIT;
            instance.mesh = own.mesh;
            instance.material = own.material;
            nicol_statistics statistics = NICOL_STATISTICS_INIT;
            const nicol_observation image = NICOL_OBSERVATION_INIT;
            float pixels[24 * 16] = {};
            std::uint32_t channels = 0;
            self.refused = {
                nicol_render(own.scene, &own.camera, nullptr, own.framebuffer),
                nicol_scene_add_instance(own.scene, &instance, nullptr),
                nicol_scene_set_transform(own.scene, 0, placed(0, 0, 0).rows),
                nicol_scene_set_environment(own.scene, nullptr, nullptr, 1),
                nicol_scene_get_channels(own.scene, &channels),
                nicol_framebuffer_get_statistics(own.framebuffer, &statistics),
                nicol_framebuffer_read(own.framebuffer, NICOL_PLANE_S0, 0, pixels, 0, sizeof pixels),
                nicol_framebuffer_write_exr(own.framebuffer, "/nowhere/x.exr"),
                nicol_framebuffer_write_png(own.framebuffer, &image, "/nowhere/x.png")};
            self.allowed = {
                nicol_render(self.other.scene, &self.other.camera, nullptr, self.other.framebuffer),
                nicol_framebuffer_read(self.other.framebuffer, NICOL_PLANE_S0, 0, pixels, 0, sizeof pixels),
                nicol_mesh_retain(own.mesh), nicol_mesh_release(own.mesh)};
            return 1;
        };
        OK(stage.try_render(options));
        CHECK(caller.same_thread);
        CHECK(caller.refused.size() == 9);
        for (const nicol_result result : caller.refused) CHECK(result == NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(caller.allowed.size() == 4);
        for (const nicol_result result : caller.allowed) CHECK(result == NICOL_OK);
        // No refused call had an effect.
        const std::vector<float> watched = read_all(stage.framebuffer);
        CHECK(stage.image() == watched);
    }
}

CONTEXT_TEST_CASE("objects released inside a callback live until the call is over") {
    auto* stage = new Stage(context);
    nicol_render_options options = plain_options();
    options.progress_user = stage;
    options.progress = [](void* user, const char*, double) -> std::int32_t {
        delete static_cast<Stage*>(user);
        return 0;
    };
    const nicol_scene scene = stage->scene;
    const nicol_camera camera = stage->camera;
    FAILS(nicol_render(scene, &camera, &options, stage->framebuffer), NICOL_ERROR_CANCELLED, "progress");
    FAILS(nicol_scene_retain(scene), NICOL_ERROR_INVALID_HANDLE, "released");
}

STAGE_TEST_CASE("statistics tell what a render did") {
    stage.render();
    const nicol_statistics first = statistics_of(stage.framebuffer);
    std::uint32_t vertices = 0, triangles = 0;
    OK(nicol_mesh_get_size(stage.mesh, &vertices, &triangles));
    CHECK(first.struct_size == sizeof first);
    CHECK(first.order == 4);
    CHECK(first.vertices == vertices);
    CHECK(first.triangles == triangles);
    CHECK(first.project_ms > 0);
    CHECK(first.relight_ms > 0);
    CHECK(first.vertices_skipped > 0);
    CHECK(first.light_columns_skipped == 1);  // a sky has no s3
    CHECK(first.channels_shared == 2);        // the sky is grey
    CHECK(first.response_bytes > 0);
    CHECK(first.texture_bytes >= std::uint64_t{24} * 16 * 16 * 3);
    stage.render();
    const nicol_statistics second = statistics_of(stage.framebuffer);
    CHECK(second.relight_ms == 0);
    CHECK(second.transfer_bytes == first.transfer_bytes);
    CHECK(second.buffer_bytes == first.buffer_bytes);
    CHECK(second.texture_bytes == first.texture_bytes);
    // The automatic executor uses threads if OpenGL runs on the CPU.
    nicol_render_options automatic = plain_options();
    automatic.executor = NICOL_EXECUTOR_AUTOMATIC;
    OK(stage.try_render(automatic));
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    OK(nicol_context_get_info(stage.context, &info));
    CHECK(statistics_of(stage.framebuffer).compute == (info.software != 0 ? 0U : 1U));
}
