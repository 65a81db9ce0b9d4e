// SPDX-License-Identifier: MIT
#include "truth.hpp"

#include <algorithm>

namespace {

// Returns pixels that objects cover completely. Under constant light of radiance 1 the background is exactly
// 1, and no reflection is.
Mask wholly_covered(const SceneSource& source, std::uint32_t size) {
    const Stage stage(source);
    nicol_spectrum one = NICOL_SPECTRUM_INIT;
    one.count = 1;
    one.values[0] = 1;
    nicol_environment handle = nullptr;
    check(nicol_environment_create_constant(source.context(), &one, &handle));
    const Environment constant(handle);
    check(nicol_scene_set_environment(stage.scene(), constant.get(), nullptr, 1));
    const Framebuffer framebuffer = stage.framebuffer(kReduction * size, kReduction * size);
    const Recipe plain{.low = 0, .shadows = false, .shade_at = NICOL_SHADE_AT_AUTOMATIC};
    stage.render(plain.options(), framebuffer.get());
    const Image image = read_image(framebuffer.get());

    Mask covered(std::size_t{size} * size, 1);
    const std::size_t pixels = std::size_t{image.width} * image.height;
    for (std::size_t i = 0; i < pixels; ++i) {
        bool background = true;
        for (std::size_t c = 0; c < image.channels; ++c)
            background = background && image.stokes[4 * (c * pixels + i)] == 1.0F;
        const std::size_t x = i % image.width / kReduction;
        const std::size_t y = i / image.width / kReduction;
        if (background) covered[y * size + x] = 0;
    }
    return covered;
}

// Returns pixels in which all samples show the same instance.
Mask without_outlines(const Stage& stage, std::uint32_t size) {
    const std::uint32_t side = kReduction * size;
    const Framebuffer framebuffer = stage.framebuffer(side, side);
    const Recipe plain{.low = 0, .shadows = false, .shade_at = NICOL_SHADE_AT_AUTOMATIC};
    nicol_render_options options = plain.options();
    options.aovs = NICOL_AOV_INSTANCE;
    stage.render(options, framebuffer.get());
    const std::vector<std::uint32_t> ids = read_instances(framebuffer.get(), std::size_t{side} * side);
    Mask inside(std::size_t{size} * size, 1);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::size_t x = i % side / kReduction;
        const std::size_t y = i / side / kReduction;
        if (ids[i] != ids[kReduction * (y * side + x)]) inside[y * size + x] = 0;
    }
    return inside;
}

}  // namespace

Truth make_truth(const SceneSource& source, std::uint32_t size, std::uint32_t samples, bool shadows) {
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    Truth truth;
    nicol_render_options noisy = reference_options(samples, 1, shadows);
    noisy.aovs = NICOL_AOV_VARIANCE;
    stage.render(noisy, framebuffer.get());
    truth.first = read_image(framebuffer.get());
    truth.variance = read_image(framebuffer.get(), NICOL_PLANE_VARIANCE);
    stage.render(reference_options(samples, 2, shadows), framebuffer.get());
    truth.second = read_image(framebuffer.get());
    truth.mask = eroded(wholly_covered(source, size), size, size);
    return truth;
}

Image reduced_image(const Stage& stage, const Recipe& recipe, nicol_framebuffer framebuffer) {
    stage.render(recipe.options(), framebuffer);
    return reduced(read_image(framebuffer), kReduction);
}

DefaultErrors default_errors(const SceneSource& source, std::uint32_t size, std::uint32_t samples) {
    Truth truth = make_truth(source, size, samples, true);
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    stage.render(default_recipe().options(), framebuffer.get());
    DefaultErrors found{.errors = {}, .inside = 0, .statistics = NICOL_STATISTICS_INIT};
    check(nicol_framebuffer_get_statistics(framebuffer.get(), &found.statistics));
    const Image image = read_image(framebuffer.get());
    found.errors = truth.errors(image);
    const Mask inside = eroded(without_outlines(stage, size), size, size);
    for (std::size_t i = 0; i < inside.size(); ++i) truth.mask[i] &= inside[i];
    found.inside = truth.errors(image)[0];
    return found;
}
