// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "commands.hpp"
#include "frame_times.hpp"
#include "scene_file.hpp"
#include "temporary_folder.hpp"
#include "truth.hpp"

namespace {

constexpr std::int32_t kAllLight = 12;  // depth after which little light is left

const std::string kPlastic =
    R"(<bsdf type="pplastic"><rgb name="diffuse_reflectance" value="0.5,0.4,0.3"/><float name="alpha" value="0.2"/></bsdf>)";
const std::string kMirror = R"(<bsdf type="conductor"><string name="material" value="Al"/></bsdf>)";
const std::string kGlass = R"(<bsdf type="dielectric"><float name="int_ior" value="1.5"/></bsdf>)";
const std::string kPane = R"(<bsdf type="thindielectric"><float name="int_ior" value="1.5"/></bsdf>)";

std::string ball(const char* center, const char* radius, const std::string& material) {
    return R"(<shape type="sphere"><transform name="to_world"><scale value=")" + std::string(radius) +
           R"("/><translate value=")" + center + R"("/></transform>)" + material + "</shape>";
}

std::string square(const char* transform, const std::string& material) {
    return R"(<shape type="rectangle"><transform name="to_world">)" + std::string(transform) +
           "</transform>" + material + "</shape>";
}

struct Example {
    const char* name;
    std::string content;
};

std::array<Example, 5> examples() {
    const std::string floor =
        square(R"(<rotate x="1" angle="-90"/><scale value="4"/><translate y="-1"/>)", kPlastic);
    const std::string beside = ball("-1.6,-0.5,0.5", "0.5", kPlastic);
    return {
        {{"plastic ball", ball("0,0,0", "1", kPlastic)},
         {"mirror ball", ball("0,0,0", "1", kMirror)},
         {"glass ball", ball("0,0,0", "1", kGlass)},
         {"pane before a plastic ball",
          ball("0,0,0", "1", kPlastic) + square(R"(<rotate x="1" angle="-56"/><translate z="1.8"/>)", kPane)},
         {"glass, mirror and plastic ball on a floor",
          ball("0,0,0", "1", kGlass) + ball("1.7,-0.4,0.3", "0.6", kMirror) + beside + floor}}};
}

Image traced(const Stage& stage, nicol_framebuffer framebuffer, std::uint32_t samples, std::uint64_t seed) {
    nicol_render_options options = reference_options(samples, seed, true);
    options.max_depth = kAllLight;
    stage.render(options, framebuffer);
    return read_image(framebuffer);
}

}  // namespace

Report bench_glass(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 96 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 256 : given.samples;
    constexpr std::uint32_t frame_size = 1024;
    const TemporaryFolder folder;
    Options options = given;
    const std::filesystem::path file = folder.path() / "scene.xml";
    options.scene = file.string();

    Report report({"glass and mirrors, by default", "s0", "s1", "s2", "frame ms", "of plastic"});
    double of_plastic = std::nan("");
    for (const Example& example : examples()) {
        // A ball of radius 1 fills a third of the picture.
        write_scene(file, "0,0,4.34", "0,0,0", kForestLight + example.content);
        const SceneSource source(options);
        const Stage stage(source);
        const Framebuffer framebuffer = stage.framebuffer(size, size);
        const Truth truth{.first = traced(stage, framebuffer.get(), samples, 1),
                          .second = traced(stage, framebuffer.get(), samples, 2),
                          .mask = Mask(std::size_t{size} * size, 1)};
        Recipe recipe = default_recipe();
        stage.render(recipe.options(), framebuffer.get());
        const StokesErrors errors = truth.errors(read_image(framebuffer.get()));
        recipe.samples = 1;
        std::vector<Contestant> contestant;
        contestant.emplace_back(source, recipe, frame_size);
        const double frame = time_frames(contestant, given.seconds).front().camera;
        if (std::isnan(of_plastic)) of_plastic = frame;
        report.add(example.name, {errors[0], errors[1], errors[2], frame, frame / of_plastic});
    }
    report.note("Errors: RMSE over the RMS of s0 against rays to depth " + std::to_string(kAllLight) +
                ", with " + std::to_string(samples) + " samples a pixel, of 8 samples a pixel by default.");
    report.note("Frames: median after a move of the camera, " + std::to_string(frame_size) + " x " +
                std::to_string(frame_size) + ", one sample a pixel.");
    return report;
}
