// SPDX-License-Identifier: MIT
// Tests of instances that cast or receive no shadows or are invisible: against scenes without them.
#include <string_view>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::Studio;

namespace {

constexpr std::uint32_t kFloor = 0, kBall = 1;
const InstanceRoles kCastsNone{.casts_shadows = false};
const InstanceRoles kReceivesNone{.receives_shadows = false};
const InstanceRoles kInvisible{.visible = false};
const InstanceRoles kAbsent{.casts_shadows = false, .visible = false};

/// A ball above a floor and under a roof, which the camera does not see. pane: whether glass covers the roof.
Scene room(bool lamp, bool pane = false) {
    Scene scene;
    scene.add({.mesh = test::rectangle(24), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    scene.add({.mesh = test::coarse_sphere(6), .material = diffuse({0.8})});
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(4)),
               .material = diffuse({0.3}),
               .to_world = test::at(0, 2.5, -1, 0.7)});
    if (pane)
        scene.add({.mesh = test::rectangle(1),
                   .material = thin_dielectric({.int_ior = 1.5, .ext_ior = 1}),
                   .to_world = test::plate_at(3.6, 3)});
    if (lamp) {
        for (const glm::dvec3& place : {glm::dvec3(0.5, 4, 1), glm::dvec3(0, 4.5, -1.8)})
            scene.add_light({.value = {20}, .to_world = look_at(place, {0, 0, 0}, {0, 1, 0.1})});
    } else {
        scene.set_environment(test::falling_light(4, true), glm::dmat3(1), 1);
    }
    return scene;
}

/// Returns whether all pixels around one show the instance, or none of them does. The reference method's
/// pixels show what is around their middles as well.
bool all_show(const Aovs& shown, int x, int y, std::uint32_t instance, bool others) {
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, shown.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, shown.width - 1); ++column) {
            const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(shown.width) +
                               static_cast<std::size_t>(column);
            if ((shown.instances[pixel] == instance) == others) return false;
        }
    return true;
}

/// Returns the share of the pixels of an instance (or of all others) in which images differ by more than
/// `most` times their RMS. At the edges of a lamp's shadows, few rays decide for many pixels.
double differing(const StokesImage& a, const StokesImage& b, double most, const Aovs& shown,
                 std::uint32_t instance, bool others = false) {
    int count = 0, all = 0;
    const StokesImage between = test::minus(a, b);
    const double limit = most * test::rms(a);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (!all_show(shown, x, y, instance, others)) continue;
            bool differs = false;
            for (int c = 0; c < a.channels; ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    differs = differs || std::abs(static_cast<double>(between.at(c, y, x)[p])) > limit;
            count += differs ? 1 : 0;
            ++all;
        }
    REQUIRE(all > 50);
    return static_cast<double>(count) / all;
}

}  // namespace

IMAGE_TEST_CASE("instances have the roles that they are given, by every method") {
    struct Case {
        const char* name;
        Method method;
        ShadeAt shade_at;
        int max_depth;
        bool lamp;
        double budget;
        bool pane = false;
        double same = 2e-3;  ///< largest difference of equal light, over the RMS: approximations of bounces,
                             ///< and for rays the facets of the ball, which hide light from each other
    };
    constexpr int direct = kDirectLightDepth;
    for (const Case& c :
         {Case{"vertices", Method::factored, ShadeAt::vertices, direct, false, 0},
          Case{"pixels", Method::factored, ShadeAt::pixels, direct, false, 0},
          Case{"a lamp", Method::factored, ShadeAt::pixels, direct, true, 0},
          Case{"a pane", Method::factored, ShadeAt::pixels, direct, true, 0, true},
          Case{"bounces", Method::factored, ShadeAt::pixels, 4, false, 0, false, 0.05},
          Case{"a budget", Method::factored, ShadeAt::pixels, direct, false, 1e6},
          Case{"dense", Method::dense, ShadeAt::vertices, direct, false, 0},
          Case{"rays", Method::reference, ShadeAt::automatic, direct, false, 0, false, 0.07},
          Case{"rays, a lamp", Method::reference, ShadeAt::automatic, direct, true, 0, false, 0.07},
          Case{"rays, bounces", Method::reference, ShadeAt::automatic, 4, false, 0, false, 0.07}}) {
        CAPTURE(std::string(c.name));
        RenderOptions options{.method = c.method, .executor = Executor::cpu, .bake_directions = 512};
        options.refine_tolerance = 0;
        options.bake_budget_ms = c.budget;
        options.order_high = 4;
        options.shade_at = c.shade_at;
        options.samples = 16;
        options.max_depth = c.max_depth;
        options.aovs = aov_instances;
        Aovs shown;
        const auto picture = [&](const Scene& scene) {
            Framebuffer target(context, 48, 36, scene.channels());
            Renderer(context).render(scene, test::some_camera(), options, target);
            shown = target.aovs();
            return target.image();
        };
        const auto with_ball = [&](const InstanceRoles& roles) {
            Scene scene = room(c.lamp, c.pane);
            scene.set_roles(kBall, roles);
            return scene;
        };
        Scene without = room(c.lamp, c.pane), alone = room(c.lamp);
        without.remove(kBall);
        alone.remove(kFloor);
        alone.remove(2);
        const StokesImage no_ball = picture(without), of_alone = picture(alone);
        const StokesImage casting_none = picture(with_ball(kCastsNone));
        const StokesImage receiving_none = picture(with_ball(kReceivesNone));
        const StokesImage invisible = picture(with_ball(kInvisible));
        CHECK(std::ranges::count(shown.instances, kBall) == 0);
        const StokesImage absent = picture(with_ball(kAbsent));
        const StokesImage full = picture(with_ball({}));
        REQUIRE(std::ranges::count(shown.instances, kBall) > 100);

        const auto differs = [&](const StokesImage& x, const StokesImage& y, bool others) {
            return differing(x, y, c.same, shown, kBall, others);
        };
        constexpr double few = 0.02;
        // The picture has shadows by and on the ball, or nothing would be tested.
        CHECK(differs(full, no_ball, true) > few);
        CHECK(differs(full, of_alone, false) > 0.1);
        CHECK(differs(casting_none, no_ball, true) < few);
        CHECK(differs(receiving_none, of_alone, false) < few);
        CHECK(differs(invisible, full, true) < few);
        CHECK(differs(invisible, full, false) > 0.1);
        CHECK(differs(absent, no_ball, true) < few);
        CHECK(differs(absent, no_ball, false) < few);
        // The light on the ball also lights others.
        if (c.max_depth > direct) continue;
        CHECK(differs(receiving_none, full, true) < few);
        CHECK(differs(casting_none, full, false) < few);
    }
}

IMAGE_TEST_CASE("a change of roles is taken over as by a fresh start") {
    for (const double budget : {0.0, 1e6}) {
        CAPTURE(budget);
        RenderOptions options{.executor = Executor::cpu, .bake_directions = 512};
        options.bake_budget_ms = budget;
        options.order_high = 4;
        options.shade_at = ShadeAt::pixels;
        options.disabled_optimisations = skip_rays;
        Studio kept(context);
        Scene scene = room(false);
        for (const InstanceRoles& roles : {InstanceRoles{}, kCastsNone, kReceivesNone, kInvisible, kAbsent}) {
            scene.set_roles(kBall, roles);
            Studio fresh(context);
            const StokesImage expected = fresh(scene, options);
            CHECK(test::rms_difference(kept(scene, options), expected) < 1e-5 * test::rms(expected));
        }
    }
}
