// SPDX-License-Identifier: MIT
#include "silhouette.hpp"

#include <cmath>

#include "image.hpp"

namespace {

constexpr int kSide = 8;  // grid of jitter offsets per pixel

// The mean of jittered images, and the pixels in which they show different instances.
struct Outlines {
    std::vector<double> mean;  // layout of Image::stokes
    Mask edges;
};

Outlines trace_outlines(Stage& stage, const Recipe& recipe, nicol_framebuffer framebuffer,
                        std::size_t pixels) {
    nicol_render_options options = recipe.options();
    options.aovs = NICOL_AOV_INSTANCE;
    Outlines outlines{.mean = {}, .edges = Mask(pixels, 0)};
    std::vector<std::uint32_t> first;
    for (int i = 0; i < kSide * kSide; ++i) {
        stage.jitter((i % kSide + 0.5) / kSide - 0.5, (i / kSide + 0.5) / kSide - 0.5);
        stage.render(options, framebuffer);
        const Image image = read_image(framebuffer);
        outlines.mean.resize(image.stokes.size());
        for (std::size_t k = 0; k < image.stokes.size(); ++k)
            outlines.mean[k] += static_cast<double>(image.stokes[k]) / (kSide * kSide);
        const std::vector<std::uint32_t> ids = read_instances(framebuffer, pixels);
        if (i == 0) first = ids;
        for (std::size_t p = 0; p < pixels; ++p)
            if (ids[p] != first[p]) outlines.edges[p] = 1;
    }
    stage.jitter(0, 0);
    return outlines;
}

double error_of(const Image& image, const Outlines& outlines) {
    const std::size_t pixels = outlines.edges.size();
    double squares = 0;
    double count = 0;
    for (std::size_t c = 0; c < image.channels; ++c) {
        for (std::size_t p = 0; p < pixels; ++p) {
            if (outlines.edges[p] == 0) continue;
            const std::size_t s0 = 4 * (c * pixels + p);
            squares += std::pow(static_cast<double>(image.stokes[s0]) - outlines.mean[s0], 2);
            ++count;
        }
    }
    return std::sqrt(squares / count);
}

}  // namespace

std::vector<double> silhouette_errors(const SceneSource& source, std::span<const Recipe> recipes,
                                      std::uint32_t size) {
    Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    const Outlines outlines =
        trace_outlines(stage, recipes.front(), framebuffer.get(), std::size_t{size} * size);
    std::vector<double> errors;
    for (const Recipe& recipe : recipes) {
        stage.render(recipe.options(), framebuffer.get());
        errors.push_back(error_of(read_image(framebuffer.get()), outlines));
    }
    return errors;
}
