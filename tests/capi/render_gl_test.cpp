// SPDX-License-Identifier: MIT
// What a render shows, what it refuses, and how it is stopped.
#include <array>
#include <cmath>
#include <cstring>
#include <thread>

#include "capi.hpp"
#include "image/stokes_image.hpp"

using namespace capi_test;

namespace {

// A diffuse square of half the image's width in front of constant light.
struct Square {
    Owned<nicol_scene> scene;
    Owned<nicol_framebuffer> framebuffer;
    nicol_camera camera = front_camera();

    Square(nicol_context context, const std::vector<float>& light, const std::vector<float>& reflectance)
        : scene(empty_scene(context)) {
        const Owned environment(constant_light(context, light));
        const Owned material(diffuse(context, reflectance));
        const Owned mesh(rectangle(context));
        OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
        add(scene, mesh, material, placed(0, 0, 0, 0.5));
        std::uint32_t channels = 0;
        OK(nicol_scene_get_channels(scene, &channels));
        OK(nicol_framebuffer_create(context, 20, 20, channels, &framebuffer));
    }
    void render() const { OK(nicol_render(scene, &camera, nullptr, framebuffer)); }
};

// Stops at the first call, and remembers what it was told.
struct Stop {
    std::vector<std::string> verbs;
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;

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

// Where the square is: mean column and row of the pixels unlike the corner, and how many there are.
struct Place {
    double x = 0, y = 0;
    int count = 0;
};
Place place_of(const std::vector<float>& s0) {
    Place place;
    for (int i = 0; i < 400; ++i) {
        if (s0[static_cast<std::size_t>(i)] == s0[0]) continue;
        place.x += i % 20;
        place.y += i / 20;
        ++place.count;
    }
    place.x /= place.count;
    place.y /= place.count;
    return place;
}

}  // namespace

TEST_CASE("the same scene gives the same bits") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context), twin(context);
        stage.render();
        const std::vector<float> first = read_all(stage.framebuffer);
        stage.render();
        CHECK(read_all(stage.framebuffer) == first);
        twin.render();
        CHECK(read_all(twin.framebuffer) == first);
    });
}

TEST_CASE("scenes of 1, 2, 5 and 16 channels render") {
    on_every_backend([](nicol_context context) {
        for (const std::size_t channels : {1U, 2U, 5U, 16U}) {
            CAPTURE(channels);
            std::vector<float> light, reflectance;
            for (std::size_t c = 0; c < channels; ++c) {
                light.push_back(1 + 0.5F * static_cast<float>(c));
                reflectance.push_back(0.9F - 0.05F * static_cast<float>(c));
            }
            const Square square(context, light, reflectance);
            square.render();
            for (std::size_t c = 0; c < channels; ++c) {
                const std::vector<float> stokes =
                    read_plane(square.framebuffer, NICOL_PLANE_STOKES, static_cast<std::uint32_t>(c));
                const float* corner = stokes.data();
                const float* middle = stokes.data() + std::size_t{4} * (10 * 20 + 10);
                CHECK(corner[0] == doctest::Approx(light[c]).epsilon(1e-5));
                // Light from all over its half of the sphere: what a diffuse surface sends back is its part.
                CHECK(middle[0] == doctest::Approx(light[c] * reflectance[c]).epsilon(1e-3));
                for (std::size_t p = 1; p < 4; ++p) {
                    CHECK(std::abs(corner[p]) < 1e-6F);
                    CHECK(std::abs(middle[p]) < 1e-6F);
                }
            }
            const TemporaryFolder folder;
            const std::string exr = folder.file("image.exr"), png = folder.file("image.png");
            const nicol_observation image = NICOL_OBSERVATION_INIT;
            // Files hold any number of channels; images for people need one or three.
            OK(nicol_framebuffer_write_exr(square.framebuffer, exr.c_str()));
            CHECK(nicol::read_exr(exr).data == read_all(square.framebuffer));
            if (channels == 1) {
                OK(nicol_framebuffer_write_png(square.framebuffer, &image, png.c_str()));
            } else {
                FAILS(nicol_framebuffer_write_png(square.framebuffer, &image, png.c_str()),
                      NICOL_ERROR_INVALID_ARGUMENT, "must have 1 (grey) or 3");
                CHECK(folder.names() == std::set<std::string>{"image.exr"});
            }
        }
    });
}

TEST_CASE("no environment is darkness") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        OK(nicol_scene_set_environment(stage.scene, nullptr, nullptr, 0));
        const Owned framebuffer(framebuffer_of(context, 24, 16, 1));
        OK(nicol_render(stage.scene, &stage.camera, nullptr, framebuffer));
        for (const float value : read_all(framebuffer)) REQUIRE(value == 0);
        for (const float value : read_plane(framebuffer, NICOL_PLANE_DOLP)) REQUIRE(value == 0);
        for (const float value : read_plane(framebuffer, NICOL_PLANE_AOLP)) REQUIRE(value == 0);
        const Owned empty(empty_scene(context));
        OK(nicol_render(empty, &stage.camera, nullptr, framebuffer));
        for (const float value : read_all(framebuffer)) REQUIRE(value == 0);
    });
}

TEST_CASE("an empty scene shows its environment") {
    on_every_backend([](nicol_context context) {
        const std::vector<float> radiance = {0.25F, 2, 0};
        const Owned environment(constant_light(context, radiance));
        const Owned scene(empty_scene(context));
        OK(nicol_scene_set_environment(scene, environment, nullptr, 3));
        const Owned framebuffer(framebuffer_of(context, 6, 5, 3));
        nicol_camera camera = front_camera();
        for (const nicol_projection projection :
             {NICOL_PROJECTION_PERSPECTIVE, NICOL_PROJECTION_ORTHOGRAPHIC}) {
            camera.projection = projection;
            OK(nicol_render(scene, &camera, nullptr, framebuffer));
            for (std::uint32_t c = 0; c < 3; ++c) {
                const std::vector<float> stokes = read_plane(framebuffer, NICOL_PLANE_STOKES, c);
                for (std::size_t i = 0; i < stokes.size(); ++i) {
                    const float expected = i % 4 == 0 ? 3 * radiance[c] : 0;
                    CHECK(stokes[i] == doctest::Approx(expected).epsilon(1e-5));
                }
            }
        }
        const nicol_statistics statistics = statistics_of(framebuffer);
        CHECK(statistics.vertices == 0);
        CHECK(statistics.triangles == 0);
    });
}

TEST_CASE("moving an instance moves it in the image") {
    on_every_backend([](nicol_context context) {
        const Square square(context, {1}, {0.25F});
        const auto render_at = [&](double x, double y, double size) {
            OK(nicol_scene_set_transform(square.scene, 0, placed(x, y, 0, size).rows));
            square.render();
            return place_of(read_plane(square.framebuffer, NICOL_PLANE_S0));
        };
        const Place middle = render_at(0, 0, 0.5);
        REQUIRE(middle.count > 40);
        CHECK(middle.x == doctest::Approx(9.5).epsilon(0.02));
        CHECK(middle.y == doctest::Approx(9.5).epsilon(0.02));
        // 20 pixels are 6 tan 22.5 degrees in the world.
        const double pixels = 20 / (6 * std::tan(0.39269908));
        const Place right = render_at(0.4, 0, 0.5);
        CHECK(right.x == doctest::Approx(9.5 + 0.4 * pixels).epsilon(0.06));
        CHECK(right.y == doctest::Approx(9.5).epsilon(0.02));
        const Place up = render_at(0, 0.4, 0.5);
        CHECK(up.x == doctest::Approx(9.5).epsilon(0.02));
        CHECK(up.y == doctest::Approx(9.5 - 0.4 * pixels).epsilon(0.06));
        CHECK(render_at(0, 0, 0.25).count < middle.count / 2);
    });
}

TEST_CASE("cameras that cannot be are refused, and the image stays") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        const auto with = [&](auto change, const char* text) {
            nicol_camera camera = stage.camera;
            change(camera);
            FAILS(nicol_render(stage.scene, &camera, nullptr, stage.framebuffer),
                  NICOL_ERROR_INVALID_ARGUMENT, text);
        };
        with([](nicol_camera& c) { c.projection = 2; }, "projection");
        for (const double fov : {180.0, 360.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
            with([&](nicol_camera& c) { c.fov = fov; }, "fov");
        for (const double bad : {-1.0, 1e9, static_cast<double>(NAN)})
            with([&](nicol_camera& c) { c.near_clip = bad; }, "near_clip");
        for (const double bad : {0.001, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
            with([&](nicol_camera& c) { c.far_clip = bad; }, "far_clip");
        with(
            [](nicol_camera& c) {
                for (std::size_t row = 0; row < 3; ++row) c.to_world[4 * row] *= -1;
            },
            "to_world");                                                  // mirrored
        with([](nicol_camera& c) { c.to_world[1] += 0.5; }, "to_world");  // sheared
        for (std::size_t i = 0; i < 16; ++i) {
            with([&](nicol_camera& c) { c.to_world[i] = NAN; }, "to_world");
            with([&](nicol_camera& c) { c.to_world[i] = INFINITY; }, "to_world");
        }
        with([](nicol_camera& c) { c.to_world[15] = 2; }, "to_world");
        with(
            [](nicol_camera& c) {
                for (std::size_t row = 0; row < 3; ++row) c.to_world[4 * row] = 0;
            },
            "to_world");
        CHECK(read_all(stage.framebuffer) == before);
        stage.render();
        CHECK(read_all(stage.framebuffer) == before);
    });
}

TEST_CASE("orders out of range are refused by name, and -1 asks for order 0") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        const auto render = [&](std::int32_t low, std::int32_t high) {
            nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
            options.order_low = low;
            options.order_high = high;
            return nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer);
        };
        for (const std::int32_t bad : {-2, INT32_MIN, 33, INT32_MAX})
            FAILS(render(bad, 0), NICOL_ERROR_INVALID_ARGUMENT, "order_low");
        for (const std::int32_t bad : {-2, INT32_MIN, -1, 3, 65, INT32_MAX})
            FAILS(render(4, bad), NICOL_ERROR_INVALID_ARGUMENT, "order_high");
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.method = 77;
        FAILS(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer), NICOL_ERROR_UNSUPPORTED,
              "method");
        CHECK(read_all(stage.framebuffer) == before);

        // The sky of this scene has no order above 2.
        nicol_statistics statistics = NICOL_STATISTICS_INIT;
        for (const auto& [low, high, order] : std::vector<std::array<std::int32_t, 3>>{
                 {0, 0, 4}, {-1, 0, 2}, {-1, -1, 0}, {1, 1, 1}, {1, 0, 2}, {12, 0, 12}, {2, 9, 2}}) {
            OK(render(low, high));
            OK(nicol_framebuffer_get_statistics(stage.framebuffer, &statistics));
            CHECK(statistics.order == static_cast<std::uint32_t>(order));
        }
        OK(render(0, 0));
        CHECK(read_all(stage.framebuffer) == before);
    });
}

TEST_CASE("options of shadows, high orders and ringing out of range are refused by name") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        const auto with = [&](auto change, const char* text) {
            nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
            change(options);
            FAILS(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer),
                  NICOL_ERROR_INVALID_ARGUMENT, text);
        };
        for (const std::uint32_t bad : {3U, 77U, UINT32_MAX})
            with([&](auto& o) { o.high_orders = bad; }, "high_orders");
        for (const std::uint32_t bad : {3U, UINT32_MAX})
            with([&](auto& o) { o.high_orders_at = bad; }, "high_orders_at");
        for (const std::int32_t bad : {-2, 2, INT32_MIN, INT32_MAX}) {
            with([&](auto& o) { o.shadows = bad; }, "shadows");
            with(
                [&](auto& o) {
                    o.method = NICOL_METHOD_REFERENCE;
                    o.shadows = bad;
                },
                "shadows");
        }
        for (const std::uint32_t bad : {1U, 255U, 65537U, 0x80000000U, UINT32_MAX})
            with([&](auto& o) { o.bake_directions = bad; }, "bake_directions");
        for (const std::uint32_t bad : {2U, UINT32_MAX}) with([&](auto& o) { o.physical = bad; }, "physical");
        for (const double bad : {-1e-9, static_cast<double>(NAN), static_cast<double>(INFINITY)})
            with([&](auto& o) { o.dering = bad; }, "dering");
        with([](auto& o) { o.reserved = 1; }, "reserved");
        CHECK(read_all(stage.framebuffer) == before);
        // Every default by name.
        nicol_render_options named = NICOL_RENDER_OPTIONS_INIT;
        named.order_low = 4;
        named.order_high = 9;
        named.shadows = 1;
        named.bake_directions = 2048;
        named.high_orders = NICOL_HIGH_ORDERS_SPLIT;
        OK(nicol_render(stage.scene, &stage.camera, &named, stage.framebuffer));
        CHECK(read_all(stage.framebuffer) == before);
    });
}

TEST_CASE("a framebuffer must have the scene's channels, or one of three") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        for (const std::uint32_t channels : {2U, 4U, 16U}) {
            const Owned other(framebuffer_of(context, 4, 4, channels));
            FAILS(nicol_render(stage.scene, &stage.camera, nullptr, other), NICOL_ERROR_INVALID_ARGUMENT,
                  "channels");
        }
    });
}

TEST_CASE("a cancelled render leaves the image, whichever verb was at work") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const auto stop_at = [&](const char* verb, nicol_scene scene, const nicol_camera& camera,
                                 Stop* given = nullptr) {
            nicol_statistics before = NICOL_STATISTICS_INIT, after = NICOL_STATISTICS_INIT;
            const std::vector<float> image = read_all(stage.framebuffer);
            OK(nicol_framebuffer_get_statistics(stage.framebuffer, &before));
            Stop fresh;
            Stop& stop = given != nullptr ? *given : fresh;
            FAILS(nicol_render(scene, &camera, &stop.options, stage.framebuffer), NICOL_ERROR_CANCELLED,
                  "progress");
            INFO(std::string(verb));
            REQUIRE(stop.verbs.size() == 1);
            CHECK(stop.verbs.front() == verb);
            CHECK(read_all(stage.framebuffer) == image);
            OK(nicol_framebuffer_get_statistics(stage.framebuffer, &after));
            after.observe_ms = before.observe_ms;  // the reading in between
            CHECK(std::memcmp(&before, &after, sizeof before) == 0);
        };
        // The first render of all: the framebuffer is still fresh.
        stop_at("bake", stage.scene, stage.camera);
        stop_at("bake", stage.scene, stage.camera);
        Stop off;
        off.options.shadows = -1;
        stop_at("project", stage.scene, stage.camera, &off);
        stage.render();
        const std::vector<float> still = read_all(stage.framebuffer);
        OK(nicol_scene_set_transform(stage.scene, 0, placed(0.3, 0, 0, 0.4).rows));
        stop_at("bake", stage.scene, stage.camera);
        off.verbs.clear();
        stop_at("relight", stage.scene, stage.camera, &off);
        off.verbs.clear();
        stop_at("relight", stage.scene, stage.camera, &off);
        stage.render();
        const std::vector<float> moved = read_all(stage.framebuffer);
        CHECK(moved != still);
        stop_at("shade", stage.scene, front_camera(5));
        nicol_scene empty = nullptr;
        OK(nicol_scene_create(context, &empty));
        OK(nicol_scene_set_environment(empty, stage.environment, nullptr, 0));
        off.verbs.clear();
        stop_at("draw", empty, stage.camera, &off);
        OK(nicol_scene_release(empty));

        // What was begun does not spoil what is rendered later.
        const Stage twin(context);
        OK(nicol_scene_set_transform(twin.scene, 0, placed(0.3, 0, 0, 0.4).rows));
        twin.render();
        CHECK(read_all(twin.framebuffer) == moved);
        stage.render();
        CHECK(read_all(stage.framebuffer) == moved);
    });
}

TEST_CASE("progress that answers 1 goes on") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        int calls = 0;
        options.progress = [](void* user, const char*, double) -> std::int32_t {
            ++*static_cast<int*>(user);
            return 1;
        };
        options.progress_user = &calls;
        OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
        CHECK(calls >= 1);
        const std::vector<float> watched = read_all(stage.framebuffer);
        stage.render();
        CHECK(read_all(stage.framebuffer) == watched);
    });
}

TEST_CASE("a callback that calls back gets an error and no deadlock") {
    on_every_backend([](nicol_context context) {
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
            nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
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
                    nicol_scene_set_environment(own.scene, nullptr, nullptr, 0),
                    nicol_scene_get_channels(own.scene, &channels),
                    nicol_framebuffer_get_statistics(own.framebuffer, &statistics),
                    nicol_framebuffer_read(own.framebuffer, NICOL_PLANE_S0, 0, pixels, 0, sizeof pixels),
                    nicol_framebuffer_write_exr(own.framebuffer, "/nowhere/x.exr"),
                    nicol_framebuffer_write_png(own.framebuffer, &image, "/nowhere/x.png")};
                self.allowed = {
                    nicol_render(self.other.scene, &self.other.camera, nullptr, self.other.framebuffer),
                    nicol_framebuffer_read(self.other.framebuffer, NICOL_PLANE_S0, 0, pixels, 0,
                                           sizeof pixels),
                    nicol_mesh_retain(own.mesh), nicol_mesh_release(own.mesh)};
                return 1;
            };
            OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
            CHECK(caller.same_thread);
            CHECK(caller.refused.size() == 9);
            for (const nicol_result result : caller.refused) CHECK(result == NICOL_ERROR_INVALID_ARGUMENT);
            CHECK(caller.allowed.size() == 4);
            for (const nicol_result result : caller.allowed) CHECK(result == NICOL_OK);
            // None of the refused calls had an effect.
            const std::vector<float> watched = read_all(stage.framebuffer);
            stage.render();
            CHECK(read_all(stage.framebuffer) == watched);
        }
    });
}

TEST_CASE("objects released inside a callback live until the call is over") {
    on_every_backend([](nicol_context context) {
        auto* stage = new Stage(context);
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.progress_user = stage;
        options.progress = [](void* user, const char*, double) -> std::int32_t {
            delete static_cast<Stage*>(user);
            return 0;
        };
        const nicol_scene scene = stage->scene;
        const nicol_camera camera = stage->camera;
        FAILS(nicol_render(scene, &camera, &options, stage->framebuffer), NICOL_ERROR_CANCELLED, "progress");
        FAILS(nicol_scene_retain(scene), NICOL_ERROR_INVALID_HANDLE, "released");
    });
}

TEST_CASE("statistics tell what a render did") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        nicol_statistics first = NICOL_STATISTICS_INIT, second = NICOL_STATISTICS_INIT;
        stage.render();
        OK(nicol_framebuffer_get_statistics(stage.framebuffer, &first));
        std::uint32_t vertices = 0, triangles = 0;
        OK(nicol_mesh_get_size(stage.mesh, &vertices, &triangles));
        CHECK(first.struct_size == sizeof first);
        CHECK(first.order == 4);
        CHECK(first.vertices == vertices);
        CHECK(first.triangles == triangles);
        CHECK(first.project_ms > 0);
        CHECK(first.relight_ms > 0);
        CHECK(first.vertices_skipped > 0);
        CHECK(first.light_columns_skipped == 1);  // no s3 in a sky
        CHECK(first.channels_shared == 2);        // a grey one
        CHECK(first.response_bytes > 0);
        CHECK(first.texture_bytes >= std::uint64_t{24} * 16 * 16 * 3);
        stage.render();
        OK(nicol_framebuffer_get_statistics(stage.framebuffer, &second));
        CHECK(second.relight_ms == 0);
        CHECK(second.transfer_bytes == first.transfer_bytes);
        CHECK(second.buffer_bytes == first.buffer_bytes);
        CHECK(second.texture_bytes == first.texture_bytes);
    });
}
