// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "commands.hpp"
#include "median.hpp"
#include "scene_file.hpp"
#include "temporary_folder.hpp"
#include "truth.hpp"

namespace {

constexpr std::int32_t kAllLight = 12;  // depth after which little light is left

constexpr const char* kLamp =
    R"(<shape type="rectangle"><transform name="to_world"><scale value="0.5"/><lookat origin="1,2.8,1" target="0,0,0" up="1,0,0"/>)"
    R"(</transform><emitter type="area"><rgb name="radiance" value="20,18,15"/></emitter></shape>)";

std::string plastic(const char* color) {
    return R"(<bsdf type="pplastic"><rgb name="diffuse_reflectance" value=")" + std::string(color) +
           R"("/><float name="alpha" value="0.2"/></bsdf>)";
}

std::string ball(const std::string& center, double radius, const std::string& material) {
    return R"(<shape type="sphere"><transform name="to_world"><scale value=")" + std::to_string(radius) +
           R"("/><translate value=")" + center + R"("/></transform>)" + material + "</shape>";
}

/// Returns a wall of half side 3 that faces the middle of a cube, after a rotation of the one behind it.
std::string wall(const std::string& rotation, const std::string& material) {
    return R"(<shape type="rectangle"><transform name="to_world"><translate z="-1"/><scale value="3"/><rotate )" +
           rotation + R"(/><translate y="2"/></transform>)" + material + "</shape>";
}

const std::string kFloor = wall(R"(x="1" angle="-90")", plastic("0.5,0.45,0.4"));

std::string three_walls() {
    return kFloor + wall(R"(y="1" angle="0")", plastic("0.6,0.6,0.6")) +
           wall(R"(y="1" angle="90")", plastic("0.7,0.3,0.2"));
}

std::string thirty_balls() {
    std::string balls;
    for (int i = 0; i < 30; ++i) {
        const double angle = 2.4 * i;
        const double distance = 0.4 * std::sqrt(i);
        balls += ball(std::to_string(distance * std::cos(angle)) + ",-0.7," +
                          std::to_string(distance * std::sin(angle)),
                      0.3, plastic(i % 2 == 0 ? "0.7,0.4,0.2" : "0.3,0.5,0.7"));
    }
    return balls;
}

struct Example {
    const char* name;
    const char* eye;
    std::string content;
};

std::array<Example, 5> examples() {
    const std::string middle = ball("0,0,0", 1, plastic("0.7,0.4,0.2"));
    const std::string closing = wall(R"(y="1" angle="-90")", plastic("0.2,0.3,0.7")) +
                                wall(R"(x="1" angle="90")", plastic("0.7,0.7,0.7"));
    return {{{"a ball", "1.5,2,5", kForestLight + middle},
             {"a ball on a floor", "1.5,2,5", kForestLight + middle + kFloor},
             {"thirty balls on a floor", "1.5,2,5", kForestLight + thirty_balls() + kFloor},
             {"a ball between three walls", "2,2,5", kForestLight + middle + three_walls()},
             {"a ball and a lamp between five walls", "0.5,2,7", kLamp + middle + three_walls() + closing}}};
}

Image traced(const Stage& stage, nicol_framebuffer framebuffer, std::uint32_t samples, std::uint64_t seed,
             std::int32_t max_depth) {
    nicol_render_options options = reference_options(samples, seed, true);
    options.max_depth = max_depth;
    stage.render(options, framebuffer);
    return read_image(framebuffer);
}

double sum_of_s0(const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.stokes.size(); i += 4) sum += static_cast<double>(image.stokes[i]);
    return sum;
}

Image difference(const Image& all, const Image& direct) {
    Image out = all;
    for (std::size_t i = 0; i < out.stokes.size(); ++i) out.stokes[i] -= direct.stokes[i];
    return out;
}

/// Cost of a picture.
struct Costs {
    double bake;  ///< seconds before the first shading
    double light,
        camera;        ///< processor milliseconds of a frame whose light was rotated or whose camera moved
    double kilobytes;  ///< kept of a vertex
};
Costs frame_costs(Stage& stage, const nicol_render_options& options, nicol_framebuffer framebuffer) {
    constexpr int frames = 7;
    const auto median_time = [&](const auto& change) {
        std::vector<double> times;
        for (int i = 0; i < frames; ++i) {
            change();
            const std::clock_t begin = std::clock();
            stage.render(options, framebuffer);
            times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        return median(times);
    };
    const double camera = median_time([&] { stage.orbit(0.5); });
    Costs out{.bake = 0, .light = std::nan(""), .camera = camera, .kilobytes = 0};
    if (stage.has_light()) out.light = median_time([&] { stage.rotate_light(1); });
    return out;
}

}  // namespace

Report bench_bounces(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 96 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 256 : given.samples;
    const TemporaryFolder folder;
    Options options = given;
    const std::filesystem::path file = folder.path() / "scene.xml";
    options.scene = file.string();

    const double none = std::nan("");
    Report report({"against light to depth 12", "missing", "s0", "s1", "s2", "indirect s0", "indirect s1",
                   "indirect s2", "bake s", "light ms", "camera ms", "bake / direct", "light / direct",
                   "camera / direct", "KB a vertex"});
    for (const Example& example : examples()) {
        write_scene(file, example.eye, "0,0.2,0", example.content);
        const SceneSource source(options);
        Stage stage(source);
        const Framebuffer framebuffer = stage.framebuffer(size, size);
        const auto by_rays = [&](std::uint64_t seed, std::int32_t max_depth) {
            return traced(stage, framebuffer.get(), samples, seed, max_depth);
        };
        const Mask mask(std::size_t{size} * size, 1);
        const Truth truth{.first = by_rays(1, kAllLight), .second = by_rays(2, kAllLight), .mask = mask};
        const Truth indirect{.first = difference(truth.first, by_rays(4, 2)),
                             .second = difference(truth.second, by_rays(5, 2)),
                             .mask = mask};
        const bool bounces = sum_of_s0(indirect.first) > 1e-3 * sum_of_s0(truth.first);
        const Costs no_costs{none, none, none, none};
        const auto add = [&](const char* how, const Image& image, const StokesErrors& alone,
                             const Costs& costs, const Costs& direct) {
            const StokesErrors errors = truth.errors(image);
            report.add(std::string(example.name) + ", " + how,
                       {1 - sum_of_s0(image) / sum_of_s0(truth.first), errors[0], errors[1], errors[2],
                        alone[0], alone[1], alone[2], costs.bake, costs.light, costs.camera,
                        costs.bake / direct.bake, costs.light / direct.light, costs.camera / direct.camera,
                        costs.kilobytes - direct.kilobytes});
        };
        const StokesErrors no_errors{none, none, none, none};
        add("rays to depth 2", by_rays(3, 2), no_errors, no_costs, no_costs);
        add("rays to depth 3", by_rays(3, 3), no_errors, no_costs, no_costs);

        nicol_render_options real_time = default_recipe().options();
        const auto measure = [&](std::int32_t max_depth, Image& image) -> Costs {
            real_time.max_depth = max_depth;
            const SceneSource uncached(options);
            Stage fresh(uncached);
            const Framebuffer target = fresh.framebuffer(size, size);
            const nicol_statistics statistics = fresh.render(real_time, target.get());
            image = read_image(target.get());
            Costs costs = frame_costs(fresh, real_time, target.get());
            costs.bake = 1e-3 * (statistics.project_ms + statistics.bake_ms + statistics.relight_ms);
            costs.kilobytes = 1e-3 * static_cast<double>(statistics.transfer_bytes) /
                              static_cast<double>(statistics.vertices);
            return costs;
        };
        Image direct, all;
        const Costs direct_costs = measure(0, direct);
        add("by default", direct, no_errors, direct_costs, no_costs);
        const Costs all_costs = measure(kAllLight, all);
        // Threads shade bounced light at pixels, where direct light has no errors of interpolation either.
        real_time.max_depth = 0;
        real_time.shade_at = NICOL_SHADE_AT_PIXELS;
        stage.render(real_time, framebuffer.get());
        const Image without = read_image(framebuffer.get());
        add("with bounces", all, bounces ? indirect.errors(difference(all, without)) : no_errors, all_costs,
            direct_costs);
    }
    report.note(
        "Missing: part of the picture's light. Errors: RMSE over the RMS of s0, with the noise of " +
        std::to_string(samples) +
        " samples a pixel taken out; indirect: of the light to depth 12 without direct light alone. Bake: "
        "everything before the first shading. Light, camera: processor time of a frame after the light was "
        "rotated by 1 degree, or the camera by 0.5. / direct: over the row before. KB a vertex: what the "
        "method keeps of vertices, more than in the row before.");
    return report;
}
