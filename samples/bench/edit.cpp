// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "clouds.hpp"
#include "commands.hpp"
#include "film.hpp"
#include "median.hpp"
#include "sphere.hpp"
#include "stage.hpp"

namespace {

constexpr std::uint32_t kRow = 10;  // balls in a row
constexpr std::uint32_t kBalls = 50;
constexpr std::uint32_t kPebbles = 1000;
constexpr std::uint32_t kBallVertices = 1200;
constexpr std::uint32_t kBodyVertices = 10000;
constexpr int kRounds = 3;        // repetitions of an edit
constexpr double kBudget = 8;     // milliseconds of a frame in motion
constexpr int kMovingFrames = 8;  // frames in motion
constexpr int kMostFrames = 5000;

Transform scaled_at(double x, double y, double z, double scale) {
    return {{scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, z, 0, 0, 0, 1}};
}

/// Places of 50 balls of radius 0.4 on a floor, and of 1,000 pebbles between them.
Transform ball_place(std::uint32_t i) {
    return scaled_at(i % kRow - 4.5, 0.4, i / kRow - 2.0, 0.4);
}
Transform pebble_place(std::uint32_t i) {
    return scaled_at(0.25 * (i % 40) - 4.9, 0.06, 0.25 * (i / 40) - 2.9, 0.06);
}

Material plastic(nicol_context context, float reflectance, float alpha) {
    nicol_pplastic parameters = NICOL_PPLASTIC_INIT;
    parameters.diffuse_reflectance = {.count = Film::kChannels, .values = {reflectance, 0.3F, 0.2F}};
    parameters.alpha = alpha;
    return create<Material>(nicol_material_create_pplastic, context, &parameters);
}

Environment forest(nicol_context context) {
    return create<Environment>(nicol_environment_load, context, NICOL_BENCH_ASSETS "/forest.exr", nullptr);
}

Environment sky(nicol_context context, double sun) {
    nicol_sky parameters = NICOL_SKY_INIT;
    parameters.turbidity = 3;
    parameters.sun_direction[0] = static_cast<float>(std::sin(sun));
    parameters.sun_direction[1] = static_cast<float>(std::cos(sun));
    return create<Environment>(nicol_environment_create_sky, context, &parameters);
}

double relative_difference(const Image& image, const Image& truth) {
    double sum = 0, power = 0;
    for (std::size_t i = 0; i < image.stokes.size(); ++i) {
        const double difference = static_cast<double>(image.stokes[i]) - static_cast<double>(truth.stokes[i]);
        sum += difference * difference;
        if (i % 4 == 0) power += static_cast<double>(truth.stokes[i]) * static_cast<double>(truth.stokes[i]);
    }
    return std::sqrt(sum / power);
}

/// The six faces of a cube around a place, rendered with default options.
class CubeFaces {
public:
    CubeFaces(nicol_context context, nicol_scene scene, std::uint32_t size) : scene_(scene) {
        for (int i = 0; i < 6; ++i)
            framebuffers_.push_back(
                create<Framebuffer>(nicol_framebuffer_create, context, size, size, Film::kChannels));
    }

    /// Renders the first `count` faces, `at_once` in each call, and returns the processor time in
    /// milliseconds. shift: of the cube to the right.
    double render(double shift, std::uint32_t count, std::uint32_t at_once) {
        std::vector<nicol_camera> cameras;
        std::vector<nicol_framebuffer> targets;
        for (std::uint32_t face = 0; face < count; ++face) {
            const double sign = face % 2 == 0 ? 1 : -1;
            const double origin[3] = {shift, 1.2, 0.5};
            double target[3] = {shift, 1.2, 0.5};
            target[face / 2] += sign;
            const double up[3] = {0, face / 2 == 1 ? 0.0 : 1.0, face / 2 == 1 ? 1.0 : 0.0};
            nicol_camera& camera = cameras.emplace_back(nicol_camera NICOL_CAMERA_INIT);
            camera.fov = 90;
            check(nicol_camera_look_at(&camera, origin, target, up));
            targets.push_back(framebuffers_[face].get());
        }
        const std::clock_t spent = std::clock();
        for (std::uint32_t i = 0; i < count; i += at_once)
            check(nicol_render_views(scene_, &cameras[i], &targets[i], at_once, nullptr));
        return 1e3 * static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
    }

private:
    nicol_scene scene_;
    std::vector<Framebuffer> framebuffers_;
};

/// Measures edits of one scene, one after the other.
class Edits {
public:
    Edits(const Options& options, Report& report)
        : size_(options.size == 0 ? 512 : options.size),
          only_(options.only),
          report_(report),
          context_(make_context(options.backend, options.cache)),
          film_(context_.get(), size_),
          ball_(make_sphere(context_.get(), kBallVertices, 0)),
          pebble_(make_sphere(context_.get(), 60, 0)),
          grey_(plastic(context_.get(), 0.4F, 0.2F)),
          red_(plastic(context_.get(), 0.6F, 0.2F)) {
        film_.set_light(forest(context_.get()));
        const auto floor = create<Mesh>(nicol_mesh_create_rectangle, context_.get());
        film_.add(floor.get(), grey_.get(), {{7, 0, 0, 0, 0, 0, 7, 0, 0, -7, 0, 0, 0, 0, 0, 1}});
        // The first ball is the instance with the most vertices, which decides the axes of the bake.
        for (std::uint32_t i = 0; i < kBalls; ++i)
            balls_.push_back(film_.add(ball_.get(), i % 2 == 0 ? grey_.get() : red_.get(), ball_place(i)));
        first_ = film_.frame([] {});
    }

    void run() {
        add_row("first picture", {first_});
        for (const std::uint32_t count : {1U, 10U})
            measure("move " + std::to_string(count) + " of 50", [&](int round) { move(count, round); });
        measure("move the largest of 50",
                [&](int round) { film_.move(balls_[0], scaled_at(-4.5, 0.5 + 0.05 * round, -2.0, 0.4)); });
        measure("deform 1 of 50", [&](int round) { deform(balls_[24], ball_.get(), kBallVertices, round); });
        measure_new_mesh();
        measure_materials_and_lights();
        measure_pebbles();
    }

    /// Measures frames in motion within a budget.
    void run_within_budget() {
        for (const std::uint32_t count : {1U, 10U})
            measure_motion("move " + std::to_string(count) + " of 50",
                           [=, this](int round) { move(count, round); });
        const char* const deforming = "deform one of 10,000 vertices";
        if (wanted(deforming)) {
            const Mesh body = make_sphere(context_.get(), kBodyVertices, 0);
            const std::uint32_t id = film_.add(body.get(), grey_.get(), scaled_at(0, 1.2, 1, 0.7));
            film_.frame([] {});
            measure_motion(deforming, [&](int round) { deform(id, body.get(), kBodyVertices, round); });
            check(nicol_scene_remove_instance(film_.scene(), id));
        }
        const char* const among_pebbles = "move 1 of 1,050";
        if (!wanted(among_pebbles)) return;
        for (std::uint32_t i = 0; i < kPebbles; ++i) film_.add(pebble_.get(), grey_.get(), pebble_place(i));
        film_.frame([] {});
        measure_motion(among_pebbles, [this](int round) { move(1, round); });
    }

    /// Measures the faces of a cube around a place among the balls.
    void run_views() {
        const std::uint32_t size = std::min(size_, 256U);
        const auto from_nothing = [&](std::uint32_t count, std::uint32_t at_once) {
            const Film same = film_.copy(size);
            return CubeFaces(context_.get(), same.scene(), size).render(0, count, at_once);
        };
        add_views("first picture", from_nothing(1, 1), from_nothing(6, 6), from_nothing(6, 1));
        CubeFaces faces(context_.get(), film_.scene(), size);
        const auto measure_views = [&](const std::string& name, const std::function<void(int)>& edit) {
            std::vector<double> times[3];
            int round = 0;
            for (int i = 0; i < kRounds; ++i)
                for (const std::uint32_t k : {0U, 1U, 2U}) {
                    edit(round);
                    times[k].push_back(faces.render(0.01 * ++round, k == 0 ? 1 : 6, k == 1 ? 6 : 1));
                }
            add_views(name, median(times[0]), median(times[1]), median(times[2]));
        };
        faces.render(0, 6, 6);
        measure_views("move the camera", [](int) {});
        measure_views("rotate the light", [&](int round) { film_.rotate_light(0.1 * (round + 1)); });
        measure_views("move 1 of 50", [&](int round) { move(1, round); });
    }

private:
    void add_views(const std::string& name, double one, double six, double apart) {
        report_.add(name, {one, six, six / one, apart});
    }

    void move(std::uint32_t count, int round) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t ball = (24 + 7 * i) % kBalls;
            Transform place = ball_place(ball);
            place.to_world[3] += 0.05 * (round + 1);
            place.to_world[11] += 0.03 * (round + 1);
            film_.move(balls_[ball], place);
        }
    }

    // Gives an instance of a sphere waves that grow.
    void deform(std::uint32_t id, nicol_mesh base, std::uint32_t vertices, int round) {
        const std::vector<float> positions = sphere_positions(vertices, 0.02 * (round + 1));
        nicol_deformation deformation = NICOL_DEFORMATION_INIT;
        deformation.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
        deformation.positions = positions.data();
        const auto mesh = create<Mesh>(nicol_mesh_create_deformed, context_.get(), base, &deformation);
        film_.set_mesh(id, mesh.get());
    }

    void measure_new_mesh() {
        std::vector<std::uint32_t> others;
        measure("new mesh of 1,000 vertices", [&](int round) {
            const Mesh mesh = make_sphere(context_.get(), 1000, 0.02 * (round + 1));
            others.push_back(film_.add(mesh.get(), grey_.get(), scaled_at(round - 1.0, 1.2, 0.5, 0.3)));
        });
        for (const std::uint32_t id : others) check(nicol_scene_remove_instance(film_.scene(), id));
    }

    void measure_materials_and_lights() {
        const auto set = [&](float reflectance, float alpha) {
            const Material material = plastic(context_.get(), reflectance, alpha);
            check(nicol_scene_set_material(film_.scene(), balls_[24], material.get()));
        };
        measure("new reflectance", [&](int round) { set(0.5F + 0.1F * static_cast<float>(round), 0.2F); });
        measure("new alpha", [&](int round) { set(0.4F, 0.25F + 0.05F * static_cast<float>(round)); });
        measure("environment's scale", [&](int round) { film_.set_light_scale(1.1 + 0.1 * round); });
        std::vector<Environment> photographs, skies;
        for (int round = 0; round < kRounds; ++round) {
            photographs.push_back(clouds(context_.get(), round));
            skies.push_back(sky(context_.get(), 0.3 + 0.1 * round));
        }
        const auto light_by = [&](std::vector<Environment>& lights) {
            return [&](int round) { film_.set_light(std::move(lights[static_cast<std::size_t>(round)])); };
        };
        measure("new environment", light_by(photographs));
        measure("new sky", light_by(skies));
        film_.set_light(forest(context_.get()));
    }

    void measure_pebbles() {
        std::vector<std::uint32_t> pebbles;
        const auto scatter = [&](int) {
            for (std::uint32_t i = 0; i < kPebbles; ++i)
                pebbles.push_back(film_.add(pebble_.get(), grey_.get(), pebble_place(i)));
        };
        const auto collect = [&](int) {
            for (const std::uint32_t id : pebbles) check(nicol_scene_remove_instance(film_.scene(), id));
            pebbles.clear();
        };
        const char* const names[] = {"add 1,000 instances", "move 1 of 1,050", "remove 1,000 instances"};
        if (std::ranges::none_of(names, [&](const char* name) { return wanted(name); })) return;
        if (wanted(names[0])) {
            measure(names[0], scatter, 1);
        } else {
            film_.frame([&] { scatter(0); });
        }
        measure(names[1], [&](int round) { move(1, round); });
        measure(names[2], collect, 1);
    }

    void measure_motion(const std::string& name, const std::function<void(int)>& edit) {
        if (!wanted(name)) return;
        std::vector<double> still, cpu, error;
        for (int i = 0; i < kRounds; ++i) still.push_back(film_.frame([&] { film_.orbit(); }).cpu_ms);
        film_.set_budget(kBudget);
        std::uint64_t pending = 0;
        for (int round = 0; round < kMovingFrames; ++round) {
            const Frame frame = film_.frame([&] { edit(round); });
            cpu.push_back(frame.cpu_ms);
            pending = frame.work.vertices_pending;
            if (round % 4 == 3)
                error.push_back(relative_difference(film_.image(), film_.fresh(size_).image()));
        }
        int frames = 0;
        double spent = 0, longest = 0;
        while (frames < kMostFrames && pending > 0) {
            const Frame frame = film_.frame([] {});
            pending = frame.work.vertices_pending;
            spent += frame.cpu_ms;
            longest = std::max(longest, frame.cpu_ms);
            ++frames;
        }
        report_.add(name, {median(cpu) - median(still), median(error), static_cast<double>(frames),
                           frames > 0 ? spent / frames - median(still) : 0, longest - median(still),
                           relative_difference(film_.image(), film_.fresh(size_).image())});
        film_.set_budget(0);
    }

    [[nodiscard]] bool wanted(const std::string& name) const { return name.find(only_) != std::string::npos; }

    // Measures an edit, which is given the number of its repetition, over a frame of a moved camera.
    void measure(const std::string& name, const std::function<void(int)>& edit, int rounds = kRounds) {
        if (!wanted(name)) return;
        film_.frame([] {});  // takes over what has not been measured
        std::vector<Frame> frames;
        for (int round = 0; round < rounds; ++round) frames.push_back(film_.frame([&] { edit(round); }));
        const Image image = film_.image();
        add_row(name, frames, relative_difference(image, film_.fresh(size_).image()));
    }

    void add_row(const std::string& name, const std::vector<Frame>& frames,
                 double difference = std::nan("")) {
        std::vector<double> still, still_cpu;
        for (int i = 0; i < kRounds; ++i) {
            // A further view may show vertices that are still to be baked. A view between two that were
            // rendered needs hardly anything.
            film_.frame([&] { film_.orbit(); });
            const Frame frame = film_.frame([&] { film_.orbit(-0.005); });
            still.push_back(frame.ms);
            still_cpu.push_back(frame.cpu_ms);
        }
        const auto of = [&](auto&& value) {
            std::vector<double> values;
            for (const Frame& frame : frames) values.push_back(static_cast<double>(value(frame)));
            return median(values);
        };
        report_.add(name, {of([](const Frame& f) { return f.ms; }) - median(still),
                           of([](const Frame& f) { return f.cpu_ms; }) - median(still_cpu),
                           of([](const Frame& f) { return f.work.project_ms; }),
                           of([](const Frame& f) { return f.work.bake_ms; }),
                           of([](const Frame& f) { return f.work.bake_trace_ms; }),
                           of([](const Frame& f) { return f.work.relight_ms; }),
                           of([](const Frame& f) { return f.work.bake_rays; }) / 1e6,
                           of([](const Frame& f) { return f.work.vertices_traced; }),
                           of([](const Frame& f) { return f.work.vertices_relit; }),
                           of([](const Frame& f) { return f.work.vertices; }), difference});
    }

    std::uint32_t size_;
    std::string only_;
    Report& report_;
    Context context_;
    Film film_;
    Frame first_;
    Mesh ball_;
    Mesh pebble_;
    Material grey_;
    Material red_;
    std::vector<std::uint32_t> balls_;
};

}  // namespace

Report bench_edit(const Options& options) {
    Report report({"after", "extra ms", "extra CPU ms", "project ms", "bake ms", "rays ms", "relight ms",
                   "million rays", "vertices traced", "relit", "of", "difference"});
    Edits(options, report).run();
    report.note(
        "A floor and 50 balls, default options. Extra: over a frame after a move of the camera. "
        "Difference: RMS from a scene that has rendered nothing else, over the RMS of s0.");
    return report;
}

Report bench_motion(const Options& options) {
    Report report({"edit in each frame", "extra CPU ms", "error", "frames to the end", "extra CPU ms each",
                   "longest", "difference"});
    Edits(options, report).run_within_budget();
    report.note(
        "The scene of nicol-bench edit with a bake_budget_ms of 8. Extra: over a frame after a move of the "
        "camera without a budget. Error: of frames in motion, from a scene that has rendered nothing else, "
        "as "
        "RMS over the RMS of s0. Then the scene stands still: frames until nothing is pending, and the "
        "difference of the last one.");
    return report;
}

Report bench_views(const Options& options) {
    Report report({"after", "one face, ms", "six faces, ms", "six / one", "six calls, ms"});
    Edits(options, report).run_views();
    report.note(
        "The scene of nicol-bench edit, from a place among the balls: processor time of one face of a cube "
        "around it, of all six by nicol_render_views, and of all six by one call each.");
    return report;
}
