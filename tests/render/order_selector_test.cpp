// SPDX-License-Identifier: MIT
// Tests of orders chosen for a tolerance, and of the resulting error.
#include "render/order_selector.hpp"

#include <atomic>
#include <optional>

#include "devices/cpu/cpu_executor.hpp"
#include "material/shared_terms.hpp"
#include "render/memory_estimate.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr int truth = 16;

/// Returns light whose power falls with the order like that of natural light.
EnvironmentPtr natural_light(bool polarized, int order = truth) {
    PshVector light(order, 3);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int c = 0; c < 3; ++c) {
        light.at(c, 0, 0, 0) = 6;
        for (int l = 1; l <= order; ++l) {
            for (int m = -l; m <= l; ++m) {
                for (int p = 0; p < (polarized && l >= 2 ? 3 : 1); ++p)
                    light.at(c, l, m, p) = (p == 0 ? 1.0 : 0.4) * std::pow(l, -1.3) * normal(random);
            }
        }
    }
    return psh_environment(light);
}

Scene spheres(const MaterialPtr& first, const MaterialPtr& second, const EnvironmentPtr& light,
              std::uint32_t segments = 8) {
    Scene scene;
    const auto mesh = test::coarse_sphere(segments);
    scene.add({.mesh = mesh, .material = first, .to_world = test::at(-1.02, 0, 0)});
    scene.add({.mesh = mesh, .material = second, .to_world = test::at(1.02, 0, 0)});
    scene.set_environment(light, glm::dmat3(1), 1);
    return scene;
}

Projection from(const glm::dvec3& eye) {
    return project(test::camera_at(eye), 64, 64);
}

/// A glossy material that counts its evaluations together with other materials.
class CountedGloss final : public Material, public SharedTerms {
public:
    CountedGloss(double weight, double alpha, int& calls)
        : weight_(weight), alpha_(alpha), calls_(calls), base_(pplastic({.alpha = alpha})) {}
    [[nodiscard]] int channels() const noexcept override { return 1; }
    [[nodiscard]] int terms() const noexcept override { return 1; }
    [[nodiscard]] double weight(int, int) const override { return weight_; }
    [[nodiscard]] double lobe_width(int) const noexcept override { return alpha_; }
    [[nodiscard]] std::string own_terms_key() const override { return "gloss " + std::to_string(alpha_); }
    [[nodiscard]] Mueller evaluate(int, const glm::dvec3& i, const glm::dvec3& o) const override {
        ++std::atomic_ref(calls_);
        return base_->evaluate(0, i, o);
    }

private:
    double weight_, alpha_;
    int& calls_;
    MaterialPtr base_;
};

/// Images of a scene's vertices from several views, with all orders of its light and with the orders chosen
/// for a tolerance.
class Comparison {
public:
    Comparison(const Scene& scene, bool shadows) : scene_(scene), shadows_(shadows) {}

    struct Result {
        double measured = 0;  ///< largest relative RMSE of s0, s1 and s2
        Statistics statistics;
    };
    /// Weights each vertex by the area that it covers in an image.
    Result run(double tolerance, HighOrders form, double refine_tolerance = 0.02) {
        const RenderOptions all{.shadows = shadows_,
                                .refine_tolerance = refine_tolerance,
                                .order_low = truth,
                                .order_high = truth};
        const RenderOptions chosen{.shadows = shadows_,
                                   .refine_tolerance = refine_tolerance,
                                   .high_orders = form,
                                   .choose_orders = true,
                                   .tolerance = tolerance};
        Result result;
        std::array<double, 3> error{};
        double scale = 0;
        for (const glm::dvec3& eye :
             {glm::dvec3(0, 1, 7), glm::dvec3(6, 2, -2), glm::dvec3(-4, 5, -4), glm::dvec3(1, -6, 2)}) {
            Statistics unused;
            exact_.run(scene_, from(eye), all, unused);
            result.statistics = {};
            chosen_.run(scene_, from(eye), chosen, result.statistics);
            const WorldGeometry& geometry = exact_.pipeline.surfaces().geometry();
            for (std::size_t v = 0; v < geometry.positions.size(); ++v) {
                const double covered = glm::dot(glm::dvec3(geometry.normals[v]),
                                                glm::normalize(eye - glm::dvec3(geometry.positions[v])));
                if (!(covered > 0)) continue;
                for (std::size_t c = 0; c < exact_.executor.stokes().size(); ++c) {
                    const glm::dvec4 a(exact_.executor.stokes()[c][v]);
                    const glm::dvec4 d = glm::dvec4(chosen_.executor.stokes()[c][v]) - a;
                    scale += covered * a.x * a.x;
                    for (int p = 0; p < 3; ++p) error[static_cast<std::size_t>(p)] += covered * d[p] * d[p];
                }
            }
        }
        result.measured = std::sqrt(std::ranges::max(error) / scale);
        return result;
    }

private:
    struct Shading {
        Workers workers{WorkerOptions{}};
        Pipeline pipeline;
        CpuExecutor executor;

        void run(const Scene& scene, const Projection& projection, const RenderOptions& options,
                 Statistics& statistics) {
            Progress progress(options.progress);
            RenderRun run{.workers = workers, .progress = progress, .statistics = statistics};
            pipeline.bake(scene, {&projection, 1}, {}, options, run);
            pipeline.run(scene, projection, options, executor, run, {}, false);
        }
    };

    const Scene& scene_;
    bool shadows_;
    Shading exact_;
    Shading chosen_;
};

}  // namespace

TEST_CASE("what a tolerance asks for holds, and not much more is computed") {
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.5, 0.3, 0.1}, .alpha = 0.3});
    const MaterialPtr glossy = pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.15});
    for (const bool all : {false, true}) {
        const Scene scene = spheres(plastic, glossy, natural_light(all));
        Comparison comparison(scene, all);
        int cheaper = -1;
        for_all({0.1, 0.03, 0.01}, {HighOrders::none, HighOrders::split},
                [&](double tolerance, HighOrders form) {
                    const auto result = comparison.run(tolerance, form);
                    const Statistics& s = result.statistics;
                    CAPTURES(all, tolerance, result.measured, s.order_error);
                    CHECK(s.order_error <= tolerance);
                    CHECK(result.measured <= 2 * tolerance);
                    CHECK(result.measured >= 0.4 * s.order_error);
                    if (form == HighOrders::split) return;
                    CHECK(s.order == s.order_low);
                    CHECK(s.order > cheaper);
                    cheaper = s.order;
                });
    }
}

TEST_CASE("orders have what coarse shadows leave of the tolerance, half of it at least") {
    const MaterialPtr glossy = pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.15});
    const Scene scene = spheres(glossy, glossy, natural_light(false), 4);
    for (const double tolerance : {0.05, 0.03, 0.02, 0.01}) {
        const Statistics s = Comparison(scene, true).run(tolerance, HighOrders::none, 0).statistics;
        CAPTURES(tolerance, s.shadow_error, s.order_error);
        CHECK(s.shadow_error > 0.008);
        const double left = std::sqrt(std::max(0.0, tolerance * tolerance - s.shadow_error * s.shadow_error));
        CHECK(s.order_error <= std::max(left, 0.5 * tolerance));
    }
}

TEST_CASE("diffuse surfaces need few orders, darkness none") {
    Scene scene = spheres(diffuse({0.5}), diffuse({0.2}), natural_light(false));
    const auto lit = Comparison(scene, false).run(0.03, HighOrders::split);
    CHECK(lit.statistics.order <= 3);
    CHECK(lit.measured <= 0.06);
    scene.set_environment(nullptr, glm::dmat3(1), 1);
    const auto dark = Comparison(scene, true).run(0.03, HighOrders::split);
    CHECK(dark.statistics.order == 0);
    CHECK(dark.statistics.order_error == 0);
}

TEST_CASE("what is prepared beside a bake changes no orders") {
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.5, 0.3, 0.1}, .alpha = 0.3});
    const Scene scene =
        spheres(plastic, pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.15}), natural_light(true));
    SceneGeometry surfaces;
    surfaces.update(scene);
    const auto choose = [&](const std::optional<SampledTerms>& prepared) {
        KeptProjection projection;
        OrderSelector selector;
        if (prepared) selector.prepare(scene, {scene.environment(), *prepared}, projection);
        return selector.choose(
            scene, {scene.environment(), SampledTerms::none}, test::without_shadows(surfaces), true,
            {.high_orders = HighOrders::split, .tolerance = 0.01}, MemoryLimit::kNone, projection);
    };
    const auto alone = choose(std::nullopt);
    for (const SampledTerms& prepared :
         {SampledTerms(SampledTerms::none), SampledTerms(SampledTerms::smooth)}) {
        const auto orders = choose(prepared);
        CHECK(orders.low == alone.low);
        CHECK(orders.high == alone.high);
        CHECK(orders.error == alone.error);
        CHECK(orders.rms == alone.rms);
    }
}

TEST_CASE("beside local lights, which take most of a frame, better orders are taken") {
    Scene scene = spheres(diffuse({0.5}), diffuse({0.2}), natural_light(false));
    const auto choose = [&](double tolerance) {
        KeptProjection projection;
        OrderSelector selector;
        SceneGeometry surfaces;
        surfaces.update(scene);
        return selector.choose(
            scene, {scene.environment(), SampledTerms::none}, test::without_shadows(surfaces), true,
            {.high_orders = HighOrders::none, .tolerance = tolerance}, MemoryLimit::kNone, projection);
    };
    const auto dark = choose(0.1), fine = choose(1e-3);
    scene.add_light({.kind = LocalLight::Kind::point, .value = {1}});
    const auto lit = choose(0.1);
    CAPTURES(dark.low, lit.low);
    CHECK(dark.low < lit.low);
    CHECK(lit.low <= 4);
    CHECK(lit.error < dark.error);
    // Orders that take noticeable time are taken if they are needed, not otherwise.
    CHECK(choose(1e-3).low == fine.low);
}

TEST_CASE("better orders that take little of a frame are taken") {
    const Scene scene = spheres(diffuse({0.5}), diffuse({0.2}), natural_light(false));
    SceneGeometry surfaces;
    surfaces.update(scene);
    const auto choose = [&](double tolerance) {
        KeptProjection projection;
        OrderSelector selector;
        return selector.choose(
            scene, {scene.environment(), SampledTerms::none}, test::without_shadows(surfaces), true,
            {.high_orders = HighOrders::none, .tolerance = tolerance}, MemoryLimit::kNone, projection);
    };
    // Order 0 keeps the first tolerance. Order 2 takes many times as long, but little of a frame.
    const OrderSelector::Orders coarse = choose(0.3), fine = choose(1e-3);
    CAPTURES(coarse.low, coarse.error, fine.low);
    CHECK(coarse.low == 2);
    CHECK(coarse.low < fine.low);
}

TEST_CASE("a new reflectance integrates no terms, and its orders are those of a selector that is new") {
    int calls = 0;
    const auto gloss = [&](double weight, double alpha) {
        return std::make_shared<const CountedGloss>(weight, alpha, calls);
    };
    Scene scene = spheres(gloss(0.3, 0.2), gloss(0.4, 0.2), natural_light(false));
    SceneGeometry surfaces;
    KeptProjection projection;
    const auto choose = [&](OrderSelector& selector) {
        surfaces.update(scene);
        const SurfaceState unshadowed = test::without_shadows(surfaces);
        return selector.choose(scene, {scene.environment(), SampledTerms::none}, unshadowed, true,
                               {.high_orders = HighOrders::split, .tolerance = 0.02}, MemoryLimit::kNone,
                               projection);
    };
    const auto calls_of = [&](OrderSelector& selector) {
        const int before = calls;
        choose(selector);
        return calls - before;
    };
    OrderSelector kept;
    CHECK(calls_of(kept) > 0);
    for (const double alpha : {0.2, 0.35}) {
        scene.set_material(scene.ids()[1], gloss(0.6, alpha));
        CAPTURES(alpha);
        CHECK((calls_of(kept) > 0) == (alpha != 0.2));
        OrderSelector fresh;
        const OrderSelector::Orders expected = choose(fresh), orders = choose(kept);
        CHECK(orders.low == expected.low);
        CHECK(orders.high == expected.high);
        CHECK(orders.error == expected.error);
        CHECK(orders.rms == expected.rms);
    }
}

TEST_CASE("without orders within the tolerance, error is not reduced at any cost") {
    for (const double alpha : {0.005, 0.1}) {
        const MaterialPtr material = pplastic({.alpha = alpha});
        const Scene scene = spheres(material, material, natural_light(false, 64));
        KeptProjection projection;
        OrderSelector selector;
        SceneGeometry surfaces;
        surfaces.update(scene);
        const auto choose = [&](double tolerance) {
            return selector.choose(
                scene, {scene.environment(), SampledTerms::none}, test::without_shadows(surfaces), true,
                {.high_orders = HighOrders::none, .tolerance = tolerance}, MemoryLimit::kNone, projection);
        };
        const OrderSelector::Orders orders = choose(1e-9);
        // Each order of rough plastic is worth its time, unless the rest of the image errs as much.
        CAPTURES(alpha, orders.low, orders.error);
        CHECK((orders.low == OrderSelector::kHighestLow) == (alpha == 0.1));
        const OrderSelector::Orders beside = choose(0.99 * orders.error);
        CAPTURES(beside.low, beside.error);
        if (alpha == 0.1) CHECK(beside.low < orders.low);
        CHECK(beside.error <= 1.5 * orders.error);
    }
}

TEST_CASE("a tolerance that cannot be reached is reported") {
    const Scene scene = spheres(pplastic({.alpha = 0.1}), pplastic({.alpha = 0.1}), natural_light(false, 24));
    KeptProjection projection;
    OrderSelector selector;
    SceneGeometry surfaces;
    surfaces.update(scene);
    const SurfaceState unshadowed = test::without_shadows(surfaces);
    RenderOptions options{.high_orders = HighOrders::none, .tolerance = 1e-9};
    constexpr std::uint64_t all_memory = MemoryLimit::kNone;
    const auto orders = selector.choose(scene, {scene.environment(), SampledTerms::none}, unshadowed, true,
                                        options, all_memory, projection);
    CHECK(orders.error > 1e-9);
    CHECK(orders.low == OrderSelector::kHighestLow);
    options.high_orders = HighOrders::split;
    CHECK(selector
              .choose(scene, {scene.environment(), SampledTerms::none}, unshadowed, true, options, all_memory,
                      projection)
              .error < orders.error);
    // The memory limits the order, but never below that of the options.
    RenderOptions fitting = options;
    fitting.order_low = 8;
    const std::uint64_t bytes = estimate_memory(scene, fitting).total();
    fitting.order_low = selector
                            .choose(scene, {scene.environment(), SampledTerms::none}, unshadowed, true,
                                    options, bytes, projection)
                            .low;
    CHECK(fitting.order_low > 4);
    CHECK(fitting.order_low < OrderSelector::kHighestLow);
    CHECK(estimate_memory(scene, fitting).total() <= bytes);
    CHECK(selector
              .choose(scene, {scene.environment(), SampledTerms::none}, unshadowed, true, options, 1,
                      projection)
              .low == 4);
}
