// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <ctime>
#include <vector>

#include "median.hpp"
#include "stage.hpp"

using nicol::defaults;

namespace {

nicol_render_options options_of(std::uint32_t order) {
    auto options = defaults(nicol_render_options_init);
    options.order_low = options.order_high = order;
    options.physical = 0;
    options.shade_at = NICOL_SHADE_AT_PIXELS;
    options.split_lights = 0;
    options.bsdf_samples = 0;
    options.disabled_optimisations = NICOL_OPTIMISATION_LIGHT_COMPONENTS;
    return options;
}

/// A gradient of a picture, and room for the gradients of one kind.
struct Gradients {
    std::vector<float> pixels;
    std::vector<double> numbers;
    nicol_stokes_image picture = defaults(nicol_stokes_image_init);

    Gradients(std::uint32_t side, std::uint32_t channels)
        : pixels(std::size_t{4} * side * side * channels, 1.0F) {
        picture.width = picture.height = side;
        picture.channels = channels;
        picture.pixels = pixels.data();
        picture.byte_size = pixels.size() * sizeof(float);
    }
    nicol_gradient by_environment(std::uint32_t order) {
        auto gradient = defaults(nicol_gradient_init);
        numbers.resize(std::size_t{4} * picture.channels * (order + 1) * (order + 1));
        gradient.environment = numbers.data();
        gradient.environment_count = numbers.size();
        return gradient;
    }
};

/// Returns the processor time of all threads that a call takes, in milliseconds.
template <class Call>
double processor_ms(const Call& call) {
    const std::clock_t before = std::clock();
    call();
    return 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

}  // namespace

Report bench_adjoint(const Options& options) {
    constexpr int repetitions = 9;
    const std::uint32_t size = options.size == 0 ? 512 : options.size;
    Report report({"order", "picture ms", "gradient ms", "gradient / picture"});
    for (const std::uint32_t order : {2U, 4U, 6U, 9U}) {
        const SceneSource source(options);
        Stage stage(source);
        check(nicol_scene_hide_emitters(stage.scene(), 1));
        const Framebuffer framebuffer = stage.framebuffer(size, size);
        std::uint32_t channels = 0;
        check(nicol_scene_get_channels(stage.scene(), &channels));
        Gradients room(size, channels);
        const nicol_render_options chosen = options_of(order);
        const nicol_gradient gradient = room.by_environment(order);
        stage.render(chosen, framebuffer.get());
        std::vector<double> pictures, gradients;
        for (int i = 0; i < repetitions; ++i) {
            stage.rotate_light(1);
            pictures.push_back(processor_ms([&] { stage.render(chosen, framebuffer.get()); }));
            gradients.push_back(processor_ms([&] { stage.adjoint(chosen, room.picture, gradient); }));
        }
        report.add(std::to_string(order),
                   {median(pictures), median(gradients), median(gradients) / median(pictures)});
    }
    report.note(
        "Medians of the processor time of " + std::to_string(repetitions) +
        " pictures in which the light rotates, and of as many gradients by the environment, in all four "
        "components.");
    return report;
}
