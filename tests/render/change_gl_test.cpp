// SPDX-License-Identifier: MIT
// Tests of scene changes: only the affected steps run again, and the image equals that of a fresh start.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::coarse_sphere;
using test::falling_light;

namespace {

RenderOptions by(Method method) {
    return {.method = method,
            .executor = Executor::cpu,
            .bake_directions = 256,
            .refine_tolerance = 0,
            .order_low = 2,
            .order_high = 5};
}

const Camera some_camera = test::camera_at({3, 4, 6}, {0, 0.3, 0});

/// Returns a rotation and translation.
glm::dmat4 motion() {
    return glm::rotate(glm::translate(glm::dmat4(1), {0.4, -0.3, 0.2}), 0.7, glm::dvec3(1, 2, -0.5));
}

const std::array<MaterialPtr, 3>& materials() {
    static const std::array<MaterialPtr, 3> some{
        pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3}), diffuse({0.5}),
        twosided(test::some_metal(0.4))};
    return some;
}

/// Returns a large ball (id 0) above a plate (id 1), and a small ball (id 2) beside it.
Scene balls_on_plate() {
    Scene scene;
    scene.set_environment(falling_light(5, true, 3), glm::dmat3(1), 1);
    scene.add({.mesh = coarse_sphere(8), .material = materials()[0]});
    scene.add({.mesh = test::rectangle(9), .material = materials()[1], .to_world = test::plate_at(-1, 3)});
    scene.add({.mesh = coarse_sphere(4), .material = materials()[1], .to_world = at(1.8, -0.5, 0.8, 0.5)});
    return scene;
}

/// Returns a cache folder that all renderers share for tables, but not for visibility.
const std::filesystem::path& tables() {
    static const TemporaryFolder folder;
    return folder.path();
}

struct Studio {
    Studio(const std::shared_ptr<gl::Context>& context_, Method method)
        : context(context_),
          options(by(method)),
          renderer(context),
          target(context, 40, 30, 3),
          folder(tables()) {
        // By default a first image refines what it shows alone.
        options.disabled_optimisations = skip_rays;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            if (file.path().extension() == ".visibility") std::filesystem::remove(file.path());
        }
        renderer.set_cache(folder, {});
    }

    const Statistics& operator()(const Scene& scene, const Camera& camera = some_camera) {
        renderer.render(scene, camera, options, target);
        return target.statistics();
    }

    /// Returns the image of a renderer that has rendered nothing else.
    StokesImage fresh(const Scene& scene, const Camera& camera = some_camera) const {
        Studio other(context, options.method);
        other.options = options;
        other(scene, camera);
        return other.target.image();
    }

    /// Renders, and checks that the image equals that of a fresh start.
    Statistics as_fresh(const Scene& scene, const Camera& camera = some_camera) {
        (*this)(scene, camera);
        CHECK(target.image().data == fresh(scene, camera).data);
        return target.statistics();
    }

    std::shared_ptr<gl::Context> context;
    RenderOptions options;
    Renderer renderer;
    Framebuffer target;
    std::filesystem::path folder;
};

/// Returns the root mean square difference relative to the largest value, because a pixel at an edge may fall
/// to either side.
double difference(const StokesImage& a, const StokesImage& b) {
    return test::rms_difference(a, b) / largest(b);
}

constexpr std::array methods{Method::factored, Method::dense};

void check_nothing_projected(const Statistics& s) {
    CHECK(s.lights_projected + s.materials_projected == 0);
}

void check_nothing_projected_or_baked(const Statistics& s) {
    check_nothing_projected(s);
    CHECK(s.bake_rays + s.vertices_traced + s.matrices_baked == 0);
}

/// Checks that all vertices were relit by the dense method, and by the factored method those that the image
/// shows, in blocks of sixteen.
void check_relit(const Statistics& s, Method method) {
    CHECK(s.vertices_relit <= s.vertices);
    if (method == Method::dense)
        CHECK(s.vertices_relit == s.vertices);
    else
        CHECK(s.vertices_relit >= s.vertices - s.vertices_skipped);
}

}  // namespace

TEST_CASE("what has not changed is not computed") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    for (const Method method : methods) {
        Scene scene = balls_on_plate();
        scene.add_light({.value = std::vector<double>(3, 1.0)});
        Studio studio(context, method);
        const Statistics first = studio(scene);
        CHECK(first.light_rays > 0);
        CHECK(first.lights_projected == 1);
        CHECK(first.materials_projected == 4);  // tables or matrices, and lobes, of two materials
        CHECK(first.vertices_traced == first.vertices);
        CHECK(first.matrices_baked == (method == Method::dense ? first.vertices : 0));
        check_relit(first, method);
        CHECK(first.vertices_shaded == first.vertices - first.vertices_skipped);

        const std::uint64_t content = studio.target.content();
        scene.set_environment(scene.environment(), glm::dmat3(1), 1);
        scene.set_transform(0, glm::dmat4(1));
        scene.set_material(0, materials()[0]);
        studio.options.samples += 1;  // of the reference method
        const Statistics still = studio(scene);
        CHECK(studio.target.content() == content);
        CHECK(static_cast<const RenderWork&>(still) == RenderWork{});

        Camera camera = test::camera_at({-3, 4, 5});
        const Statistics moved = studio.as_fresh(scene, camera);
        check_nothing_projected_or_baked(moved);
        // Only vertices that the first image did not show.
        CHECK(moved.vertices_relit <= moved.vertices - first.vertices_relit);
        if (method == Method::dense) CHECK(moved.relight_ms == 0);
        CHECK(moved.vertices_shaded == moved.vertices - moved.vertices_skipped);

        // Another lens needs no new shading.
        camera.fov *= 0.7;
        const Statistics nearer = studio.as_fresh(scene, camera);
        CHECK(nearer.vertices_shaded == 0);
        CHECK(nearer.draw_ms > 0);

        scene.set_environment(scene.environment(), glm::dmat3(motion()), 1);
        const Statistics lit = studio.as_fresh(scene, camera);
        check_nothing_projected_or_baked(lit);
        check_relit(lit, method);

        scene.set_environment(falling_light(3, false, 3), glm::dmat3(1), 2);
        const Statistics other = studio.as_fresh(scene, camera);
        CHECK(other.lights_projected == 1);
        CHECK(other.vertices_traced == 0);
    }
}

IMAGE_TEST_CASE("a scene that is rotated and shifted as a whole is relit alone") {
    for (const Method method : methods) {
        for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
            Scene scene = balls_on_plate();
            Studio studio(context, method);
            studio.options.shade_at = where;
            studio.options.aovs = aov_depth | aov_normals | aov_positions;
            studio(scene);
            for (const std::uint32_t id : scene.ids()) {
                scene.set_transform(id, motion() * scene.at(id).to_world);
            }
            const Statistics rotated = studio(scene);
            CAPTURES(method, where);
            check_nothing_projected_or_baked(rotated);
            CHECK(rotated.vertices_relit > rotated.vertices / 3);
            CHECK(difference(studio.target.image(), studio.fresh(scene)) < 2e-5);

            Studio other(context, method);
            other.options = studio.options;
            other(scene);
            const Aovs& here = studio.target.aovs();
            const Aovs& there = other.target.aovs();
            std::size_t differing = 0;
            for (std::size_t i = 0; i < here.normals.size(); ++i)
                differing += !(std::abs(here.normals[i] - there.normals[i]) < 1e-4F &&
                               std::abs(here.positions[i] - there.positions[i]) < 1e-4F);
            for (std::size_t i = 0; i < here.depth.size(); ++i)
                differing += here.depth[i] > there.depth[i] + 1e-4F;
            CHECK(differing < here.depth.size() / 200);
        }
    }
}

IMAGE_TEST_CASE("a moved instance is traced anew, and others where it can be in their light") {
    for (const Method method : methods) {
        Scene scene = balls_on_plate();
        Studio studio(context, method);
        const Statistics first = studio(scene);
        scene.set_transform(2, at(1.6, 0.6, -0.9, 0.5) * glm::rotate(glm::dmat4(1), 0.3, {1, 1, 0}));
        const Statistics moved = studio.as_fresh(scene);
        check_nothing_projected(moved);
        CHECK(moved.vertices_traced > scene.at(2).mesh->positions.size());
        CHECK(moved.bake_rays < (first.bake_rays + first.bake_rays_skipped) / 2);
        CHECK(moved.vertices_relit < moved.vertices);
        CHECK(moved.vertices_shaded < moved.vertices - moved.vertices_skipped);

        // The ball moves away from all others, which keep their visibility except where the ball was.
        scene.set_transform(2, at(0, -40, 0, 0.5));
        studio.as_fresh(scene);
        scene.set_transform(2, at(0, -60, 0, 0.5));
        const Statistics far = studio.as_fresh(scene);
        CHECK(far.vertices_relit < 2 * scene.at(2).mesh->positions.size());
    }
}

TEST_CASE("without shadows a shifted instance keeps its light and a rotated one is relit alone") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    for (const Method method : methods) {
        Scene scene = balls_on_plate();
        Studio studio(context, method);
        studio.options.shadows = false;
        studio(scene);
        scene.set_transform(2, at(1.6, 0.6, -0.9, 0.5));
        const Statistics shifted = studio.as_fresh(scene);
        check_nothing_projected_or_baked(shifted);
        const std::size_t count = scene.at(2).mesh->positions.size();
        // Only vertices that the first image did not show.
        CHECK(shifted.vertices_relit < (method == Method::dense ? 1 : count));
        CHECK(shifted.vertices_shaded > 0);
        CHECK(shifted.vertices_shaded <= count);

        scene.set_transform(2, at(1.6, 0.6, -0.9, 0.5) * glm::rotate(glm::dmat4(1), 0.4, {1, 0.3, 0.2}));
        const Statistics rotated = studio.as_fresh(scene);
        CHECK(rotated.bake_rays == 0);
        CHECK(rotated.vertices_relit >= (method == Method::dense ? count : count / 3));
        CHECK(rotated.vertices_relit < count + 32);  // blocks of sixteen vertices
        CHECK(rotated.matrices_baked == (method == Method::dense ? count : 0));
    }
}

IMAGE_TEST_CASE("a material that is swapped is projected alone and its instance shaded alone") {
    for (const Method method : methods) {
        Scene scene = balls_on_plate();
        Studio studio(context, method);
        studio(scene);
        const std::size_t count = scene.at(2).mesh->positions.size();
        const MaterialPtr grey = diffuse({0.2});
        scene.set_material(2, grey);
        const Statistics swapped = studio.as_fresh(scene);
        CHECK(swapped.lights_projected == 0);
        CHECK(swapped.materials_projected == 2);  // a table or matrices, and lobes
        CHECK(swapped.vertices_traced == 0);
        CHECK(swapped.matrices_baked == (method == Method::dense ? count : 0));
        CHECK(swapped.vertices_relit == (method == Method::dense ? count : 0));
        CHECK(swapped.vertices_shaded > 0);
        CHECK(swapped.vertices_shaded <= count);

        // A second side changes the geometry.
        scene.set_material(2, materials()[2]);
        CHECK(studio.as_fresh(scene).vertices_traced > 0);
        scene.set_material(2, grey);
        studio.as_fresh(scene);
    }
}

TEST_CASE("instances come and go, and a cancelled render leaves nothing half done") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    for (const Method method : methods) {
        Scene scene = balls_on_plate();
        Studio studio(context, method);
        const Statistics first = studio(scene);
        const auto added = scene.add(
            {.mesh = coarse_sphere(3), .material = materials()[2], .to_world = at(-1.5, -0.3, 1.2, 0.4)});
        CHECK(studio.as_fresh(scene).bake_rays < first.bake_rays + first.bake_rays_skipped);
        scene.remove(1);
        studio.as_fresh(scene);

        // Progress is reported at most ten times a second, so the first report must count.
        studio.options.progress = [](const char*, double) { return false; };
        for (int step = 0; step < 4; ++step) {
            scene.set_transform(added, at(-1.5, 0.1 * step, 1.2, 0.4));
            if (step > 1) scene.set_environment(scene.environment(), glm::dmat3(motion()), step);
            CHECK_THROWS_AS(studio(scene), Error);
        }
        studio.options.progress = nullptr;
        studio.as_fresh(scene);

        // Only the light has changed, and nothing may be reused from the cancelled state.
        studio.options.progress = [](const char*, double) { return false; };
        scene.set_environment(scene.environment(), glm::dmat3(1), 2);
        CHECK_THROWS_AS(studio(scene), Error);
        studio.options.progress = nullptr;
        studio.as_fresh(scene);

        scene.remove(0);
        scene.remove(2);
        scene.remove(added);
        studio.as_fresh(scene);
    }
}

TEST_CASE("options that change and change back leave no trace") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    const Scene scene = balls_on_plate();
    Studio studio(context, Method::factored);
    const RenderOptions usual = studio.options;
    std::array<RenderOptions, 8> others;
    others.fill(usual);
    others[0].physical = true;
    others[1].method = Method::dense;
    others[2].executor = Executor::compute;
    others[3].high_orders = HighOrders::convolution;
    others[4].components = 1;
    others[5].shadows = false;
    others[6].shade_at = ShadeAt::pixels;
    others[7].shade_at = ShadeAt::pixels;
    others[7].high_orders = HighOrders::convolution;
    for (const RenderOptions& other : others) {
        for (const RenderOptions& options : {usual, other, usual}) {
            studio.options = options;
            studio.as_fresh(scene);
        }
    }
}

TEST_CASE("a change of the high orders alone relights no vertex") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    const Scene scene = balls_on_plate();
    Studio studio(context, Method::factored);
    studio(scene);
    const StokesImage before = studio.target.image();
    studio.options.order_high = 3;
    const Statistics fewer = studio(scene);
    CHECK(fewer.lights_projected == 1);
    CHECK(fewer.vertices_relit == 0);
    CHECK(difference(studio.target.image(), before) > 1e-4);
    CHECK(difference(studio.target.image(), studio.fresh(scene)) < 1e-6);
}

TEST_CASE("any series of changes ends where a fresh start does") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    for (const Method method : methods) {
        std::mt19937 random(method == Method::dense ? 3 : 5);
        std::uniform_real_distribution<double> value(-1, 1);
        const auto pick = [&random](std::size_t count) { return random() % count; };
        Scene scene = balls_on_plate();
        Studio studio(context, method);
        const auto some_place = [&] {
            const glm::dvec3 place{2 * value(random), value(random), 2 * value(random)};
            const glm::dvec3 axis{value(random), 1, value(random)};
            return glm::rotate(at(place.x, place.y, place.z, 0.4), value(random), axis);
        };
        for (int step = 0; step < 24; ++step) {
            const std::size_t edits = 1 + pick(2);
            for (std::size_t edit = 0; edit < edits; ++edit) {
                const std::uint32_t id = scene.ids()[pick(scene.ids().size())];
                switch (pick(7)) {
                    case 0:
                        scene.set_transform(id, some_place());
                        break;
                    case 1:
                        for (const std::uint32_t each : scene.ids())
                            scene.set_transform(each, motion() * scene.at(each).to_world);
                        break;
                    case 2:
                        scene.set_material(id, materials()[pick(3)]);
                        break;
                    case 3:
                        scene.add({.mesh = coarse_sphere(3),
                                   .material = materials()[pick(3)],
                                   .to_world = some_place()});
                        break;
                    case 4:
                        if (scene.ids().size() > 2) scene.remove(id);
                        break;
                    case 5:
                        scene.set_environment(scene.environment(), glm::dmat3(some_place()) / 0.4, 1);
                        break;
                    default:
                        studio.options.shadows = !studio.options.shadows;
                        break;
                }
            }
            Camera camera = test::camera_at({5 * value(random), 5, 6});
            camera.fov = 60;
            if (step % 3 == 0) camera = some_camera;
            studio(scene, camera);
            CAPTURE(step);
            CHECK(difference(studio.target.image(), studio.fresh(scene, camera)) < 2e-5);
        }
    }
}

IMAGE_TEST_CASE("a seed and a number of light samples change only pictures that take samples") {
    Studio studio(context, Method::factored);
    Scene scene = balls_on_plate();
    const auto runs = [&](std::uint64_t seed, int light_samples) {
        studio.options.seed = seed;
        studio.options.light_samples = light_samples;
        return studio(scene).draw_ms > 0;
    };
    CHECK(runs(0, 16));
    CHECK_FALSE(runs(1, 16));
    CHECK_FALSE(runs(1, 8));
    scene.add_light({.value = std::vector<double>(3, 1.0), .to_world = at(1, 3, 2)});
    CHECK(runs(1, 8));
    CHECK_FALSE(runs(1, 8));
    CHECK(runs(2, 8));
    CHECK(runs(2, 16));
    CHECK_FALSE(runs(2, 16));
}
