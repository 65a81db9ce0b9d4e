// SPDX-License-Identifier: MIT
// Tests of several views of a scene in one call.
#include <cmath>
#include <deque>
#include <utility>

#include "capi.hpp"

using namespace capi_test;

namespace {

/// Bodies on a floor, and cameras around them with framebuffers of different sizes.
struct Ring {
    explicit Ring(nicol_context owner, nicol_mesh (*shape)(nicol_context) = cube)
        : context(owner), scene(empty_scene(context)) {
        const Owned light(clear_sky(context, {1, 1, 0}));
        OK(nicol_scene_set_environment(scene, light, nullptr, 1));
        const Owned grey(diffuse(context, {0.5F, 0.4F, 0.3F}));
        const Owned floor(rectangle(context)), body(shape(context));
        add(scene, floor, grey, {{3, 0, 0, 0, 0, 0, 3, -0.5, 0, -3, 0, 0, 0, 0, 0, 1}});
        for (const double x : {-0.6, 0.6}) add(scene, body, grey, placed(x, 0, 0, 0.4));
        for (std::uint32_t i = 0; i < 3; ++i) {
            cameras.push_back(camera_at({3.0 * i - 3, 1, 3.0 - i}));
            framebuffers.emplace_back(framebuffer_of(context, 24 + 8 * i, 16, i == 1 ? 1 : 3));
        }
    }

    [[nodiscard]] nicol_result render(const nicol_render_options& options) const {
        return nicol_render_views(scene, cameras.data(), targets().data(), 3, &options);
    }
    [[nodiscard]] std::vector<nicol_framebuffer> targets() const {
        return {framebuffers.begin(), framebuffers.end()};
    }
    [[nodiscard]] std::vector<float> images() const {
        std::vector<float> all;
        for (const auto& framebuffer : framebuffers) {
            const std::vector<float> image = read_all(framebuffer);
            all.insert(all.end(), image.begin(), image.end());
        }
        return all;
    }

    nicol_context context;
    Owned<nicol_scene> scene;
    std::vector<nicol_camera> cameras;
    std::deque<Owned<nicol_framebuffer>> framebuffers;
};

nicol_render_options with_shadows() {
    nicol_render_options options = plain_options();
    options.shadows = 1;
    return options;
}

}  // namespace

CONTEXT_TEST_CASE("views in one call are those of single renders, and bake once") {
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE, NICOL_METHOD_REFERENCE}) {
        CAPTURE(method);
        nicol_render_options options = with_shadows();
        options.method = method;
        options.samples = 4;
        const Ring together(context), apart(context);
        // Otherwise what is traced depends on what is seen.
        options.disabled_optimisations = NICOL_OPTIMISATION_RAYS;
        OK(together.render(options));
        for (std::size_t i = 0; i < 3; ++i)
            OK(nicol_render(apart.scene, &apart.cameras[i], &options, apart.framebuffers[i]));
        CHECK(together.images() == apart.images());
    }
}

CONTEXT_TEST_CASE("the first view bakes what all need") {
    const Ring together(context, sphere), apart(context, sphere);
    const nicol_render_options options = with_shadows();
    OK(together.render(options));
    std::uint64_t rays_apart = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        OK(nicol_render(apart.scene, &apart.cameras[i], &options, apart.framebuffers[i]));
        rays_apart += statistics_of(apart.framebuffers[i]).bake_rays;
        CHECK((statistics_of(together.framebuffers[i]).bake_rays > 0) == (i == 0));
    }
    CHECK(statistics_of(together.framebuffers[0]).bake_rays < rays_apart);
    CHECK(statistics_of(together.framebuffers[0]).vertices_unbaked > 0);
    const std::vector<float> images = together.images(), expected = apart.images();
    double difference = 0, power = 0;
    for (std::size_t i = 0; i < images.size(); ++i) {
        difference += std::pow(double{images[i]} - double{expected[i]}, 2);
        power += std::pow(double{expected[i]}, 2);
    }
    CHECK(std::sqrt(difference / power) < 0.01);
}

CONTEXT_TEST_CASE("a bake budget is one for all views") {
    const Ring ring(context);
    nicol_render_options options = with_shadows();
    OK(ring.render(options));
    options.bake_budget_ms = 1e-3;
    OK(nicol_scene_set_transform(ring.scene, 1, placed(-0.7, 0, 0, 0.4).rows));
    OK(ring.render(options));
    const std::uint64_t pending = statistics_of(ring.framebuffers[0]).vertices_pending;
    CHECK(pending > 0);
    CHECK(statistics_of(ring.framebuffers[2]).vertices_pending == pending);
    options.bake_budget_ms = 0;
    OK(ring.render(options));
    CHECK(statistics_of(ring.framebuffers[2]).vertices_pending == 0);
}

CONTEXT_TEST_CASE("wrong views are refused before any of them is rendered") {
    Ring ring(context);
    OK(ring.render(with_shadows()));
    const std::vector<float> before = ring.images();
    std::vector<nicol_camera> cameras = ring.cameras;
    for (nicol_camera& camera : cameras) camera.fov = 20;
    const std::vector<nicol_framebuffer> targets = ring.targets();
    const auto call = [&](const nicol_camera* with, const nicol_framebuffer* into, std::uint32_t count) {
        return [=, &ring] { return nicol_render_views(ring.scene, with, into, count, nullptr); };
    };
    std::vector<nicol_camera> bent = cameras, older = cameras;
    bent[2].fov = 180;
    older[1].struct_size -= 8;
    std::vector<nicol_framebuffer> twice = targets, absent = targets;
    twice[2] = twice[0];
    absent[1] = nullptr;
    const Owned two_channels(framebuffer_of(context, 4, 4, 2));
    std::vector<nicol_framebuffer> unfit = targets;
    unfit[2] = two_channels;
    check_refused({{"count is 0; it must lie in 1 to 1024", call(cameras.data(), targets.data(), 0)},
                   {"count is 1025", call(cameras.data(), targets.data(), 1025)},
                   {"cameras is NULL", call(nullptr, targets.data(), 3)},
                   {"framebuffers is NULL", call(cameras.data(), nullptr, 3)},
                   {"fov", call(bent.data(), targets.data(), 3)},
                   {"cameras[1].struct_size", call(older.data(), targets.data(), 3)},
                   {"framebuffers[2] is framebuffers[0] again", call(cameras.data(), twice.data(), 3)},
                   {"channels", call(cameras.data(), unfit.data(), 3)}});
    FAILS(call(cameras.data(), absent.data(), 3)(), NICOL_ERROR_INVALID_HANDLE, "");
    CHECK(ring.images() == before);
}

CONTEXT_TEST_CASE("views before a cancelled one have their images") {
    const Ring ring(context, sphere);
    nicol_render_options options = with_shadows();
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = 64;  // long enough for reports of progress in each view
    struct Views {
        int begun = 0;
        double fraction = HUGE_VAL;
    } views;
    options.progress_user = &views;
    options.progress = [](void* user, const char*, double fraction) -> std::int32_t {
        auto& seen = *static_cast<Views*>(user);
        if (fraction <= std::exchange(seen.fraction, fraction)) ++seen.begun;
        return seen.begun < 2;
    };
    FAILS(ring.render(options), NICOL_ERROR_CANCELLED, "progress");
    CHECK(statistics_of(ring.framebuffers[0]).camera_rays > 0);
    CHECK(statistics_of(ring.framebuffers[1]).camera_rays == 0);
}
