// SPDX-License-Identifier: MIT
// Tests of options, threads, progress and errors.
#include <thread>

#include "image_difference.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

constexpr int width = 21, height = 13;  // not a multiple of the tile size

Scene ball_on_floor() {
    Scene scene;
    const Frame floor(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    scene.add(square(diffuse({0.4}), floor, {0, -1, 0}, 4));
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()),
               .material = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}}),
               .to_world = glm::dmat4(1.0)});
    scene.set_environment(rayleigh_sky({.sun_direction = {1, 1, 1}}), glm::dmat3(1.0), 1);
    return scene;
}

Camera camera() {
    Camera out;
    out.to_world = look_at({2, 1.5, 4}, {0, 0, 0}, {0, 1, 0});
    return out;
}

void check_refused(ErrorCode code, const Scene& scene, int w, int h, const ReferenceOptions& options,
                   const std::string& part = "") {
    ReferenceStatistics statistics;
    check_error(code,
                CALL(render_reference(scene, project(camera(), width, height), w, h, options, statistics)),
                part);
}

}  // namespace

TEST_CASE("light with a table is looked up there, and light of coefficients has one") {
    // An environment that forwards to another one. radiance() must not be called if there is a table.
    class Watched final : public Environment {
    public:
        Watched(EnvironmentPtr light, bool table) : light_(std::move(light)), table_(table) {}
        int channels() const noexcept override { return light_->channels(); }
        bool polarized() const noexcept override { return light_->polarized(); }
        bool circular() const noexcept override { return light_->circular(); }
        Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
            if (table_) throw Error(ErrorCode::unsupported, "slow");
            return light_->radiance(channel, towards_light);
        }
        PshVector project(int order) const override { return light_->project(order); }
        EquirectImage image() const override { return light_->image(); }
        std::unique_ptr<const Environment> tabulated() const override {
            return table_ ? light_->tabulated() : nullptr;
        }

    private:
        EnvironmentPtr light_;
        bool table_;
    };
    // The sky is polarized and has orders up to 12.
    const EnvironmentPtr sky = psh_environment(
        rayleigh_sky({.sun_direction = {1, 0.4, 1}, .radiance = {1}, .turbidity = 3})->project(12));
    std::vector<StokesImage> images;
    for (const bool table : {false, true}) {
        Scene scene = ball_on_floor();
        scene.set_environment(std::make_shared<const Watched>(sky, table), glm::dmat3(1.0), 1);
        images.push_back(render(scene, camera(), width, height, {.samples = 16}));
    }
    // Equal samples leave only the error of the table.
    const double difference = rms_difference(images[0], images[1]);
    CHECK(difference < 1e-3 * rms(images[0]));
    CHECK(difference > 0);
}

TEST_CASE("a seed gives the same image with any number of threads; another seed another") {
    const Scene scene = ball_on_floor();
    const auto image = [&](std::uint64_t seed, int threads) {
        return render(scene, camera(), width, height,
                      {.samples = 20, .seed = seed, .workers = {.threads = threads}})
            .data;
    };
    const std::vector<float> one = image(5, 1);
    CHECK(one == image(5, 2));
    CHECK(one == image(5, 7));
    CHECK(one == image(5, 0));
    const std::vector<float> other = image(6, 1);
    std::size_t same = 0;
    for (std::size_t i = 0; i < one.size(); i += 4) same += one[i] == other[i] ? 1 : 0;
    CHECK(same < one.size() / 4 / 20);
}

TEST_CASE("pixels have noise of their own") {
    Scene scene;
    scene.add(square(diffuse({0.5})));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    const StokesImage image = render(scene, camera_on({0, 0, 0}, {0, 0, 1}), 16, 16, {.samples = 4});
    int same = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 1; x < 16; ++x) same += image.at(0, y, x)[0] == image.at(0, y, x - 1)[0] ? 1 : 0;
    CHECK(same < 5);
}

TEST_CASE("every pixel and ray is counted") {
    const Scene scene = ball_on_floor();
    ReferenceStatistics statistics;
    (void)render_reference(scene, project(camera(), width, height), width, height, {.samples = 3},
                           statistics);
    CHECK(statistics.camera_rays == 3 * width * height);
    CHECK(statistics.shadow_rays > statistics.camera_rays / 4);
    CHECK(statistics.shadow_rays <= 2 * statistics.camera_rays);
    CHECK(statistics.triangles == make_sphere().triangles.size() + 2);
}

TEST_CASE("progress is reported on the calling thread, rises, and can stop the render") {
    const Scene scene = ball_on_floor();
    const std::thread::id caller = std::this_thread::get_id();
    int calls = 0;
    double last = 0;
    bool sound = true;
    ReferenceOptions options{.samples = 4096, .workers = {.threads = 4}};
    options.progress = [&](const char* verb, double fraction) {
        ++calls;
        sound = sound && std::string(verb) == "trace" && std::this_thread::get_id() == caller &&
                fraction >= last && fraction <= 1;
        last = fraction;
        return true;
    };
    (void)render(scene, camera(), width, height, options);
    CHECK(calls > 0);
    CHECK(sound);

    // The render is far too large to finish, so it ends only if it stops in the middle of a pixel.
    for (const int threads : {1, 3}) {
        calls = 0;
        options.samples = kMaxReferenceSamples;
        options.workers.threads = threads;
        options.progress = [&](const char*, double) {
            sound = sound && std::this_thread::get_id() == caller;
            return ++calls < 2;
        };
        check_refused(ErrorCode::cancelled, scene, 1024, 1024, options);
        CHECK(calls == 2);
        CHECK(sound);
    }
}

TEST_CASE("options and sizes out of range are refused by name") {
    const Scene scene = ball_on_floor();
    const auto bad = ErrorCode::invalid_argument;
    for (const int samples : {0, -1, kMaxReferenceSamples + 1})
        check_refused(bad, scene, width, height, {.samples = samples},
                      "samples is " + std::to_string(samples));
    check_refused(bad, scene, width, height, {.workers = {.threads = -1}}, "threads");
    for (const int side : {0, -5, kMaxImageSide + 1}) check_refused(bad, scene, side, height, {.samples = 1});
}

TEST_CASE("what throws inside reaches the caller") {
    class Broken final : public Material {
    public:
        int channels() const noexcept override { return 1; }
        int terms() const noexcept override { return 1; }
        double weight(int, int) const override { return 1; }
        double lobe_width(int) const noexcept override { return 1; }
        Mueller evaluate(int, const glm::dvec3&, const glm::dvec3&) const override {
            throw Error(ErrorCode::unsupported, "broken");
        }
    };
    Scene scene;
    scene.add(square(std::make_shared<const Broken>()));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    CHECK_THROWS_WITH_AS((void)render(scene, camera_on({0, 0, 0}, {0, 0, 1}), 64, 64,
                                      {.samples = 16, .workers = {.threads = 4}}),
                         "broken", Error);
}

TEST_CASE("what lies outside the clip planes is not rendered") {
    Scene scene;
    scene.add(square(diffuse({0.5})));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    for (const bool orthographic : {true, false}) {
        Camera view;
        view.orthographic = orthographic;
        view.to_world = look_at({0, 0, 2}, {0, 0, 0}, {0, 1, 0});
        view.fov = 50;
        const auto middle = [&](double near, double far) {
            view.near_clip = near;
            view.far_clip = far;
            // In the corner the distance along the ray differs from the depth.
            const StokesImage image = render(scene, view, 16, 16, {.samples = 64}, Strategy::surface);
            return static_cast<double>(image.at(0, 1, 1)[0]);
        };
        CHECK(middle(1.99, 2.01) == doctest::Approx(0.5).epsilon(1e-5));
        CHECK(middle(0.1, 1.99) == doctest::Approx(1).epsilon(1e-5));
        CHECK(middle(2.01, 10) == doctest::Approx(1).epsilon(1e-5));
    }
}
