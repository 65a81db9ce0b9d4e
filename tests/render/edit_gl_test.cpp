// SPDX-License-Identifier: MIT
// Tests of random edits: the image equals that of a renderer that has rendered nothing else, up to rounding.
#include "geometry/deformed_mesh.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::Studio;

namespace {

/// A floor, which stays, and things on it.
class Playground {
public:
    explicit Playground(unsigned seed) : random_(seed) {
        scene.set_environment(test::falling_light(5, true, 3), glm::dmat3(1), 1);
        scene.add({.mesh = test::rectangle(16), .material = materials_[0], .to_world = test::plate_at(0, 3)});
        for (int i = 0; i < 4; ++i) add();
    }

    void edit() {
        switch (random_() % 7) {
            case 0:
                return add();
            case 1:
                return things_.size() > 2 ? remove() : add();
            case 2:
                return scene.set_mesh(thing(), meshes_[random_() % meshes_.size()]);
            case 3:
                return deform();
            default:
                return scene.set_transform(thing(), place());
        }
    }

    void rotate_light(double angle) {
        scene.set_environment(scene.environment(),
                              glm::dmat3(glm::rotate(glm::dmat4(1), angle, glm::dvec3(1, 2, 0))), 1);
    }

    Scene scene;

private:
    void add() {
        things_.push_back(scene.add({.mesh = meshes_[random_() % meshes_.size()],
                                     .material = materials_[random_() % materials_.size()],
                                     .to_world = place()}));
    }
    void remove() {
        const auto thing = things_.begin() + static_cast<std::ptrdiff_t>(random_() % things_.size());
        scene.remove(*thing);
        things_.erase(thing);
    }
    // Bends an instance, or bends it further.
    void deform() {
        const std::uint32_t id = thing();
        const Mesh& mesh = *scene.at(id).mesh;
        std::uniform_real_distribution<float> part(-0.3F, 0.3F);
        const glm::vec3 bend(part(random_), part(random_), part(random_));
        std::vector<glm::vec3> positions = mesh.positions;
        for (glm::vec3& p : positions) p += p.y * p.y * bend;
        scene.set_mesh(id, std::make_shared<const Mesh>(deformed(mesh, std::move(positions), {})));
    }
    std::uint32_t thing() { return things_[random_() % things_.size()]; }
    glm::dmat4 place() {
        std::uniform_real_distribution<double> coordinate(-1.5, 1.5), size(0.2, 0.5), angle(0, 3);
        const double half = size(random_);
        return at(coordinate(random_), 0.9 * half, coordinate(random_), half) *
               glm::rotate(glm::dmat4(1), angle(random_), glm::dvec3(0, 1, 0));
    }

    std::mt19937 random_;
    std::vector<std::uint32_t> things_;
    std::array<std::shared_ptr<const Mesh>, 3> meshes_{
        test::coarse_sphere(5), std::make_shared<const Mesh>(make_cube(2)), test::coarse_sphere(3)};
    std::array<MaterialPtr, 3> materials_{diffuse({0.5}), pplastic({.alpha = 0.3}),
                                          twosided(test::some_metal(0.4))};
};

}  // namespace

IMAGE_TEST_CASE("random edits leave the image of a fresh start") {
    for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
        const RenderOptions options{.executor = Executor::cpu,
                                    .bake_directions = 512,
                                    .refine_tolerance = 0.02,
                                    .order_low = 3,
                                    .order_high = 5,
                                    .shade_at = where};
        // A first image by default refines what it shows alone.
        RenderOptions tracing = options;
        tracing.disabled_optimisations = skip_rays;
        Playground playground(7);
        Studio studio(context);
        studio(playground.scene, options);
        std::uint64_t rays = 0, fresh_rays = 0, relit = 0, fresh_relit = 0;
        for (int edit = 0; edit < 12; ++edit) {
            playground.edit();
            if (edit % 4 == 3) playground.edit();
            // A rotated light meets shadows that were kept.
            if (edit % 3 == 2) playground.rotate_light(0.4 * edit);
            const StokesImage image = studio(playground.scene, tracing);
            Studio fresh(context);
            const StokesImage truth = fresh(playground.scene, tracing);
            CAPTURES(where, edit);
            CHECK(studio.statistics.vertices == fresh.statistics.vertices);
            CHECK(fresh.statistics.vertices_added > 0);
            // Vertices that nothing occludes are rounded as their neighbours in a block of sixteen are.
            CHECK(test::rms_difference(image, truth) < 1e-7 * largest(truth));
            rays += studio.statistics.bake_rays;
            fresh_rays += fresh.statistics.bake_rays + fresh.statistics.bake_rays_skipped;
            relit += studio.statistics.vertices_relit;
            fresh_relit += fresh.statistics.vertices_relit;
        }
        CHECK(rays < fresh_rays / 2);
        CHECK(relit < fresh_relit);
    }
}
