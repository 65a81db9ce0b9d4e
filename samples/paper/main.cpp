// SPDX-License-Identifier: MIT
// nicol-paper: the paper's scene, its ablation and its costs, using only the C ABI.
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>

#include "common/failure.hpp"
#include "harmonics.hpp"
#include "report.hpp"
#include "sheet.hpp"

namespace {

using Truth = std::array<Image, 2>;

Image mean(const Truth& truth) {
    Image image = truth[0];
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < image.stokes[c].size(); ++i) {
            image.stokes[c][i] = 0.5F * (image.stokes[c][i] + truth[1].stokes[c][i]);
        }
    }
    return image;
}

class Paper {
public:
    explicit Paper(const Options& options)
        : options_(options),
          stage_(options),
          dense_(stage_.make_scene()),
          factored_(stage_.make_scene()),
          target_(stage_.make_framebuffer()) {}

    void run() {
        std::printf("%s\n", stage_.machine().c_str());
        say("spherical harmonics");
        const std::size_t panel = std::min<std::size_t>(options_.size, 256);
        write_spin_harmonics(panel, path("fig8_harmonics.png"));
        write_decomposition(light_file(options_.data), panel, path("fig9_decomposition.png"));
        find_objects();
        if (options_.reference > 0) trace_truth();
        for (const Step& step : steps()) run_step(step);
        // All images share the exposure of the last one, because they are compared.
        const Colouring colours(expose(images_.back()), std::min<std::size_t>(options_.size, 512));
        write_ablation(colours);
        write_realizable_range(colours);
        write_tables();
    }

private:
    Image image(View view, const Recipe& recipe) {
        const Scene& scene = recipe.method == NICOL_METHOD_DENSE ? dense_ : factored_;
        return image(scene.get(), view, recipe);
    }

    Image image(nicol_scene scene, View view, const Recipe& recipe) {
        stage_.render(scene, view, recipe, target_.get());
        Image image = read_image(target_.get());
        image.object = masks_.at(static_cast<std::size_t>(view));
        return image;
    }

    void find_objects() {
        const Scene scene = stage_.make_mask_scene();
        const Recipe recipe{.order_low = 0, .order_high = 0, .shadows = false};
        for (const View view : {View::front, View::side}) {
            stage_.render(scene.get(), view, recipe, target_.get());
            const Image shown = read_image(target_.get());
            std::vector<std::uint8_t>& mask = masks_.at(static_cast<std::size_t>(view));
            mask.resize(shown.size * shown.size);
            for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = shown.stokes[0][4 * i] < 0.5F;
        }
    }

    void trace_truth() {
        say("reference");
        const Recipe recipe{.method = NICOL_METHOD_REFERENCE, .samples = options_.reference, .seed = 1};
        Recipe other = recipe;
        other.seed = 2;
        const Scene scene = stage_.make_reference_scene(path("light.exr"));
        truth_.emplace(
            Truth{image(scene.get(), View::front, recipe), image(scene.get(), View::front, other)});
        check(nicol_framebuffer_write_exr(target_.get(), path("reference.exr").c_str()));
    }

    void run_step(const Step& step) {
        say(step.name);
        StepResult result{.step = step, .cost = {}};
        images_.push_back(image(View::front, step.recipe));
        check(nicol_framebuffer_write_exr(target_.get(), path(step.file).c_str()));
        const RealizableRange range = realizable_range(images_.back());
        result.negative = range.negative;
        result.overpolarized = range.overpolarized;
        if (truth_) result.errors = relative_errors(images_.back(), *truth_, truth_mask());
        result.cost =
            measure(stage_, dense_.get(), factored_.get(), step.recipe, options_.frames, target_.get());
        results_.push_back(result);
    }

    // Returns the object without silhouettes: reference pixels are means over squares, drawn pixels are
    // points.
    [[nodiscard]] std::vector<std::uint8_t> truth_mask() const {
        return eroded(masks_.at(static_cast<std::size_t>(View::front)), images_.back().size);
    }

    void write_ablation(const Colouring& colours) {
        Sheet sheet({"s0", "s1", "s2"});
        const auto add = [&](const char* name, const Image& image) {
            sheet.add_row(name,
                          {colours.s0(image), colours.polarized(image, 1), colours.polarized(image, 2)});
        };
        for (std::size_t i = 0; i < images_.size(); ++i) add(results_[i].step.name, images_[i]);
        if (truth_) add("reference: rays, all orders of the light", mean(*truth_));
        add_notes(sheet);
        sheet.write(path("fig20_ablation.png"));
    }

    void write_realizable_range(const Colouring& colours) {
        say("with and without eq. 70");
        Sheet sheet({"s0", "s1", "s2", "eq. 70 fails"});
        for (const View view : {View::front, View::side}) {
            for (const bool physical : {false, true}) {
                Recipe recipe;
                recipe.physical = physical;
                const Image shown = image(view, recipe);
                sheet.add_row(std::string(view == View::front ? "(a) " : "(b) ") +
                                  (physical ? "moved into the range of eq. 70" : "as computed"),
                              {colours.s0(shown), colours.polarized(shown, 1), colours.polarized(shown, 2),
                               colours.unphysical(shown)});
                if (physical && view == View::front)
                    check(nicol_framebuffer_write_exr(target_.get(), path("physical.exr").c_str()));
            }
        }
        add_notes(sheet);
        sheet.add_note(
            "eq. 70 fails: red where s0 < 0, yellow where polarization exceeds s0, in some channel");
        sheet.write(path("fig22_physical_range.png"));
    }

    static void add_notes(Sheet& sheet) {
        sheet.add_note("s1, s2: red negative, green positive. one exposure for all panels. black: s0 < 0");
        sheet.add_note("light cut at order 4 or 9 rings: s0 < 0 and excess polarization are to be expected");
    }

    void write_tables() {
        std::string text = stage_.machine() + ", " + std::to_string(options_.size) + " x " +
                           std::to_string(options_.size) + "\n\n" +
                           cost_table(results_, stage_.components(), options_.frames > 0) + '\n' +
                           range_table(results_);
        if (truth_) text += '\n' + error_table(results_);
        std::fputs(text.c_str(), stdout);
        std::ofstream file(path("table4.md"));
        file << text;
        file.close();
        if (!file) throw Failure(path("table4.md") + ": cannot be written");
    }

    [[nodiscard]] std::string path(const char* name) const { return (options_.out / name).string(); }
    static void say(const char* what) { std::fprintf(stderr, "nicol-paper: %s\n", what); }

    const Options& options_;
    Stage stage_;
    Scene dense_, factored_;
    Framebuffer target_;
    std::array<std::vector<std::uint8_t>, 2> masks_;  // objects by view
    std::optional<Truth> truth_;
    std::vector<Image> images_;
    std::vector<StepResult> results_;
};

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Failure("--out: " + folder.string() + ": cannot make the folder: " + error.message());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Options options = parse_options(argc, argv);
        if (options.help) {
            std::fputs(usage, stdout);
            return 0;
        }
        require_data(options.data);
        make_folder(options.out);
        Paper(options).run();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nicol-paper: %s\n", error.what());
    }
    return 2;
}
